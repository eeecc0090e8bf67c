"""Which findings are known: by what they are about, each as often as it was there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.engine.known import Baseline, Entry, Older, Sieve
from archlint.finding import Finding, Place, Related, Severity
from archlint.report.occurrence import Key, Occurrence


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "node.py").touch()
    return tmp_path


def finding(line: int = 12, *identity: str, file: str = "src/node.py", code: str = "SRV003") -> Finding:
    place = Place(file, line, 5, line, 20)
    return Finding(code, "x", Severity.ERROR, f"it waits on line {line}", place, identity=identity)


def key(*arguments: int | str, **words: str) -> Key:
    return Occurrence.of(finding(*arguments, **words)).key


def holding(*keys: Key) -> Baseline:
    return Baseline("known.txt", tuple(Entry(number, one) for number, one in enumerate(keys, 3)))


def older(*keys: Key, severity: Severity = Severity.ERROR) -> list[Older]:
    return [Older(one, severity) for one in keys]


def test_its_line_does_not_matter_but_its_rule_its_file_and_its_names_do():
    known = key(12, "on_request", "plan")
    assert key(80, "on_request", "plan") == known
    assert known not in (
        key(12, "on_request", "map"),
        key(12, "on_request", "plan", code="SRV005"),
        key(12, "on_request", "plan", file="src/other.py"),
    )


def test_without_names_the_message_counts_but_for_its_line_numbers():
    assert key(12) == key(80)


def test_the_launch_file_that_shows_it_does_not_matter():
    alone, launched = finding(12, "plan"), replace(finding(12, "plan"), system="launch/a.launch.py")
    assert Occurrence.of(alone) == Occurrence.of(launched)


def test_a_file_among_its_names_is_seen_from_its_own(folder: Path, monkeypatch: pytest.MonkeyPatch):
    other = Related(Place("launch/b.launch.py", 1, 1, 1, 2), "included here")
    here = replace(finding(3, "launch/b.launch.py", "speed", file="launch/a.launch.py"), related=(other,))
    assert Occurrence.of(here).what == "b.launch.py, speed"
    (folder / "launch").mkdir()
    monkeypatch.chdir("launch")
    other = Related(Place("b.launch.py", 1, 1, 1, 2), "included here")
    there = replace(finding(3, "b.launch.py", "speed", file="a.launch.py"), related=(other,))
    key_there = Occurrence.of(there).key
    monkeypatch.chdir(folder)
    assert key_there == Occurrence.of(here).key


def test_so_is_a_file_of_the_workspace_that_it_shows_nowhere():
    elsewhere = finding(3, "other/launch/b.launch", "speed", file="launch/a.launch.py")
    assert Occurrence.of(elsewhere, {"other/launch/b.launch"}).what == "../other/launch/b.launch, speed"


def test_a_baseline_holds_what_it_lists_as_often_as_it_lists_it():
    sieve = Sieve(holding(key(1, "plan"), key(1, "plan")))
    sifted = sieve.part([finding(line, "plan") for line in (30, 20, 10)])
    assert [one.place.line for one in sifted.baselined] == [10, 20]
    assert [one.place.line for one in sifted.new] == [30]
    assert sieve.idle() == []


def test_what_a_baseline_lists_more_often_than_it_is_found_is_idle():
    sieve = Sieve(holding(key(1, "plan"), key(1, "plan"), key(1, "map")))
    sieve.part([finding(10, "plan")])
    assert [entry.line for entry in sieve.idle()] == [4, 5]


def test_of_several_workspaces_an_entry_is_for_one():
    sieve = Sieve(holding(key(1, "plan")))
    assert len(sieve.part([finding(10, "plan")]).baselined) == 1
    assert len(sieve.part([finding(10, "plan")]).new) == 1


@pytest.mark.parametrize("code", ["LNT003", "LNT004"])
def test_a_failure_of_ours_is_never_held(code: str):
    assert len(Sieve(holding(key(1, "x", code=code))).part([finding(1, "x", code=code)]).new) == 1


def test_what_an_earlier_revision_has_is_not_new():
    sieve = Sieve(before=older(key(1, "plan")))
    sifted = sieve.part([finding(10, "plan"), finding(20, "plan"), finding(30, "map")])
    assert [one.place.line for one in sifted.older] == [10]
    assert [one.place.line for one in sifted.new] == [20, 30]


def test_what_weighs_more_than_before_is_new():
    assert len(Sieve(before=older(key(1, "plan"), severity=Severity.INFO)).part([finding(10, "plan")]).new) == 1
    less = replace(finding(10, "plan"), severity=Severity.INFO)
    assert len(Sieve(before=older(key(1, "plan"), severity=Severity.WARNING)).part([less]).older) == 1


def test_the_finding_of_a_file_that_is_gone_may_be_in_another_one_now():
    sieve = Sieve(before=older(key(1, "plan", file="src/gone.py"), key(1, "map")))
    sifted = sieve.part([finding(10, name, file="src/new.py") for name in ("plan", "map")])
    assert [len(sifted.older), len(sifted.new)] == [1, 1]


def test_what_the_baseline_holds_does_not_hide_an_equal_finding_that_is_new():
    sieve = Sieve(holding(key(1, "plan")), before=older(key(1, "plan")))
    sifted = sieve.part([finding(10, "plan"), finding(20, "plan")])
    assert (len(sifted.baselined), len(sifted.older), len(sifted.new)) == (1, 0, 1)


def test_with_an_earlier_revision_only_an_entry_that_the_change_makes_idle_counts():
    sieve = Sieve(holding(key(1, "plan"), key(1, "map")), before=older(key(1, "plan")))
    sieve.part([])
    assert [entry.key.what for entry in sieve.idle()] == ["plan"]
