"""Following programs ahead in processes of their own.

What a process finds is offered to the run as if an earlier run had kept it.  The run asks for its programs in the same
order as ever, and follows those again that nobody has followed under the same conditions: the number of processes
changes nothing but the time.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Sequence
from dataclasses import field
from itertools import pairwise
from typing import TYPE_CHECKING, TypeVar

from archlint.monitor import Monitor
from archlint.records import dataclass
from archlint.syntax import workers

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.programs.kept import KeptPrograms

WORTH_IT = 200_000
"""From how many bytes of source on a process more is worth its start."""
SHARES = 4
"""Into how many parts for each process a group is divided that is more than the share of one."""
DEADLINE = 900.0
"""How many seconds of processor time one part of the work may take before the run does it itself."""

_SIZE = struct.Struct("=Q")
_Item = TypeVar("_Item")


@dataclass
class Beside:
    """Work that needs no program: processes do it that have none to follow, also while the run goes on.

    ``parts`` are done in any process, in any order, and their answers are there for :meth:`answers`.
    """

    parts: Sequence[Callable[[], bytes]]
    _work: workers.Work | None = field(default=None, init=False)
    _first: int = field(default=0, init=False)
    """How many parts of the work are none of these."""

    @property
    def is_begun(self) -> bool:
        """Whether processes do it."""
        return self._work is not None

    def begin(self, work: workers.Work, first: int) -> None:
        """The processes of some work, whose first parts are others, go on with these."""
        self._work, self._first = work, first
        work.hand_out()

    def answers(self) -> list[workers.Answer]:
        """What the processes have to say, once they are done."""
        assert self._work is not None
        try:
            return self._work.answers_to(self._first + len(self.parts))[self._first :]
        finally:
            self.close()

    def close(self) -> None:
        """Nobody wants to know any more."""
        if self._work is not None:
            self._work.close()


def follow_ahead(
    parts: Sequence[Callable[[], object]],
    kept: KeptPrograms,
    jobs: int,
    monitor: Monitor | None = None,
    beside: Beside | None = None,
) -> None:
    """Do the parts of some work in up to ``jobs`` processes, the first ones first, and take what programs they have
    followed.  A part whose process fails is left to the run.  Then the processes go on with what is ``beside``."""
    if jobs < 2 or len(parts) < 2 or not workers.can_fork(waiting=1):
        return

    monitor = monitor or Monitor()
    kept.forget_new()  # nobody here asks for what this process has followed
    others = [] if beside is None else beside.parts

    def job(name: bytes) -> bytes:
        number = int(name)
        if number >= len(parts):
            return others[number - len(parts)]()
        kept.is_worker = True
        monitor.begin_part()
        parts[number]()
        report = monitor.end_part()
        return _SIZE.pack(len(report)) + report + kept.take_new()

    def on_done(number: int, seconds: float) -> None:
        if number < len(parts):
            monitor.part_done()

    numbers = [b"%06d" % number for number in range(len(parts) + len(others))]
    monitor.dividing(len(parts))
    work = workers.Work(job, numbers, min(jobs, len(parts)), DEADLINE, on_done)
    try:
        answers = work.answers_to(len(parts))
    except OSError:  # no process to be had
        return
    finally:
        monitor.divided()
        if beside is None or len(work.answers) < len(parts):
            work.close()
    if beside is not None:
        beside.begin(work, len(parts))
    for answer in answers:
        if isinstance(answer, bytes):
            end = _SIZE.size + _SIZE.unpack_from(answer)[0]
            monitor.take(answer[_SIZE.size : end])
            kept.add(answer[end:])


def independent_groups(modules: Iterable[Module], index: ModuleIndex) -> list[list[Module]]:
    """Modules in groups of which none imports anything that another imports, too; the largest group first."""
    groups: dict[str, list[Module]] = {}
    group_of: dict[str, str] = {}
    for module in modules:
        paths = index.imported_by(module)
        names = sorted({group_of[path] for path in paths if path in group_of})
        members = [module, *(member for name in names for member in groups.pop(name))]
        name = module.path
        groups[name] = members
        joined = set(names)
        group_of = {path: name if of in joined else of for path, of in group_of.items()} if joined else group_of
        group_of.update(dict.fromkeys(paths, name))
    return by_weight(groups.values(), lambda module: module.file.size)


def shares(rows: Sequence[_Item], count: int) -> list[range]:
    """The numbers of some rows in up to ``count`` parts of neighbours, of about the same length."""
    bounds = [len(rows) * number // count for number in range(count + 1)]
    return [range(start, end) for start, end in pairwise(bounds) if start < end]


def by_weight(groups: Iterable[list[_Item]], weight: Callable[[_Item], int]) -> list[list[_Item]]:
    """Groups, the heaviest first."""
    return sorted(groups, key=lambda group: -sum(map(weight, group)))


__all__ = ["SHARES", "WORTH_IT", "Beside", "by_weight", "follow_ahead", "independent_groups", "shares"]
