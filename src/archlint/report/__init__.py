"""Show findings: one pure function a format, from a report to text."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final, Literal

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.report.model import Report

FormatName = Literal["text", "concise", "json", "sarif", "github", "gitlab", "junit"]
"""Each is a module of this package with a function ``render``."""


@dataclass(frozen=True)
class Format:
    """What a format shows."""

    laid_out: bool = False
    """Whether its function takes colours and the width of a terminal."""
    for_people: bool = False
    """Whether it says nothing where nothing was found, so that a summary beside it is welcome."""
    arranged: bool = False
    """Whether it may group findings and leave out some: people read it from the top."""
    lasting: bool = False
    """Whether it says the same of the same findings: others say how long it took, or have a service's own paths."""
    with_fixes: bool = False
    """Whether it shows the edits of fixes, or which findings have some."""


FORMATS: Final[Mapping[FormatName, Format]] = {
    "text": Format(laid_out=True, for_people=True, arranged=True, lasting=True, with_fixes=True),
    "concise": Format(for_people=True, arranged=True, lasting=True, with_fixes=True),
    "json": Format(with_fixes=True),
    "sarif": Format(),
    "github": Format(for_people=True),
    "gitlab": Format(),
    "junit": Format(),
}
"""A new format is a new row."""


def render(format: FormatName, report: Report, color: bool = False, columns: int | None = None) -> str:
    """The report in a format of :data:`FORMATS`; ``columns`` is the width of the terminal that it is for, if any."""
    module = importlib.import_module(f"archlint.report.{format}")
    text: str = module.render(report, color, columns) if FORMATS[format].laid_out else module.render(report)
    return text
