"""Workflow commands, which GitHub Actions shows as annotations of the changed lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Finding, Severity
from archlint.report.paths import findings_in_repository
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.report.model import Report

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def render(report: Report) -> str:
    return "".join(_annotation(finding) + "\n" for finding in findings_in_repository(report))


def _annotation(finding: Finding) -> str:
    place = finding.place
    properties = {
        "file": place.file,
        "line": place.line,
        "endLine": place.end_line,
        "title": f"{finding.code} {finding.name}",
    }
    if place.line == place.end_line:  # columns of an annotation of several lines are refused
        properties |= {"col": place.column, "endColumn": place.end_column}
    listed = ",".join(f"{name}={_property(str(value))}" for name, value in properties.items())
    return f"::{_COMMANDS[finding.severity]} {listed}::{_data(_text(finding))}"


def _text(finding: Finding) -> str:
    """The message with its help, after the place and the code for those who read the plain log."""
    place = finding.place
    head = f"{place.file}:{place.line}:{place.column}: {finding.code} {finding.message}"
    return "\n".join(visible(line) for line in (head, finding.help) if line)


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(visible(text)).replace(":", "%3A").replace(",", "%2C")
