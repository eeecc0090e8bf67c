"""One line a finding, as compilers write it: ``file:line:column: severity: CODE [*] message``; the mark is for a safe
fix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.report.fix_marks import mark
from archlint.report.groups import grouped
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import Report


def render(report: Report) -> str:
    blocks = []
    for heading, findings in grouped(report):
        blocks.append("".join([f"{heading}\n" if heading else "", *map(_line, findings)]))
    return "\n".join(blocks)


def _line(finding: Finding) -> str:
    place = finding.place
    return (
        f"{visible(place.file)}:{place.line}:{place.column}: "
        f"{finding.severity.label}: {finding.code} {mark(finding)}{visible(finding.message)}\n"
    )
