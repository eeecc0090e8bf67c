"""Reads files of the workspace by the paths that findings show, and nothing outside of it."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

TEXT_LIMIT = 8_000_000
"""Bytes; a launch or parameter file that is larger is not read."""
ENTRIES = 20_000
"""How many files one folder listing may name."""


class SourceTree:
    """The files below one folder.  Paths are relative to it, with ``/``; a path that leads out of ``within``
    does not exist as far as this class is concerned."""

    def __init__(self, base: Path, within: Path | None = None) -> None:
        self.base = base
        self._within = os.path.realpath(within or base)
        self._listed: dict[str, list[str]] = {}
        self.asked: dict[str, None] = {}
        """Every path that an answer depended on, for whoever caches answers."""

    def _real(self, path: str) -> Path | None:
        self.asked.setdefault(path)
        if "\0" in path:
            return None
        real = os.path.realpath(self.base / path)
        inside = real == self._within or real.startswith(self._within.rstrip(os.sep) + os.sep)
        return Path(real) if inside else None

    def is_file(self, path: str) -> bool:
        real = self._real(path)
        return real is not None and real.is_file()

    def is_folder(self, path: str) -> bool:
        real = self._real(path)
        return real is not None and real.is_dir()

    def text(self, path: str) -> str | None:
        """A regular file's text; None where there is none, it is too large, or it cannot be decoded: XML by the
        encoding that it names, all else as UTF-8."""
        real = self._real(path)
        try:
            if real is None or not real.is_file() or real.stat().st_size > TEXT_LIMIT:
                return None
            return _decoded(real.read_bytes())
        except (OSError, UnicodeDecodeError):
            return None

    def unreadable(self, path: str) -> str | None:
        """Why a file that is there has no :meth:`text`; None where it has one, or is not there."""
        real = self._real(path)
        try:
            if real is None or not real.is_file():
                return None
            if real.stat().st_size > TEXT_LIMIT:
                return f"the file is too large to analyse: the limit is {TEXT_LIMIT // 1000} kB"
            _decoded(real.read_bytes())
        except OSError as error:
            return f"cannot read this file: {error.strerror or error}"
        except UnicodeDecodeError as error:
            return f"byte 0x{error.object[error.start]:02x} is no {error.encoding}: save the file as UTF-8"
        return None

    def same_file(self, path: str, files: Iterable[SourceFile]) -> SourceFile | None:
        """The file that a path leads to through symbolic links; None where that is none of ``files``."""
        real = self._real(path)
        if real is None:
            return None
        try:
            inode = real.stat().st_ino
        except OSError:
            return None
        candidates = (file for file in files if file.inode == inode)
        return next((file for file in candidates if os.path.realpath(file.path) == str(real)), None)

    def files_below(self, folder: str) -> list[str]:
        """All files below a folder, sorted; links to folders are not followed."""
        folder = posixpath.normpath(folder)
        if folder not in self._listed:
            self._listed[folder] = self._list(folder)
        return self._listed[folder]

    def _list(self, folder: str) -> list[str]:
        real = self._real(folder)
        found: list[str] = []
        if real is None:
            return found
        for top, folders, names in os.walk(real):
            folders[:] = sorted(name for name in folders if not name.startswith((".", "__pycache__")))
            below = Path(top).relative_to(real).as_posix()
            for name in names:
                found.append(posixpath.normpath(posixpath.join(folder, below, name)))
            if len(found) > ENTRIES:
                break
        return sorted(found)


_XML_ENCODING = re.compile(
    rb"""\s*<\?xml[^>]*\sencoding\s*=\s*["'](iso-8859-1|iso-8859-15|windows-1252)["']""", re.IGNORECASE
)


def _decoded(data: bytes) -> str:
    named = _XML_ENCODING.match(data)
    return data.decode("utf-8-sig" if named is None else named[1].decode("ascii"))
