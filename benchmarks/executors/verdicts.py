"""What archlint says of the wait in the program of each cell, and whether what was seen bears it out."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.execution import blocking
from archlint.finding import Finding
from benchmarks.executors.cells import Cell, partner, program
from benchmarks.executors.running import HANGS, NOTHING, SOME, STOPS, STRANDS, WORKS

JUDGES = ("SRV003", "EXE001", "EXE002", "EXE004", "EXE014", "CBG001")
"""The rules that say what becomes of a wait in a callback."""
TIMEOUT = "raises TimeoutError"
CLASH = "raises ValueError"
OPEN = "may hang"
STARVES = "starves if answers are late"
NO_SLEEP = "hangs, or does not sleep"
CLASHES = "times out, or raises ValueError"
RACES = "sometimes hangs"
RACES_TO_ITS_LIMIT = "sometimes times out"
RACES_AND_RAISES = "sometimes hangs, or raises RCLError"
RACES_TO_ITS_LIMIT_AND_RAISES = "sometimes times out, or raises RCLError"

_MANIFEST = "<package format='3'><name>{name}</name><version>0.0.0</version></package>"
_SAID = (
    ("it does not sleep at all", NO_SLEEP),
    ("none is left", STARVES),
    ("no thread is left", STARVES),
    ("leave no thread", STARVES),
    (blocking.Outcome.RAISES_NESTED, "raises RuntimeError"),
    (blocking.Outcome.STRANDS, STRANDS),
    (blocking.Outcome.RAISES_TIMEOUT, TIMEOUT),
    (blocking.Outcome.TIMES_OUT, NOTHING),
    ("so it is None", NOTHING),
    (blocking.Outcome.HANGS, HANGS),
    ("may never respond", OPEN),
    ("works here", WORKS),
)
"""What messages say, the most telling first."""
_BEFORE = {
    blocking.Outcome.FINE: WORKS,
    blocking.Outcome.HANGS: HANGS,
    blocking.Outcome.TIMES_OUT: NOTHING,
    blocking.Outcome.TIMES_OUT_OR_CLASHES: CLASHES,
    blocking.Outcome.SOMETIMES_HANGS: RACES,
    blocking.Outcome.SOMETIMES_TIMES_OUT: RACES_TO_ITS_LIMIT,
    blocking.Outcome.HANGS_OR_RAISES: RACES_AND_RAISES,
    blocking.Outcome.TIMES_OUT_OR_RAISES: RACES_TO_ITS_LIMIT_AND_RAISES,
}
_ALSO = {
    STARVES: {WORKS, HANGS, NOTHING, TIMEOUT, SOME, STOPS},
    NO_SLEEP: {WORKS, HANGS, STOPS},
    HANGS: {STOPS},
    CLASHES: {NOTHING, CLASH},
    RACES: {WORKS, HANGS, STOPS, SOME, CLASH},
    RACES_TO_ITS_LIMIT: {WORKS, NOTHING, SOME, CLASH},
    RACES_AND_RAISES: {WORKS, HANGS, STOPS, SOME, CLASH, "raises RCLError"},
    RACES_TO_ITS_LIMIT_AND_RAISES: {WORKS, NOTHING, SOME, CLASH, "raises RCLError"},
}
"""Outcomes that are no other than what was said."""


_ALL_FORMS = {"SRV003": {"lost-answers": True}}
"""The options of rules that say less of a large workspace, as all cells together are one."""


def verdicts(cells: Sequence[Cell], distros: Sequence[str]) -> dict[str, dict[Cell, str]]:
    """By distribution, what archlint says becomes of each cell: the words of the findings, ``works`` without one."""
    with tempfile.TemporaryDirectory() as name, working_in(Path(name)) as folder:
        for cell in cells:
            package = folder / cell.name
            package.mkdir()
            words = re.sub(r"\W", "_", cell.name)
            (package / "package.xml").write_text(_MANIFEST.format(name=words))
            (package / "asker.py").write_text(program(cell))
            if partner(cell):
                (package / "other.py").write_text(partner(cell))
        return {
            distro: _verdicts(cells, Settings(distro=distro, cache_dir="cache", rules=_ALL_FORMS)) for distro in distros
        }


def _verdicts(cells: Sequence[Cell], settings: Settings) -> dict[Cell, str]:
    found: dict[str, list[Finding]] = {cell.name: [] for cell in cells}
    for finding in check(Request((".",), settings, jobs=1)).findings:
        if finding.code in JUDGES:
            found[finding.place.file.partition("/")[0]].append(finding)
    return {cell: meaning([one.message for one in found[cell.name]]) for cell in cells}


def meaning(messages: Sequence[str]) -> str:
    """A word for what the findings of one program say."""
    if not messages:
        return WORKS
    for text, word in _SAID:
        if any(text in message for message in messages):
            return word + _before(messages)
    return f"says else: {messages[0]}"


def _before(messages: Sequence[str]) -> str:
    """Older releases of a distribution may do something else: ``raises RuntimeError, before: works``."""
    found = [match for message in messages if (match := re.search(r"\(([^()]+) before rclpy", message))]
    return f", before: {_BEFORE[found[0].group(1)]}" if found else ""


def agrees(said: str, seen: str, cell: Cell) -> bool:
    """Whether what was seen of a cell is what archlint says; of two releases, the wheels have the older one."""
    said = said.partition(", before: ")[2] or said
    if said == WORKS and cell.wait == "spin_once" and seen in (NOTHING, SOME):
        return True  # it looked for work for as long as it may, and nothing was due
    return seen == said or seen in _ALSO.get(said, ())


@contextmanager
def working_in(folder: Path) -> Iterator[Path]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield folder
    finally:
        os.chdir(before)
