"""Which git submodule a path lies in, as ``.gitmodules`` says: of one that is not checked out, nothing is there."""

from __future__ import annotations

import os
import re

_MAX_BYTES = 200_000
_LEVELS = 60
_PATH = re.compile(r"^[ \t]*path[ \t]*=[ \t]*(\S.*)$", re.MULTILINE)


def paths_of_submodules(text: str) -> list[str]:
    """The paths that a ``.gitmodules`` names, from its folder."""
    return [path.rstrip(" \t\r") for path in _PATH.findall(text)]


def submodule_of(link: str) -> str | None:
    """The path of the submodule, from the folder of its ``.gitmodules``, into which a symbolic link leads; None where
    it leads elsewhere.  Only the folders around the link are looked at."""
    try:
        target = os.path.normpath(os.path.join(os.path.dirname(link), os.readlink(link)))
    except OSError:
        return None
    folder = os.path.dirname(link)
    for _ in range(_LEVELS):
        for path in _paths_in(os.path.join(folder, ".gitmodules")):
            root = os.path.normpath(os.path.join(folder, path))
            if target == root or target.startswith(root + os.sep):
                return path
        folder = os.path.dirname(folder)
    return None


def _paths_in(file: str) -> list[str]:
    try:
        if not os.path.isfile(file) or os.path.getsize(file) > _MAX_BYTES:
            return []
        with open(file, encoding="utf-8", errors="replace") as stream:
            return paths_of_submodules(stream.read(_MAX_BYTES))
    except OSError:
        return []
