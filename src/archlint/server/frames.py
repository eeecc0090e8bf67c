"""What an editor sends, as far as it is made of frames: a header with the length of a message, and the message.

Where a frame is damaged nobody can say where the next one begins.  pygls would take all that follows for more header
and never answer again; other servers end, and editors start them anew.
"""

from __future__ import annotations

import re
from typing import BinaryIO

from archlint.visible import visible

MOST_BYTES = 100_000_000
"""Of a message: an editor sends a document as a whole, and a larger one is not analysed."""
_LONGEST_LINE = 4_096
_HEADER = re.compile(rb"([A-Za-z0-9-]+):[ \t]*([^\r\n]*?)[ \t]*\r?\n")
_SHOWN = 40


class DamagedFrame(Exception):
    """``str()`` says what is wrong."""


class Frames:
    """A stream that ends in front of the first damaged frame; :attr:`mistake` then says what is wrong with it."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._has_length = False
        self.mistake: str | None = None

    def readline(self) -> bytes:
        """The next line of a header, as pygls expects it; nothing at the end."""
        line = self._stream.readline(_LONGEST_LINE)
        if not line.endswith(b"\n") and len(line) < _LONGEST_LINE:
            return b""  # the editor is gone
        try:
            return self._checked(line)
        except DamagedFrame as error:
            self.mistake = str(error)
            return b""

    def read(self, size: int) -> bytes:
        return self._stream.read(size)

    def _checked(self, line: bytes) -> bytes:
        if not line.strip():
            if not self._has_length:
                raise DamagedFrame("a header has no Content-Length")
            self._has_length = False
            return b"\r\n"
        header = _HEADER.fullmatch(line)
        if header is None:
            raise DamagedFrame(f"'{_start_of(line)}' is no header")
        name, value = header.groups()
        if name.lower() != b"content-length":
            return line
        if not value.isdigit():
            raise DamagedFrame(f"'{_start_of(value)}' is no length")
        if len(value) > len(str(MOST_BYTES)) or int(value) > MOST_BYTES:
            raise DamagedFrame(f"a message is too large: the limit is {MOST_BYTES // 1_000_000} MB")
        self._has_length = True
        return b"Content-Length: %s\r\n" % value


def _start_of(line: bytes) -> str:
    text = visible(line.decode("utf-8", "replace").strip())
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}…"


__all__ = ["DamagedFrame", "Frames"]
