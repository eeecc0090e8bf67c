"""Markdown that says what a text says and nothing else: as GitHub reads it (CommonMark with tables).

Nothing of the user's becomes markup, HTML, a mention, a cell or a row of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from urllib.parse import quote

from archlint.visible import visible

_MARKUP = re.compile(r"([\\`*\[\]#~$]|(?<![A-Za-z0-9])_|_(?![A-Za-z0-9]))")
"""An underscore inside a word is one."""
_HTML = (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("@", "&#64;"), ("|", "&#124;"))
_BLOCK = re.compile(r"^([-+=]|\d+[.)])")
"""What begins a list, a line under a heading or a rule."""
_OTHER_SURROGATE = re.compile("[\ud800-\udc7f\udd00-\udfff]")
_SHORT = 60
"""Characters of a line that its author ended before it was full."""
_LITERAL = re.compile(r"^(\s|[-+*•>|]\s|\d+[.)]\s|:\w|@\w|>>>|```|\.\. |[=\-~^#*]{3,}\s*$|\w[\w .]*:\s*$)")
"""What begins a line of a docstring that means more than its words: a list, a field, an example, a heading."""


def text(words: str) -> str:
    """Plain words, on one line."""
    escaped = _MARKUP.sub(r"\\\1", visible(words))
    for character, entity in _HTML:
        escaped = escaped.replace(character, entity)
    return escaped


def code(words: str) -> str:
    """A name or a value, in the type of code; nothing for an empty one."""
    shown = visible(words)
    if not shown.strip():
        return f"&quot;{shown}&quot;" if shown else ""
    fence = "`" * (_longest_run(shown) + 1)
    space = " " if shown.startswith(("`", " ")) or shown.endswith(("`", " ")) else ""
    return f"{fence}{space}{shown}{space}{fence}"


def link(label: str, target: str, line: int | None = None) -> str:
    """A link from Markdown (``label``) to a file by its relative path, and to one of its lines."""
    # A byte of a name that is no UTF-8 is an escaped surrogate; a path of the disk has no others.
    known = visible(target) if _OTHER_SURROGATE.search(target) else target
    place = quote(known.encode("utf-8", "surrogateescape")) + ("" if line is None else f"#L{line}")
    return f"[{label}]({place})"


def table(titles: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """The lines of a table of cells that are Markdown; columns that are empty in all rows are left out."""
    cells = [[*row] for row in rows]
    kept = [column for column in range(len(titles)) if any(row[column] for row in cells)]
    if not cells:
        return
    yield _row(titles[column] for column in kept)
    yield _row("---" for _ in kept)
    yield from (_row(row[column] for column in kept) for row in cells)


def _row(cells: Iterable[str]) -> str:
    # A bar ends a cell even inside code, unless there is a backslash before it, which the table takes away again: one
    # that Markdown needs has to be there beside it.
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def paragraphs(words: str) -> Iterator[str]:
    """A docstring: paragraphs of prose as such, what is laid out (lists, fields, examples) as it stands."""
    literal: list[str] = []
    for block in re.split(r"\n\s*\n", words.strip("\n")) if words.strip() else ():
        lines = block.split("\n")
        if any(_LITERAL.match(line) for line in lines):
            literal += [*([""] if literal else []), *map(visible, lines)]
            continue
        yield from _fenced(literal)
        literal = []
        yield _prose(lines)
    yield from _fenced(literal)


def _prose(lines: Sequence[str]) -> str:
    """Lines of prose: one that ends early, before a new sentence, stays a line of its own."""
    joined = text(lines[0])
    for line, following in pairwise(lines):
        ends_early = len(line) < _SHORT and not following[:1].islower()
        joined += ("\\\n" if ends_early else " ") + text(following)
    return "\n".join(_without_block(line) for line in joined.split("\n"))


def _without_block(line: str) -> str:
    """A line that begins nothing but a line."""
    return _BLOCK.sub(lambda match: f"{match[1][:-1]}\\{match[1][-1]}", line)


def _fenced(lines: Sequence[str]) -> Iterator[str]:
    if lines:
        fence = "`" * max(3, max(map(_longest_run, lines)) + 1)
        yield "\n".join([f"{fence}text", *lines, fence])


def _longest_run(shown: str) -> int:
    """The length of the longest run of backticks."""
    return max(map(len, re.findall("`+", shown)), default=0)


__all__ = ["code", "link", "paragraphs", "table", "text"]
