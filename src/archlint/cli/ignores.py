"""``--add-ignores``: suppress in place what is found now."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.cli.exits import UsageError
from archlint.counted import counted
from archlint.disk import lies_in
from archlint.engine.pipeline import check
from archlint.fixes import apply as fixes
from archlint.fixes.ignores import with_ignores
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.engine.pipeline import Request
    from archlint.report.model import Report

PASSES = 50
"""How often it is looked what is still found: where a rule reports the first of several places, each pass shows the
next one."""


@dataclass(frozen=True)
class Ignored:
    """The report on what is left, and what was done."""

    report: Report
    said: str


def ignore(request: Request, reason: str) -> Ignored:
    """Suppress all that a request finds and that a comment can suppress.

    Raises :class:`UsageError` where a file cannot be written.
    """
    count = 0
    files: set[str] = set()
    request = replace(request, occurrences=True, keeper=None)
    report = check(request)
    for _ in range(PASSES):
        outcome = with_ignores(_wanted(report), reason)
        if not outcome.texts:
            break
        try:
            fixes.write(outcome)
        except OSError as error:
            raise UsageError(f"cannot write {error.filename}: {error.strerror}") from None
        files.update(outcome.texts)
        before, report = report, check(request)
        count += report.summary.suppressed - before.summary.suppressed
    return Ignored(report, _said(count, len(files), report))


def _wanted(report: Report) -> dict[str, dict[int, set[str]]]:
    """The codes to suppress, by file and line; what is about archlint's own run is not."""
    wanted: dict[str, dict[int, set[str]]] = {}
    for occurrence in report.occurrences:
        mine = not occurrence.known and not occurrence.code.startswith("LNT")
        if mine and lies_in(occurrence.place.file, report.inside):
            wanted.setdefault(occurrence.place.file, {}).setdefault(occurrence.place.line, set()).add(occurrence.code)
    return wanted


def _said(count: int, files: int, report: Report) -> str:
    said = f"Suppressed {counted(count, 'finding')} in {counted(files, 'file')}."
    left = report.summary.findings
    return said if not left else f"{said} No comment can suppress the {left} that {'is' if left == 1 else 'are'} left."


__all__ = ["Ignored", "ignore"]
