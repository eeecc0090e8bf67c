"""The words of suppressions, for every kind of file, and the words that look like one and mean nothing."""

from __future__ import annotations

import re
import sys

SUPPRESSION = r"archlint:\s*ignore(-file)?(?![\w-])\s*(?:\[([^\[\]]*)\])?"
"""What follows the mark of a comment; the groups are ``-file`` and the codes."""

CODES = 2
"""The group of the codes."""


def codes_in(match: re.Match[str]) -> list[str]:
    """The codes that a match of :data:`SUPPRESSION` lists, as written."""
    return [code for code in map(str.strip, (match[CODES] or "").split(",")) if code]


def listed_at(match: re.Match[str], column: int) -> tuple[int, int] | None:
    """First and last column (exclusive) of the list of codes, brackets included, where the match is at ``column``."""
    start = column - match.start()
    return None if match[CODES] is None else (start + match.start(CODES) - 1, start + match.end(CODES) + 1)


_WORDS = re.compile(r"[^#\w]*\w")


def gives_reason(line: str, start: int, end: int = sys.maxsize) -> bool:
    """Whether the words behind the codes of a suppression, which end at ``start``, say something: those of another
    comment do not count."""
    return _WORDS.match(line, start, end) is not None


_FAMILIES = "ACT|API|ARC|CBG|GRF|LCH|LNT|MSG|NME|OWN|PKG|PRM|QOS|SRV|TMO|TOP"
"""Those whose codes no other linter has: ruff knows an EXE001, too."""

_LOOKALIKE = re.compile(
    r"archlint:\s*(?!ignore(?:-file)?(?![\w-]))(?:disable|enable|ignor|noqa|nolint|off|skip|suppress)[\w-]*"
    rf"|\bnoqa\s*[:\[]\s*(?:[A-Z]+[0-9]+,\s*)*(?:{_FAMILIES})[0-9]{{3}}"
)


def lookalike(text: str) -> re.Match[str] | None:
    """The first words that were meant as a suppression and are none: ``archlint: disable``, ``noqa: TMO001``."""
    return _LOOKALIKE.search(text)
