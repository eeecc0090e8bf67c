"""Plant a defect in a workspace of copies, check it, and take the defect out again."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from archlint.config.selection import Layer
from archlint.config.settings import Settings
from archlint.engine.pipeline import NothingToDo, Request, check
from archlint.finding import Finding

from .defect import Defect
from .python_source import Edit

EXTRA = ("GRF002",)
"""Rules that are off by default and are judged here."""

Key = tuple[str, str, int, str]


@dataclass
class Outcome:
    """``found`` is the expected finding; ``others`` are new ones that nothing planted here explains."""

    defect: Defect
    found: Finding | None
    others: list[Finding] = field(default_factory=list)


class Bench:
    """A folder of copied packages; ``cache`` is shared, since most files are the same each time."""

    def __init__(self, folder: Path, cache: Path) -> None:
        self.folder = folder
        self.cache = cache
        self._before: dict[str | None, Counter[Key]] = {}

    def run(self, launch: str | None) -> list[Finding]:
        os.chdir(self.folder)
        layer = Layer(None, EXTRA if launch is None else (), ())
        settings = Settings(layers=(layer,), closed_world=launch is not None, cache_dir=str(self.cache))
        try:
            return list(check(Request((".",), settings, jobs=1, launch=launch)).findings)
        except NothingToDo:
            return []

    def before(self, launch: str | None) -> Counter[Key]:
        if launch not in self._before:
            self._before[launch] = Counter(_key(finding) for finding in self.run(launch))
        return self._before[launch]

    def plant(self, defect: Defect) -> Outcome:
        """What is new with the defect in place."""
        before = self.before(defect.launch)
        whole = {edit.file: (self.folder / edit.file).read_bytes() for edit in defect.edits}
        try:
            for file, data in whole.items():
                edits = [edit for edit in defect.edits if edit.file == file]
                (self.folder / file).write_bytes(edited(data, edits))
            after = self.run(defect.launch)
        finally:
            for file, data in whole.items():
                (self.folder / file).write_bytes(data)
        new = _without(after, before, _key)
        expected = [one for one in new if one.code in defect.rules and _is_at(one, defect)]
        # A message may speak of what has changed: the same rule at the same line is not new.
        there: Counter[tuple[str, str, int]] = Counter()
        for (code, file, line, _), count in before.items():
            there[code, file, line] += count
        others = [
            one
            for one in _without(after, there, lambda finding: _key(finding)[:3])
            if one not in expected and one.code not in defect.also
        ]
        return Outcome(defect, expected[0] if expected else None, others)


def edited(data: bytes, edits: list[Edit]) -> bytes:
    for edit in sorted(edits, key=lambda one: one.start, reverse=True):
        data = data[: edit.start] + edit.text + data[edit.end :]
    return data


def _without(findings: Iterable[Finding], before: Counter[Any], key: Callable[[Finding], Any]) -> list[Finding]:
    """The findings that were not there before."""
    left = Counter(before)
    new = []
    for finding in findings:
        if left[key(finding)]:
            left[key(finding)] -= 1
        else:
            new.append(finding)
    return new


def _key(finding: Finding) -> Key:
    """Lists of what else there is may change in a message; its first words do not."""
    return (finding.code, finding.place.file, finding.place.line, finding.message.partition(";")[0])


def _is_at(finding: Finding, defect: Defect) -> bool:
    return any(
        place.file == lines.file and place.line <= lines.last and lines.first <= place.end_line
        for lines in defect.places
        for place in (finding.place, *(related.place for related in finding.related))
    )
