"""Regular expressions of a configuration, matched in bounded time.

A configuration may come from anybody, and Python's ``re`` takes longer than anybody waits for ``(a+)+b``.  Here each
part of a pattern is asked once for each position of the text, and there is an end to what one text may take.  What
that cannot match (references to groups, looks behind, flags, possessive forms) is refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import field
from functools import lru_cache

from archlint.records import dataclass

_Ends = frozenset[int]
_Part = Callable[["_Match", int], _Ends]
"""Where a part of a pattern may end that begins at a position."""

LONGEST_TEXT = 255
"""Characters of a text that is matched; rcl takes no longer name."""
_MOST_STEPS = 20_000
"""Positions that parts of a pattern are asked about for one text; a usual name takes some hundreds."""
_LONGEST_PATTERN = 500
_DEEPEST = 20
_COUNT = re.compile(r"\{(\d{1,3})?(,(\d{1,3})?)?\}")
_NOTHING: _Ends = frozenset()


class InvalidPattern(ValueError):
    """What is wrong with a pattern, in words."""


class _TooMuchWork(Exception):
    """One text takes more than it may."""


@dataclass
class _Match:
    text: str
    steps: int = 0
    known: dict[tuple[int, int], _Ends] = field(default_factory=dict)

    def ends(self, part: _Part, start: int) -> _Ends:
        key = (id(part), start)
        if key not in self.known:
            self.known[key] = part(self, start)
        return self.known[key]

    def all_ends(self, part: _Part, starts: _Ends) -> _Ends:
        self.steps += len(starts)
        if self.steps > _MOST_STEPS:
            raise _TooMuchWork
        return _NOTHING.union(*(self.ends(part, start) for start in starts))


@lru_cache(maxsize=256)
def compile_pattern(pattern: str) -> _Part:
    """The pattern; ``InvalidPattern`` where it is none, or one that takes no bounded time."""
    if len(pattern) > _LONGEST_PATTERN:
        raise InvalidPattern(f"is longer than {_LONGEST_PATTERN} characters")
    try:
        re.compile(pattern)
    except (re.error, OverflowError, RecursionError) as error:
        raise InvalidPattern(f"is no regular expression: {error}") from None
    reader = _Reader(pattern)
    part = reader.choice(0)
    if reader.rest:
        raise InvalidPattern(f"has '{reader.rest[:10]}', which is not supported here")
    return part


@lru_cache(maxsize=10_000)
def matches(pattern: str, text: str) -> bool | None:
    """Whether a pattern matches a whole text; None where the text is too long, or takes too much work."""
    if len(text) > LONGEST_TEXT:
        return None
    try:
        return len(text) in _Match(text).ends(compile_pattern(pattern), 0)
    except _TooMuchWork:
        return None


class _Reader:
    """Reads a pattern of which ``re`` has said that it is one."""

    def __init__(self, pattern: str) -> None:
        self.rest = pattern

    def choice(self, depth: int) -> _Part:
        if depth > _DEEPEST:
            raise InvalidPattern(f"has more than {_DEEPEST} groups in each other")
        ways = [self._sequence(depth)]
        while self._take("|"):
            ways.append(self._sequence(depth))
        return ways[0] if len(ways) == 1 else lambda match, start: _NOTHING.union(*(match.ends(w, start) for w in ways))

    def _take(self, word: str) -> bool:
        taken = self.rest.startswith(word)
        self.rest = self.rest[len(word) :] if taken else self.rest
        return taken

    def _sequence(self, depth: int) -> _Part:
        parts: list[_Part] = []
        while self.rest and self.rest[0] not in "|)":
            parts.append(self._repeated(self._one(depth)))

        def ends(match: _Match, start: int) -> _Ends:
            reached: _Ends = frozenset({start})
            for part in parts:
                reached = match.all_ends(part, reached)
            return reached

        return ends

    def _one(self, depth: int) -> _Part:
        if self._take("("):
            return self._group(depth)
        if self._take("^") or self._take(r"\A"):
            return lambda _, start: frozenset({start}) if start == 0 else _NOTHING
        if self._take("$") or self._take(r"\Z"):
            return lambda match, start: frozenset({start}) if start == len(match.text) else _NOTHING
        return _character(self._character())

    def _group(self, depth: int) -> _Part:
        look = next((word for word in ("?=", "?!") if self._take(word)), "")
        if not look and not self._take("?:"):
            name = re.match(r"\?P<\w+>", self.rest)
            self._take(name.group() if name else "")
            if self.rest.startswith("?"):
                raise InvalidPattern(f"has '({self.rest[:3]}', which is not supported here")
        inside = self.choice(depth + 1)
        self._take(")")
        if not look:
            return inside
        return lambda match, start: (
            frozenset({start}) if bool(match.ends(inside, start)) == (look == "?=") else _NOTHING
        )

    def _character(self) -> str:
        """The part of the pattern that stands for one character."""
        if self.rest.startswith("["):
            end = re.match(r"\[\^?\]?(?:\\.|[^\]\\])*\]", self.rest, re.DOTALL)
            word = end.group() if end else self.rest
        elif self.rest.startswith("\\"):
            if self.rest[1:2] in set("bB123456789"):
                raise InvalidPattern(f"has '{self.rest[:2]}', which is not supported here")
            escape = re.match(r"\\(?:x..|u.{4}|U.{8}|N\{[^}]*\}|0[0-7]{0,2}|.)", self.rest, re.DOTALL)
            word = escape.group() if escape else self.rest
        else:
            word = self.rest[0]
        self.rest = self.rest[len(word) :]
        return word

    def _repeated(self, part: _Part) -> _Part:
        count = _COUNT.match(self.rest)
        if self.rest[:1] and self.rest[0] in "*+?":
            least, most = (1 if self.rest[0] == "+" else 0), (1 if self.rest[0] == "?" else None)
            self.rest = self.rest[1:]
        elif count is not None and count.group() not in ("{}", "{,}"):
            least = int(count[1] or 0)
            most = least if count[2] is None else int(count[3]) if count[3] else None
            self.rest = self.rest[count.end() :]
        else:
            return part
        if self.rest.startswith("+"):
            raise InvalidPattern("has a possessive form, which is not supported here")
        self._take("?")  # how much is taken first makes no difference for a whole text
        return lambda match, start: frozenset(_repetitions(match, part, start, least, most))


def _character(word: str) -> _Part:
    expression = re.compile(word)
    return lambda match, start: (
        frozenset({start + 1}) if expression.fullmatch(match.text[start : start + 1]) else _NOTHING
    )


def _repetitions(match: _Match, part: _Part, start: int, least: int, most: int | None) -> Iterator[int]:
    """The positions after so many repetitions.  More than one for each character and two change nothing: from then on
    only those count that take no character, and these can be left out or added."""
    reached: _Ends = frozenset({start})
    for _ in range(min(least, len(match.text) + 2)):
        reached = match.all_ends(part, reached)
    every, new = set(reached), reached
    rounds = len(match.text) + 2 if most is None else min(most - least, len(match.text) + 2)
    for _ in range(rounds):
        new = match.all_ends(part, new) - every
        every |= new
    yield from every
