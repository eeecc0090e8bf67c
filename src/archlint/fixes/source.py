"""The text of a file with its places: lines and columns of findings, and offsets."""

from __future__ import annotations

import io
import re
import tokenize
from bisect import bisect_right
from dataclasses import field
from functools import cached_property
from pathlib import Path

from archlint.disk import read_regular
from archlint.place import Place
from archlint.records import dataclass

_LINE_END = re.compile(r"\r\n|\r|\n")


@dataclass
class Source:
    """A file as text.  ``encoding`` is what it is written in; line ends are kept as they are."""

    file: str
    text: str
    encoding: str = "utf-8"
    taken: set[str] = field(default_factory=set)
    """Names that fixes of this file have brought in already."""

    @cached_property
    def starts(self) -> list[int]:
        """Offsets at which lines start."""
        return [0, *(match.end() for match in _LINE_END.finditer(self.text))]

    @property
    def newline(self) -> str:
        """How the file ends its first line."""
        match = _LINE_END.search(self.text)
        return "\n" if match is None else match[0]

    def offset(self, line: int, column: int) -> int:
        """The offset of a place; both count from 1."""
        if not 0 < line <= len(self.starts):
            raise ValueError(f"{self.file} has no line {line}")
        return self.starts[line - 1] + column - 1

    def place(self, start: int, end: int) -> Place:
        return Place(self.file, *self._position(start), *self._position(end))

    def _position(self, offset: int) -> tuple[int, int]:
        line = bisect_right(self.starts, offset)
        return line, offset - self.starts[line - 1] + 1

    def line(self, number: int) -> str:
        """A line without its end."""
        end = self.starts[number] if number < len(self.starts) else len(self.text)
        return self.text[self.starts[number - 1] : end].rstrip("\r\n")

    @property
    def lines(self) -> list[str]:
        """All lines without their ends."""
        return [self.line(number) for number in range(1, len(self.starts) + 1)]

    def has(self, place: Place) -> bool:
        """Whether the file still reaches as far as a place."""
        return place.end_line <= len(self.starts) and self.span(place)[1] <= len(self.text)

    def span(self, place: Place) -> tuple[int, int]:
        """Offsets at which a place starts and ends."""
        return self.offset(place.line, place.column), self.offset(place.end_line, place.end_column)

    def at(self, place: Place) -> str:
        """The text that stands there."""
        return self.text[slice(*self.span(place))]

    def indent(self, statement: Place) -> str | None:
        """What the line of a statement starts with; None where something else precedes the statement."""
        before = self.line(statement.line)[: statement.column - 1]
        return None if before.strip() else before

    def tokens(self, start: int, end: int) -> list[tuple[str, int, int]]:
        """Tokens that mean something in a bracketed piece of the text: text, start and end offset."""
        piece = self.text[start:end]
        tokens = []
        starts = [0, *(match.end() for match in re.finditer("\n", piece))]
        try:
            for token in tokenize.generate_tokens(io.StringIO(piece).readline):
                if token.type not in _MEANINGLESS and token.string:
                    first = starts[token.start[0] - 1] + token.start[1]
                    last = starts[token.end[0] - 1] + token.end[1]
                    tokens.append((token.string, start + first, start + last))
        except (tokenize.TokenError, IndentationError, SyntaxError):
            return []
        return tokens


_MEANINGLESS = frozenset(
    {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}
)


MAX_BYTES = 8_000_000
"""A larger file is not mended, and its names are not looked at: the largest that archlint reads at all."""


def read(file: str, given: bytes | None = None, folder: Path = Path()) -> Source | None:
    """A file as text, by its path from ``folder``, whose bytes may be ``given``; None where it cannot be read as such,
    or would not be written back byte by byte."""
    try:
        data = read_regular(folder / file, MAX_BYTES) if given is None else given
        encoding = "utf-8"
        if file.endswith(".py") or not Path(file).suffix:
            encoding = tokenize.detect_encoding(io.BytesIO(data).readline)[0]
        text = data.decode(encoding)
    except (OSError, SyntaxError, LookupError, ValueError):
        return None
    if text.startswith("\ufeff") or "\f" in text or text.encode(encoding) != data:
        return None
    return Source(file, text, encoding)
