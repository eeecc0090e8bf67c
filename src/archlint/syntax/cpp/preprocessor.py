"""Branches of the preprocessor that are no code, or hold no whole statements.

``#if A`` … ``if (x) {`` … ``#else`` … ``if (y) {`` … ``#endif`` is code in either case, and no tree can hold both: the
first branch stays, with as many lines and columns as there were.  What ``#if 0`` leaves out is no code at all, nor is
what a file that can be built for ROS 1, too, has behind macros of that name: ``#ifdef BUILDING_ROS1`` … ``#elif defined
BUILDING_ROS2``.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import field

from archlint.records import dataclass

_DIRECTIVE = re.compile(rb"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b(?:\\\n|[^\n])*", re.MULTILINE)
_CONDITION = re.compile(
    rb"\s*#\s*(?P<word>if|ifdef|ifndef|elif)\b\s*"
    rb"(?P<no>!?)\s*(?:defined\b)?\s*\(?\s*(?P<name>\w+)\s*\)?\s*(?:==\s*(?P<value>\d+)\s*)?(?://.*|/\*.*)?"
)
_EDITION = re.compile(
    rb"_*(?:(?:USE|BUILD|BUILDING|WITH|IS|FOR|ENABLE|HAS|HAVE)_)*ROS_?([12])(?:_(?:BUILD|ENABLED))?_*"
)
"""A macro for one of ROS 1 and ROS 2, such as ``USE_ROS2``."""
_VERSION = re.compile(rb"_*ROS_VERSION_*")
_NEVER = (b"0", b"false")
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
    """What to blank of a block whose conditions are known, up to that of the branch that is code."""
    blanked: list[tuple[int, int]] = []
    for (start, end), (next_start, _) in itertools.pairwise(directives):
        holds = _holds(data, data[start:end])
        if holds is None:
            return []
        blanked.append((start, end))
        if holds:
            return [*blanked, (next_start, directives[-1][1])]
        blanked.append((end, next_start))
    return [*blanked, directives[-1]]


def _holds(data: bytes, directive: bytes) -> bool | None:
    """Whether a condition holds when the file is built for ROS 2; None where other things decide it."""
    if directive.split(b"#", 1)[1].split()[:1] == [b"else"]:
        return True
    match = _CONDITION.fullmatch(directive)
    if match is None:
        return None
    name, value = match["name"], match["value"]
    negated = match["word"] == b"ifndef" or match["no"] == b"!"
    if name in _NEVER:
        return negated if match["word"] == b"if" and value is None else None
    edition = _EDITION.fullmatch(name)
    if re.search(rb"#\s*(?:define|undef)\s+" + re.escape(name) + rb"\b", data):
        return None  # a macro of the file itself, such as the guard of a header
    if edition is not None and value is None:
        return (edition[1] == b"2") is not negated
    if _VERSION.fullmatch(name) and value in (b"1", b"2"):
        return (value == b"2") is not negated
    return None


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
