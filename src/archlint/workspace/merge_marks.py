"""The marks that git leaves in a file where it could not merge two sides."""

from __future__ import annotations

import re

_MARKS = [re.compile(mark, re.MULTILINE) for mark in (r"^<<<<<<< .+\n", r"^=======\r?\n", r"^>>>>>>> ")]
"""In their order; each is looked for behind the one before, so that marks without an end are read once."""
UNMERGED = "the marks of a merge are left in this file"


def merge_in(text: str) -> int | None:
    """Where the first marks begin; None for a text without the marks of both sides."""
    first, at = None, 0
    for mark in _MARKS:
        match = mark.search(text, at)
        if match is None:
            return None
        first, at = (match.start() if first is None else first), match.end()
    return first


__all__ = ["UNMERGED", "merge_in"]
