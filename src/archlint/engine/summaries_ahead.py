"""What analyses say of single files by their text alone, said in processes of their own before rules ask for it.

Most of what the rules take in a run without a cache is that.  Each file is a piece of work by itself, and what is said
of it is data, so the number of processes changes nothing but the time.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.kept import analyses
from archlint.checks.registry import registered
from archlint.programs.ahead import Beside
from archlint.records import dataclass
from archlint.syntax import workers
from archlint.syntax.memory import default_processes
from archlint.workspace.model import PYTHON_KINDS

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_WORTH_IT = 200_000
"""From how many bytes of source on that nothing was said of the processes are worth their start."""
_FILES = 8
"""How many files are one part of the work."""
_DEADLINE = 300.0
"""How many seconds of processor time one part may take before the run does it itself."""


def processes_of(request: Request) -> int:
    """How many processes say something of files: one where the work is not divided."""
    return 1 if request.pool is not None else request.jobs or default_processes()


@dataclass
class SummariesAhead:
    """Has everything said of files of which nothing has been said so far, where that takes long and most rules are
    selected: few of them ask for all of it.  A part whose process fails is left to the rules."""

    request: Request
    files: Collection[SourceFile]
    _beside: Beside | None = field(default=None, init=False)

    def begin(self, index: WorkspaceIndex) -> Beside | None:
        """What the processes that follow programs may do after it; None where it is not worth it."""
        if processes_of(self.request) > 1 and len(self.request.settings.selection.codes) * 2 >= len(registered()):
            self._beside = self._parts(index)
        return self._beside

    def _parts(self, index: WorkspaceIndex) -> Beside | None:
        summaries = index.summaries
        new = [file for file in self.files if file.kind in PYTHON_KINDS and summaries.has_nothing_of(file.relative)]
        if sum(file.size for file in new) < _WORTH_IT:
            return None
        new.sort(key=lambda file: (-file.size, file.relative))
        count = -(-len(new) // _FILES)
        return Beside([partial(_said_of, index, new[at::count]) for at in range(count)])

    def finish(self, index: WorkspaceIndex) -> None:
        """Take what has been said; processes say it now, where none has begun."""
        if self._beside is None:
            return
        try:
            for answer in self._answers(self._beside):
                if isinstance(answer, bytes):
                    index.summaries.add(answer)
        except OSError:  # no process to be had
            return

    def _answers(self, beside: Beside) -> Sequence[workers.Answer]:
        if beside.is_begun:
            return beside.answers()
        if not workers.can_fork(waiting=1):
            return ()
        numbers = [b"%06d" % number for number in range(len(beside.parts))]
        return workers.run_in_workers(
            lambda number: beside.parts[int(number)](), numbers, processes_of(self.request), _DEADLINE
        )

    def close(self) -> None:
        """The run has ended, perhaps before it wanted to know."""
        if self._beside is not None:
            self._beside.close()


def _said_of(index: WorkspaceIndex, files: Iterable[SourceFile]) -> bytes:
    for file in files:
        analyses.say_all(index, file.relative)
    return index.summaries.take_new()


__all__ = ["SummariesAhead", "processes_of"]
