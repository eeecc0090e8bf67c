"""Where to start when there are many findings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.finding import Severity
from archlint.report.groups import is_launched, most_important, package_of
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import Report

MANY = 10
"""More findings than these do not fit a screen, and their errors may have left it."""
_NAMED = 5
"""How many errors are named."""


def starting_points(report: Report) -> str:
    """Lines that say what to look at first; empty where there are few findings."""
    lines = list(_lines(report)) if len(report.findings) > MANY else []
    return "\n".join(["Where to start:", *lines]) if lines else ""


def _lines(report: Report) -> Iterator[str]:
    every = len(report.findings)
    errors = [finding for finding in most_important(report, every) if finding.severity is Severity.ERROR]
    launched = [finding for finding in errors if is_launched(finding, report)]
    yield from _errors(launched or errors, " in code that a launch file starts" if launched else "")
    code, count = _most_frequent(f"{finding.code} {finding.name}" for finding in report.findings)
    if code:
        yield f"  {code} has {count} of the {every} findings: `archlint explain {code.split()[0]}`"
    package, count = _most_frequent(package_of(finding, report) or "" for finding in report.findings)
    if package:
        yield f"  the package {visible(package)} has {count} of the {every} findings"


def _errors(errors: list[Finding], where: str) -> Iterator[str]:
    if errors:
        yield f"  {len(errors)} error{'s' if len(errors) > 1 else ''}{where}:"
    named = errors if len(errors) == _NAMED + 1 else errors[:_NAMED]
    for finding in named:
        place = finding.place
        yield f"    {visible(place.file)}:{place.line}:{place.column} {finding.code} {finding.name}"
    if len(errors) > len(named):
        yield f"    and {len(errors) - len(named)} more"


def _most_frequent(words: Iterable[str]) -> tuple[str, int]:
    """The word that comes more often than each other one, and how often; an empty one where none does."""
    first, *others = Counter(words).most_common(2)
    return first if others and first[1] > others[0][1] else ("", 0)


__all__ = ["MANY", "starting_points"]
