"""Packages that a workspace holds and that others maintain: copies and submodules of drivers, libraries and the like.

Nothing says so outright. A package counts as one of them if all of this speaks for it: rosdistro has its name, or its
package.xml names the address of a project; it lies in a folder that has what the root of a repository has, such as a
license; and nobody who maintains it, or has written it, has a part in the packages of which that cannot be said. Where
most packages of a workspace look like that, it is the workspace of those who maintain them.
"""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.ros.packages import table
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_LICENSES = ("LICENSE", "LICENSE.txt", "LICENSE.md", "LICENCE", "COPYING", "license.txt")
_FILES = (*_LICENSES, "CONTRIBUTING.md", ".travis.yml", ".gitlab-ci.yml")
_FOLDERS = (".github",)
_HISTORY = "CHANGELOG.rst"
"""What ``catkin_generate_changelog`` writes into each package of a repository that is released."""


@once
def vendored_folders(workspace: WorkspaceIndex) -> frozenset[str]:
    """The folders of the packages that others maintain, by their shown paths."""
    packages = workspace.manifests
    released = [folder for folder in packages if workspace.tree.is_file(posixpath.join(folder, _HISTORY))]
    with_history = frozenset(released) if len(released) * 2 < len(packages) else frozenset()
    foreign = {
        folder: package
        for folder, package in packages.items()
        if _is_published(package) and (folder in with_history or _is_in_a_repository(workspace, folder))
    }
    own = {person for folder, package in packages.items() if folder not in foreign for person in package.people}
    chosen = frozenset(
        folder for folder, package in foreign.items() if package.people and own.isdisjoint(package.people)
    )
    return chosen if len(chosen) * 2 <= len(packages) else frozenset()


def vendored_package(workspace: WorkspaceIndex, file: str) -> str | None:
    """The folder of the package with a file, if others maintain it."""
    package = next((folder for folder in folders_above(file) if folder in workspace.manifests), None)
    return package if package in vendored_folders(workspace) else None


def _is_published(package: Package) -> bool:
    return package.has_address or package.name in table().names


def _is_in_a_repository(workspace: WorkspaceIndex, folder: str) -> bool:
    """Whether a folder, or one above it that holds only a part of the packages, looks like the root of a repository."""
    for around in (folder, *folders_above(folder)):
        if all(_is_below(other, around) for other in workspace.manifests):
            return False
        files = (posixpath.join(around, name) for name in _FILES)
        if any(map(workspace.tree.is_file, files)):
            return True
        if any(workspace.tree.is_folder(posixpath.join(around, name)) for name in _FOLDERS):
            return True
    return False


def _is_below(folder: str, around: str) -> bool:
    return folder == around or folder.startswith(f"{around}/")


__all__ = ["vendored_folders", "vendored_package"]
