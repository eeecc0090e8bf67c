"""Lines of source files, for the frames of a report."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Collection
from pathlib import Path

from archlint.disk import lies_in, read_regular

MAX_BYTES = 1_000_000
"""Larger files are not shown."""

_COOKIE = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")


class Sources:
    """Reads files by the paths that findings show, relative to ``folder``, each once; ``given`` has the bytes of those
    that are not on the disk.  What lies, through links, outside of ``inside`` (:func:`archlint.disk.lies_in`) has no
    lines to show."""

    def __init__(
        self,
        given: Callable[[str], bytes | None] = lambda file: None,
        folder: Path = Path(),
        inside: Collection[str] = (),
    ) -> None:
        self._given = given
        self._folder = folder
        self._inside = inside
        self._lines: dict[str, list[str]] = {}

    def line(self, file: str, number: int) -> str | None:
        """A line of a file, from 1; None where there is none."""
        lines = self._lines.get(file)
        if lines is None:
            lines = self._lines[file] = self._read(file)
        return lines[number - 1] if 0 < number <= len(lines) else None

    def _read(self, file: str) -> list[str]:
        """Lines without their ends, as Python parts them; none where the file is not readable text."""
        given, path = self._given(file), self._folder / file
        if given is None:
            try:
                given = read_regular(path, MAX_BYTES) if lies_in(path, self._inside) else b""
            except OSError:
                return []
        return _lines_of(_decode(given))


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
