"""Findings for people: what, where in the code, the related places, and what to write instead."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.report.fix_marks import mark
from archlint.report.frames import UNLIMITED, Line, Style, frames, wrapped
from archlint.report.groups import grouped
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import Report, SourceLine

_STYLES: Mapping[Style, str] = {
    "error": "bold red",
    "warning": "bold yellow",
    "info": "bold blue",
    "related": "blue",
    "gutter": "blue",
    "path": "bold",
    "message": "bold",
    "help": "bold cyan",
}

NARROWEST = 24
"""Columns; lines are not wrapped to fewer."""
_INDENT = 4
"""Cells before the lines of a message after the first."""


def render(report: Report, color: bool = False, columns: int | None = None) -> str:
    """The findings; ``columns`` is the width of the terminal that they are for: there, errors come last, next to the
    prompt.  Without one they are in the order of the files, and no message is wrapped, so that what reads them finds a
    message on one line."""
    paint = _painter() if color else _plain
    room = UNLIMITED if columns is None else max(columns, NARROWEST)
    blocks: list[list[Line]] = []
    for heading, findings in grouped(report):
        if columns is not None:
            findings = sorted(findings, key=lambda finding: finding.severity)
        blocks += [[[("path", heading)]]] if heading else []
        blocks += [list(_lines(finding, report.source_line, room)) for finding in findings]
    return "\n".join("".join("".join(paint(*piece) for piece in line) + "\n" for line in block) for block in blocks)


def _lines(finding: Finding, source_line: SourceLine, columns: int) -> Iterator[Line]:
    severity = finding.severity.label
    head: Line = [(severity, f"{severity}[{finding.code}]"), ("plain", f" {finding.name}: ")]
    if fixable := mark(finding):
        head.insert(1, ("help", f" {fixable.strip()}"))
    yield from wrapped(head, ("message", visible(finding.message)), columns, _INDENT)
    body = list(frames(finding, source_line, columns))
    yield from body
    margin = " " * max(body[0][0][1].find("-->"), 0)
    for title, text in (("system", finding.system), ("help", finding.help)):
        if text:
            start: Line = [("gutter", f"{margin} = "), ("help", f"{title}: ")]
            yield from wrapped(start, ("plain", visible(text)), columns)


def _plain(style: Style, text: str) -> str:
    return text


def _painter() -> Callable[[Style, str], str]:
    """A function that puts a text in the colours of a style; only the eight that every theme defines."""
    from rich import style as rich_style
    from rich.color import ColorSystem

    styles = {name: rich_style.Style.parse(definition) for name, definition in _STYLES.items()}

    def paint(style: Style, text: str) -> str:
        known = styles.get(style)
        return text if known is None else known.render(text, color_system=ColorSystem.STANDARD)

    return paint
