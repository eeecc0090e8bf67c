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
    from archlint.workspace.model import Package

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
    every = (package for package in workspace.manifests.values() if not package.ros1)
    return tuple(name for package in every for name in absent_dependencies_of(workspace, package))


def absent_dependencies_of(workspace: WorkspaceIndex, package: Package) -> tuple[str, ...]:
    """What a package declares that is neither ROS's nor the system's, nor here."""
    known = (packages.table().names, workspace.packages.keys(), rosdep.keys())
    return tuple(
        dependency.name
        for dependency in package.dependencies
        if condition_holds(dependency.condition) and not any(dependency.name in names for names in known)
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
    return frozenset[str]().union(*_repositories_by_list(workspace).values())


@once
def _repositories_by_list(workspace: WorkspaceIndex) -> dict[str, frozenset[str]]:
    """The repositories that are not here, by the ``.repos`` file that lists them."""
    here = _folders_with_packages(workspace)
    lists = (path for path in workspace.tree.files_below(workspace.tree.top) if path.endswith(_LISTS))
    texts = ((path, workspace.tree.text(path) or "") for path in lists)
    return {path: frozenset(_plain(_name(row)) for row in _REPOSITORY.findall(text)) - here for path, text in texts}


def list_of_repositories(workspace: WorkspaceIndex) -> str:
    """The first ``.repos`` file with a repository that is not here, which may bring any package; empty where there is
    none."""
    return next((path for path, names in _repositories_by_list(workspace).items() if names), "")


def _folders_with_packages(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names of the folders in which packages are: a repository that is here brings no other."""
    return frozenset(_plain(part) for folder in workspace.manifests for part in folder.split("/"))


def is_fetched(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether a ``.repos`` file lists a repository with the name of a package, but for its underscores, that is not
    here, or with what its name begins with: ``laser_board`` brings ``laser_board_msgs``."""
    return any(_plain(name) in _repositories(workspace) for name in (package, *_beginnings(package)))


def unknown_repository(workspace: WorkspaceIndex, package: str) -> str:
    """The repository that is not here, and of which nobody knows what is in it, where nothing else tells where a
    package may be; empty where something does, or there is none."""
    unknown = _unknown_repositories(workspace)
    named = _has_a_place(workspace, package) or _is_in_a_named_submodule(workspace, package)
    return unknown[0] if unknown and not named else ""


def may_be_in_a_submodule(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the name of a git submodule that is not checked out, or of a repository that a script clones, has the
    word with which that of a package begins: ``arm_ros`` may bring ``arm_description``, and so may ``acme_arm``.  Or
    whether it has the whole name of the package in it: ``ros-imu-bno`` brings ``imu_bno``, and ``imu-ros2-bno`` too.
    One that no ``.gitmodules`` names is an empty folder or file, and nobody knows what is in it."""
    if _has_a_place(workspace, package) or _unknown_repositories(workspace):
        return True
    return _is_in_a_named_submodule(workspace, package)


def _is_in_a_named_submodule(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether a submodule or repository that is not here has the words of a package in its own name, or its first."""
    first, *others = words = re.split(r"[_-]", package.lower())
    absent = _absent_submodules(workspace)
    if others and any({*words}.issubset(re.split(r"[_-]", name.lower())) for name in absent):
        return True
    return len(first) > _SHORT and any(first in _submodule_words(name) for name in absent)


def _has_a_place(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether there is nothing but a place for a package, or for what its name begins with, where packages lie:
    ``arm_x1`` for ``arm_x1_ros2``.  A ``.gitignore`` may name that place, for a repository in this one."""
    names = [package, *_beginnings(package)]
    paths = [posixpath.normpath(posixpath.join(parent, name)) for parent in _parents(workspace) for name in names]
    if any(_is_empty_folder(workspace, path) or _is_link_of_git(workspace, path) for path in paths):
        return True
    return package in _ignored_folders(workspace)


def _beginnings(package: str) -> list[str]:
    """What a name begins with before each underscore, but for what is short or is only about a theme."""
    names = (package[:at] for at, letter in enumerate(package) if letter == "_" and at > _SHORT)
    return [name for name in names if name not in _THEMES]


def _is_empty_folder(workspace: WorkspaceIndex, path: str) -> bool:
    return workspace.tree.is_folder(path) and not workspace.tree.files_below(path)


def _is_link_of_git(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether there is an empty file in the place of a folder: what some archives have for a repository in another."""
    return workspace.tree.is_file(path) and not workspace.tree.text(path)


@once
def _unknown_repositories(workspace: WorkspaceIndex) -> tuple[str, ...]:
    """The names of such files where packages lie, but for those that are names of packages."""
    parents = {*_parents(workspace)}
    every = workspace.tree.files_below(workspace.tree.top)
    beside = (path for path in every if posixpath.dirname(path) in parents and _REPOSITORY_NAME.fullmatch(_name(path)))
    declared = {row.name for package in workspace.manifests.values() for row in package.dependencies}
    known = packages.table().names | declared
    return tuple(_name(path) for path in beside if _is_link_of_git(workspace, path) and _name(path) not in known)


_REPOSITORY_NAME = re.compile(r"(?=.*[a-z])[A-Za-z0-9][\w-]*")
"""No ``COLCON_IGNORE``, and no file with an ending."""

_SCRIPT = re.compile(r".*\.(?:sh|bash)|[^/]*[Dd]ockerfile[^/]*")
_CLONE = re.compile(r"\bgit clone\b[^\n]*?(?:://|@)[^\s'\"]*/([\w-]+?)(?:\.git)?/?(?=[\s'\"]|$)")


@once
def _cloned(workspace: WorkspaceIndex) -> tuple[str, ...]:
    """The names of the repositories that scripts of the workspace clone."""
    every = workspace.tree.files_below(workspace.tree.top)
    texts = [workspace.tree.text(path) or "" for path in every if _SCRIPT.fullmatch(posixpath.basename(path))]
    return tuple(dict.fromkeys(name for text in texts for name in _CLONE.findall(text)))


_FOLDER = re.compile(r"^[ \t]*/?(?:[\w.-]+/)*src/([\w-]+)/?[ \t\r]*$", re.MULTILINE)


@once
def _ignored_folders(workspace: WorkspaceIndex) -> frozenset[str]:
    """The folders in a ``src`` that a ``.gitignore`` names one by one: packages that the team keeps elsewhere."""
    every = workspace.tree.files_below(workspace.tree.top)
    texts = [workspace.tree.text(path) or "" for path in every if posixpath.basename(path) == ".gitignore"]
    return frozenset(name for text in texts for name in _FOLDER.findall(text))


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
def _parents(workspace: WorkspaceIndex) -> tuple[str, ...]:
    """The folders in which packages lie."""
    return tuple(sorted({posixpath.dirname(folder) for folder in workspace.manifests if folder not in ("", ".")}))


@once
def _absent_submodules(workspace: WorkspaceIndex) -> tuple[str, ...]:
    """The names of all repositories that the workspace says it has and that are not there."""
    every = workspace.tree.files_below(workspace.tree.top)
    folders = {folder for path in every for folder in posixpath.dirname(path).split("/")}
    text = workspace.tree.text(posixpath.join(workspace.tree.top, ".gitmodules")) or ""
    names = [*map(_name, paths_of_submodules(text)), *_cloned(workspace)]
    return tuple(name for name in names if name not in folders)


def _plain(name: str) -> str:
    return re.sub(r"[_-]", "", name).lower().removesuffix(".git")


def _name(path: str) -> str:
    return posixpath.basename(path.rstrip("/"))


__all__ = [
    "absent_dependencies_of",
    "has_parts_elsewhere",
    "is_fetched",
    "list_of_repositories",
    "may_be_in_a_submodule",
    "may_come_with_another",
    "unknown_repository",
]
