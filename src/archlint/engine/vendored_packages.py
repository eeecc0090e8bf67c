"""Findings in packages that others maintain: they are counted and not shown, for nobody here mends them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.checks.registry import registered
from archlint.packaging.vendored import vendored_folders, vendored_package
from archlint.workspace.around import is_below

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex

_OF_DECLARATIONS = ("ARC", "OWN003", "LNT")
"""Rules about what a team declares, and about what archlint itself could not read."""


def without_vendored(
    index: WorkspaceIndex, findings: Sequence[Finding], request: Request
) -> tuple[list[Finding], list[Finding]]:
    """The findings that are shown, and those that are not, for all that they are about is in packages that others
    maintain.  All are shown where the settings want all files, and those below a path that was asked for and that
    holds nothing else."""
    if request.settings.unused_files:
        return list(findings), []
    named = [path for path in map(os.path.abspath, request.paths) if not _holds_own(index, path)]
    shown: list[Finding] = []
    hidden: list[Finding] = []
    for finding in findings:
        asked_for = any(is_below(os.path.abspath(finding.place.file), path) for path in named)
        (hidden if not asked_for and _is_vendored(index, finding) else shown).append(finding)
    return shown, hidden


def _is_vendored(index: WorkspaceIndex, finding: Finding) -> bool:
    if finding.code not in registered() or finding.code.startswith(_OF_DECLARATIONS):
        return False
    files = {finding.place.file, *(related.place.file for related in finding.related)}
    return all(vendored_package(index, file) is not None for file in files)


def _holds_own(index: WorkspaceIndex, path: str) -> bool:
    """Whether a path holds a package of those who ask, or lies in none that others maintain."""
    vendored = vendored_folders(index)
    roots = {os.path.abspath(package.root): folder in vendored for folder, package in index.manifests.items()}
    held = [of_others for root, of_others in roots.items() if is_below(root, path)]
    if held:
        return not all(held)
    in_clone = vendored_package(index, os.path.join(os.path.relpath(path), "file")) is not None
    return not (in_clone or any(is_below(path, root) for root, of_others in roots.items() if of_others))


__all__ = ["without_vendored"]
