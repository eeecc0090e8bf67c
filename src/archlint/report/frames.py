"""Code frames: the lines that a finding is about, with each place underlined.

A frame is made of lines, a line of pieces of text with a style, so that it can be printed plain or in colour.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Literal

from archlint import cells
from archlint.finding import SeverityLabel
from archlint.records import dataclass
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.report.model import SourceLine

Style = SeverityLabel | Literal["plain", "related", "gutter", "path", "message", "help"]
Piece = tuple[Style, str]
"""A style and a text that is safe to show."""
Line = list[Piece]

MAX_WIDTH = 160
"""Cells of a source line that are shown; of longer ones the part around the underlined place."""
UNLIMITED = sys.maxsize
"""The width of what is not for a terminal."""
_ROOM = 28
"""The fewest cells in which a message stands beside its underline; where there are fewer it is put below."""
CONTEXT = 1
"""Lines shown before and after the primary place."""
_TAB = "    "


@dataclass(frozen=True)
class Mark:
    """A place to underline, with what to say about it; ``style`` is that of the underline."""

    place: Place
    message: str
    style: Style
    primary: bool


def frames(finding: Finding, source_line: SourceLine, columns: int = UNLIMITED) -> Iterator[Line]:
    """The frames of a finding, ``columns`` cells wide: one for each file, that of the primary place first."""
    marks = [Mark(finding.place, "", finding.severity.label, True)]
    marks += [Mark(related.place, related.message, "related", False) for related in finding.related]
    by_file: dict[str, list[Mark]] = {}
    for mark in marks:
        by_file.setdefault(mark.place.file, []).append(mark)
    width = len(str(max(mark.place.line for mark in marks) + CONTEXT))
    for file, here in by_file.items():
        place = here[0].place
        arrow = "-->" if here[0].primary else ":::"
        yield [("gutter", f"{' ' * width}{arrow} "), ("path", f"{visible(file)}:{place.line}:{place.column}")]
        yield from _frame(here, source_line, width, columns)


def _frame(marks: Sequence[Mark], source_line: SourceLine, width: int, columns: int) -> Iterator[Line]:
    file = marks[0].place.file
    by_line: dict[int, list[Mark]] = {}
    for mark in marks:
        by_line.setdefault(mark.place.line, []).append(mark)
        if mark.primary:
            for near in range(max(mark.place.line - CONTEXT, 1), mark.place.line + CONTEXT + 1):
                by_line.setdefault(near, [])
    texts = {number: source_line(file, number) for number in sorted(by_line)}
    if all(texts[number] is None for number in by_line if by_line[number]):
        yield from _without_source(marks, width, columns)
        return
    yield _gutter(width)
    previous = 0
    for number, text in texts.items():
        if text is None or not (text.strip() or by_line[number]):
            continue
        if previous and number > previous + 1:
            yield [("gutter", "...")]
        previous = number
        yield from _source(number, text, by_line[number], width, columns)
    yield _gutter(width)


def _gutter(width: int, number: int | None = None) -> Line:
    label = "" if number is None else str(number)
    return [("gutter", f"{label:>{width}} |")]


def _without_source(marks: Sequence[Mark], width: int, columns: int) -> Iterator[Line]:
    for mark in marks:
        if mark.message:
            text = f"line {mark.place.line}: {visible(mark.message)}"
            yield from wrapped([("gutter", " " * width + " = ")], (mark.style, text), columns)


def _source(number: int, text: str, marks: Sequence[Mark], width: int, columns: int) -> Iterator[Line]:
    """A source line and one line under it for each of its marks, more where the message of a mark is long."""
    start, stop = _window(text, marks, min(MAX_WIDTH, columns - width - len(" | ")))
    shown = _shown(text[start:stop])
    clipped = ("…" if start else ""), ("…" if stop < len(text) else "")
    yield [*_gutter(width, number), ("plain", f" {clipped[0]}{shown}{clipped[1]}".rstrip())]
    for mark in sorted(marks, key=lambda mark: not mark.primary):
        first, end = _columns(mark, len(text))
        before = " " * cells.width(clipped[0] + _shown(text[start : max(first, start)]))
        under = _shown(text[max(first, start) : min(end, stop)])
        line = ("^" if mark.primary else "-") * max(cells.width(under), 1)
        yield from _underlined(mark, before, line, width, columns)


def _underlined(mark: Mark, before: str, line: str, width: int, columns: int) -> Iterator[Line]:
    """The line under a place and its message: beside it, or below it where there is too little room."""
    gutter = _gutter(width)
    start = width + len(" | ") + len(before)
    message = visible(mark.message)
    needed = cells.width(message)
    if not message or start + len(line) + 1 + min(needed, _ROOM) <= columns:
        head: Line = [*gutter, ("plain", f" {before}"), (mark.style, f"{line} " if message else line)]
        yield from wrapped(head, (mark.style, message), columns, gutter=gutter)
        return
    yield [*gutter, ("plain", f" {before}"), (mark.style, line)]
    indent = min(start, max(columns - max(needed, _ROOM), width + len(" | ")))
    head = [*gutter, ("plain", " " * (indent - width - len(" |")))]
    yield from wrapped(head, (mark.style, message), columns, gutter=gutter)


def wrapped(
    head: Line, piece: Piece, columns: int, indent: int | None = None, gutter: Sequence[Piece] = ()
) -> Iterator[Line]:
    """A line that ends in a text, and the lines more that this takes: after the ``gutter``, ``indent`` cells from the
    left, or below the text."""
    style, text = piece
    if not text:
        yield head
        return
    start = sum(cells.width(part) for _, part in head)
    indent = start if indent is None else indent
    first, *others = cells.wrapped(text, columns - indent, columns - start)
    last_style, last = head[-1]
    yield [*head, (style, first)] if first else [*head[:-1], (last_style, last.rstrip())]
    for other in others:
        yield [*gutter, ("plain", " " * (indent - sum(cells.width(part) for _, part in gutter))), (style, other)]


def _columns(mark: Mark, length: int) -> tuple[int, int]:
    """First index of a mark in its line and the index after its last; a longer span ends with the line."""
    place = mark.place
    first = min(place.column - 1, length)
    end = place.end_column - 1 if place.end_line == place.line else length
    return first, min(max(end, first), length)


def _window(text: str, marks: Sequence[Mark], limit: int) -> tuple[int, int]:
    """The part of a line that is shown: all of it, or what ``limit`` cells have room for around the first mark."""
    widths = [cells.width(_shown(character)) for character in text]
    if sum(widths) <= limit:
        return 0, len(text)
    room = limit - 2  # what is left out is shown by a dot on either side
    first = min((_columns(mark, len(text))[0] for mark in marks), default=0)
    before = _fitting(widths[:first][::-1], room // 4)
    stop = first + _fitting(widths[first:], room - sum(widths[first - before : first]))
    return first - _fitting(widths[:first][::-1], room - sum(widths[first:stop])), stop


def _fitting(widths: Sequence[int], room: int) -> int:
    """How many characters of these widths have room in so many cells."""
    for number, width in enumerate(widths):
        room -= width
        if room < 0:
            return number
    return len(widths)


def _shown(text: str) -> str:
    return "".join(_TAB if character == "\t" else visible(character) for character in text)
