"""What becomes of each program: known from an earlier run, or followed now."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

from archlint.interpreter.reads import Reads
from archlint.programs.followed import Followed
from archlint.programs.progress import Progress
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.faults import Faults
    from archlint.interpreter.modules import ModuleIndex
    from archlint.model import Asked, Overrides, Program
    from archlint.monitor import Monitor
    from archlint.programs.kept import KeptPrograms, NothingKept
    from archlint.programs.keys import EntryKey, ProgramKey


@dataclass(frozen=True)
class _Entry:
    """What is known of the run of an executable, for others of it."""

    key: EntryKey
    late: bool
    asked: Asked
    steps: int


@dataclass
class Follower:
    """Has programs followed, each where nothing is known of it, and knows which programs are shared.

    A program that an earlier run has left in memory is that of all runs and never changes; who changes one asks for
    its :meth:`own` first.
    """

    index: ModuleIndex
    kept: KeptPrograms | NothingKept
    faults: Faults
    monitor: Monitor
    progress: Progress = field(default_factory=Progress)
    _keys: dict[int, ProgramKey] = field(default_factory=dict)
    """Of all programs, by the ``id`` of each, which lives as long as this."""
    _shared: dict[int, ProgramKey] = field(default_factory=dict)
    """The same of those that an earlier run has followed."""
    _entries: dict[EntryKey, list[_Entry]] = field(default_factory=dict)
    """The runs of each executable with its command line."""

    def follow(self, key: ProgramKey, act: Callable[[], Followed]) -> Followed:
        """What becomes of a program: known from an earlier run, or what ``act`` says now."""
        late = self.progress.budget.is_spent
        followed = self.kept.get(key, late)
        if followed is not None:
            self._shared[id(followed.program)] = key
            self.monitor.known(key.text)
        else:
            faults, began = self.faults.count, time.process_time()
            self.kept.import_for(key.file)
            with self.index.reading(Reads()) as reads:
                followed = act()
            seconds = time.process_time() - began
            if self.kept.keeps and self.faults.count == faults:  # what was read takes long to put together
                self.kept.put(key, late, followed, self.index.all_read(reads))
            self.monitor.followed(key.text, _words(key, followed.program), seconds)
        self._keys[id(followed.program)] = key
        self.progress.add(followed)
        return followed

    def follow_entry(
        self, key: EntryKey, overrides: Overrides, act: Callable[[], Followed], current: Callable[[EntryKey], Program]
    ) -> tuple[Program, bool]:
        """The program of an executable, and whether it is one that was followed before with other overrides, of which
        it asks nothing that they say otherwise.  ``current`` is what a program of that key is by now."""
        late = self.progress.budget.is_spent
        alike = self._entries.setdefault(replace(key, overrides=None), [])
        before = next((row for row in alike if row.late is late and row.asked.hold_for(overrides)), None)
        if before is not None and self.kept.get(key, late) is None:
            self.kept.put_again(key, before.key)
            self.progress.budget.spend(before.steps)
            program = current(before.key)
            self.monitor.followed(key.text, _words(key, program), 0.0)
            return program, True
        followed = self.follow(key, act)
        if followed.asked is not None:
            alike.append(_Entry(key, late, followed.asked, followed.steps))
        return followed.program, False

    def own(self, programs: Sequence[Program]) -> Mapping[int, Program]:
        """Go on with copies of those of these programs that other runs have, too: the copies, by the ids of what they
        are copies of."""
        copies: dict[int, Followed] = {}
        for program in programs:
            key = self._shared.pop(id(program), None)
            copy = None if key is None else self.kept.copy_of(key)
            if key is not None and copy is not None:
                copies[id(program)] = copy
                self._keys[id(copy.program)] = key
        if copies:
            self.progress.replace(copies)
        return {number: followed.program for number, followed in copies.items()}

    def files_read_by(self, program: Program) -> list[str] | None:
        """The files, by their shown paths, that a program was followed through; None where that was not kept."""
        key = self._keys.get(id(program))
        paths = None if key is None else self.kept.files_of(key)
        if paths is None:
            return None
        return [file.relative for path in paths if (file := self.index.importable.at(path)) is not None]


def _words(key: ProgramKey, program: Program) -> str:
    """A program as people know it: its name, and its file."""
    if program.file.rpartition("/")[2] == program.name:
        return f"{key.verb}{program.file}"
    return f"{key.verb}{program.name} ({program.file})"


__all__ = ["Follower"]
