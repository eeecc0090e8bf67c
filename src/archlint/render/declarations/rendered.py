"""A declaration in a format."""

from __future__ import annotations

from archlint.records import dataclass


@dataclass(frozen=True)
class Rendered:
    """``left_out`` says in sentences what is not in ``text``, for it is not known or the format has no words for it."""

    text: str
    left_out: tuple[str, ...] = ()


MADE = "Made by `archlint export` from the source."
"""What stands at the head of each declaration."""

__all__ = ["MADE", "Rendered"]
