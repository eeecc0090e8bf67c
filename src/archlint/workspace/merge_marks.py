"""The marks that git leaves in a file where it could not merge two sides."""

from __future__ import annotations

import re

_MERGE = re.compile(r"^<<<<<<< .+\n(?:.*\n)*?=======\r?\n(?:.*\n)*?>>>>>>> ", re.MULTILINE)
UNMERGED = "the marks of a merge are left in this file"


def merge_in(text: str) -> int | None:
    """Where the first marks begin; None for a text without the marks of both sides."""
    marks = _MERGE.search(text)
    return None if marks is None else marks.start()


__all__ = ["UNMERGED", "merge_in"]
