"""What an editor holds of files: their texts, saved or not."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from archlint.place import Place
from archlint.records import dataclass


@dataclass(frozen=True)
class Buffer:
    """The text of a file in an editor, as the bytes that saving it would write; ``version`` is the editor's count."""

    data: bytes
    version: int | None = None


_LINE_END = re.compile(r"\r\n|\r|\n")

_COOKIE = re.compile(r"[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")
_XML_ENCODING = re.compile(r"""\s*<\?xml[^>]*\sencoding\s*=\s*["']([-\w.]+)["']""")


def as_saved(text: str) -> bytes:
    """The bytes that an editor would write: in the encoding that the text names, else in UTF-8."""
    cookies = (match for line in text.split("\n", 2)[:2] if (match := _COOKIE.match(line)))
    named = next(cookies, None) or _XML_ENCODING.match(text)
    try:
        return text.encode("utf-8" if named is None else named[1])
    except (LookupError, ValueError):
        return text.encode("utf-8", "replace")


Buffers = Mapping[str, Buffer]
"""By absolute path.  It never changes: another state of the editor is another one."""


class Shifts:
    """Where the lines of a text are in a later one, which differs from it in one stretch."""

    def __init__(self, before: str, now: str) -> None:
        old, new = _LINE_END.split(before), _LINE_END.split(now)
        self._same = _in_common(old, new)
        shorter = min(len(old), len(new)) - self._same
        self._tail_starts = len(old) - min(shorter, _in_common(old[::-1], new[::-1]))
        self._by = len(new) - len(old)

    def of(self, place: Place) -> Place | None:
        """A place in the later text; None where its lines are not those that they were."""
        if place.end_line <= self._same:
            return place
        if place.line > self._tail_starts:
            return replace(place, line=place.line + self._by, end_line=place.end_line + self._by)
        return None


def _in_common(lines: Sequence[str], others: Sequence[str]) -> int:
    """How many lines two texts begin with alike."""
    pairs = enumerate(zip(lines, others, strict=False))
    return next((number for number, (line, other) in pairs if line != other), min(len(lines), len(others)))


__all__ = ["Buffer", "Buffers", "Shifts", "as_saved"]
