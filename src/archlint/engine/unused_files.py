"""Findings in files that nothing runs: they are counted and not shown, for nobody mends what nobody starts."""

from __future__ import annotations

import os
from collections.abc import Iterable, Set
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.checks.registry import registered
from archlint.checks.scope import Scope
from archlint.packaging.disused_packages import is_in_disused_package
from archlint.packaging.unbuilt_files import runs_nowhere
from archlint.packaging.unused_files import is_earlier_version, nothing_runs

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex


def unused_files(index: WorkspaceIndex, findings: Iterable[Finding], request: Request) -> frozenset[str]:
    """The files of findings that nothing runs, but for those that the run was asked about by their names; none where
    the settings want all files shown."""
    if request.settings.unused_files:
        return frozenset()
    every = list(findings)
    named = named_files(request)
    told = [finding for finding in every if _is_of_what_runs(finding)]
    files = {file for finding in told for file in (finding.place.file, *_others_of(finding))}
    unread = {finding.place.file for finding in told if finding.code == "LNT002"}
    unused = (file for file in files if nothing_runs(index, file) or (file in unread and _is_left(index, file)))
    whole = {finding.place.file for finding in every if is_in_disused_package(index, finding.place.file)}
    return frozenset(file for file in (*unused, *whole) if os.path.abspath(file) not in named)


def named_files(request: Request) -> frozenset[str]:
    """What a run was asked about, by absolute paths."""
    return frozenset(map(os.path.abspath, request.paths))


def _is_left(index: WorkspaceIndex, file: str) -> bool:
    """Whether a file that cannot be read is nothing anybody waits for: no build takes it, or a later version has
    followed."""
    return runs_nowhere(index, file) or is_earlier_version(index, file)


def apart(index: WorkspaceIndex, findings: Iterable[Finding], files: Set[str]) -> tuple[list[Finding], list[Finding]]:
    """The findings that are shown, and those that are not, for they are in these files.  One about nodes that run
    together is shown if one of them is in another file, unless all others are put aside or are sources that nothing
    compiles."""
    shown: list[Finding] = []
    hidden: list[Finding] = []
    for finding in findings:
        own, others = finding.place.file, _others_of(finding)
        unused = own in files and (others <= files or _never_meets(index, own))
        alone = bool(others) and others <= files and all(_never_meets(index, other) for other in others)
        of_runs = _is_of_what_runs(finding) and (unused or alone)
        (hidden if of_runs or (own in files and _is_of_disused_package(index, finding)) else shown).append(finding)
    return shown, hidden


def _never_meets(index: WorkspaceIndex, file: str) -> bool:
    """Whether the nodes of a file that nothing runs meet none that run: unlike a script, which somebody may start by
    its path, it is put aside, or nothing compiles it."""
    return is_disused(index, file) or (index.code.kind_of(file) == "cpp" and runs_nowhere(index, file))


def count_of_files(findings: Iterable[Finding], files: Set[str]) -> int:
    """How many of some files findings are about."""
    return len(files & {file for finding in findings for file in (finding.place.file, *_others_of(finding))})


def _others_of(finding: Finding) -> set[str]:
    """The files of the other nodes that a finding is about."""
    check = registered().get(finding.code)
    together = check is not None and check.scope is Scope.SYSTEM
    return {related.place.file for related in finding.related if together}


def _is_of_disused_package(index: WorkspaceIndex, finding: Finding) -> bool:
    """Whether a finding is about a package that is put aside, its package.xml and setup.py with it."""
    declared = finding.code not in registered() or finding.code.startswith(_OF_DECLARATIONS)
    files = (finding.place.file, *_others_of(finding))
    return not declared and all(is_in_disused_package(index, file) for file in files)


_OF_FILES = frozenset({"PKG001"})
"""Rules about packages that tell which file of code needs what."""
_OF_DECLARATIONS = ("ARC", "OWN003")
"""Rules about what a team declares: they are shown wherever they are."""


def _is_of_what_runs(finding: Finding) -> bool:
    check = registered().get(finding.code)
    if check is None:
        return finding.code == "LNT002"
    of_code = check.scope not in (Scope.WORKSPACE, Scope.RUNNING) or finding.code in _OF_FILES
    return of_code and not finding.code.startswith(_OF_DECLARATIONS)


__all__ = ["apart", "count_of_files", "named_files", "unused_files"]
