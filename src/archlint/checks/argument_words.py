"""What is said of the arguments of a call that do not fit its parameters."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping, Sequence

from archlint.model import Misuse
from archlint.suggestions import nearest


def what_does_not_fit(misuse: Misuse, parameters: Sequence[str], takes: int) -> str:
    """What is missing or too much; ``takes`` is how many arguments go by position."""
    names = quoted(parameters)
    match misuse:
        case Misuse.MISSING:
            return f"{names} {'is' if len(parameters) == 1 else 'are'} missing"
        case Misuse.TOO_MANY if not takes:
            return "it takes no argument"
        case Misuse.TOO_MANY:
            return f"it takes at most {takes} {'argument' if takes == 1 else 'arguments'} by position"
        case Misuse.UNKNOWN_KEYWORD:
            return f"it has no {'parameter' if len(parameters) == 1 else 'parameters'} {names}"
    return f"{names} is given by position and by name"


def keywords_meant(unknown: Sequence[str], known: Sequence[str]) -> dict[str, str]:
    """For each keyword that a function does not have the parameter that is meant by it: one of almost the same name,
    the only one that has all of its words, or the only one of the same stem, ``reliability`` for ``reliable``.  Empty
    where that is not told for all of them."""
    meant: dict[str, str] = {}
    for keyword in unknown:
        free = [name for name in known if name not in meant.values()]
        words = set(keyword.split("_"))
        longer = [name for name in free if words < set(name.split("_"))]
        longer = longer or [name for name in free if _have_one_stem(keyword, name)]
        near = nearest(keyword, free) or (longer[0] if len(longer) == 1 else None)
        if near is None:
            return {}
        meant[keyword] = near
    return meant


_STEM = 5
"""Letters of the shortest stem that says what is meant."""


def _have_one_stem(keyword: str, name: str) -> bool:
    """Whether two single words begin with the same letters, but for the last few of the first one."""
    stem = posixpath.commonprefix([keyword, name])
    return "_" not in keyword + name and len(stem) >= max(_STEM, len(keyword) - 2)


def cure_of_keywords(unknown: Sequence[str], meant: Mapping[str, str]) -> str:
    """What to write instead of keywords that a function does not have."""
    if meant:
        return "write " + ", and ".join(f"{near}= instead of {keyword}=" for keyword, near in meant.items())
    return f"take out {' and '.join(f'{keyword}=' for keyword in unknown)}"


def quoted(names: Sequence[str]) -> str:
    """Names in quotes: ``'a', 'b' and 'c'``."""
    return " and ".join(filter(None, (", ".join(map(repr, names[:-1])), *map(repr, names[-1:]))))


__all__ = ["cure_of_keywords", "keywords_meant", "quoted", "what_does_not_fit"]
