"""``find_packages()`` as setuptools searches: nothing is imported, the folders are listed.

Source: ``PackageFinder`` and ``PEP420PackageFinder`` of setuptools/discovery.py.
"""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Sequence
from fnmatch import fnmatchcase
from typing import Protocol

from archlint.workspace.folders import folders_above


class Listing(Protocol):
    """The files of the workspace by shown paths."""

    def files_below(self, folder: str) -> Sequence[str]: ...


def found_packages(
    tree: Listing, where: str, include: Collection[str], exclude: Collection[str], *, namespaces: bool
) -> list[str]:
    """The names of the packages below a folder, sorted; with ``namespaces`` a folder needs no ``__init__.py``."""
    start = "" if where == "." else f"{where}/"
    below = [path.removeprefix(start) for path in tree.files_below(where)]
    folders = {parent for path in below for parent in folders_above(path)}
    marked = {posixpath.dirname(path) for path in below if posixpath.basename(path) == "__init__.py"}
    taken: list[str] = []
    for folder in sorted(folders):
        if "." in folder or not (namespaces or all(parent in marked for parent in (folder, *folders_above(folder)))):
            continue
        name = folder.replace("/", ".")
        if _matches(name, include) and not _matches(name, exclude):
            taken.append(name)
    return taken


def _matches(name: str, patterns: Collection[str]) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in patterns)


__all__ = ["found_packages"]
