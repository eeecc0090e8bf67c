"""Folders that a build lists where they are not, and what launch files look for in them."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.packaging.uninstalled_files import listed_in_vain
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def folder_meant(workspace: WorkspaceIndex, package: str, folder: str) -> str | None:
    """The only folder of a package that has the name of a missing one and lies one level below its place, as
    ``src/config`` does instead of ``config``; both without a slash at their end."""
    installs = workspace.installs.get(package)
    if installs is None or "/" in folder.rstrip("/"):
        return None
    top, folders = "" if installs.folder == "." else f"{installs.folder}/", set()
    for file in workspace.tree.files_below(installs.folder):
        parts = file.removeprefix(top).split("/")
        own = len(parts) > 2 and parts[1] == folder.rstrip("/") and workspace.package_of(file) == package
        if own and not workspace.roles.is_trial(file):
            folders.add("/".join(parts[:2]))
    return folders.pop() if len(folders) == 1 else None


def is_told_with_its_folder(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether the build of a package lists the folder of a missing file in vain: that is said of the build (PKG004),
    and cures both, unless the one that is meant has not got the file."""
    installs = workspace.installs.get(package)
    folder = next((above for above in folders_above(path) if (package, above) in _folders_in_vain(workspace)), "")
    if installs is None or not folder:
        return False
    right = folder_meant(workspace, package, folder)
    rest = path.removeprefix(f"{folder}/")
    return right is None or workspace.tree.is_file(posixpath.join(installs.folder, right, rest))


@once
def _folders_in_vain(workspace: WorkspaceIndex) -> frozenset[tuple[str, str]]:
    rows = ((workspace.package_of(row.place.file) or "", row) for row in listed_in_vain(workspace) if row.folder)
    return frozenset((package, row.file.rstrip("/")) for package, row in rows)


def with_its_ending(workspace: WorkspaceIndex, package: str, file: str) -> str | None:
    """The interface file that a path means which lacks the ending, ``msg/Speed`` for ``msg/Speed.msg``, or has a comma
    behind it."""
    plain = file.rstrip(",")
    right = plain if plain != file else f"{file}.{posixpath.basename(posixpath.dirname(file))}"
    path = posixpath.normpath(posixpath.join(workspace.installs[package].folder, right))
    return right if workspace.tree.is_file(path) else None


__all__ = ["folder_meant", "is_told_with_its_folder", "with_its_ending"]
