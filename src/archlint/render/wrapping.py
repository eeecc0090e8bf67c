"""Long names in rows: what a picture is wide by is mostly names."""

from __future__ import annotations

import re
from collections.abc import Iterable

TITLE, SMALL = 24, 32
"""Characters of a row in larger and in smaller letters."""
_PIECE = re.compile(r"[^/_ .-]*[/_ .-]+|[^/_ .-]+")


def wrapped(text: str, most: int) -> list[str]:
    """``text`` in rows of about ``most`` characters, parted after a slash, an underscore, a space, a dot or a hyphen
    alone: a piece without any may be longer."""
    if len(text) <= most:
        return [text]
    rows = [""]
    for piece in _PIECE.findall(text):
        if rows[-1] and len(rows[-1]) + len(piece.rstrip()) > most:
            rows.append("")
        rows[-1] += piece
    return [row.rstrip() for row in rows]


def all_wrapped(texts: Iterable[str], most: int) -> list[str]:
    return [row for text in texts for row in wrapped(text, most)]


__all__ = ["SMALL", "TITLE", "all_wrapped", "wrapped"]
