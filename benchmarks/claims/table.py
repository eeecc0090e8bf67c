"""What was observed, as data: ``observed.tsv`` has a row for each claim and a column for each distribution."""

from __future__ import annotations

import csv
from pathlib import Path

from benchmarks.claims.model import Claim

FILE = Path(__file__).parent / "observed.tsv"
DISTROS = ("jazzy", "kilted")
_KEYS = ("rule", "form", "handler", "executor", "groups")

Table = dict[str, dict[Claim, str]]


def read(known: set[Claim]) -> Table:
    """The committed table, less what is no longer tried."""
    table: Table = {distro: {} for distro in DISTROS}
    if not FILE.exists():
        return table
    with FILE.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter="\t"):
            claim = Claim(*(row[key] for key in _KEYS))
            for distro in DISTROS:
                if claim in known and row[distro]:
                    table[distro][claim] = row[distro]
    return table


def write(table: Table) -> None:
    with FILE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, delimiter="\t", lineterminator="\n")
        writer.writerow([*_KEYS, *DISTROS])
        for claim in sorted({claim for column in table.values() for claim in column}):
            outcomes = [table[distro].get(claim, "") for distro in DISTROS]
            writer.writerow([claim.rule, claim.form, claim.handler, claim.executor, claim.groups, *outcomes])
