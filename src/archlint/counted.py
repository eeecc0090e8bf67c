"""Numbers with what they count."""

from __future__ import annotations


def counted(number: int, noun: str) -> str:
    """``1 node``, ``2 nodes``; ``noun`` is the singular, of which an *s* makes the plural."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
