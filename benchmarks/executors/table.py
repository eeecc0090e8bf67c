"""What was observed, as data: ``observed.tsv`` has a row for each cell and a column for each distribution."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from benchmarks.executors.cells import Cell, all_cells

FILE = Path(__file__).parent / "observed.tsv"
DISTROS = ("jazzy", "kilted")
_HOW_OFTEN = re.compile(r" \(\d+ of \d+\)")
_KEYS = ("wait", "handler", "executor", "groups", "latency")

Table = dict[str, dict[Cell, str]]
"""By distribution, the outcome of each cell; of several runs that differ all, as ``hangs (1 of 8) | works (7 of 8)``.

Rows of earlier runs do not say how often."""


def read() -> Table:
    """The committed table; cells that are no longer tried are left out."""
    table: Table = {distro: {} for distro in DISTROS}
    if not FILE.exists():
        return table
    known = set(all_cells())
    with FILE.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter="\t"):
            cell = Cell(*(row[key] for key in _KEYS[:4]), float(row["latency"]))
            for distro in DISTROS:
                if cell in known and row[distro]:
                    table[distro][cell] = row[distro]
    return table


def write(table: Table) -> None:
    with FILE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, delimiter="\t", lineterminator="\n")
        writer.writerow([*_KEYS, *DISTROS])
        for cell in sorted({cell for column in table.values() for cell in column}):
            outcomes = [table[distro].get(cell, "") for distro in DISTROS]
            writer.writerow([cell.wait, cell.handler, cell.executor, cell.groups, f"{cell.latency:g}", *outcomes])


def add(column: dict[Cell, str], seen: Mapping[Cell, Iterable[str]]) -> None:
    """Replace the outcomes of the cells that were tried again."""
    for cell, outcomes in seen.items():
        counts = Counter(outcomes)
        words = [f"{outcome} ({count} of {counts.total()})" for outcome, count in sorted(counts.items())]
        column[cell] = " | ".join(words if len(words) > 1 else counts)


def outcomes_of(text: str) -> list[str]:
    """The outcomes that were seen of a cell."""
    return without_how_often(text).split(" | ")


def without_how_often(text: str) -> str:
    return _HOW_OFTEN.sub("", text)
