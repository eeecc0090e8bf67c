"""By which programs are told apart, in one run and from one run to the next."""

from __future__ import annotations

from archlint.model import Overrides
from archlint.programs.keys import DefinitionKey, EntryKey, ModuleKey, ProgramKey, ScriptKey

FILE = "robot/robot/talker.py"


def entry(overrides: Overrides | None = None, words: tuple[str | None, ...] | None = None) -> EntryKey:
    return EntryKey(FILE, "robot", "talker", "main", None if overrides is None else overrides.key, words)


def test_programs_that_start_in_one_file_are_told_apart():
    keys: list[ProgramKey] = [
        ScriptKey(FILE),
        ModuleKey(FILE),
        DefinitionKey(FILE, "Talker"),
        DefinitionKey(FILE, "main"),
        entry(),
        entry(words=()),
        entry(words=("front",)),
        entry(words=(None,)),
        entry(Overrides(others={"rate": 1.0})),
        entry(Overrides(others={"rate": 2.0})),
    ]
    assert len({key.text for key in keys}) == len(keys)


def test_the_text_of_a_key_does_not_depend_on_the_order_of_sets_and_tables():
    one = entry(Overrides(others={"a": 1, "b": 2}, settled=frozenset(("a", "b", "c"))))
    other = entry(Overrides(others={"b": 2, "a": 1}, settled=frozenset(("c", "b", "a"))))
    assert one == other and one.text == other.text
