"""JUnit XML, which colcon and CI services collect as test results: a finding is a failed test."""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import Report


def render(report: Report) -> str:
    count = len(report.findings)
    cases = "".join(_failed(finding) for finding in report.findings) or _passed()
    seconds = f"{report.summary.elapsed_s:.3f}"
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<testsuites tests="{max(count, 1)}" failures="{count}" errors="0" time="{seconds}">\n'
        f'<testsuite name="archlint" tests="{max(count, 1)}" failures="{count}" errors="0" skipped="0"'
        f' time="{seconds}">\n{cases}</testsuite>\n</testsuites>\n'
    )


def _passed() -> str:
    return '<testcase classname="archlint" name="no findings"/>\n'


def _failed(finding: Finding) -> str:
    place = finding.place
    where = f"{place.file}:{place.line}:{place.column}"
    related = [
        f"{one.place.file}:{one.place.line}:{one.place.column}: {one.message}" for one in finding.related
    ]
    lines = [f"{where}: {finding.message}", *related, finding.help]
    text = "\n".join(visible(line) for line in lines if line)
    return (
        f"<testcase classname={_attribute(f'archlint.{finding.code}')}"
        f" name={_attribute(f'{finding.code} {finding.name} ({where})')}"
        f' file={_attribute(place.file)} line="{place.line}">\n'
        f"<failure type={_attribute(finding.severity.label)} message={_attribute(finding.message)}>"
        f"{escape(text)}</failure>\n</testcase>\n"
    )


def _attribute(text: str) -> str:
    return quoteattr(visible(text))
