"""Lines of source files, for the frames of a report."""

from __future__ import annotations

import io
import re
import stat
from collections.abc import Callable
from pathlib import Path

MAX_BYTES = 1_000_000
"""Larger files are not shown."""

_COOKIE = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")


class Sources:
    """Reads files by the paths that findings show, relative to ``folder``, each once; ``given`` has the bytes of those
    that are not on the disk."""

    def __init__(self, given: Callable[[str], bytes | None] = lambda file: None, folder: Path = Path()) -> None:
        self._given = given
        self._folder = folder
        self._lines: dict[str, list[str]] = {}

    def line(self, file: str, number: int) -> str | None:
        """A line of a file, from 1; None where there is none."""
        lines = self._lines.get(file)
        if lines is None:
            given = self._given(file)
            lines = self._lines[file] = _read(self._folder / file) if given is None else _lines_of(_decode(given))
        return lines[number - 1] if 0 < number <= len(lines) else None


def _read(path: Path) -> list[str]:
    """Lines without their ends, as Python parts them; none where the file is not readable text."""
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode) or status.st_size > MAX_BYTES:
            return []
        text = _decode(path.read_bytes())
    except OSError:
        return []
    return _lines_of(text)


def _lines_of(text: str) -> list[str]:
    return [line.removesuffix("\n") for line in io.StringIO(text, newline=None)]


def _decode(data: bytes) -> str:
    head = data.split(b"\n", 2)[:2]
    cookie = next((match[1] for line in head if (match := _COOKIE.match(line))), b"utf-8")
    for encoding in (cookie.decode("ascii", "replace"), "utf-8-sig"):
        try:
            text = data.decode(encoding)
        except (LookupError, ValueError):
            continue
        return text.removeprefix("\ufeff")
    return data.decode("utf-8", "replace")
