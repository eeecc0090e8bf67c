"""How often each rule found something, the most frequent first: as lines, and as JSON in the form that ruff's has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict
from typing import TYPE_CHECKING

from archlint.json_text import json_text
from archlint.records import dataclass
from archlint.report.fix_marks import is_fixable

if TYPE_CHECKING:
    from archlint.finding import Finding


@dataclass(frozen=True)
class RuleCount:
    """What one rule found: ``fixable`` says whether ``--fix`` mends all of it, ``fixable_count`` how much."""

    code: str
    name: str
    count: int
    fixable: bool
    fixable_count: int


def counted(findings: Iterable[Finding]) -> list[RuleCount]:
    """A row for each rule that found something."""
    counts: Counter[tuple[str, str]] = Counter()
    fixable: Counter[str] = Counter()
    for finding in findings:
        counts[finding.code, finding.name] += 1
        fixable[finding.code] += is_fixable(finding)
    rows = sorted(counts.items(), key=lambda row: (-row[1], row[0]))
    return [RuleCount(code, name, count, fixable[code] == count, fixable[code]) for (code, name), count in rows]


def as_text(findings: Iterable[Finding]) -> str:
    """Count, code, how many of them are fixable where any finding is (``[*]`` all, ``[-]`` some, ``[ ]`` none), and
    name, with tabs between."""
    rows = counted(findings)
    width = max((len(str(row.count)) for row in rows), default=0)
    any_fixable = any(row.fixable_count for row in rows)
    return "".join(
        f"{row.count:>{width}}\t{row.code}\t{_share(row) if any_fixable else ''}{row.name}\n" for row in rows
    )


def as_json(findings: Iterable[Finding]) -> str:
    """A list of objects with the fields of :class:`RuleCount`."""
    return json_text([asdict(row) for row in counted(findings)], indent=1) + "\n"


def _share(row: RuleCount) -> str:
    return "[*] " if row.fixable else "[-] " if row.fixable_count else "[ ] "
