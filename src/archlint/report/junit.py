"""JUnit XML, which colcon and CI services collect as test results.

A finding that fails the run is a failed test; any other is a test that passed and has something to say.  The xUnit
plugin of Jenkins refuses attributes that its schema (``junit-10.xsd``) does not have, so the place is in the name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import Report


def render(report: Report) -> str:
    findings = report.findings
    count = max(len(findings), 1)
    failures = sum(finding.severity >= report.failing for finding in findings)
    cases = "".join(_case(finding, finding.severity >= report.failing) for finding in findings) or _NOTHING
    seconds = f"{report.summary.elapsed_s:.3f}"
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<testsuites tests="{count}" failures="{failures}" errors="0" time="{seconds}">\n'
        f'<testsuite name="archlint" tests="{count}" failures="{failures}" errors="0" skipped="0"'
        f' time="{seconds}">\n{cases}</testsuite>\n</testsuites>\n'
    )


_NOTHING = '<testcase classname="archlint" name="no findings"/>\n'


def _case(finding: Finding, fails: bool) -> str:
    place = finding.place
    where = f"{place.file}:{place.line}:{place.column}"
    said = _failure(finding, where) if fails else f"<system-out>{escape(_text(finding, where))}</system-out>"
    return (
        f"<testcase classname={_attribute(f'archlint.{finding.code}')}"
        f" name={_attribute(f'{finding.code} {finding.name} ({where})')}>\n{said}\n</testcase>\n"
    )


def _failure(finding: Finding, where: str) -> str:
    return (
        f"<failure type={_attribute(finding.severity.label)} message={_attribute(finding.message)}>"
        f"{escape(_text(finding, where))}</failure>"
    )


def _text(finding: Finding, where: str) -> str:
    related = [
        f"{other.place.file}:{other.place.line}:{other.place.column}: {other.message}" for other in finding.related
    ]
    lines = [f"{where}: {finding.message}", *related, finding.help]
    return "\n".join(visible(line) for line in lines if line)


def _attribute(text: str) -> str:
    return quoteattr(visible(text))
