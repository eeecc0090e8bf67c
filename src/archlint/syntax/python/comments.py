"""``# archlint: ignore[…]`` comments and the lines they cover."""

from __future__ import annotations

import re
from bisect import bisect_left

from archlint.syntax.comment_words import SUPPRESSION, codes_in, gives_reason, listed_at, lookalike
from archlint.syntax.facts import Suppression
from archlint.syntax.python.positions import CommentPositions, LineTable

_SUPPRESSION = re.compile(rf"#\s*{SUPPRESSION}")


def find_suppressions(text: str, positions: CommentPositions, lines: LineTable) -> list[Suppression]:
    """All suppressions of a file, and what only looks like one, in the order in which they stand there."""
    units: list[tuple[int, int]] | None = None
    ends: list[int] = []
    suppressions = []
    for offset, comment in positions.comments:
        other = lookalike(comment)
        if other is not None:
            line, column = lines.place(offset + other.start())
            end = column + other.end() - other.start()
            suppressions.append(Suppression(line, column, end, (line, line), [], not_understood=other[0]))
        for match in _SUPPRESSION.finditer(comment):
            if units is None:
                units = _logical_lines(text, positions, lines)
                ends = [last for _, last in units]
            line, column = lines.place(offset + match.start())
            suppressions.append(
                Suppression(
                    line,
                    column,
                    column + match.end() - match.start(),
                    (1, len(lines.starts)) if match[1] else _covered(line, units, ends),
                    codes_in(match),
                    "file" if match[1] else "line",
                    listed=listed_at(match, column),
                    reason=gives_reason(comment, match.end()),
                )
            )
    return suppressions


def _covered(line: int, units: list[tuple[int, int]], ends: list[int]) -> tuple[int, int]:
    """The logical line that a comment is in or, on a line of its own, the next one; ``ends`` are their last lines."""
    index = bisect_left(ends, line)
    return units[index] if index < len(units) else (line, line)


def _logical_lines(text: str, positions: CommentPositions, lines: LineTable) -> list[tuple[int, int]]:
    """First and last line of every logical line; decorators belong to what they decorate."""
    units: list[tuple[int, int]] = []
    decorated_from = None
    previous = 0
    for end in positions.line_ends:
        last, _ = lines.place(end)
        if last <= previous:  # `if test: statement` ends once for each of the two
            continue
        first = previous + 1
        while first < last and _is_blank_or_comment(text, lines, first):
            first += 1
        previous = last
        if _line_text(text, lines, first).startswith("@"):
            decorated_from = decorated_from or first
            continue
        units.append((decorated_from or first, last))
        decorated_from = None
    return units


def _is_blank_or_comment(text: str, lines: LineTable, line: int) -> bool:
    stripped = _line_text(text, lines, line)
    return not stripped or stripped.startswith("#")


def _line_text(text: str, lines: LineTable, line: int) -> str:
    start = lines.starts[line - 1]
    end = lines.starts[line] if line < len(lines.starts) else len(text)
    return text[start:end].strip()
