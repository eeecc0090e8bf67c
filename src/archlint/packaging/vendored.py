"""Packages that a workspace holds and that others maintain: copies and submodules of drivers, libraries and the like.

Nothing says so outright.  A package counts as one of them if something shows that it was copied (``clones.py``), and
nothing speaks against it: nobody who maintains it, or has written it, has a part in the packages of which that cannot
be said, and it needs none of these.  A copy with another name is a beginning of one's own.  Where most of a workspace
looks like that, it is the workspace of those who maintain these packages.
"""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Set
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.packaging.clones import (
    clone_around,
    clone_of_file,
    is_a_release,
    is_a_repository,
    is_in,
    is_published,
    repositories_around,
)
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_HISTORY = "CHANGELOG.rst"
"""What ``catkin_generate_changelog`` writes into each package of a repository that is released."""


@once
def vendored_folders(workspace: WorkspaceIndex) -> frozenset[str]:
    """The folders of the packages that others maintain, by their shown paths."""
    packages = workspace.manifests
    foreign = _copies(workspace)
    own = [package for folder, package in packages.items() if folder not in foreign]
    people = {person for package in own for person in package.people}
    chosen = frozenset(
        folder
        for folder in foreign
        if packages[folder].people
        and people.isdisjoint(packages[folder].people)
        and not _needs(workspace, packages[folder], own)
    )
    if not chosen:
        return chosen
    rest = packages.keys() - chosen
    copied = {_whole(workspace, folder, rest) for folder in chosen} if is_a_repository(workspace) else chosen
    return chosen if len(copied) <= len(rest) else frozenset()


def _copies(workspace: WorkspaceIndex) -> set[str]:
    """The folders of the packages that look like copies."""
    packages = workspace.manifests
    published = {folder for folder, package in packages.items() if is_published(package)}
    roots = {folder: [*repositories_around(workspace, folder)] for folder in packages}
    released = {folder for folder in packages if workspace.tree.is_file(posixpath.join(folder, _HISTORY))}
    if len(released) * 2 >= len(packages):
        released = set()  # those who maintain this workspace release it
    copies = {folder for folder in published if roots[folder] or folder in released}
    mostly = {root for folder in copies for root in roots[folder] if _is_mostly_of(root, packages, published)}
    copies |= {folder for folder in packages if not mostly.isdisjoint(roots[folder])}
    copies |= {folder for folder in packages if clone_around(workspace, folder) is not None}
    versions = {package.version for folder, package in packages.items() if folder not in published}
    copies |= {folder for folder in published if is_a_release(packages[folder], versions)}
    copies |= {folder for folder in packages if any(_is_of(packages[folder], packages[copy]) for copy in copies)}
    return copies


def _is_mostly_of(root: str, packages: Collection[str], published: Set[str]) -> bool:
    """Whether a repository holds published packages, and fewer others."""
    held = {folder for folder in packages if is_in(folder, root)}
    return len(held & published) * 2 > len(held)


def _is_of(package: Package, other: Package) -> bool:
    """Whether a package goes with another one: ``lidar_msgs`` with ``lidar``, by the same people."""
    return package.name.startswith(f"{other.name}_") and not other.people.isdisjoint(package.people)


def _needs(workspace: WorkspaceIndex, package: Package, own: Collection[Package]) -> bool:
    """Whether a package declares that it needs one outside of its repository, or its CMakeLists.txt names that."""
    around = [*repositories_around(workspace, package.relative)]
    names = {other.name for other in own if not any(is_in(other.relative, root) for root in around)}
    installs = workspace.installs.get(package.name)
    words = frozenset[str]() if installs is None else installs.words
    return any(dependency.name in names for dependency in package.dependencies) or not names.isdisjoint(words)


def _whole(workspace: WorkspaceIndex, folder: str, rest: Collection[str]) -> str:
    """What was copied with a package: the outermost repository around it that holds nothing of the team."""
    around = [root for root in repositories_around(workspace, folder) if not any(is_in(other, root) for other in rest)]
    return [folder, *around][-1]


def vendored_package(workspace: WorkspaceIndex, file: str) -> str | None:
    """The folder of the package with a file, or of the clone around one of no package, if others maintain it."""
    package = next((folder for folder in folders_above(file) if folder in workspace.manifests), None)
    if package is None:
        return clone_of_file(workspace, file)
    return package if package in vendored_folders(workspace) else None


__all__ = ["vendored_folders", "vendored_package"]
