"""The table of faults, ``bugs.tsv``: where each was fixed, what it was, and what archlint says of it."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

PATH = Path(__file__).with_name("bugs.tsv")


class Verdict(Enum):
    """What a reader found archlint to say of the commit before the fix."""

    DEFAULT = "default"
    """A default rule tells of the fault, at its place."""
    OPT_IN = "opt-in"
    """Only a rule that is off by default does."""
    PART = "part"
    """A finding leads to the place, but says something else of it, or half."""
    SILENT = "silent"


@dataclass(frozen=True)
class Bug:
    """One fault, as the commit before its fix has it."""

    repository: str
    """As the code host has it, ``owner/name``."""
    fix: str
    """The commit that repairs it; the fault is in its first parent."""
    file: str
    line: int
    """One-based, of the parent."""
    group: str
    description: str
    verdict: Verdict
    rules: tuple[str, ...]
    """The codes that tell of it; empty when none does."""
    why: str
    """What keeps archlint from telling of it, or from telling all."""

    @property
    def place(self) -> str:
        return f"{self.repository} {self.fix[:10]} {self.file}:{self.line}"


def read(path: Path = PATH) -> list[Bug]:
    """The faults of a table, in its order.

    Raises:
        ValueError: a verdict that there is not, or a line that is no number.
    """
    with path.open(encoding="utf-8", newline="") as stream:
        return [_bug(row) for row in csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE)]


def _bug(row: dict[str, str]) -> Bug:
    return Bug(
        row["repository"],
        row["fix"],
        row["file"],
        int(row["line"]),
        row["group"],
        row["description"],
        Verdict(row["verdict"]),
        tuple(row["rules"].split()),
        row["why"],
    )
