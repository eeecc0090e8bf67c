"""The package.xml files of a workspace: which one is around a file."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_LEVELS = 60
"""How many folders upwards a package.xml is looked for; the tree answers for nothing above the workspace."""


def package_around(workspace: WorkspaceIndex, folder: str) -> Package | None:
    """The package whose package.xml is the nearest one upwards from a folder; None where that one makes no package."""
    return kept(workspace, (package_around, folder), lambda: _nearest(workspace, folder))


def _nearest(workspace: WorkspaceIndex, folder: str) -> Package | None:
    for _ in range(_LEVELS):
        if workspace.tree.is_file(posixpath.normpath(posixpath.join(folder, "package.xml"))):
            return workspace.manifests.get(folder)
        folder = posixpath.normpath(posixpath.join(folder, ".."))
    return None
