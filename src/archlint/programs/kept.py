"""Programs that an earlier run has followed: what became of each, and what that was decided by.

A program is followed again only where something that it read is not as it was: the code of a file, what an import
means, which modules ran before it, the interfaces.  The order in which programs are followed is that of a run without
any of this, and so is what they give.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import msgspec

from archlint.model.encoding import NotEncodable, NotPrograms, decode, encode_noting
from archlint.programs.followed import Definition, Followed

if TYPE_CHECKING:
    from archlint.interpreter.modules import ModuleIndex
    from archlint.interpreter.reads import Lookup, Reads

ProgramKey = tuple[object, ...]
"""What is followed: an entry point with what it is started with, a script, a class, a function, a module."""


class _Entry(msgspec.Struct, array_like=True):
    """One program: its numbers are rows of the tables."""

    key: str
    late: bool
    everything: bool
    files: list[int]
    used: list[int]
    lookups: list[int]
    imports: list[list[int]]
    writers: list[int]
    writes: bool
    result: bytes


class _Kept(msgspec.Struct, array_like=True):
    surroundings: str
    """What all programs depend on."""
    everything: str
    """What the few depend on that ask for all modules."""
    files: list[tuple[str, str]]
    """Path and fingerprint."""
    lookups: list[tuple[int, str, int, int]]
    """File, name, dots, and the file that it means; -1 for none."""
    entries: list[_Entry]


@dataclass
class _Row:
    """A program of this run: of its entry, or as it was followed."""

    late: bool
    everything: bool
    files: Collection[str]
    used: Collection[str]
    lookups: dict[Lookup, str | None]
    imports: list[list[str]]
    writers: Collection[str]
    """The modules that had changed objects of those that it uses; none of ``imports``."""
    writes: bool
    """Whether its imports have changed objects of other modules."""
    result: bytes


@dataclass
class KeptPrograms:
    """What is known of programs from earlier runs, and what this run adds.

    ``fingerprint`` says of a file, by its path, what decides what it means: its code, its package, its name; None where
    that cannot be said.  ``surroundings`` stands for what decides beside the files.
    """

    index: ModuleIndex
    fingerprint: Callable[[str], str | None]
    surroundings: str
    import_now: Callable[[Iterable[str]], None]
    """Imports modules for which a program answers that is not followed again."""
    payload: bytes | None = None
    changed: bool = False
    """Whether there is something new to keep."""
    _rows: dict[str, _Row] = field(default_factory=dict)
    _fingerprints: dict[str, str | None] = field(default_factory=dict)
    _lookups: dict[Lookup, str | None] = field(default_factory=dict)
    _first: dict[str, str] = field(default_factory=dict)
    """By the path of a module that a program has imported which was not followed again: the module whose import led to
    it."""
    _owners: dict[int, tuple[str, object]] = field(default_factory=dict)
    """Which program has an object, by the id of the object, which stays alive here."""

    def __post_init__(self) -> None:
        self._known = {entry.key: entry for entry in self._loaded()}

    def _loaded(self) -> list[_Entry]:
        try:
            kept = None if self.payload is None else msgspec.msgpack.decode(self.payload, type=_Kept)
        except (msgspec.MsgspecError, ValueError, RecursionError):
            kept = None
        self._kept = kept or _Kept("", "", [], [], [])
        return self._kept.entries if self._kept.surroundings == self.surroundings else []

    # ------------------------------------------------------------------------------------------- what is known

    def get(self, key: ProgramKey, late: bool) -> Followed | None:
        """What became of a program, if it would be the same again."""
        entry = self._known.get(repr(key))
        if entry is None or entry.late is not late:
            return None
        try:
            row = self._row(entry)
            if row is None or not self._fits(row):
                return None
            [parts] = decode(entry.result)
            result = _followed(parts)
        except (LookupError, TypeError, ValueError):
            return None
        self._rows[entry.key] = row
        for group in row.imports:
            self._first.update(dict.fromkeys(group, group[0]))
            self.index.imported.update(group)
        if row.writes:  # what they have changed has to be here
            self.import_now(path for group in row.imports for path in group)
        return result

    def read_by(self) -> Iterable[str]:
        """The files whose code the programs have seen, followed again or not."""
        return sorted({path for row in self._rows.values() for path in row.files})

    def first_of(self, path: str) -> str | None:
        """The module whose import led to that of another, when it was imported first by a program that was not
        followed again.  It is told once."""
        first = self._first.get(path)
        if first is not None:
            self._first = {other: of for other, of in self._first.items() if of != first}
        return first

    def all_first(self) -> list[str]:
        """All modules that :meth:`first_of` may name, in the order in which they were imported."""
        return list(dict.fromkeys(self._first.values()))

    def _row(self, entry: _Entry) -> _Row | None:
        """What an entry depends on; None where some of it is not as it was."""
        if not all(self._same_file(number) for number in entry.files):
            return None
        if entry.everything and self._kept.everything != self._everything():
            return None
        lookups = {}
        for number in entry.lookups:
            file, name, dots, found = self._kept.lookups[number]
            lookup = self._path(file), name, dots
            lookups[lookup] = None if found < 0 else self._path(found)
            if self._means(lookup) != lookups[lookup]:
                return None
        files, used = [[self._path(number) for number in numbers] for numbers in (entry.files, entry.used)]
        imports = [[self._path(number) for number in group] for group in entry.imports]
        writers = [self._path(number) for number in entry.writers]
        rest = entry.writes, entry.result
        return _Row(entry.late, entry.everything, files, used, lookups, imports, writers, *rest)

    def _fits(self, row: _Row) -> bool:
        """Whether the modules that ran before the program are those that ran before it then."""
        own = {path for group in row.imports for path in group}
        before = self.index.imported
        if not own.isdisjoint(before) or any(path not in own and path not in before for path in row.used):
            return False
        return self.index.writers(row.used) - own == set(row.writers)

    def _path(self, number: int) -> str:
        return self._kept.files[number][0]

    def _same_file(self, number: int) -> bool:
        path, fingerprint = self._kept.files[number]
        return self._print_of(path) == fingerprint

    def _print_of(self, path: str) -> str | None:
        if path not in self._fingerprints:
            self._fingerprints[path] = self.fingerprint(path)
        return self._fingerprints[path]

    def _means(self, lookup: Lookup) -> str | None:
        if lookup not in self._lookups:
            importer, name, dots = lookup
            file = self.index.at(importer)
            found = None if file is None else self.index.file_of(file, name, dots)
            self._lookups[lookup] = None if found is None else found.path
        return self._lookups[lookup]

    def _everything(self) -> str:
        prints = [(file.path, self._print_of(file.path)) for file in self.index.files()]
        return hashlib.sha256(repr(prints).encode()).hexdigest()

    # ------------------------------------------------------------------------------------------- what is new

    def put(self, key: ProgramKey, late: bool, result: Followed, reads: Reads) -> None:
        """Keep what became of a program, if it can stand alone."""
        if any(self._print_of(path) is None for path in reads.files):
            return
        self.changed = True
        try:
            payload, objects = encode_noting([_parts(result)])
        except NotEncodable:
            return
        name = repr(key)
        shared = {owner for item in objects if (owner := self._owner(item, name)) != name}
        if shared:  # they would not share it any more
            for other in shared:
                self._rows.pop(other, None)
            return
        own = {path for group in reads.imports for path in group}
        self._rows[name] = _Row(
            late,
            reads.everything,
            sorted(reads.files),
            sorted(reads.used),
            reads.lookups,
            reads.imports,
            sorted(self.index.writers(reads.used) - own),
            any(self.index.writes(path) for path in own),
            payload,
        )

    def _owner(self, item: object, name: str) -> str:
        return self._owners.setdefault(id(item), (name, item))[0]

    def dump(self) -> bytes:
        """All that is known, for the next run."""
        rows = self._rows | {key: row for key, row in self._others() if key not in self._rows}
        files: dict[str, int] = {}
        lookups: dict[Lookup, tuple[int, int, str | None]] = {}

        def number(path: str) -> int:
            return files.setdefault(path, len(files))

        def look_up(lookup: Lookup, found: str | None) -> int:
            if lookup not in lookups:
                lookups[lookup] = (len(lookups), number(lookup[0]), found)
                if found is not None:
                    number(found)
            return lookups[lookup][0]

        entries = [
            _Entry(
                key,
                row.late,
                row.everything,
                [number(path) for path in row.files],
                [number(path) for path in row.used],
                [look_up(lookup, found) for lookup, found in row.lookups.items()],
                [[number(path) for path in group] for group in row.imports],
                [number(path) for path in row.writers],
                row.writes,
                row.result,
            )
            for key, row in sorted(rows.items())
        ]
        table = [
            (at, name, dots, -1 if found is None else files[found])
            for (_, name, dots), (_, at, found) in lookups.items()
        ]
        prints = [(path, self._print_of(path) or "") for path in files]
        return msgspec.msgpack.encode(_Kept(self.surroundings, self._everything(), prints, table, entries))

    def _others(self) -> Iterable[tuple[str, _Row]]:
        """The programs that nobody asked for this time, and that are as they were."""
        for key, entry in self._known.items():
            row = self._row(entry) if key not in self._rows else None
            if row is not None:
                yield key, row


def _parts(result: Followed) -> list[object]:
    definitions = [definition.parts() for definition in result.definitions]
    return [result.program, result.steps, sorted(result.ran), sorted(result.made), result.holders, definitions]


def _followed(parts: Sequence[Any]) -> Followed:
    program, steps, ran, made, holders, definitions = parts
    rows = [Definition(*row) for row in definitions]
    return Followed(program, steps, frozenset(ran), frozenset(made), holders, rows)


class NothingKept:
    """No cache: each program is followed."""

    def get(self, key: ProgramKey, late: bool) -> Followed | None:
        return None

    def put(self, key: ProgramKey, late: bool, result: Followed, reads: Reads) -> None:
        return None

    def first_of(self, path: str) -> str | None:
        return None

    def all_first(self) -> list[str]:
        return []


__all__ = ["KeptPrograms", "NotPrograms", "NothingKept", "ProgramKey"]
