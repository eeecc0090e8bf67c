"""Branches of the preprocessor that are no code, or hold no whole statements.

``#if A`` … ``if (x) {`` … ``#else`` … ``if (y) {`` … ``#endif`` is code in either case, and no tree can hold both: the
first branch stays, with as many lines and columns as there were.  What ``#if 0`` leaves out is no code at all.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass, field

_DIRECTIVE = re.compile(rb"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b(?:\\\n|[^\n])*", re.MULTILINE)
_NEVER = re.compile(rb"\s*#\s*if\s+(?:0|false)\s*(?://.*)?")
_NO_CODE = re.compile(rb'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'', re.DOTALL)


MAX_NESTED = 50
"""Conditions inside of conditions whose branches are looked at: each is read again for every one around it."""


@dataclass
class _Block:
    """An ``#if`` that has not ended."""

    directives: list[tuple[int, int]] = field(default_factory=list)
    """Where each of its directives begins and ends."""


def with_whole_branches(data: bytes) -> bytes:
    """The source without what ``#if 0`` leaves out, and with one branch left of each ``#if`` whose branches open or
    close brackets of code around them."""
    if b"#if" not in data:
        return data
    blanked: list[tuple[int, int]] = []
    open_blocks: list[_Block] = []
    for match in _DIRECTIVE.finditer(data):
        word = match[1]
        if word.startswith(b"if"):
            open_blocks.append(_Block([match.span()]))
        elif open_blocks:
            open_blocks[-1].directives.append(match.span())
            if word == b"endif":
                block = open_blocks.pop()
                if len(open_blocks) < MAX_NESTED:
                    blanked += _left_out(data, block.directives) or _unbalanced(data, block.directives)
    if not blanked:
        return data
    changed = bytearray(data)
    for start, end in blanked:
        changed[start:end] = _blank(data[start:end])
    return bytes(changed)


def _left_out(data: bytes, directives: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """What to blank of an ``#if 0``: all of it, or all but its ``#else``."""
    if not _NEVER.fullmatch(data[slice(*directives[0])]):
        return []
    second, last = directives[1], directives[-1]
    if len(directives) == 2:
        return [(directives[0][0], last[1])]
    if len(directives) == 3 and b"else" in data[slice(*second)]:
        return [(directives[0][0], second[1]), last]
    return []


def _unbalanced(data: bytes, directives: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """What to blank of a block: all but its first branch, and nothing where each branch is whole."""
    branches = [(start[1], end[0]) for start, end in itertools.pairwise(directives)]
    if not any(_balance(data[start:end]) for start, end in branches):
        return []
    first_end = branches[0][1]
    return [directives[0], (first_end, directives[-1][1])]


def _balance(code: bytes) -> int:
    """How many brackets are opened and not closed; below zero for closed ones."""
    code = _NO_CODE.sub(b"", code)
    return code.count(b"{") - code.count(b"}") or code.count(b"(") - code.count(b")")


def _blank(code: bytes) -> bytes:
    return re.sub(rb"[^\n]", b" ", code)


__all__ = ["with_whole_branches"]
