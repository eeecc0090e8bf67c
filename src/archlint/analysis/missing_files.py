"""Files that a launch file names and that are not there."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def names_beside(workspace: WorkspaceIndex, package: str, path: str) -> list[str]:
    """The names of the files in the folder in which a path of a package, from its share folder on, would be."""
    installs = workspace.installs.get(package)
    if installs is None:
        return []
    inside = path if path.startswith(f"{installs.folder}/") else posixpath.join(installs.folder, path)
    folder = posixpath.dirname(posixpath.normpath(inside))
    files = workspace.tree.files_below(folder)
    return [posixpath.basename(file) for file in files if posixpath.dirname(file) == folder]
