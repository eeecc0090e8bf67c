"""Files that a launch file names and that are not there."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def is_folder_missing(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether the source of a package has nothing at all in the folder of a path, from its share folder on."""
    folder = _folder(workspace, package, path)
    return folder is not None and not any(workspace.tree.files_below(folder))


def names_beside(workspace: WorkspaceIndex, package: str, path: str) -> list[str]:
    """The names of the files in the folder in which a path of a package, from its share folder on, would be; but for
    those that name the missing file themselves: they need it, too, and would include themselves."""
    folder, name = _folder(workspace, package, path), posixpath.basename(posixpath.normpath(path))
    if folder is None:
        return []
    named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])")
    files = (file for file in workspace.tree.files_below(folder) if posixpath.dirname(file) == folder)
    return [posixpath.basename(file) for file in files if not named.search(workspace.tree.text(file) or "")]


def _folder(workspace: WorkspaceIndex, package: str, path: str) -> str | None:
    installs = workspace.installs.get(package)
    if installs is None:
        return None
    inside = path if path.startswith(f"{installs.folder}/") else posixpath.join(installs.folder, path)
    return posixpath.dirname(posixpath.normpath(inside))
