"""Paths of files, and the addresses under which an editor knows them."""

from __future__ import annotations

import os
from collections.abc import Mapping

from pygls.uris import from_fs_path, to_fs_path


def path_of(uri: str) -> str | None:
    """The absolute path of a file; None for what is no file on this machine."""
    if not uri.startswith("file:"):
        return None
    path = to_fs_path(uri)
    return None if not path else os.path.normpath(path)


class Addresses:
    """Addresses by path: those that the editor has used itself, spelt as it spells them."""

    def __init__(self, known: Mapping[str, str]) -> None:
        self._known = known

    def of(self, path: str) -> str:
        return self._known.get(path) or from_fs_path(path) or path


__all__ = ["Addresses", "path_of"]
