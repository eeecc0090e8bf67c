"""Files that a launch file names and that are not there."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def names_beside(workspace: WorkspaceIndex, package: str, path: str) -> list[str]:
    """The names of the files in the folder in which a path of a package, from its share folder on, would be; but for
    those that name the missing file themselves: they need it, too, and would include themselves."""
    installs = workspace.installs.get(package)
    if installs is None:
        return []
    inside = path if path.startswith(f"{installs.folder}/") else posixpath.join(installs.folder, path)
    folder, name = posixpath.split(posixpath.normpath(inside))
    named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])")
    files = (file for file in workspace.tree.files_below(folder) if posixpath.dirname(file) == folder)
    return [posixpath.basename(file) for file in files if not named.search(workspace.tree.text(file) or "")]
