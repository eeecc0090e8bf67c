"""Packages that a workspace holds and that others maintain: copies and submodules of drivers, libraries and the like.

Nothing says so outright. A package counts as one of them if all of this speaks for it: rosdistro has its name, or its
package.xml the address of a project that is called alike (a copy with another name is a beginning of one's own); it
lies in a folder that has what the root of a repository has, such as a license; nobody who maintains it, or has written
it, has a part in the packages of which that cannot be said; and it needs none of these. Where most packages of a
workspace look like that, it is the workspace of those who maintain them.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Set
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
_WORD = re.compile(r"[a-z0-9]+")
_SHORT = 3
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
    own = [package for folder, package in packages.items() if folder not in foreign]
    people, names = {person for package in own for person in package.people}, {package.name for package in own}
    chosen = frozenset(
        folder
        for folder, package in foreign.items()
        if package.people and people.isdisjoint(package.people) and not _needs(workspace, package, names)
    )
    return chosen if len(chosen) * 2 <= len(packages) else frozenset()


def _needs(workspace: WorkspaceIndex, package: Package, names: Set[str]) -> bool:
    """Whether a package declares that it needs another one, or its CMakeLists.txt names that."""
    installs = workspace.installs.get(package.name)
    words = frozenset[str]() if installs is None else installs.words
    return any(dependency.name in names for dependency in package.dependencies) or not names.isdisjoint(words)


def vendored_package(workspace: WorkspaceIndex, file: str) -> str | None:
    """The folder of the package with a file, if others maintain it."""
    package = next((folder for folder in folders_above(file) if folder in workspace.manifests), None)
    return package if package in vendored_folders(workspace) else None


def _is_published(package: Package) -> bool:
    return package.name in table().names or any(_is_called_like(address, package.name) for address in package.addresses)


def _is_called_like(address: str, name: str) -> bool:
    """Whether an address has a word of a name that is longer than an abbreviation."""
    said = _WORD.findall(address.lower())
    return any(len(word) > _SHORT and word in said for word in _WORD.findall(name.lower()))


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
