"""Code that no package installs: what rules find in it is information, for only who knows where it lies starts it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.checks.folding import with_others
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
_OF_CALLS = ("API", "EXE", "SRV", "TMO")


def once_for_a_file(findings: Iterable[Finding], files: AbstractSet[str]) -> list[Finding]:
    """The findings, those that are information for this reason with the reason in their message.  What a rule says of
    calls and waits in one such file is one finding, and so is the same in a copy beside it; each wrong name and message
    stays."""
    of_files: dict[tuple[str, str, str | None, int | None], list[Finding]] = {}
    shown: list[Finding] = []
    for number, finding in enumerate(findings):
        if finding.place.file in files and finding.severity is Severity.INFO and _is_about_code(finding):
            apart = None if finding.code.startswith(_OF_CALLS) else number
            of_files.setdefault((finding.code, finding.place.file, finding.system, apart), []).append(finding)
        else:
            shown.append(finding)
    of_copies: dict[tuple[object, ...], list[Finding]] = {}
    for (code, file, _, apart), row in of_files.items():
        finding = _first_of(row, "another line like it", "more lines like it")
        # The line and the message are those of a copy, which may have other values.
        twin = posixpath.dirname(file), finding.message, finding.place.line
        of_copies.setdefault((code, *twin, apart), []).append(finding)
    copies = (_first_of(row, "so does a copy beside it", "copies beside it do, too") for row in of_copies.values())
    reason = "; no installed program uses this file"
    return [*shown, *(replace(finding, message=f"{finding.message}{reason}") for finding in copies)]


def _first_of(findings: Sequence[Finding], another: str, more: str) -> Finding:
    """The first finding for all; the message ends with how many others there are."""
    ordered = sorted(findings, key=lambda finding: finding.sort_key)
    return with_others(ordered, another, more) if len(ordered) > 1 else ordered[0]


def _is_about_code(finding: Finding) -> bool:
    check = registered().get(finding.code)
    return check is not None and check.scope.of_code and not check.says_if_installed


__all__ = ["as_information", "files_of", "once_for_a_file"]
