"""Findings for people: what, where in the code, the related places, and what to write instead."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.report.frames import Line, Style, frames
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


def render(report: Report, color: bool = False) -> str:
    paint = _painter() if color else _plain
    blocks = []
    for finding in report.findings:
        lines = _lines(finding, report.source_line)
        blocks.append("".join("".join(paint(*piece) for piece in line) + "\n" for line in lines))
    return "\n".join(blocks)


def _lines(finding: Finding, source_line: SourceLine) -> Iterator[Line]:
    severity = finding.severity.label
    yield [
        (severity, f"{severity}[{finding.code}]"),
        ("plain", f" {finding.name}: "),
        ("message", visible(finding.message)),
    ]
    body = list(frames(finding, source_line))
    yield from body
    margin = " " * max(body[0][0][1].find("-->"), 0)
    if finding.system is not None:
        yield [("gutter", f"{margin} = "), ("help", "system: "), ("plain", visible(finding.system))]
    if finding.help:
        yield [("gutter", f"{margin} = "), ("help", "help: "), ("plain", visible(finding.help))]


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
