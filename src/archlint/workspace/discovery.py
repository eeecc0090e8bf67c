"""Find: which files there are to check, and the packages that they belong to."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence

from archlint.workspace.membership import place
from archlint.workspace.model import Problem, Workspace
from archlint.workspace.pruning import COLCON_FOLDERS
from archlint.workspace.walk import Walk

_ROOT_MARKS = (".git", "archlint.toml", ".archlint.toml")


class PathNotFound(Exception):
    """A path that was asked for and does not exist; ``path`` is as it was typed."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.path = path


def find(
    paths: Sequence[str], *, exclude: Sequence[str] = (), working_directory: str | None = None
) -> Workspace:
    """All packages and files that ``paths`` (files and folders; without any, the working directory) lead to.

    ``exclude`` are ``fnmatch`` patterns for paths from the working directory, or for the name of a file or
    folder; what is named in ``paths`` itself is taken all the same.  The rest of the package that a path lies
    in is found as context, so that imports resolve.  Raises :class:`PathNotFound` for the first path that
    does not exist.
    """
    here = os.path.abspath(working_directory or os.curdir)
    typed = list(paths) or [os.curdir]
    asked = [_absolute(path, here) for path in typed]
    walk = Walk(here, _excluder(exclude))
    folders = [path for path in asked if os.path.isdir(path)]
    for name, path in zip(typed, asked, strict=True):
        if path not in folders:
            _add_file(walk, name, path)
    for folder in folders:
        walk.add_folder(folder)
    for package in sorted({package for path in asked if (package := _package_around(path)) is not None}):
        walk.add_folder(package, context=True)
    root = _root([path if path in folders else os.path.dirname(path) for path in asked])
    return place(root, walk.files.values(), walk.problems.values())


def _absolute(path: str, working_directory: str) -> str:
    absolute = os.path.normpath(os.path.join(working_directory, path))
    try:
        os.stat(absolute)
    except PermissionError:
        return absolute
    except (OSError, ValueError):
        raise PathNotFound(path) from None
    if not path:
        raise PathNotFound(path)
    return absolute


def _add_file(walk: Walk, typed: str, path: str) -> None:
    try:
        walk.add_file(path)
    except FileNotFoundError:
        raise PathNotFound(typed) from None
    except OSError as error:
        shown = walk.shown(path)
        walk.problems[shown] = Problem(shown, 1, 1, f"cannot be read: {error.strerror}")


def _excluder(patterns: Sequence[str]) -> Callable[[str], bool] | None:
    if not patterns:
        return None
    from fnmatch import translate

    matches = [re.compile(translate(pattern.removeprefix("./").rstrip("/"))).match for pattern in patterns]

    def excluded(shown: str) -> bool:
        name = shown.rpartition("/")[2]
        return any(match(shown) or match(name) for match in matches)

    return excluded


def _package_around(path: str) -> str | None:
    """The folder of the ROS package that a path lies in; None if it is that folder, or in none.

    The search ends with the repository.
    """
    folder = path
    while True:
        if os.path.isfile(os.path.join(folder, "package.xml")):
            return folder if folder != path else None
        parent = os.path.dirname(folder)
        if parent == folder or os.path.lexists(os.path.join(folder, ".git")):
            return None
        folder = parent


def _root(folders: Sequence[str]) -> str:
    """The folder of the repository or workspace around the folders.

    Without one it is the package around them, or the innermost folder that they share.
    """
    try:
        common = os.path.commonpath(folders)
    except ValueError:  # different drives
        return folders[0]
    folder = common
    while not _is_root(folder):
        parent = os.path.dirname(folder)
        if parent == folder:
            return _package_around(common) or common
        folder = parent
    return folder


def _is_root(folder: str) -> bool:
    def has(name: str) -> bool:
        return os.path.lexists(os.path.join(folder, name))

    return any(map(has, _ROOT_MARKS)) or (has("src") and any(map(has, COLCON_FOLDERS)))
