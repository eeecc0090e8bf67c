"""LNT001: take codes that hide nothing out of a suppression, or all of it where none is left."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.edit_sites import IdleSuppression
    from archlint.fixes.source import Source


def shortened(idle: IdleSuppression, source: Source) -> Fix | None:
    """None where the file is no longer as the finding saw it."""
    if not source.has(idle.comment) or not source.at(idle.listed).startswith("["):
        return None
    edit = _without_codes(idle, source) if idle.needed else _removal(idle, source)
    return Fix("safe", (edit,), "remove the suppression")


def _without_codes(idle: IdleSuppression, source: Source) -> Edit:
    start, end = source.span(idle.comment)
    first, last = source.span(idle.listed)
    return Edit(idle.comment, f"{source.text[start:first]}[{', '.join(idle.needed)}]{source.text[last:end]}")


def _removal(idle: IdleSuppression, source: Source) -> Edit:
    """Without the comment: what else stands on the line stays, and what was a comment stays one."""
    place = idle.comment
    line = source.line(place.line)
    rest = line[place.end_column - 1 :]
    behind = place.end_column + len(rest) - len(rest.lstrip())
    words = line[idle.listed.end_column - 1 : place.end_column - 1].removesuffix("-->").strip()
    if idle.closed and words:
        return Edit(place, f"<!-- {words} -->")
    if not rest.strip():
        start = len(line[: place.column - 1].rstrip()) + 1
        if start == 1:  # nothing else stands on the line
            return Edit(Place(place.file, place.line, 1, place.line + 1, 1), "")
        return Edit(Place(place.file, place.line, start, place.line, len(line) + 1), "")
    if idle.closed or rest.lstrip().startswith("#"):
        return Edit(Place(place.file, place.line, place.column, place.line, behind), "")
    return Edit(place, "#")
