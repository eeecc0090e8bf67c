"""Gaps that the author of an exercise leaves for others to fill in, by the comments that ask for it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_WORDS = ("TODO", "todo", "YOUR", "Your", "your")
_ASKS = re.compile(r"\bTODO\b|\btodo:|\b(?i:your (?:code|answer|solution))\b")
"""Upper case or a colon, for in Spanish the word means everything."""
_GAP = 2
"""How many empty lines below such a comment are room for what is to be written."""


def is_left_blank(workspace: WorkspaceIndex, file: str, name: str, line: int) -> bool:
    """Whether a comment asks others to define a name that a file reads, or the line where it reads it stands below the
    room for what a comment asks for."""
    if not any(workspace.code.mentions(file, word) for word in _WORDS):
        return False
    text = workspace.tree.text(file) or ""
    return _is_asked_for(text, name) or _is_below_gap(text, line)


_SEVERAL = 3
"""How many comments that ask for code no longer are an author's notes to himself."""


def is_an_exercise(text: str) -> bool:
    """Whether several comments of a file ask for what is to be written there: nobody has done so yet."""
    return (
        sum(line.strip().startswith("#") and _ASKS.search(line) is not None for line in text.splitlines()) >= _SEVERAL
    )


def _is_asked_for(text: str, name: str) -> bool:
    word = re.compile(rf"(?<![\w.]){re.escape(name)}(?!\w)")
    return any(_ASKS.search(block) and word.search(block) for block in _comments(text.splitlines()))


def _is_below_gap(text: str, line: int) -> bool:
    empty = 0
    for above in reversed(text.splitlines()[: line - 1]):
        words = above.strip()
        if words and not words.startswith("#"):
            return False
        if words and _ASKS.search(words):
            return empty >= _GAP
        empty += not words
    return False


def _comments(lines: Sequence[str]) -> Iterator[str]:
    """The comments of a file, those of lines that follow each other in one."""
    block: list[str] = []
    for line in (*lines, ""):
        if line.strip().startswith("#"):
            block.append(line)
        elif block:
            yield "\n".join(block)
            block = []


__all__ = ["is_an_exercise", "is_left_blank"]
