"""The forms in which programs are kept, on the disk and in memory: what each depends on, and what became of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import TYPE_CHECKING, Protocol

import msgspec

from archlint.records import dataclass

if TYPE_CHECKING:
    from typing import TypeAlias

    from archlint.interpreter.reads import Lookup
    from archlint.workspace.importable import Importable
    from archlint.workspace.tree import Question

    Fingerprint: TypeAlias = Callable[[str], "str | None"]
    """What decides what the code of a file, by its path, means."""
    Meaning: TypeAlias = Callable[[Lookup], "str | None"]
    """The file, by its path, that an import means."""


@dataclass
class Row:
    """One program: what it depends on, and what became of it."""

    late: bool
    """Whether the workspace had spent its statements when the program was followed."""
    everything: bool
    """Whether it depends on all modules."""
    files: Collection[str]
    """The files whose code it has seen."""
    used: Collection[str]
    """The modules that were imported for it, or had been before."""
    lookups: dict[Lookup, str | None]
    """The file that each import means; None where it means none of the workspace."""
    imports: list[list[str]]
    """The modules that ran for the first time: each that was imported first, and those that its import led to."""
    writers: Collection[str]
    """The modules that had changed objects of those that it uses; none of ``imports``."""
    changes: Mapping[str, Collection[str]]
    """Of its imports those that have changed objects of other modules, with the modules whose objects these were."""
    answers: Mapping[Question, str | None]
    """What was asked of the disk."""
    result: bytes
    decoded: object = None
    """What became of it, once that has been asked for, where it stays in memory."""


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
    changes: list[tuple[int, list[int]]]
    answers: list[int]
    result: bytes


class _Kept(msgspec.Struct, array_like=True):
    surroundings: str
    everything: str
    files: list[tuple[str, str]]
    """Path and fingerprint."""
    lookups: list[tuple[int, str, int, int]]
    """File, name, dots, and the file that it means; -1 for none."""
    answers: list[tuple[str, str, str | None]]
    """Question, path, and the answer."""
    entries: list[_Entry]


class Known(Protocol):
    """Programs that an earlier run has followed."""

    @property
    def everything(self) -> str:
        """The fingerprint of all files together."""

    @property
    def importable(self) -> Importable | None:
        """By which files imports have meant what they meant; None where they are not in memory."""

    @property
    def keys(self) -> Collection[str]: ...

    @property
    def fingerprints(self) -> Mapping[str, str]:
        """Those of the files, by their paths, that the programs have read."""

    def has_same_files(self, key: str, fingerprint: Fingerprint) -> bool:
        """Whether the files that a program has read have the fingerprints that they had; those of now never change."""

    def has_same_lookups(self, key: str, means: Meaning) -> bool:
        """Whether the imports that a program has looked up mean what they meant; what they mean now never changes."""

    def row(self, key: str) -> Row | None:
        """A program; raises ``LookupError`` where the table is damaged."""


@dataclass
class InMemory:
    """Programs that a run in this process has left.  The runs that come after it ask one after the other."""

    rows: Mapping[str, Row]
    fingerprints: Mapping[str, str]
    surroundings: str
    everything: str
    importable: Importable
    """The files by which its imports have meant what they meant: by the same they still do."""

    @property
    def keys(self) -> Collection[str]:
        return self.rows.keys()

    def has_same_files(self, key: str, fingerprint: Fingerprint) -> bool:
        before = self.fingerprints
        return all(path in before and fingerprint(path) == before[path] for path in self.rows[key].files)

    def has_same_lookups(self, key: str, means: Meaning) -> bool:
        return all(means(lookup) == target for lookup, target in self.rows[key].lookups.items())

    def row(self, key: str) -> Row | None:
        return self.rows.get(key)


class Table:
    """Programs as they were written.  One that is damaged, or of other surroundings, has none."""

    def __init__(self, payload: bytes | None, surroundings: str) -> None:
        try:
            kept = None if payload is None else msgspec.msgpack.decode(payload, type=_Kept)
        except (msgspec.MsgspecError, ValueError, RecursionError):
            kept = None
        if kept is None or kept.surroundings != surroundings:
            kept = _Kept(surroundings, "", [], [], [], [])
        self._kept = kept
        self._entries = {entry.key: entry for entry in kept.entries}
        self._changed: set[int] | None = None
        """The files that are not as they were."""
        self._moved: set[int] | None = None
        """The look-ups that mean other files than they did."""
        self.importable = None

    @property
    def everything(self) -> str:
        return self._kept.everything

    @property
    def keys(self) -> Collection[str]:
        return self._entries.keys()

    @property
    def fingerprints(self) -> Mapping[str, str]:
        return dict(self._kept.files)

    def has_same_files(self, key: str, fingerprint: Fingerprint) -> bool:
        if self._changed is None:
            self._changed = {n for n, (path, before) in enumerate(self._kept.files) if fingerprint(path) != before}
        return self._changed.isdisjoint(self._entries[key].files)

    def has_same_lookups(self, key: str, means: Meaning) -> bool:
        if self._moved is None:
            self._moved = {
                n
                for n in range(len(self._kept.lookups))
                for lookup, target in [self._lookup(n)]
                if means(lookup) != target
            }
        return self._moved.isdisjoint(self._entries[key].lookups)

    def row(self, key: str) -> Row | None:
        entry = self._entries.get(key)
        if entry is None:
            return None
        paths = self._paths
        return Row(
            entry.late,
            entry.everything,
            paths(entry.files),
            paths(entry.used),
            dict(map(self._lookup, entry.lookups)),
            [paths(group) for group in entry.imports],
            paths(entry.writers),
            {self._kept.files[number][0]: paths(changed) for number, changed in entry.changes},
            {(question, path): answer for question, path, answer in map(self._kept.answers.__getitem__, entry.answers)},
            entry.result,
        )

    def _lookup(self, number: int) -> tuple[Lookup, str | None]:
        """What was looked up, and the file that it meant."""
        file, name, dots, target = self._kept.lookups[number]
        files = self._kept.files
        return (files[file][0], name, dots), None if target < 0 else files[target][0]

    def _paths(self, numbers: list[int]) -> list[str]:
        return [self._kept.files[number][0] for number in numbers]


class _Numbers:
    """The rows of the tables, as they come up."""

    def __init__(self) -> None:
        self.files: dict[str, int] = {}
        self.lookups: dict[Lookup, tuple[int, str | None]] = {}
        self.answers: dict[tuple[str, str, str | None], int] = {}

    def of(self, paths: Collection[str]) -> list[int]:
        return [self.files.setdefault(path, len(self.files)) for path in paths]

    def of_answer(self, question: str, path: str, answer: str | None) -> int:
        return self.answers.setdefault((question, path, answer), len(self.answers))

    def of_lookup(self, lookup: Lookup, target: str | None) -> int:
        if lookup not in self.lookups:
            self.of([lookup[0], *([] if target is None else [target])])
            self.lookups[lookup] = len(self.lookups), target
        return self.lookups[lookup][0]


def write(known: InMemory) -> bytes:
    """Programs as a :class:`Table` reads them."""
    numbers = _Numbers()
    entries = [
        _Entry(
            key,
            row.late,
            row.everything,
            numbers.of(row.files),
            numbers.of(row.used),
            [numbers.of_lookup(lookup, target) for lookup, target in row.lookups.items()],
            [numbers.of(group) for group in row.imports],
            numbers.of(row.writers),
            [(numbers.of([path])[0], numbers.of(changed)) for path, changed in row.changes.items()],
            [numbers.of_answer(*question, answer) for question, answer in row.answers.items()],
            row.result,
        )
        for key, row in sorted(known.rows.items())
    ]
    lookups = [
        (numbers.files[file], name, dots, -1 if target is None else numbers.files[target])
        for (file, name, dots), (_, target) in numbers.lookups.items()
    ]
    files = [(path, known.fingerprints.get(path, "")) for path in numbers.files]
    answers = list(numbers.answers)
    return msgspec.msgpack.encode(_Kept(known.surroundings, known.everything, files, lookups, answers, entries))


__all__ = ["InMemory", "Known", "Row", "Table", "write"]
