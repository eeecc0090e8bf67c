"""Standard streams that are closed, as ``>&-`` of a shell closes them."""

from __future__ import annotations

import os
import sys


def reopen_closed() -> None:
    """Put something in place of each standard stream that is closed.

    Otherwise the next file that is opened gets the number of the closed stream, and what is said goes into that file.
    Standard output becomes a file that refuses whatever is written, which ends a run that has something to say.
    """
    if sys.stdin is None:
        sys.stdin = os.fdopen(os.open(os.devnull, os.O_RDONLY), encoding="utf-8")
    if sys.stdout is None:
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_RDONLY), "w", encoding="utf-8")
    if sys.stderr is None:
        sys.stderr = os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8")


__all__ = ["reopen_closed"]
