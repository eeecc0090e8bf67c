"""How wide a text is in a terminal, and columns of texts: wide characters take two cells, combining ones none.

All commands lay their columns out with these.  Not with rich's tables: commands that only list something
must not wait for rich, of which nothing but the widths is needed, and these only where a text is not ASCII.
"""

from __future__ import annotations

import sys
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
