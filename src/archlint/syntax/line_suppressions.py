"""Suppressions in the comments of a file that is read by lines."""

from __future__ import annotations

import re

from archlint.syntax.comment_words import SUPPRESSION, codes_in, gives_reason, listed_at, lookalike
from archlint.syntax.facts import Suppression

_SUPPRESSION = re.compile(rf"#\s*{SUPPRESSION}")


def suppressions_of_lines(text: str) -> list[Suppression]:
    """``# archlint: ignore[…]``: for its own line, or alone on a line for the next that says something."""
    suppressions: list[Suppression] = []
    if "archlint:" not in text:
        return suppressions
    lines = text.splitlines()
    said = _said_next(lines)
    for number, line in enumerate(lines, start=1):
        if other := lookalike(line):
            span = (number, other.start() + 1, other.end() + 1, (number, number))
            suppressions.append(Suppression(*span, [], not_understood=other[0]))
        indent = len(line) - len(line.lstrip())
        for match in _SUPPRESSION.finditer(line):
            covered = said[number] if match.start() == indent and said[number] else number
            suppressions.append(
                Suppression(
                    number,
                    match.start() + 1,
                    match.end() + 1,
                    (1, len(lines)) if match[1] else (covered, covered),
                    codes_in(match),
                    "file" if match[1] else "line",
                    listed=listed_at(match, match.start() + 1),
                    reason=gives_reason(line, match.end()),
                )
            )
    return suppressions


def _said_next(lines: list[str]) -> list[int]:
    """For each line, counted from 1, the next one that says something; 0 where none does."""
    said = [0] * (len(lines) + 1)
    for number in range(len(lines) - 1, 0, -1):
        row = lines[number].strip()
        said[number] = number + 1 if row and not row.startswith("#") else said[number + 1]
    return said
