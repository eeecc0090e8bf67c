"""How wide a text is in a terminal, lines and columns of texts: wide characters take two cells, combining ones none.

All commands lay their columns out with these.  Not with rich's tables: commands that only list something
must not wait for rich, of which nothing but the widths is needed, and these only where a text is not ASCII.
"""

from __future__ import annotations

import re
import sys
import unicodedata
from collections.abc import Iterator, Sequence


def width(text: str) -> int:
    """How many cells a text takes that is safe to show."""
    if text.isascii():
        return len(text)
    from rich.cells import cell_len  # nearly all texts are ASCII, and need no table of Unicode

    return cell_len(text)


def padding(text: str, cells: int) -> str:
    """The spaces after a text, up to a width."""
    return " " * (cells - width(text))


def padded(text: str, cells: int) -> str:
    """A text with spaces after it up to a width."""
    return text + padding(text, cells)


_WORD = re.compile(" *[^ ]+| +$")


def wrapped(text: str, cells: int, first: int | None = None) -> list[str]:
    """A text in lines of at most ``cells`` cells, the first one of ``first``.

    A line ends between words, and between the wide characters of scripts that have no spaces.  A word that is too long
    for any line, such as a path, stays whole.
    """
    room = cells if first is None else first
    lines, line, used = [], "", 0
    for piece in _pieces(text):
        wide = width(piece)
        if used + wide > room and (line or room < cells):
            lines.append(line)
            room, line, piece = cells, "", piece.lstrip(" ")
            used, wide = 0, width(piece)
        line += piece
        used += wide
    return [*lines, line]


def _pieces(text: str) -> Iterator[str]:
    """What a line may end between: words with the spaces before them, and parts of words of wide characters."""
    for word in _WORD.findall(text):
        if word.isascii():
            yield word
            continue
        start = 0
        for end in range(1, len(word)):
            if _may_part(word[end - 1], word[end]):
                yield word[start:end]
                start = end
        yield word[start:]


def _may_part(left: str, right: str) -> bool:
    """Whether a line may end between two characters: no line begins with a closing mark or ends in an opening one."""
    if left == " " or not width(right) or max(width(left), width(right)) < 2:
        return False
    return unicodedata.category(right) not in ("Pe", "Pf", "Po", "Lm") and unicodedata.category(left) not in (
        "Ps",
        "Pi",
    )


def columns(
    rows: Sequence[Sequence[str]], widest: int = sys.maxsize, painted: Sequence[Sequence[str]] | None = None
) -> Iterator[str]:
    """Rows of texts with their columns below each other, two cells apart.

    A column is as wide as its longest text of ``widest`` cells at most; longer ones stand out.  ``painted`` are the
    texts as they are shown, with their colours, which take no cells.
    """
    limits = [max((w for w in map(width, column) if w <= widest), default=0) for column in zip(*rows, strict=True)]
    for row, shown in zip(rows, painted or rows, strict=True):
        cells = (word + padding(text, limit) for text, word, limit in zip(row, shown, limits, strict=True))
        yield "  ".join(cells).rstrip()
