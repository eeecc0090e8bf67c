"""The folders that a path lies in."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator


def folders_above(path: str) -> Iterator[str]:
    """The folders that a path lies in, the innermost first; ``/`` is the last one of an absolute path."""
    while (folder := posixpath.dirname(path)) not in ("", path):
        yield folder
        path = folder
