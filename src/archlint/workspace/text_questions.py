"""What is asked of the text of a file when not all of it matters, so that an edit elsewhere in it changes no answer."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence

_LINES, _FINDS = "lines", "finds"
_ALL = "content"


def about_lines(first: int, last: int) -> str:
    """The question what some lines say, from 1."""
    return f"{_LINES} {first} {last}"


def about_pattern(pattern: str) -> str:
    """The question which lines have something that a pattern matches, with their numbers."""
    return f"{_FINDS} {pattern}"


def is_about_text(question: str) -> bool:
    """Whether the answer follows from the text of a file, all of it or a part; what words it has is noted apart."""
    return question.partition(" ")[0] in (_ALL, _LINES, _FINDS)


def part_of(question: str, text: str) -> list[tuple[int, str]]:
    """The lines that a question about a part of a text is about, with their numbers from 1."""
    kind, _, rest = question.partition(" ")
    if kind == _LINES:
        first, last = map(int, rest.split())
        return list(enumerate(text.split("\n", max(last, 0))[max(first - 1, 0) : max(last, 0)], max(first, 1)))
    pattern = re.compile(rest, re.MULTILINE)
    if pattern.search(text) is None:
        return []
    return [(number, line) for number, line in enumerate(text.split("\n"), 1) if pattern.search(line)]


def is_about_part(question: str) -> bool:
    """Whether :func:`part_of` knows what a question is about."""
    return question.partition(" ")[0] in (_LINES, _FINDS)


def digest_of_part(part: Sequence[tuple[int, str]] | None) -> str | None:
    """The answer to a question about a part, as it is kept; None where there is no text."""
    return None if part is None else hashlib.sha256(repr(part).encode()).hexdigest()


__all__ = ["about_lines", "about_pattern", "digest_of_part", "is_about_part", "is_about_text", "part_of"]
