"""What an earlier run has followed, programs and launches: what became of each, and what that was decided by.

A program is followed again only where something that it read is not as it was: the code of a file, what an import
means, which modules ran before it, the interfaces, what it asked of the disk.  The order in which programs are followed
is that of a run without any of this, and so is what they give.
"""

from __future__ import annotations

import hashlib
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar, cast

from archlint.model.encoding import PROGRAMS, Language, NotEncodable, NotPrograms, decode, encode_noting
from archlint.programs.followed import Definition, Followed
from archlint.programs.kept_table import InMemory, Row, Table, write
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.modules import ModuleIndex
    from archlint.interpreter.reads import Lookup, Reads
    from archlint.programs.kept_table import Known
    from archlint.programs.keys import ProgramKey
    from archlint.workspace.tree import Question

_MOSTLY = 0.9

Result = TypeVar("Result")


@dataclass
class KeptResults(ABC, Generic[Result]):
    """What is known of programs from earlier runs, and what this run adds.

    ``fingerprint`` says of a file, by its path, what decides what it means: its code, its package, its name; None where
    that cannot be said.  ``surroundings`` stands for what decides beside the files.
    """

    index: ModuleIndex
    fingerprint: Callable[[str], str | None]
    surroundings: str
    import_now: Callable[[Iterable[str]], None]
    """Imports modules for which a program answers that is not followed again."""
    known: Known
    """What earlier runs have followed."""
    ask: Callable[[Question], str | None] = lambda question: None
    """What the disk answers."""
    lasts: bool = True
    """Whether anybody will ask for what this run adds."""
    shares: bool = False
    """Whether that will be in this process: what :meth:`get` returns is then that of all runs, and never changes."""
    changed: bool = False
    """Whether there is something new to keep."""
    is_worker: bool = False
    """Whether only a part of the programs is followed here, so that nothing can be said of what depends on all."""
    _rows: dict[str, Row] = field(default_factory=dict)
    _new: list[str] = field(default_factory=list)
    """The keys of the programs that were followed since somebody took them."""
    _fingerprints: dict[str, str | None] = field(default_factory=dict)
    _lookups: dict[Lookup, str | None] = field(default_factory=dict)
    _groups: dict[str, Sequence[str]] = field(default_factory=dict)
    """By the path of a module that a program has imported which was not followed again: the modules that ran for the
    first time when one of them was imported, that one first."""
    _put_off: list[str] = field(default_factory=list)
    """The modules of C++ that are to be imported before any program of C++ is followed."""
    _owners: dict[int, tuple[str, object]] = field(default_factory=dict)
    """Which program has an object, by the id of the object, which stays alive here."""

    def __post_init__(self) -> None:
        self._tables: list[Known] = [self.known]

    @property
    def keeps(self) -> bool:
        """Whether anybody, in this process or another, will ask for what this run adds."""
        return self.lasts or self.is_worker

    language: ClassVar[Language]
    """What results are made of."""

    @abstractmethod
    def parts_of(self, result: Result) -> list[object]:
        """A result as plain data."""

    @abstractmethod
    def made_of(self, parts: Sequence[Any]) -> Result:
        """The result of these parts."""

    def add(self, payload: bytes) -> None:
        """Programs that another process has followed."""
        self._tables.insert(0, Table(payload, self.surroundings))
        self.changed = True

    def is_mostly_known(self) -> bool:
        """Whether of the files that programs had read few have changed since."""
        before = self._tables[-1].fingerprints
        same = sum(self._print_of(path) == fingerprint for path, fingerprint in before.items())
        return bool(before) and same > _MOSTLY * len(before)

    # ------------------------------------------------------------------------------------------- what is known

    def knows(self, key: ProgramKey) -> bool:
        """Whether something is known of a program that may be the same again."""
        return any(self._valid(table, key.text) is not None for table in self._tables)

    def get(self, key: ProgramKey, late: bool) -> Result | None:
        """What became of a program, if it would be the same again."""
        name = key.text
        for table in self._tables:
            try:
                row = self._valid(table, name)
                if row is None or row.late is not late or not self._fits(row):
                    continue
                result = self._result_of(row)
            except (LookupError, TypeError, ValueError):
                continue
            self._take(name, row)
            return result
        return None

    def _result_of(self, row: Row) -> Result:
        if row.decoded is not None:
            return cast("Result", row.decoded)
        result = self._made(row)
        if self.shares:
            row.decoded = result
        return result

    def _made(self, row: Row) -> Result:
        [parts] = decode(row.result, self.language)
        return self.made_of(parts)

    def copy_of(self, key: ProgramKey) -> Result | None:
        """What became of a program, for somebody who will change it; None where all that there is of it is theirs."""
        row = self._rows.get(key.text)
        return None if row is None or row.decoded is None else self._made(row)

    def _take(self, name: str, row: Row) -> None:
        """A program is as it was: what it has imported counts as imported."""
        self._rows[name] = row
        for group in row.imports:
            self._groups.update(dict.fromkeys(group, group))
            self.index.imported.update(group)
        if not row.changes:
            return
        paths = [path for group in row.imports for path in group]
        if all(map(self._is_cpp, row.changes)):  # no program of Python meets what these have changed
            self.index.note_changes(row.changes)
            self._put_off += paths
        else:  # what they have changed has to be here
            self.import_now(paths)

    def _is_cpp(self, path: str) -> bool:
        file = self.index.importable.at(path)
        return file is not None and file.kind == "cpp"

    def import_for(self, file: str) -> None:
        """A program that begins in a file, by its shown path, is about to be followed: import what it may meet and what
        was put off."""
        if self._put_off and not file.endswith(".py"):
            paths, self._put_off = self._put_off, []
            self.import_now(paths)

    def files_of(self, key: ProgramKey) -> Collection[str] | None:
        """The files whose code a program has seen; None for one that is not kept."""
        row = self._rows.get(key.text)
        return None if row is None else row.files

    def read_by(self) -> Iterable[str]:
        """The files whose code the programs have seen, followed again or not."""
        return sorted({path for row in self._rows.values() for path in row.files})

    def first_of(self, path: str) -> str | None:
        """The module whose import led to that of another, when it was imported first by a program that was not
        followed again.  It is returned once."""
        group = self._groups.get(path)
        if group is None:
            return None
        for member in group:
            self._groups.pop(member, None)
        return group[0]

    def all_first(self) -> list[str]:
        """All modules that :meth:`first_of` may name, in the order in which they were imported."""
        return list(dict.fromkeys(group[0] for group in self._groups.values()))

    def _valid(self, table: Known, key: str) -> Row | None:
        """A program, if nothing that it depends on has changed but, perhaps, what ran before it."""
        if key not in table.keys or not table.has_same_files(key, self._print_of):
            return None
        if table.importable is not self.index.importable and not table.has_same_lookups(key, self._means):
            return None
        row = table.row(key)
        if row is None or (row.everything and table.everything != self._everything):
            return None
        return row if all(self.ask(question) == answer for question, answer in row.answers.items()) else None

    def _fits(self, row: Row) -> bool:
        """Whether the modules that ran before the program are those that ran before it then."""
        own = {path for group in row.imports for path in group}
        before = self.index.imported
        if not own.isdisjoint(before) or any(path not in own and path not in before for path in row.used):
            return False
        return self.index.writers(row.used) - own == set(row.writers)

    def _print_of(self, path: str) -> str | None:
        if path not in self._fingerprints:
            self._fingerprints[path] = self.fingerprint(path)
        return self._fingerprints[path]

    def _means(self, lookup: Lookup) -> str | None:
        if lookup not in self._lookups:
            importer, name, dots = lookup
            file = self.index.importable.at(importer)
            target = None if file is None else self.index.importable.meant(file, name, dots)
            self._lookups[lookup] = None if target is None else target.path
        return self._lookups[lookup]

    @cached_property
    def _everything(self) -> str:
        prints = [(file.path, self._print_of(file.path)) for file in self.index.importable.files()]
        return hashlib.sha256(repr(prints).encode()).hexdigest()

    # ------------------------------------------------------------------------------------------- what is new

    def put(self, key: ProgramKey, late: bool, result: Result, reads: Reads) -> None:
        """Keep what became of a program, if it can stand alone."""
        if any(self._print_of(path) is None for path in reads.files) or (self.is_worker and reads.everything):
            return
        if not self.keeps:
            return
        try:
            payload, objects = encode_noting([self.parts_of(result)], self.language)
        except (NotEncodable, UnicodeError):
            return
        self.changed = True
        name = key.text
        shared = {owner for item in objects if (owner := self._owner(item, name)) != name}
        if shared:  # they would not share it any more
            for other in shared:
                self._rows.pop(other, None)
            return
        own = {path for group in reads.imports for path in group}
        self._new.append(name)
        self._rows[name] = Row(
            late,
            reads.everything,
            sorted(reads.files),
            sorted(reads.used),
            reads.lookups,
            reads.imports,
            sorted(self.index.writers(reads.used) - own),
            {path: sorted(self.index.changed_by(path)) for path in sorted(own) if self.index.writes(path)},
            reads.answers,
            payload,
        )

    def put_again(self, key: ProgramKey, before: ProgramKey) -> None:
        """Keep that a program becomes what another one has become."""
        row = self._rows.get(before.text)
        if row is not None and self.keeps:
            self.changed = True
            self._new.append(key.text)
            # What the other one was first to import had run before this one.
            writers = sorted(self.index.writers(row.used))
            self._rows[key.text] = replace(row, imports=[], writers=writers, changes={})

    def _owner(self, item: object, name: str) -> str:
        return self._owners.setdefault(id(item), (name, item))[0]

    def all_known(self) -> InMemory:
        """All that is known, for the next run."""
        return self._with_surroundings(self._rows | dict(self._others()))

    def forget_new(self) -> None:
        """From now on, only what is followed after this is new."""
        self._new = []

    def take_new(self) -> bytes:
        """The programs that were followed since the last time."""
        rows = {key: self._rows[key] for key in self._new if key in self._rows}
        self._new = []
        return write(self._with_surroundings(rows))

    def _with_surroundings(self, rows: Mapping[str, Row]) -> InMemory:
        fingerprints = {path: known for path, known in self._fingerprints.items() if known is not None}
        return InMemory(rows, fingerprints, self.surroundings, self._everything, self.index.importable)

    def _others(self) -> Iterable[tuple[str, Row]]:
        """The programs that nobody asked for this time, and that are as they were."""
        table = self._tables[-1]
        for key in table.keys:
            row = self._valid(table, key) if key not in self._rows else None
            if row is not None:
                yield key, row


