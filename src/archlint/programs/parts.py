"""How the programs of a workspace are divided among processes that follow them ahead.

Groups of modules that have nothing to do with one another are a part each; what is started of a group that is more than
the share of one process is several.  What launch files start of an executable is followed where it has just been
followed itself: all that it imports is there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import AbstractContextManager
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from archlint.monitor import Monitor
from archlint.programs.ahead import SHARES, Beside, follow_ahead, shares
from archlint.programs.kept import KeptPrograms
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.model import Program
    from archlint.programs.entry import Entry, EntryPoint
    from archlint.programs.kept import NothingKept

Parts = Sequence[Callable[[], object]]
"""Some work in parts, each of which follows programs."""


@dataclass
class Follows:
    """How programs are followed."""

    in_order: Callable[[Sequence[Entry], Sequence[Module]], None]
    """All that is started of some modules, and what is left of these."""
    entry: Callable[[EntryPoint, Module], Program]
    """One executable."""
    imports: Callable[[Module], None]
    """The import of a module."""
    program: Callable[[EntryPoint], Program]
    """What an executable that was followed has become."""
    settled: Callable[[Iterable[EntryPoint]], AbstractContextManager[None]]
    """Inside, it is as if all programs had run, and not only these executables."""


@dataclass
class Ahead:
    """Has programs followed in up to ``jobs`` processes, where that is worth it."""

    index: ModuleIndex
    kept: KeptPrograms | NothingKept
    follows: Follows
    jobs: int = 1
    monitor: Monitor = field(default_factory=Monitor)
    beside: Beside | None = None
    """What the processes do when no program is left."""
    started: Callable[[EntryPoint, Module, Program], None] | None = None
    """Follows what launch files start of an executable, given what it is without them."""
    has_started: bool = field(default=False, init=False)
    """Whether all of that was followed."""

    def follow(self, parts: Callable[[], Parts], beside: Beside | None = None) -> bool:
        """Do parts of the work, and what is ``beside`` it, in processes of their own; False where it is not worth it,
        or where this is one of them."""
        if self.jobs < 2 or not isinstance(self.kept, KeptPrograms) or self.kept.is_worker:
            return False
        if self.kept.is_mostly_known():
            return False
        follow_ahead(parts(), self.kept, self.jobs, self.monitor, beside)
        return True

    def follow_all(
        self, groups: Callable[[], Sequence[Sequence[Module]]], entries: Sequence[Entry], modules: Sequence[Module]
    ) -> None:
        """Follow all programs, in groups of modules that have nothing to do with one another."""
        done = self.follow(lambda: self._parts(groups(), entries, modules), self.beside)
        self.has_started = done and self.started is not None

    def _parts(self, groups: Sequence[Sequence[Module]], entries: Sequence[Entry], modules: Sequence[Module]) -> Parts:
        """Each group in one part; of one that is more than the share of a process, what is started in several."""
        sizes = [size_of(group) for group in groups]
        parts: list[Callable[[], None]] = []
        for group, size in zip(groups, sizes, strict=True):
            paths = {module.file.path for module in group}
            own = [(entry, module) for entry, module in entries if module.file.path in paths]
            if size * self.jobs > sum(sizes) and len(own) > 1:
                parts += [partial(self._follow_share, own, share) for share in shares(own, SHARES * self.jobs)]
            else:
                parts.append(self.part(group, entries, modules))
        return parts

    def part(self, group: Sequence[Module], entries: Sequence[Entry], modules: Sequence[Module]) -> Callable[[], None]:
        """Following the programs of a group."""
        paths = {module.file.path for module in group}
        own = [(entry, module) for entry, module in entries if module.file.path in paths]
        return partial(self._follow_group, own, [module for module in modules if module.file.path in paths])

    def _follow_group(self, entries: Sequence[Entry], modules: Sequence[Module]) -> None:
        self.follows.in_order(entries, modules)
        self._follow_started(entries)

    def _follow_share(self, entries: Sequence[Entry], share: range) -> None:
        """Follow some executables as if those before them had run: the modules that these import are there."""
        with self.index.aside():
            for _, module in entries[: share.start]:
                self.follows.imports(module)
        own = [entries[number] for number in share]
        for entry in own:
            self.follows.entry(*entry)
        self._follow_started(own)

    def _follow_started(self, entries: Sequence[Entry]) -> None:
        """Follow what launch files start of these."""
        if self.started is None:
            return
        with self.follows.settled(entry for entry, _ in entries):
            for entry, module in entries:
                self.started(entry, module, self.follows.program(entry))


def size_of(modules: Iterable[Module]) -> int:
    """How many bytes of source modules have."""
    return sum(module.file.size for module in modules)


__all__ = ["Ahead", "Follows", "size_of"]
