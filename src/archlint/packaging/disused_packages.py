"""Whole packages that are put aside, by the name of a folder that they lie in: nothing in use needs or starts them."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept
from archlint.packaging.run_commands import documents
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def is_in_disused_package(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file belongs to a package that is put aside, and that no package, code, launch file or document outside
    of what is put aside has a word for."""
    folder = next((above for above in folders_above(file) if above in workspace.manifests), None)
    if folder is None or not workspace.roles.is_put_aside(posixpath.join(folder, "package.xml")):
        return False
    return kept(workspace, (is_in_disused_package, folder), lambda: _is_disused(workspace, folder))


def _is_disused(workspace: WorkspaceIndex, folder: str) -> bool:
    name = workspace.manifests[folder].name
    used = [package for where, package in workspace.manifests.items() if not _is_aside(workspace, f"{where}/.")]
    if any(name in (package.name, *(needed.name for needed in package.dependencies)) for package in used):
        return False
    python = workspace.code.files_that_mention(name)
    launch = (path for path in workspace.launch_files.all() if workspace.code.mentions(path, name))
    if not all(_is_aside(workspace, path) for path in (*python, *launch)):
        return False
    command = re.compile(rf"\bros2[ \t]+(?:run|launch)[ \t]+{re.escape(name)}\s")
    return not any(
        command.search(text) for path, text in documents(workspace).items() if not _is_aside(workspace, path)
    )


def _is_aside(workspace: WorkspaceIndex, path: str) -> bool:
    return workspace.roles.is_put_aside(path)


__all__ = ["is_in_disused_package"]
