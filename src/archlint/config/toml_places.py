"""Where a key or a value is in a TOML file; the parser of the standard library does not say."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import lru_cache

from archlint.records import dataclass

KeyPath = tuple[str, ...]
TextSpan = tuple[int, int, int]
"""Line, first column and column after the last, all from 1."""

_PART = r"""(?:[A-Za-z0-9_-]+|"(?:[^"\\]|\\.)*"|'[^']*')"""
_DOTTED = rf"{_PART}(?:\s*\.\s*{_PART})*"
_HEADER = re.compile(rf"\s*\[\[?\s*({_DOTTED})\s*\]\]?\s*(?:#.*)?$")
_ASSIGNMENT = re.compile(rf"\s*({_DOTTED})\s*=")
_QUIET = re.compile(r"""\"\"\".*?\"\"\"|'''.*?'''|"(?:[^"\\]|\\.)*"|'[^']*'|#.*""")
_TRIPLE = re.compile(r'"""|\'\'\'')


@dataclass
class _Entry:
    """A table header or an assignment, with the lines that its value takes."""

    path: KeyPath
    line: int
    columns: tuple[int, int]
    value: list[tuple[int, int, str]] = field(default_factory=list)
    """Lines of the value: number, column offset, text."""


def locate(text: str, path: KeyPath, element: str | None = None, after: int = 0) -> TextSpan | None:
    """The place of a key or table, or of the string ``element`` in its value; None where it is not found.

    Of several the first one counts that stands on line ``after`` or below.
    """
    prefixes = []
    for entry in _entries(text):
        if entry.line < after:
            continue
        if entry.path == path or (entry.path[: len(path)] == path and not entry.value):
            return _inside(entry, element) or (entry.line, *entry.columns)
        if entry.value and path[: len(entry.path)] == entry.path:
            prefixes.append(entry)
    for entry in prefixes:  # an inline table
        wanted = element if element is not None else path[-1]
        return _inside(entry, wanted) or (entry.line, *entry.columns)
    return None


def headers(text: str, path: KeyPath) -> Sequence[TextSpan]:
    """The places of all headers of a table or of a list of tables."""
    return _headers(text).get(path, ())


@lru_cache(maxsize=4)
def _headers(text: str) -> Mapping[KeyPath, Sequence[TextSpan]]:
    """All headers of a file, which are asked for once for each table of a list."""
    spans: dict[KeyPath, list[TextSpan]] = {}
    for entry in _entries(text):
        if not entry.value:
            spans.setdefault(entry.path, []).append((entry.line, *entry.columns))
    return spans


def _inside(entry: _Entry, element: str | None) -> TextSpan | None:
    if element is None:
        return None
    word = re.compile(rf"""(["']?)(?<![\w-]){re.escape(element)}(?![\w-])\1""")
    for number, offset, text in entry.value:
        match = word.search(text)
        if match:
            return (number, offset + match.start() + 1, offset + match.end() + 1)
    return None


def _entries(text: str) -> list[_Entry]:
    entries: list[_Entry] = []
    table: KeyPath = ()
    depth, triple = 0, ""
    for number, line in enumerate(text.splitlines(), 1):
        if triple or depth:
            entries[-1].value.append((number, 0, line))
            depth, triple = _after(line, depth, triple)
            continue
        header, assignment = _HEADER.match(line), _ASSIGNMENT.match(line)
        if header:
            table = _split(header[1])
            entries.append(_Entry(table, number, (header.start(1) + 1, header.end(1) + 1)))
        elif assignment:
            columns = (assignment.start(1) + 1, assignment.end(1) + 1)
            end = assignment.end()
            value = line[end:]
            entries.append(_Entry(table + _split(assignment[1]), number, columns, [(number, end, value)]))
            depth, triple = _after(value, 0, "")
    return entries


def _after(line: str, depth: int, triple: str) -> tuple[int, str]:
    """Bracket depth and open triple quote after a line."""
    if triple:
        _, quote, line = line.partition(triple)
        if not quote:
            return depth, triple
    line = _QUIET.sub("", line)
    opened = _TRIPLE.search(line)
    if opened:
        line, triple = line[: opened.start()], opened[0]
    else:
        triple = ""
    depth += sum(line.count(c) for c in "[{") - sum(line.count(c) for c in "]}")
    return max(depth, 0), triple


def _split(dotted: str) -> KeyPath:
    return tuple(part.strip("\"'") for part in re.findall(_PART, dotted))
