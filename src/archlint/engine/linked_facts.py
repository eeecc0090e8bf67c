"""Shards of several folders as one workspace: everything that a run asks the disk for otherwise."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from msgspec import structs

from archlint.engine.facts_file import CodeRow, FileRow, ProblemRow, Shard
from archlint.engine.facts_folder import FactsError, read
from archlint.syntax.cache import NullStore, Stamp, digest_of
from archlint.syntax.files import language_of, source_digest
from archlint.syntax.python.gate import Refusal
from archlint.workspace.discovery import Excluder
from archlint.workspace.membership import place
from archlint.workspace.model import Link, Problem, SourceFile, SourceKind, Workspace
from archlint.workspace.snapshot import Entry, Snapshot

_Row = TypeVar("_Row")


class LinkedFacts:
    """The facts of some shards, by the names that errors give them.  All files lie below ``base`` (the working
    directory), as far as anybody can tell.  Raises :class:`FactsError` for shards that contradict each other."""

    def __init__(self, shards: Mapping[str, Shard], base: str | None = None) -> None:
        self._base = Path(base or os.getcwd())
        self._shards = list(shards.values())
        self._entries = _merged({name: shard.entries for name, shard in shards.items()})
        files = _merged(
            {
                name: {row.path: structs.replace(row, context=False) for row in shard.files}
                for name, shard in shards.items()
            }
        )
        asked = {row.path for shard in self._shards for row in shard.files if not row.context}
        self._files = {
            path: row if path in asked else structs.replace(row, context=True) for path, row in files.items()
        }
        code = _merged({name: shard.code for name, shard in shards.items()})
        folders = [folder for shard in self._shards for folder in shard.folders]
        self.tree = Snapshot(self._base, self._entries, folders)
        self.cache = FactsCache(
            {self._path(path): (self._digest(files[path].kind, path, row), row) for path, row in code.items()}
        )

    @classmethod
    def of_folders(cls, folders: Sequence[str]) -> LinkedFacts:
        """Those that :mod:`archlint.engine.facts_folder` has written.  Raises :class:`FactsError`."""
        return cls({name: shard for folder in folders for name, shard in read(Path(folder)).items()})

    def workspace(self, exclude: Sequence[str]) -> Workspace:
        """The workspace that they make up, without what ``exclude`` matches."""
        excluder = Excluder(exclude, str(self._base))
        rows = [row for path, row in self._files.items() if not any(map(excluder, _from_top(path)))]
        problems = dict.fromkeys(_problem(row) for shard in self._shards for row in shard.problems)
        workspace = place(
            str(self._base),
            [self._source_file(number, row) for number, row in enumerate(rows, 1)],
            problems,
            (self._path(folder) for shard in self._shards for folder in shard.complete),
            self._read,
        )
        return replace(workspace, idle_exclusions=tuple(excluder.idle))

    def read(self, file: SourceFile) -> bytes | Refusal:
        """The bytes of a file, as :func:`archlint.syntax.python.gate.read_bytes` gives them."""
        try:
            return self._read(file)
        except OSError as error:
            return Refusal(1, 1, f"cannot read this file: {error.strerror}")

    def _read(self, file: SourceFile) -> bytes:
        entry = self._entries.get(file.relative, Entry(errno=errno.ENOENT))
        if entry.data is None:
            number = entry.errno or errno.ENOENT
            raise OSError(number, os.strerror(number), file.relative)
        return entry.data

    def _digest(self, kind: SourceKind, path: str, row: CodeRow) -> str:
        """That of the source, which is the same wherever it is compiled."""
        data = self._entries[path].data
        if data is None:
            return digest_of(row.screened + b"\0" + row.facts)
        return source_digest(data, language_of(kind))

    def _path(self, path: str) -> str:
        return os.path.normpath(self._base / path)

    def _source_file(self, number: int, row: FileRow) -> SourceFile:
        links = tuple(Link(self._path(link)) for link in row.links)
        return SourceFile(
            self._path(row.path), row.path, row.kind, None, None, row.size, 0, number, row.context, 0, links
        )


class FactsCache(NullStore):
    """A cache that knows every file: what it says, and what the screen says of it."""

    def __init__(self, rows: Mapping[str, tuple[str, CodeRow]]) -> None:
        self._digests: dict[str, str] = {}
        self._payloads: dict[str, bytes] = {}
        for path, (digest, row) in rows.items():
            if row.facts:
                self._digests[path] = digest
                self._payloads[digest] = row.screened or row.facts
                self._payloads[f"all-{digest}"] = row.facts

    def lookup(self, path: str, stamp: Stamp) -> str | None:
        return self._digests.get(path)

    def get(self, digest: str) -> bytes | None:
        return self._payloads.get(digest)


def _merged(shards: Mapping[str, Mapping[str, _Row]]) -> dict[str, _Row]:
    """The rows of all shards by path; raises :class:`FactsError` where two say different things of one file."""
    merged: dict[str, _Row] = {}
    origin: dict[str, str] = {}
    for name, rows in shards.items():
        for path, row in rows.items():
            known = merged.setdefault(path, row)
            if known != row:
                raise FactsError(f"{origin[path]} and {name} disagree about {path}: {_APART}")
            origin.setdefault(path, name)
    return dict(sorted(merged.items()))


_APART = "give the facts of each checkout a folder of its own with `archlint facts --prefix`, or write both again"


def _from_top(path: str) -> Iterator[str]:
    """A path and the folders around it, the outermost first."""
    parts = path.split("/")
    for number in range(1, len(parts) + 1):
        yield "/".join(parts[:number])


def _problem(row: ProblemRow) -> Problem:
    return Problem(row.path, row.line, row.column, row.message, row.help)


__all__ = ["FactsCache", "LinkedFacts"]
