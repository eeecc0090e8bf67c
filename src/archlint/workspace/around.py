"""The workspace around what was asked for: it is read too, so that both ends of a connection are known."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from itertools import islice

from archlint.workspace.pruning import COLCON_FOLDERS

ROOT_MARKS = (".git", "archlint.toml", ".archlint.toml")

_CLONES_DEPTH = 3
"""How many folders above a repository the ``src`` of a workspace is looked for: ``src/organisation/repository``."""


def package_around(path: str) -> str | None:
    """The folder of the ROS package that a path lies in; None if it is that folder, or in none.

    The search ends with the repository.
    """
    folder = path
    while True:
        if os.path.isfile(os.path.join(folder, "package.xml")):
            return folder if folder != path else None
        parent = os.path.dirname(folder)
        if parent == folder or has(folder, ".git"):
            return None
        folder = parent


def workspace_around(path: str) -> str | None:
    """The folder of the workspace or repository that a path lies in; None if it is that folder, or in none."""
    asked = path if os.path.isdir(path) else os.path.dirname(path)
    if _holds_workspace(asked):
        return None
    for folder in _upwards(package_around(path) or asked):
        if folder != asked and is_workspace(folder):
            return _workspace_of_clones(folder) or folder
        if is_workspace(folder):
            return _workspace_of_clones(folder)
    return None


def is_workspace(folder: str) -> bool:
    """Whether a folder is a repository, is configured, was built in by colcon, or holds a workspace's sources."""
    return (
        any(has(folder, mark) for mark in ROOT_MARKS)
        or (has(folder, "src") and _was_built_in(folder))
        or (os.path.basename(folder) == "src" and not has(os.path.dirname(folder), "package.xml"))
    )


def within_one_workspace(asked: str, workspace: str, packages: Iterable[tuple[str, str]]) -> str:
    """The widest folder from ``asked`` up to ``workspace`` whose packages all have different names.

    ``packages`` are names and folders.  A name that comes twice says that here are two workspaces, or the steps
    of a course, side by side.
    """
    named = list(packages)
    widest = asked
    for folder in _upwards(asked):
        names = [name for name, root in named if is_below(root, folder)]
        if len(names) != len(set(names)):
            return widest
        widest = folder
        if folder == workspace:
            break
    return widest


def has(folder: str, name: str) -> bool:
    return os.path.lexists(os.path.join(folder, name))


def is_below(path: str, folder: str) -> bool:
    """Whether a path is a folder or lies in it; both are absolute."""
    return path == folder or path.startswith(folder.rstrip(os.sep) + os.sep)


def _holds_workspace(folder: str) -> bool:
    return os.path.isdir(os.path.join(folder, "src")) and not has(folder, "package.xml")


def _was_built_in(folder: str) -> bool:
    return any(has(folder, name) for name in COLCON_FOLDERS)


def _workspace_of_clones(repository: str) -> str | None:
    """The ``src`` that a repository was cloned into, where colcon has built beside it."""
    above = islice(_upwards(os.path.dirname(repository)), _CLONES_DEPTH)
    return next(
        (folder for folder in above if os.path.basename(folder) == "src" and _was_built_in(os.path.dirname(folder))),
        None,
    )


def _upwards(folder: str) -> Iterator[str]:
    """A folder and those around it, below the user's home folder and the root of the file system."""
    home = os.path.expanduser("~")
    while folder not in (home, os.path.dirname(folder)):
        yield folder
        folder = os.path.dirname(folder)
