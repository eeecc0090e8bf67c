"""\"Did you mean\": the known word that is nearest to an unknown one."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from itertools import takewhile

from archlint.records import dataclass

MOST_COMPARED = 100_000
"""Pairs of names that one rule holds against each other to say what was meant: a file may have thousands of names that
are not known, and as many that are.  A pair of long names counts for several, by what it takes."""
_PAIR = 256
"""So many pairs of letters are a pair of names: two of 16 letters."""


@dataclass
class _Comparisons:
    left: int


_COMPARISONS: ContextVar[_Comparisons | None] = ContextVar("comparisons", default=None)


@contextmanager
def limited_suggestions() -> Iterator[None]:
    """Inside, no more than so many names are compared; behind the limit none is near.  What would go beyond it is not
    begun: one word may be held against all names of a workspace."""
    token = _COMPARISONS.set(_Comparisons(MOST_COMPARED))
    try:
        yield
    finally:
        _COMPARISONS.reset(token)


@lru_cache(maxsize=10_000)
def distance(first: str, second: str, limit: int) -> int:
    """The edit distance with transpositions; anything above ``limit`` is ``limit + 1``."""
    if abs(len(first) - len(second)) > limit:
        return limit + 1
    first, second = _without_common_ends(first, second)
    before: list[int] = []
    row = list(range(len(second) + 1))
    for i, left in enumerate(first, start=1):
        last, before, row = before, row, [i]
        for j, right in enumerate(second, start=1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (left != right))
            if i > 1 and j > 1 and left == second[j - 2] and first[i - 2] == right:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]


def _without_common_ends(first: str, second: str) -> tuple[str, str]:
    """Two texts without what they begin and end with alike: the distance is that of what is between."""
    start, most = 0, min(len(first), len(second))
    while start < most and first[start] == second[start]:
        start += 1
    end = 0
    while end < most - start and first[-1 - end] == second[-1 - end]:
        end += 1
    return first[start : len(first) - end], second[start : len(second) - end]


_OPPOSITES = (
    ("input", "output"),
    ("lower", "upper"),
    ("lower", "power"),
    ("read", "ready"),
    ("send", "sent"),
    ("start", "stop"),
)
"""Words that are near each other and mean different things."""
_UNDOING = ("un", "de", "dis", "in", "non", "anti")
"""What makes the opposite of a word: ``unsubscribe``, ``deactivate``, ``disconnect``, ``inactive``."""
_TURNED = (("en", "dis"), ("ac", "de"), ("at", "de"), ("in", "de"), ("in", "ex"), ("im", "ex"), ("on", "off"))
"""How two opposites begin that go on alike: ``enable`` and ``disable``, ``attach`` and ``detach``."""
_SHORTEST_STEM = 4
"""What is left of a word that has one of these: in ``under`` and ``index`` it is no word."""
_SHORT = 2
"""Words up to this length that differ in a letter are different words: ``x`` and ``y``, ``kp`` and ``kd``."""
_PARTS = re.compile(r"[_/.\s-]+|(?<=[a-z])(?=[A-Z])")
_DIGITS = re.compile(r"\d+")


def nearest(word: str, known: Iterable[str], most: int | None = None) -> str | None:
    """The known word within a third of the word's length (at least one edit, but not all of it), and within ``most``
    edits where that is given; the first of equals.  Names in which one whole word stands for another are two names, not
    one and a slip: ``publish_odom`` and ``publish_rate``, ``motor_1`` and ``motor_2``."""
    comparisons = _COMPARISONS.get()
    if len(word) > 256 or (comparisons is not None and comparisons.left <= 0):
        return None
    limit = max(1, len(word) // 3)
    candidates = {candidate for candidate in known if abs(len(candidate) - len(word)) <= limit}
    if comparisons is not None:
        comparisons.left -= sum(1 + len(word) * len(candidate) // _PAIR for candidate in candidates)
        if comparisons.left < 0:
            return None
    limit = limit if most is None else min(limit, most)
    letters = _letters(word)
    best: tuple[int, str] | None = None
    for candidate in sorted(other for other in candidates if _may_be_near(letters, _letters(other), limit)):
        edits = distance(word.lower(), candidate.lower(), limit)
        if edits > limit or edits >= len(word) or candidate == word or _are_two_names(word, candidate):
            continue
        if best is None or edits < best[0]:
            best = (edits, candidate)
    return None if best is None else best[1]


@lru_cache(maxsize=50_000)
def _letters(word: str) -> int:
    """The letters that occur in a word, in whichever case, as bits; several letters may share one."""
    bits = 0
    for letter in word.lower():
        bits |= 1 << (ord(letter) & 63)
    return bits


def _may_be_near(first: int, second: int, limit: int) -> bool:
    """Whether two words with these letters may be within so many edits: one edit adds or takes one letter at most."""
    if first == second:
        return True
    return (first & ~second).bit_count() <= limit and (second & ~first).bit_count() <= limit


def _are_two_names(first: str, second: str) -> bool:
    mine, yours = (_PARTS.split(name) for name in (first, second))
    if len(mine) != len(yours):
        left, right = _apart(mine, yours)
        return bool(left and right) and left != right and not _is_slip(left, right)
    pairs = [(left.lower(), right.lower()) for left, right in zip(mine, yours, strict=True)]
    return any(left != right and not _is_slip(left, right) for left, right in pairs)


def are_opposites(first: str, second: str) -> bool:
    """Whether two words, in lower case, say that a thing and its contrary are done, or are so."""
    if tuple(sorted((first, second))) in _OPPOSITES:
        return True
    short, long = sorted((first, second), key=len)
    if len(short) >= _SHORTEST_STEM and any(long == start + short for start in _UNDOING):
        return True
    return any(
        first.startswith(mine) and second.startswith(yours) and first[len(mine) :] == second[len(yours) :] != ""
        for pair in _TURNED
        for mine, yours in (pair, pair[::-1])
    )


def _apart(mine: Sequence[str], yours: Sequence[str]) -> tuple[str, str]:
    """What two names consist of besides the words that they begin and end with alike: ``gostraight`` and ``status`` of
    ``RobotGoStraight`` and ``RobotStatus``."""
    words = [[word.lower() for word in words] for words in (mine, yours)]
    for end in (0, -1):
        while all(words) and words[0][end] == words[1][end]:
            words = [row[1:] if end == 0 else row[:-1] for row in words]
    return "".join(words[0]), "".join(words[1])


def _is_slip(first: str, second: str) -> bool:
    """Whether one of two words is probably the other one misspelt."""
    if are_opposites(first, second) or _DIGITS.findall(first) != _DIGITS.findall(second):
        return False
    short, long = sorted((len(first), len(second)))
    if short <= _SHORT:
        return short > 0 and long == short + 1
    limit = max(1, long // 3)
    return distance(first, second, limit) <= limit


def common_words(first: str, second: str) -> str:
    """What two names begin with, up to the end of the last ``_`` that they share: ``front_`` of ``front_left`` and
    ``front_light``."""
    shared = "".join(left for left, _ in takewhile(lambda pair: pair[0] == pair[1], zip(first, second, strict=False)))
    return shared[: shared.rfind("_") + 1]


def have_same_words(first: str, second: str) -> bool:
    """Whether two names consist of the same words in another order, some of them perhaps written together:
    ``params_multirobot_1`` and ``multi_robot_1_params``."""
    mine, yours = ([part.lower() for part in _PARTS.split(name) if part] for name in (first, second))
    return first != second and max(len(mine), len(yours)) > 1 and (_made_of(mine, yours) or _made_of(yours, mine))


def _made_of(coarse: list[str], fine: list[str]) -> bool:
    """Whether each of some words is one, or several in a row, of others, and all of these are used."""
    left = list(fine)
    for word in sorted(coarse, key=len, reverse=True):
        runs = ((i, j) for i in range(len(left)) for j in range(i + 1, len(left) + 1) if "".join(left[i:j]) == word)
        span = next(runs, None)
        if span is None:
            return False
        left[span[0] : span[1]] = [""]  # words on both sides are no neighbours
    return not any(left)


def did_you_mean(word: str, known: Iterable[str], quote: str = "'", rivals: Collection[str] = ()) -> str:
    """``; did you mean 'x'?`` to put after a message, or nothing, as :func:`probable` says."""
    near = probable(word, known, rivals)
    return "" if near is None else meant(f"{quote}{near}{quote}")


def probable(word: str, known: Iterable[str], rivals: Collection[str] = ()) -> str | None:
    """The nearest known word; None also where one of ``rivals`` is nearer to that."""
    near = nearest(word, known)
    return None if near is None or (rivals and nearest(near, {word, *rivals}) not in (None, word)) else near


def hint(near: str | None) -> str:
    """``; did you mean 'x'?`` for a name that is near; nothing where none is."""
    return meant(f"'{near}'") if near else ""


def name_meant(name: str, known: Iterable[str]) -> str:
    """As :func:`did_you_mean`; where no name is near, the first few that ``name`` is a part of."""
    names = sorted(set(known))  # where there are '/robot' and 'robot', the first is enough
    part = name.strip("/").lower()
    holding = {
        other.strip("/"): f"'{other}'" for other in reversed(names) if part in other.lower()
    }  # '/a', not 'a' too
    near = [*reversed(holding.values())] if len(part) > _SHORT else []
    return did_you_mean(name, names) or meant(listed(near, "", shown=3))


def meant(words: str) -> str:
    """``; did you mean …?`` to put after a message, of the words for what is perhaps meant; nothing where there are
    none."""
    return f"; did you mean {words}?" if words else ""


def listed_for(name: str, names: Iterable[str]) -> str:
    """The names that there are in place of one, as :func:`listed`: where these are more than are shown, those come
    first that have a word with it in common."""
    every, words = sorted(names), _words_of(name)
    if len(every) > SHOWN:
        every.sort(key=lambda other: -len(words & _words_of(other)))
    return listed(every)


def _words_of(name: str) -> set[str]:
    return set(re.findall("[a-z]+", name.lower()))


SHOWN = 8
"""How many names a list shows."""


def listed(names: Sequence[str], otherwise: str = "none", *, shown: int = SHOWN) -> str:
    """The first ``shown`` names for a line of help, with how many more there are; ``otherwise`` where there is none."""
    more = f" and {len(names) - shown} more" if len(names) > shown else ""
    return ", ".join(names[:shown]) + more or otherwise
