"""The files of a workspace as somebody has written them down: a tree that needs no disk."""

from __future__ import annotations

import errno
import os
import posixpath
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from archlint.workspace.folders import folders_above
from archlint.workspace.tree import ENTRIES, SourceTree

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

_MOST_LINKS = 40
"""How many symbolic links one path may lead through, as on Linux."""


class Entry(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True, gc=False):
    """What lies at a path: a file with ``data``, a symbolic link, or a file that could not be read (``errno``); else a
    file whose content was left out."""

    data: bytes | None = None
    link: str | None = None
    """The path that it leads to, that of a folder with ``/`` at the end; empty for a file out of the folder, and for
    what is no file."""
    errno: int = 0

    @property
    def leads_to_folder(self) -> bool:
        return self.link is not None and self.link.endswith("/")

    @property
    def is_left_out(self) -> bool:
        return self.data is None and self.link is None and not self.errno


class Snapshot(SourceTree):
    """A tree of entries by their paths, relative to ``base`` with ``/``."""

    def __init__(self, base: Path, entries: Mapping[str, Entry], folders: Iterable[str] = ()) -> None:
        super().__init__(base)
        self._entries = entries
        self._folders = frozenset(
            folder for path in (*entries, *(f"{f}/x" for f in folders)) for folder in _above(path)
        )
        self.missed: dict[str, None] = {}
        """The files whose content was asked for and was left out."""

    def given(self, path: str) -> bytes | None:
        entry = self._entry(path)
        return b"" if entry is None or entry.data is None else entry.data

    def answer(self, question: str, path: str) -> str | None:
        return self.ask((question, path))  # it never changes

    def same_file(self, path: str, files: Iterable[SourceFile]) -> SourceFile | None:
        target = self._resolved(path)
        return next((file for file in files if file.relative == target), None)

    def _kind_now(self, path: str) -> str | None:
        entry, target = self._entry(path), self._resolved(path)
        if entry is not None:
            return None if entry.link is not None else "file"
        return "folder" if target in self._folders else None

    def _content_now(self, path: str) -> bytes | None:
        entry = self._entry(path)
        if entry is None or entry.link is not None:
            return None
        if entry.errno:
            raise OSError(entry.errno, os.strerror(entry.errno), path)
        if entry.is_left_out:
            self.missed[path] = None
        return entry.data

    def _list(self, folder: str) -> list[str]:
        real = self._resolved(folder)
        if real not in self._folders:
            return []
        start = "" if real == "." else f"{real}/"
        files = (path for path, entry in self._entries.items() if not entry.leads_to_folder)
        below = (path.removeprefix(start) for path in files if path.startswith(start))
        seen = [posixpath.normpath(posixpath.join(folder, path)) for path in below if not _is_hidden(path)]
        return sorted(seen)[:ENTRIES]

    def _entry(self, path: str) -> Entry | None:
        resolved = self._resolved(path)
        return None if resolved is None else self._entries.get(resolved)

    def _resolved(self, path: str) -> str | None:
        """The path without symbolic links, as far as they are known; None for one that leads out of the folder."""
        path = posixpath.normpath(os.path.relpath(path, self.base) if os.path.isabs(path) else path).replace(
            os.sep, "/"
        )
        for _ in range(_MOST_LINKS):
            if "\0" in path or path == ".." or path.startswith("../"):
                return None
            link = next((part for part in (path, *_above(path)) if self._leads_on(part)), None)
            if link is None:
                return path
            target = self._entries[link].link
            path = posixpath.normpath(f"{target}{path.removeprefix(link)}")
        return None

    def _leads_on(self, path: str) -> bool:
        entry = self._entries.get(path)
        return entry is not None and bool(entry.link)


def _above(path: str) -> Iterable[str]:
    """The folders around a path, ``.`` last."""
    yield from folders_above(path)
    yield "."


def _is_hidden(path: str) -> bool:
    return any(part.startswith((".", "__pycache__")) for part in path.split("/")[:-1])


TOO_LARGE = errno.EFBIG

__all__ = ["TOO_LARGE", "Entry", "Snapshot"]
