"""Code that no package installs: what rules find in it is information, for only who knows where it lies starts it."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.checks.registry import registered
from archlint.finding import Finding, Severity

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def files_of(workspace: WorkspaceIndex, findings: Iterable[Finding]) -> frozenset[str]:
    """The files of findings about code that no package installs; none where there are no packages, for all code is
    started by its path then."""
    if not workspace.manifests:
        return frozenset()
    files = {finding.place.file for finding in findings if _is_about_code(finding)}
    return frozenset(file for file in files if is_not_installed(workspace, file))


def as_information(findings: Iterable[Finding], files: AbstractSet[str]) -> list[Finding]:
    """The findings, those about code in some files as no more than information.  What has no ending of Python besides
    is a copy that nobody can import either, and is left out."""
    rows = [(finding, finding.place.file in files and _is_about_code(finding)) for finding in findings]
    return [
        replace(finding, severity=min(finding.severity, Severity.INFO)) if aside else finding
        for finding, aside in rows
        if not aside or finding.place.file.endswith(_ENDINGS)
    ]


_ENDINGS = (".py", ".pyw")


def with_reason(findings: Iterable[Finding], files: AbstractSet[str]) -> list[Finding]:
    """The findings, with the reason why some are only information in their message."""
    return [
        replace(finding, message=f"{finding.message}; no installed program uses this file")
        if finding.place.file in files and finding.severity is Severity.INFO and _is_about_code(finding)
        else finding
        for finding in findings
    ]


def _is_about_code(finding: Finding) -> bool:
    check = registered().get(finding.code)
    return check is not None and check.scope.of_code and not check.says_if_installed


__all__ = ["as_information", "files_of", "with_reason"]
