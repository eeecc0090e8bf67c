"""Why there is nothing to check: what was looked for, and what was there instead."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice

from archlint.disk import walk
from archlint.suggestions import listed
from archlint.workspace.kinds import kind_of
from archlint.workspace.model import CODE_KINDS, LAUNCH_TEXT_KINDS, SourceKind
from archlint.workspace.pruning import MARKERS

_MOST = 10_000
"""How many files are counted."""
_READ: tuple[SourceKind | None, ...] = (*CODE_KINDS, *LAUNCH_TEXT_KINDS, "package_xml", "interface")
"""The kinds of which one file is enough for a check."""
_KINDS = {
    ".cpp": "C++",
    ".cc": "C++",
    ".cxx": "C++",
    ".hpp": "C++",
    ".h": "C++",
    ".rs": "Rust",
}
"""What files are, by their suffixes; of others the suffix says it."""


def nothing_found(paths: Sequence[str], excluding: str | None = None) -> str:
    """The message where no file of ``paths`` is one that archlint reads.

    ``excluding`` is the configuration without whose ``exclude`` there would be one.
    """
    where = ", ".join(paths)
    example = next(
        (_below(folder, name) for path in paths for folder, name in _files(path) if _is_read(folder, name)), ""
    )
    if example and excluding is not None:
        file = os.path.basename(excluding)
        return f"nothing to check in {where}: `exclude` in {file} leaves out all of it, such as {example}"
    if example:
        return f"nothing to check in {where}: all of it is left out, such as {example}{_why_left_out(example)}"
    text = (
        f"nothing to check in {where}: no package.xml, no Python or C++ file and no launch file; there {_there(paths)}"
    )
    advice = next((advice for path in paths if (advice := _to_be_fetched(path))), "")
    return f"{text}\n{advice}" if advice else text


def _there(paths: Sequence[str]) -> str:
    files = list(islice((name for path in paths for _, name in _files(path)), _MOST))
    if not files:
        return "is no file at all"
    count = Counter(_kind(name) for name in files)
    kinds = [f"{number} {kind}" for kind, number in sorted(count.items(), key=lambda row: (-row[1], row[0]))]
    verb, noun = ("is", "file") if len(files) == 1 else ("are", "files")
    return f"{verb} {listed(kinds, shown=4)} {noun}"


def _kind(name: str) -> str:
    suffix = os.path.splitext(name)[1]
    return _KINDS.get(suffix, suffix or "other")


def _files(path: str) -> Iterator[tuple[str, str]]:
    """The files there that are not hidden: the folder and the name of each."""
    if os.path.isfile(path):
        yield os.path.split(path)
    for around, folders, names in walk(path):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from ((around, name) for name in sorted(names) if not name.startswith("."))


def _is_read(folder: str, name: str) -> bool:
    return kind_of(name, os.path.basename(folder)) in _READ


def _below(folder: str, name: str) -> str:
    return os.path.normpath(os.path.join(folder, name)).replace(os.sep, "/")


def _why_left_out(file: str) -> str:
    """What leaves a file out that ``exclude`` does not."""
    parts = file.split("/")[:-1]
    for folder in ("/".join(parts[: end + 1]) or "/" for end in range(len(parts))):
        for marker in MARKERS:
            if os.path.exists(os.path.join(folder, marker)):
                return f": there is {_below(folder, marker)}"
    return ": git ignores it, or a build has left it"


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
