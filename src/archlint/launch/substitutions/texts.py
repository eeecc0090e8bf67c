"""Texts made of others: parts one after the other, joined, or read from configurations and the environment."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    file_origin,
    join_texts,
    one_of,
    reason,
)
from archlint.launch.objects import LaunchObject, known_text

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun

COMBINATIONS = 12


def concatenate(parts: Sequence[Value], joint: str = "") -> Value:
    """The parts one after the other, over all their alternatives."""
    rows: list[list[Value]] = [[]]
    for number, part in enumerate(parts):
        options = alternatives(part)
        if len(rows) * len(options) > COMBINATIONS:
            options = (Unknown("more values than can be followed"),)
        between = [Known(joint)] if joint and number else []
        rows = [[*row, *between, option] for row in rows for option in options]
    joined = one_of(row[0] if len(row) == 1 else join_texts(row, file_origin(*row)) for row in rows)
    return chosen_with(joined, *parts)


def written_at(value: Value, place: Place | None) -> Value:
    """A text that is not known to be written anywhere else, with where it is given."""
    if isinstance(value, Known) and value.origin is None:
        return Known(value.value, value.via, place, value.kind)
    return value


def each_text(value: Value, make: Callable[[str], Value]) -> Value:
    """What is made of each text that a value may be; what is not known stays so."""
    texts = ((option, known_text(option)) for option in alternatives(value))
    results = one_of(Unknown(reason(option)) if text is None else make(text) for option, text in texts)
    return chosen_with(results, value)


def _parts(run: LaunchRun, value: Value | None) -> list[Value]:
    """The texts of a list, or of what stands for the only item of one."""
    items = value.items(run).values if isinstance(value, ListValue) else (value,)
    return [run.perform(item) for item in items if item is not None]


def configuration(run: LaunchRun, value: LaunchObject) -> Value:
    name = run.text_of(value.argument("variable_name"))
    if name is None:
        run.result.reads_any = True
        return Unknown("the name of a launch configuration is not known")
    run.note_read(name)
    setting = run.launch.configurations.get(name)
    if setting is not None:
        return setting
    default = value.argument("default")
    if default is not None:
        return run.perform(default)
    place = _asked_at(value)
    if place is not None:
        in_branch = bool(value.branch_arms - run.code_arms)
        run.note_undeclared(name, place, run.is_conditional or in_branch)
    return Unknown(f"the launch configuration '{name}' is not set")


def _asked_at(value: LaunchObject) -> Place | None:
    """Where a file asks for a configuration: with the call of a function of another file that is given the name."""
    name, place, call = value.argument("variable_name"), value.place, value.called_at
    if not isinstance(name, Known) or name.origin is None or place is None or call is None:
        return place
    return place if place.file in (call.file, name.origin.file) else call


def text(run: LaunchRun, value: LaunchObject) -> Value:
    return run.perform(value.argument("text"))


def path_join(run: LaunchRun, value: LaunchObject) -> Value:
    parts = _parts(run, value.argument("substitutions"))
    texts = [text for text in map(known_text, parts) if text is not None]
    if len(texts) == len(parts):
        return Known(posixpath.join("", *texts), origin=file_origin(*parts))
    return concatenate(parts, "/")


def string_join(run: LaunchRun, value: LaunchObject) -> Value:
    joint = run.perform(value.argument("delimiter"))
    parts = _parts(run, value.argument("substitutions"))
    text = known_text(joint)
    return Unknown(reason(joint)) if text is None else concatenate(parts, text)


def environment(run: LaunchRun, value: LaunchObject) -> Value:
    name = run.text_of(value.argument("name"))
    if name is None:
        return Unknown("the name of an environment variable is not known")
    variable = run.launch.environment.get(name) or run.library.environment(name)
    if variable is not None:
        return variable
    default = value.argument("default_value")
    if default is None or name in _SET_EVERYWHERE:
        return Unknown(f"the environment variable {name}")
    return run.perform(default)


_SET_EVERYWHERE = frozenset({"HOME", "LOGNAME", "PATH", "PWD", "SHELL", "USER"})
"""Variables that a login sets: their default is for the machine that has none."""


def anonymous(run: LaunchRun, value: LaunchObject) -> Value:
    name = run.perform(value.argument("name"))
    return join_texts((name, Known("_"), Unknown("a name that launch makes unique")))
