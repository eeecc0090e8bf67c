"""Gaps that the author of an exercise leaves for others to fill in, by the comments that ask for it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import count, takewhile
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_WORDS = ("TODO", "todo", "YOUR", "Your", "your")
_ASKS = re.compile(r"\bTODO\b|\btodo:|\b(?i:your (?:code|answer|solution))\b")
"""Upper case or a colon, for in Spanish the word means everything."""
_ASKING = rf"^\s*#.*(?:{_ASKS.pattern})"
_GAP = 2
"""How many empty lines below such a comment are room for what is to be written."""


def is_left_blank(workspace: WorkspaceIndex, file: str, name: str, line: int) -> bool:
    """Whether a comment asks others to define a name that a file reads, or the line where it reads it stands below the
    room for what a comment asks for."""
    if not any(workspace.code.mentions(file, word) for word in _WORDS):
        return False
    return _is_asked_for(workspace, file, name) or _is_below_gap(workspace, file, line)


_NOQA = r"#\s*(?:noqa|NOQA)\b(?:(?![ \t]*:)|[ \t]*:[ \tA-Z0-9,]*\bF821\b)"
"""What tells flake8 and ruff to say nothing of a line, or nothing of an undefined name."""


def lines_looked_at(workspace: WorkspaceIndex, file: str) -> frozenset[int]:
    """The lines of a file whose author has told other linters that a name there is known to be undefined."""
    if not any(workspace.code.mentions(file, word) for word in ("noqa", "NOQA")):
        return frozenset()
    return frozenset(number for number, _ in workspace.tree.lines_with(file, _NOQA))


_SEVERAL = 3
"""How many comments that ask for code no longer are an author's notes to himself."""


def is_an_exercise(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether several comments of a file ask for what is to be written there: nobody has done so yet."""
    return len(workspace.tree.lines_with(file, _ASKING)) >= _SEVERAL


def _is_asked_for(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    word = re.compile(rf"(?<![\w.]){re.escape(name)}(?!\w)")
    asking = (number for number, _ in workspace.tree.lines_with(file, _ASKING))
    return any(word.search(line) for number in asking for line in _comment_around(workspace, file, number))


def _comment_around(workspace: WorkspaceIndex, file: str, number: int) -> list[str]:
    """The lines of comments that follow each other, this one among them.  Each line is asked for by itself, so that
    those behind the comment are not."""
    numbers = (range(number, 0, -1), count(number + 1))
    return [line for way in numbers for line in takewhile(_is_comment, _lines(workspace, file, way))]


def _lines(workspace: WorkspaceIndex, file: str, numbers: Iterable[int]) -> Iterator[str]:
    for number in numbers:
        lines = workspace.tree.lines(file, number, number)
        if not lines:
            return
        yield lines[0]


def _is_comment(line: str) -> bool:
    return line.strip().startswith("#")


def _is_below_gap(workspace: WorkspaceIndex, file: str, line: int) -> bool:
    empty = 0
    for above in _lines(workspace, file, range(line - 1, 0, -1)):
        words = above.strip()
        if words and not words.startswith("#"):
            return False
        if words and _ASKS.search(words):
            return empty >= _GAP
        empty += not words
    return False


__all__ = ["is_an_exercise", "is_left_blank", "lines_looked_at"]