class KeptPrograms(KeptResults[Followed]):
    """What became of programs."""

    language = PROGRAMS

    def parts_of(self, result: Followed) -> list[object]:
        ran, instantiated = sorted(result.ran), sorted(result.instantiated)
        definitions = [definition.parts() for definition in result.definitions]
        return [result.program, result.steps, ran, instantiated, result.holders, definitions]

    def made_of(self, parts: Sequence[Any]) -> Followed:
        program, steps, ran, instantiated, holders, definitions = parts
        rows = [Definition(*row) for row in definitions]
        return Followed(program, steps, frozenset(ran), frozenset(instantiated), holders, rows)


class NothingKept:
    """No cache: each program is followed."""

    keeps: ClassVar[bool] = False

    def knows(self, key: ProgramKey) -> bool:
        return False

    def get(self, key: ProgramKey, late: bool) -> Followed | None:
        return None

    def put(self, key: ProgramKey, late: bool, result: Followed, reads: Reads) -> None:
        return None

    def put_again(self, key: ProgramKey, before: ProgramKey) -> None:
        return None

    def copy_of(self, key: ProgramKey) -> Followed | None:
        return None

    def import_for(self, file: str) -> None:
        return None

    def files_of(self, key: ProgramKey) -> Collection[str] | None:
        return None

    def first_of(self, path: str) -> str | None:
        return None

    def all_first(self) -> list[str]:
        return []


__all__ = ["KeptPrograms", "KeptResults", "NotPrograms", "NothingKept"]
