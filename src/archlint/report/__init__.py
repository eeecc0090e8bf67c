"""Show findings: one pure function a format, from a report to text."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.report.model import Report

FORMATS = ("text", "concise", "json", "sarif", "github", "gitlab", "junit")
"""Each is a module of this package with a function ``render``; a new format is a new row."""

FOR_PEOPLE = ("text", "concise", "github")
"""Formats that say nothing where nothing was found, so that a summary beside them is welcome."""

LASTING = ("text", "concise")
"""Formats that tell the same of the same findings: the others tell how long it took, or a service's own paths."""

WITH_FIXES = frozenset({"json"})
"""Formats that show the edits of fixes."""


def render(format: str, report: Report, color: bool = False) -> str:
    """The report in a format of :data:`FORMATS`; only ``text`` knows colours."""
    module = importlib.import_module(f"archlint.report.{format}")
    text: str = module.render(report, color=color) if format == "text" else module.render(report)
    return text
