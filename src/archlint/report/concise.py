"""One line a finding, as compilers write it: ``file:line:column: severity: CODE [*] message``; the mark is for a safe
fix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.report.fix_marks import mark
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.report.model import Report


def render(report: Report) -> str:
    return "".join(
        f"{visible(finding.place.file)}:{finding.place.line}:{finding.place.column}: "
        f"{finding.severity.label}: {finding.code} {mark(finding)}{visible(finding.message)}\n"
        for finding in report.findings
    )
