"""Find: which files there are to check, and the packages that they belong to."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from archlint.workspace.around import (
    ROOT_MARKS,
    has,
    is_below,
    package_around,
    within_one_workspace,
    workspace_around,
)
from archlint.workspace.membership import Read, package_of, place
from archlint.workspace.model import Package, Problem, Workspace
from archlint.workspace.pruning import COLCON_FOLDERS
from archlint.workspace.walk import Walk


class PathNotFound(Exception):
    """A path that was asked for and does not exist; ``path`` is as it was typed."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.path = path


def find(
    paths: Sequence[str],
    *,
    exclude: Sequence[str] = (),
    working_directory: str | None = None,
    read: Read | None = None,
) -> Workspace:
    """All packages and files that ``paths`` (files and folders; without any, the working directory) lead to.

    ``exclude`` are ``fnmatch`` patterns for paths from the working directory, or for the name of a file or
    folder; what is named in ``paths`` itself is taken all the same.  The rest of the package and of the
    workspace that a path lies in is found as context: what is asked for narrows what is shown, not what is known.
    ``read`` gives the bytes of manifests and build files, if not the disk.
    Raises :class:`PathNotFound` for the first path that does not exist.
    """
    here = os.path.abspath(working_directory or os.curdir)
    typed = list(paths) or [os.curdir]
    asked = [_absolute(path, here) for path in typed]
    excluder = Excluder(exclude, here)
    walk = Walk(here, excluder if exclude else None)
    folders = [path for path in asked if os.path.isdir(path)]
    asked_folders = [path if path in folders else os.path.dirname(path) for path in asked]
    # Each with its own repository: what two of them share may be the folder of a user.
    walk.inside += sorted({os.path.realpath(_root([folder])) for folder in asked_folders})
    for name, path in zip(typed, asked, strict=True):
        if path not in folders:
            _add_file(walk, name, path)
    for folder in folders:
        walk.add_folder(folder)
    packages = sorted({package for path in asked if (package := package_around(path)) is not None})
    for package in packages:
        walk.add_folder(package, context=True)
    complete_folders = [*folders, *packages, *_add_workspaces(walk, asked, read)]
    # What is read as context lies in the root, too, or no launch file of a neighbour could be read.
    root = _root(asked_folders + complete_folders)
    workspace = place(root, walk.files.values(), walk.problems.values(), complete_folders, read)
    return replace(
        workspace,
        idle_exclusions=tuple(excluder.idle),
        looked_at=tuple(walk.looked_at),
        inside=tuple(walk.inside),
        ignored_packages=tuple(sorted(walk.ignored_packages)),
    )


def _add_workspaces(walk: Walk, asked: Sequence[str], read: Read | None) -> list[str]:
    """Take the workspaces around paths as context; returns their folders."""
    around = {path: workspace for path in asked if (workspace := workspace_around(path)) is not None}
    if not around:
        return []  # what is asked for is whole: no manifest need be read for this
    before = set(walk.files)
    for workspace in sorted(set(around.values())):
        walk.add_folder(workspace, context=True)
    added = [key for key in walk.files if key not in before]
    packages = [
        (package.name, package.root)
        for file in walk.files.values()
        if file.kind == "package_xml" and isinstance(package := package_of(file, read), Package)
    ]
    kept = [
        within_one_workspace(package_around(path) or path, workspace, packages) for path, workspace in around.items()
    ]
    for key in added:
        if not any(is_below(walk.files[key].path, folder) for folder in kept):
            walk.looked_at.append(walk.files.pop(key).path)  # its package may be what narrows the workspace
    return kept


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


class Excluder:
    """Says of paths from ``here``, a folder, whether a pattern leaves them out; remembers which patterns ever did."""

    def __init__(self, patterns: Sequence[str], here: str) -> None:
        self._matches = [(pattern, _matcher(pattern, here)) for pattern in patterns]
        self.idle = list(dict.fromkeys(patterns))

    def __call__(self, shown: str) -> bool:
        name = shown.rpartition("/")[2]
        hits = [
            pattern
            for pattern, matches in self._matches
            if matches(shown) or ("/" not in pattern.rstrip("/") and matches(name))
        ]
        for pattern in hits:
            if pattern in self.idle:
                self.idle.remove(pattern)
        return bool(hits)


def _matcher(pattern: str, here: str) -> Callable[[str], object]:
    """Says whether a pattern is for a path.  One that leads upwards (``../tools/*``) is also for paths that do not:
    those in ``here`` itself, where that is ``tools``."""
    from fnmatch import translate

    pattern = pattern.removeprefix("./").rstrip("/")
    upwards = 0
    while pattern.startswith("../"):
        pattern, upwards = pattern.removeprefix("../"), upwards + 1
    matches = re.compile(translate(pattern)).match
    if not upwards:
        return matches
    above = "/".join(here.replace(os.sep, "/").split("/")[-upwards:])
    return lambda path: matches(os.path.normpath(f"{above}/{path}").replace(os.sep, "/"))


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
            return package_around(common) or common
        folder = parent
    return folder


def _is_root(folder: str) -> bool:
    built = has(folder, "src") and any(has(folder, name) for name in COLCON_FOLDERS)
    return built or any(has(folder, mark) for mark in ROOT_MARKS)
