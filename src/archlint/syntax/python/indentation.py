"""Indentation of spaces and tabs mixed, made even for a parser that compares it as text.

CPython compares indentation by columns, a tab going on to the next multiple of eight (*Lexical analysis*,
2.1.8), and refuses what would mean something else with tabs of another width.  libcst compares the characters.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
import warnings
from dataclasses import field

from archlint.records import dataclass

_TAB = 8
_LINE = re.compile(r"([ \t]*)([^\r\n]*(?:\r\n|\n|\r|\Z))")


@dataclass(frozen=True)
class EvenText:
    """A text without tabs in its indentation.

    ``shifts`` says by line (from 1) how many characters the indentation has now, and how many it had.
    """

    text: str
    shifts: dict[int, tuple[int, int]] = field(default_factory=dict)


def with_even_indentation(text: str) -> EvenText | None:
    """A text whose tabs in front of a line are spaces; None where that changes nothing, or Python refuses the text."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
        inside = _lines_inside_strings(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError, tokenize.TokenError):
        return None
    shifts: dict[int, tuple[int, int]] = {}
    lines = []
    for number, match in enumerate(_LINE.finditer(text), 1):
        blanks, rest = match.groups()
        if "\t" in blanks and number not in inside:
            even = blanks.expandtabs(_TAB)
            shifts[number] = (len(even), len(blanks))
            blanks = even
        lines.append(blanks + rest)
    return EvenText("".join(lines), shifts) if shifts else None


def _lines_inside_strings(text: str) -> set[int]:
    """The numbers of the lines whose first character is in a string."""
    inside: set[int] = set()
    opened: list[int] = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        kind = tokenize.tok_name[token.type]
        if kind == "STRING":
            inside.update(range(token.start[0] + 1, token.end[0] + 1))
        elif kind in ("FSTRING_START", "TSTRING_START"):
            opened.append(token.start[0])
        elif kind in ("FSTRING_END", "TSTRING_END"):
            inside.update(range(opened.pop() + 1, token.end[0] + 1))
    return inside
