"""Which files git tracks, as the index of a repository lists them: a pattern never ignores one of these.

The index is read as git's ``Documentation/gitformat-index`` describes it; git itself is not run.  Of an index that is
split or damaged, what can be read counts, and of one that is too large nothing does.
"""

from __future__ import annotations

import os
import struct
from bisect import bisect_left
from functools import cached_property

_MOST_BYTES = 60_000_000
_HEADER = struct.Struct(">4sII")
_STAT = 40
"""Bytes at the beginning of an entry: times, device, mode, owner and size."""
_HASHES = (20, 32)
"""Bytes of a name of an object: of SHA-1, and of SHA-256."""
_EXTENDED = 0x4000
_LENGTH = 0x0FFF
"""Of the flags of an entry: whether there are more of them, and the bytes of its path (at most so many are told)."""
_SKIPPED = 0x4000
"""Of the further flags: a sparse checkout leaves the file out."""
_TIMES = 16
"""The first bytes of an entry: when the file was changed, as git saw it last; zeros where it never did."""
_Entry = tuple[bytes, bool]
"""A path, and whether the file was never put beside the index."""


class Tracked:
    """The files that the repository in ``root`` tracks; its index is read when it is first asked for."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.index = os.path.join(_git_folder(root), "index")

    @property
    def is_read(self) -> bool:
        """Whether somebody has asked."""
        return "_paths" in vars(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Tracked) and self.index == other.index

    def __hash__(self) -> int:
        return hash(self.index)

    def has(self, path: str, is_folder: bool = False) -> bool:
        """Whether a file is tracked, or a folder has a tracked file in it or is a submodule."""
        return _has(self._paths, self._below(path), is_folder)

    def has_elsewhere(self, path: str) -> bool:
        """Whether a path is a tracked file that this checkout never had, or a folder with one: the checkout is sparse,
        or of a partial clone.  A file that was there and is deleted is none of them."""
        return _has(self.never_checked_out, self._below(path), is_folder=True)

    @cached_property
    def never_checked_out(self) -> list[bytes]:
        """The tracked files that this checkout never had, sorted."""
        return never_checked_out(self.index)

    @cached_property
    def _paths(self) -> list[bytes]:
        return sorted(paths_of_index(_bytes(self.index)))

    def _below(self, path: str) -> bytes:
        return os.fsencode(path[len(self.root.rstrip(os.sep)) + 1 :].replace(os.sep, "/"))


def _has(paths: list[bytes], path: bytes, is_folder: bool) -> bool:
    if _is_at(paths, path):
        return True
    if not is_folder:
        return False
    position = bisect_left(paths, path + b"/")
    return position < len(paths) and paths[position].startswith(path + b"/")


def _is_at(paths: list[bytes], path: bytes) -> bool:
    position = bisect_left(paths, path)
    return position < len(paths) and paths[position] == path


def _git_folder(root: str) -> str:
    """The folder that git keeps its things in: ``.git``, or what a file of that name says (of a submodule, or of a
    linked worktree)."""
    path = os.path.join(root, ".git")
    if not os.path.isfile(path):
        return path
    first = _bytes(path, 4096).split(b"\n", 1)[0]
    if not first.startswith(b"gitdir:"):
        return path
    return os.path.normpath(os.path.join(root, os.fsdecode(first.removeprefix(b"gitdir:").strip())))


def _bytes(path: str, most: int = _MOST_BYTES) -> bytes:
    """What a file holds; nothing where it cannot be read or has more than ``most`` bytes."""
    try:
        if not os.path.isfile(path) or os.path.getsize(path) > most:
            return b""
        with open(path, "rb") as stream:
            return stream.read(most)
    except (OSError, ValueError):
        return b""


def never_checked_out(index: str) -> list[bytes]:
    """The files that an index lists and that were never put beside it, sorted."""
    return sorted(path for path, absent in _all_entries(_bytes(index)) if absent)


def repository_around(path: str) -> Tracked | None:
    """The repository that a path lies in; None where there is none."""
    folder = os.path.dirname(path)
    while not os.path.lexists(os.path.join(folder, ".git")):
        folder, below = os.path.dirname(folder), folder
        if folder == below:
            return None
    return Tracked(folder)


def paths_of_index(data: bytes) -> list[bytes]:
    """The paths of an index, from the root of its repository; none of what is no index."""
    return [path for path, _ in _all_entries(data)]


def _all_entries(data: bytes) -> list[_Entry]:
    if len(data) < _HEADER.size:
        return []
    mark, version, count = _HEADER.unpack_from(data)
    if mark != b"DIRC" or version not in (2, 3, 4):
        return []
    for hash_size in _HASHES:
        entries = _entries(data, version, count, hash_size)
        if entries is not None:
            return entries
    return []


def _entries(data: bytes, version: int, count: int, hash_size: int) -> list[_Entry] | None:
    """All entries; None if the entries do not have this form."""
    entries: list[_Entry] = []
    at, before = _HEADER.size, b""
    for _ in range(count):
        start = at
        at += _STAT + hash_size + 2
        if at > len(data):
            return None
        flags = int.from_bytes(data[at - 2 : at], "big")
        absent = not any(data[start : start + _TIMES])
        if flags & _EXTENDED:
            absent = absent or bool(int.from_bytes(data[at : at + 2], "big") & _SKIPPED)
            at += 2
        kept = b""
        if version == 4:
            dropped, at = _number(data, at)
            kept = before[: len(before) - dropped] if dropped <= len(before) else b""
        end = data.find(b"\0", at)
        path = kept + data[at:end]
        if end < 0 or not path or min(len(path), _LENGTH) != flags & _LENGTH:
            return None
        entries.append((path, absent))
        before = path
        at = end + 1 if version == 4 else start + (end - start + 8) // 8 * 8
    return entries


def index_of(paths: list[bytes]) -> bytes:
    """An index that lists these paths, as :func:`paths_of_index` reads it; what git keeps of each file is left out."""
    entries = []
    for path in sorted(paths):
        entry = bytes(_STAT + _HASHES[0]) + min(len(path), _LENGTH).to_bytes(2, "big") + path
        entries.append(entry + bytes(8 - len(entry) % 8))
    return _HEADER.pack(b"DIRC", 2, len(entries)) + b"".join(entries)


def _number(data: bytes, at: int) -> tuple[int, int]:
    """A number as a pack file writes an offset, and where it ends."""
    value = -1
    while at < len(data):
        byte = data[at]
        value, at = (value + 1) << 7 | byte & 0x7F, at + 1
        if not byte & 0x80:
            break
    return max(value, 0), at
