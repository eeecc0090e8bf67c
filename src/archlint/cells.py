"""How wide a text is in a terminal, and columns of texts: wide characters take two cells, combining ones none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence


def width(text: str) -> int:
    """How many cells a text takes that is safe to show."""
    if text.isascii():
        return len(text)
    from rich.cells import cell_len  # nearly all texts are ASCII, and need no table of Unicode

    return cell_len(text)


def padded(text: str, cells: int) -> str:
    """A text with spaces after it up to a width."""
    return text + " " * (cells - width(text))


def columns(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Rows of texts with their columns below each other, two cells apart."""
    widths = [max(map(width, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(map(padded, row, widths)).rstrip()
