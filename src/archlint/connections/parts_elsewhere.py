"""Whether a workspace says itself that more belongs to it than is there."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.ros import packages, rosdep
from archlint.workspace.manifest import condition_holds
from archlint.workspace.submodules import paths_of_submodules

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_LISTS = (".repos", ".rosinstall")
"""Files with the repositories that ``vcs import`` and ``wstool`` bring into a workspace."""
_REPOSITORY = re.compile(
    r"^[ \t]+(?:(?=.*:[ \t\r]*$)|local-name:[ \t]*)['\"]?([\w./-]+)['\"]?:?[ \t\r]*$", re.MULTILINE
)


@once
def has_parts_elsewhere(workspace: WorkspaceIndex) -> bool:
    """Whether something that a workspace names as its own is not there: a package in a package.xml that is neither
    ROS's nor the system's, a submodule that is not checked out, a repository of a ``.repos`` file.  What is in it may
    be the other end of anything."""
    return _depends_on_absent(workspace) or any(not there for there in _listed(workspace))


def _depends_on_absent(workspace: WorkspaceIndex) -> bool:
    return bool(_absent_dependencies(workspace))


@once
def _absent_dependencies(workspace: WorkspaceIndex) -> tuple[str, ...]:
    known = (packages.table().names, workspace.packages.keys(), rosdep.keys())
    return tuple(
        dependency.name
        for package in workspace.manifests.values()
        for dependency in package.dependencies
        if not package.ros1 and condition_holds(dependency.condition)
        if not any(dependency.name in names for names in known)
    )


def may_come_with_another(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether a package.xml declares a package of which nothing is known whose initials are the word that a package
    begins with: ``fast_local_planner`` may bring ``flp_ros``."""
    first = re.split(r"[_-]", package.lower())[0]
    absent = _absent_dependencies(workspace)
    return len(first) >= _SHORT and any(first == _initials(name) for name in absent)


def _initials(name: str) -> str:
    return "".join(word[0] for word in re.split(r"[_-]", name.lower()) if word)


def _listed(workspace: WorkspaceIndex) -> Iterator[bool]:
    """Whether each repository that a workspace lists has files in it."""
    every = workspace.tree.files_below(workspace.tree.top)
    folders = {folder for path in every for folder in posixpath.dirname(path).split("/")}
    submodules = workspace.tree.text(posixpath.join(workspace.tree.top, ".gitmodules")) or ""
    yield from (_name(path) in folders for path in paths_of_submodules(submodules))
    for path in (path for path in every if path.endswith(_LISTS)):
        repositories = _REPOSITORY.findall(workspace.tree.text(path) or "")
        yield from (_name(repository) in folders for repository in repositories)


@once
def _repositories(workspace: WorkspaceIndex) -> frozenset[str]:
    every = workspace.tree.files_below(workspace.tree.top)
    texts = [workspace.tree.text(path) or "" for path in every if path.endswith(_LISTS)]
    return frozenset(_plain(_name(repository)) for text in texts for repository in _REPOSITORY.findall(text))


def is_fetched(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether a ``.repos`` file lists a repository with the name of a package, but for its underscores."""
    return _plain(package) in _repositories(workspace)


def may_be_in_a_submodule(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the name of a git submodule that is not checked out has the word with which that of a package begins:
    ``arm_ros`` may bring ``arm_description``, and so may ``acme_arm``.  Or whether it has the whole name of the package
    in it: ``ros-imu-bno`` brings ``imu_bno``.  One that no ``.gitmodules`` names is an empty folder or file."""
    first, *others = words = re.split(r"[_-]", package.lower())
    absent = _absent_submodules(workspace)
    beside = [posixpath.normpath(posixpath.join(parent, package)) for parent in _parents_of_packages(workspace)]
    if any(workspace.tree.is_folder(path) or _is_link_of_git(workspace, path) for path in beside):
        return True
    if others and any(_has_in_a_row(re.split(r"[_-]", name.lower()), words) for name in absent):
        return True
    return len(first) > _SHORT and any(first in _submodule_words(name) for name in absent)


def _is_link_of_git(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether there is an empty file in the place of a folder: what some archives have for a repository in another."""
    return workspace.tree.is_file(path) and not workspace.tree.text(path)


def _has_in_a_row(words: list[str], wanted: list[str]) -> bool:
    return any(words[at : at + len(wanted)] == wanted for at in range(len(words)))


_SHORT = 3
_COMMON = frozenset({"robot", "ros2", "robots"})
"""First words that packages of very different robots have."""
_THEMES = _COMMON | {
    *("common", "control", "controller", "description", "driver", "drivers", "image", "interfaces", "launch", "lidar"),
    *("messages", "moveit", "msgs", "navigation", "sensor", "serial", "simulation"),
}
"""Words that say in the middle of a name what a package is about."""


def _submodule_words(name: str) -> set[str]:
    first, *others = re.split(r"[_-]", name.lower())
    return ({first} - _COMMON) | ({*others} - _THEMES)


@once
def _parents_of_packages(workspace: WorkspaceIndex) -> tuple[str, ...]:
    return tuple(sorted({posixpath.dirname(folder) for folder in workspace.manifests if folder}))


@once
def _absent_submodules(workspace: WorkspaceIndex) -> tuple[str, ...]:
    every = workspace.tree.files_below(workspace.tree.top)
    folders = {folder for path in every for folder in posixpath.dirname(path).split("/")}
    text = workspace.tree.text(posixpath.join(workspace.tree.top, ".gitmodules")) or ""
    return tuple(name for path in paths_of_submodules(text) if (name := _name(path)) not in folders)


def _plain(name: str) -> str:
    return re.sub(r"[_-]", "", name).lower().removesuffix(".git")


def _name(path: str) -> str:
    return posixpath.basename(path.rstrip("/"))


__all__ = ["has_parts_elsewhere", "is_fetched", "may_be_in_a_submodule", "may_come_with_another"]
