"""Why there is nothing to check: what was looked for, and what was there instead."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice

from archlint.suggestions import listed

_MOST = 10_000
"""How many files are counted."""
_KINDS = {
    ".cpp": "C++",
    ".cc": "C++",
    ".cxx": "C++",
    ".hpp": "C++",
    ".h": "C++",
    ".rs": "Rust",
}
"""What files are, by their suffixes; of others the suffix says it."""


def nothing_found(paths: Sequence[str]) -> str:
    """The message where no file of ``paths`` is one that archlint reads."""
    where = ", ".join(paths)
    text = f"nothing to check in {where}: no package.xml, no Python file and no launch file; there {_there(paths)}"
    advice = next((advice for path in paths if (advice := _to_be_fetched(path))), "")
    return f"{text}\n{advice}" if advice else text


def _there(paths: Sequence[str]) -> str:
    files = list(islice((name for path in paths for name in _files(path)), _MOST))
    if not files:
        return "is no file at all"
    count = Counter(_kind(name) for name in files)
    kinds = [f"{number} {kind}" for kind, number in sorted(count.items(), key=lambda row: (-row[1], row[0]))]
    verb, noun = ("is", "file") if len(files) == 1 else ("are", "files")
    return f"{verb} {listed(kinds, shown=4)} {noun}{'; C++ is not read' if count['C++'] else ''}"


def _kind(name: str) -> str:
    suffix = os.path.splitext(name)[1]
    return _KINDS.get(suffix, suffix or "other")


def _files(path: str) -> Iterator[str]:
    if os.path.isfile(path):
        yield os.path.basename(path)
    for _, folders, names in os.walk(path):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from (name for name in names if not name.startswith("."))


def _to_be_fetched(path: str) -> str:
    """What brings the sources of a workspace that has none yet; empty where nothing says so."""
    for folder in (path, os.path.dirname(os.path.abspath(path))):
        names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        lists = [name for name in names if name.endswith(".repos")]
        if lists:
            return f"The sources that {lists[0]} lists may not be there yet: vcs import src < {lists[0]}"
        if ".gitmodules" in names:
            return "The submodules may not be there yet: git submodule update --init --recursive"
    return ""


__all__ = ["nothing_found"]
