"""``--fix`` and ``--diff``: apply the fixes of a run's findings, or show what they would change."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.cli.exits import UsageError
from archlint.engine.pipeline import check
from archlint.fixes import apply as fixes
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.engine.pipeline import Request
    from archlint.finding import Finding
    from archlint.report.model import Report

PASSES = 8
"""How often a file is mended again, where fixes were in each other's way."""


@dataclass(frozen=True)
class Fixed:
    """The report on what is left, and how many findings were fixed."""

    report: Report
    count: int


def mend(request: Request, report: Report, unsafe: bool) -> Fixed:
    """Apply fixes until none is left, or the next round would only repeat one.

    Raises :class:`UsageError` where a file cannot be written.
    """
    count = 0
    done: set[object] = set()
    for _ in range(PASSES):
        wanted = [finding for finding in fixes.fixable(report.findings, unsafe) if _key(finding) not in done]
        outcome = fixes.apply(wanted, inside=report.inside)
        if not outcome.fixed:
            break
        try:
            fixes.write(outcome)
        except OSError as error:
            raise UsageError(f"cannot write {error.filename}: {error.strerror}") from None
        done.update(_key(finding) for finding in outcome.fixed)
        count += len(outcome.fixed)
        report = check(request)
    return Fixed(report, count)


def _key(finding: Finding) -> object:
    """What sets one fix apart from the next: the same edit at the same line is no progress."""
    edits = () if finding.fix is None else finding.fix.edits
    return (finding.code, finding.place.file, finding.message, *((edit.place.line, edit.text) for edit in edits))


def difference(report: Report, unsafe: bool) -> str:
    """What the fixes would change, as a unified diff; empty where there is nothing to fix."""
    return fixes.unified_diff(fixes.apply(fixes.fixable(report.findings, unsafe), inside=report.inside))
