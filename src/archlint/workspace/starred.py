"""Patterns of git with many stars, matched in time that grows with the path and the pattern, and not with their power.

A library makes one regular expression of a pattern, and ``*a*a*a*a*b`` then takes longer than anybody waits.
"""

from __future__ import annotations

import re
from fnmatch import translate

from archlint.name_paths import NamePattern, matches_names

_STARS = 2
"""How many stars of one name a regular expression may try against each other."""


def has_many_stars(line: str) -> bool:
    """Whether a line of a pattern file needs a :class:`StarredPattern`."""
    parts = line.split("/")
    return max(len(re.findall(r"\*+", part)) for part in parts) > _STARS or parts.count("**") > _STARS


class StarredPattern:
    """One line of a pattern file."""

    def __init__(self, line: str) -> None:
        """Raises ``re.error`` for what is no pattern."""
        text = line.rstrip()
        self.ignores = not text.startswith("!")
        text = text.removeprefix("!")
        self._of_folders = text.endswith("/")
        self._parts = [None if part == "**" else _name(part) for part in text.strip("/").split("/")]

    def speaks_of(self, path: str) -> bool:
        """Whether the pattern is about this very path; that of a folder ends in ``/``."""
        if self._of_folders and not path.endswith("/"):
            return False
        return matches_names(self._parts, path.rstrip("/").split("/"))


def _name(part: str) -> NamePattern:
    """A pattern for one name; ``translate`` makes expressions that do not go back to a star once the next has its
    place."""
    plain = re.sub(r"\\(.)", r"[\1]", part)
    return re.compile(translate(plain.replace("[^", "[!"))).match
