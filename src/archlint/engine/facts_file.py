"""The form of a shard: what ``check`` needs to know of the files of one package, without the disk that they lie on.

docs/facts.md describes it.  Anybody may have written a shard, so it is data only: it is decoded into these types, and
each path and each file's facts are looked at before anything is used.
"""

from __future__ import annotations

import posixpath
import zlib
from collections.abc import Iterable
from typing import Annotated

import msgspec

from archlint.syntax import facts
from archlint.workspace.folders import folders_above
from archlint.workspace.model import COMPILED_KINDS, SourceKind
from archlint.workspace.snapshot import Entry

FORMAT_VERSION = 3
"""Of shards and of their index: raised whenever the form or its meaning changes."""
MAX_BYTES = 1_000_000_000
"""A shard that is larger than this, once unpacked, is not read."""

_Number = Annotated[int, msgspec.Meta(ge=1, le=10_000_000)]
_Size = Annotated[int, msgspec.Meta(ge=0, le=MAX_BYTES)]


class OddShard(Exception):
    """What is wrong with a shard; ``str()`` says it."""


class FileRow(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """A file that archlint reads.  A ``context`` file is read so that imports resolve; nothing is reported for it."""

    path: str
    kind: SourceKind
    size: _Size
    context: bool = False
    links: list[str] = []
    """The paths of the symbolic links that give a Python file other names."""


class CodeRow(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """What a file of Python or C++ says: its encoded facts, empty where it could not be read.  ``screened`` is empty
    for a file that has some of the words that matter in ROS; for others it names the modules that they import, a line
    each after ``-`` (``-1`` for ROS 1)."""

    screened: bytes
    facts: bytes


class ProblemRow(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """A file or folder that could not be read."""

    path: str
    line: _Number
    column: _Number
    message: str
    help: str | None = None


class Shard(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """All paths are relative to one folder, that of the workspace, with ``/``."""

    files: list[FileRow]
    code: dict[str, CodeRow]
    entries: dict[str, Entry]
    """All files, whether archlint reads them or not."""
    folders: list[str]
    """The folders in which there are no entries."""
    complete: list[str]
    """The folders of which all files are here."""
    problems: list[ProblemRow]


def packed(shard: Shard) -> bytes:
    """A shard as bytes, always the same.  Raises :class:`OddShard` for a file name that is no UTF-8."""
    try:
        return zlib.compress(msgspec.msgpack.encode(shard, order="deterministic"), 6)
    except UnicodeEncodeError as error:
        raise OddShard(f"the file name {error.object!r} is not UTF-8") from None


def unpacked(data: bytes) -> Shard:
    """Raises :class:`OddShard`."""
    unpacking = zlib.decompressobj()
    try:
        raw = unpacking.decompress(data, MAX_BYTES)
        if not unpacking.eof or unpacking.unused_data:
            raise OddShard("it is cut off or too large")
        shard = msgspec.msgpack.decode(raw, type=Shard)
    except (zlib.error, msgspec.MsgspecError, ValueError, RecursionError) as error:
        raise OddShard(f"it is damaged ({error})") from None
    _check(shard)
    return shard


def _check(shard: Shard) -> None:
    linked = (entry.link.removesuffix("/") for entry in shard.entries.values() if entry.link)
    links = (link for file in shard.files for link in file.links)
    problems = (problem.path for problem in shard.problems)
    _check_paths((*shard.entries, *shard.folders, *shard.complete, *linked, *links, *problems))
    folders = {folder for path in shard.entries for folder in folders_above(path)}
    if not folders.isdisjoint(shard.entries):
        raise OddShard(f"{min(folders & shard.entries.keys())} is both a file and a folder")
    kinds = {file.path: file.kind for file in shard.files}
    if len(kinds) != len(shard.files):
        raise OddShard("a file is listed twice")
    unknown = kinds.keys() - shard.entries.keys()
    if unknown:
        raise OddShard(f"the content of {min(unknown)} is missing")
    compiled = {path for path, kind in kinds.items() if kind in COMPILED_KINDS}
    if compiled != shard.code.keys():
        raise OddShard(f"{min(compiled ^ shard.code.keys())} has no facts, or has them without being code")
    for path, row in shard.code.items():
        _check_facts(path, row)


def _check_facts(path: str, row: CodeRow) -> None:
    if row.screened and not row.screened.startswith(b"-"):
        raise OddShard(f"what {path} imports is damaged")
    if row.facts and facts.decode(row.facts) is None:
        raise OddShard(f"the facts of {path} are damaged, or of another version of archlint")


def _check_paths(paths: Iterable[str]) -> None:
    for path in paths:
        leads_out = path == ".." or path.startswith(("/", "../"))
        if not path or "\0" in path or leads_out or posixpath.normpath(path) != path:
            raise OddShard(f"{path!r} is not a path inside the workspace")


__all__ = ["FORMAT_VERSION", "CodeRow", "FileRow", "OddShard", "ProblemRow", "Shard", "packed", "unpacked"]
