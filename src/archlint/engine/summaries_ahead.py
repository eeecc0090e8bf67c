"""What analyses say of single files by their text alone, said in processes of their own before rules ask for it.

Most of what the rules take in a run without a cache is that.  Each file is a piece of work by itself, and what is said
of it is data, so the number of processes changes nothing but the time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import analyses
from archlint.checks.registry import registered
from archlint.syntax import workers
from archlint.syntax.memory import default_processes
from archlint.workspace.model import PYTHON_KINDS

if TYPE_CHECKING:
    from collections.abc import Collection

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


def summarise_ahead(request: Request, index: WorkspaceIndex, files: Collection[SourceFile]) -> None:
    """Have everything said of files of which nothing has been said so far, where that takes long and most rules are
    selected: few of them ask for all of it.  A part whose process fails is left to the rules."""
    count = processes_of(request)
    if count < 2 or len(request.settings.selection.codes) * 2 < len(registered()) or not workers.can_fork(waiting=1):
        return
    summaries = index.summaries
    new = [file for file in files if file.kind in PYTHON_KINDS and summaries.has_nothing_of(file.relative)]
    if sum(file.size for file in new) < _WORTH_IT:
        return
    new.sort(key=lambda file: (-file.size, file.relative))
    parts = [new[at :: -(-len(new) // _FILES)] for at in range(-(-len(new) // _FILES))]

    def job(number: bytes) -> bytes:
        for file in parts[int(number)]:
            analyses.say_all(index, file.relative)
        return summaries.take_new()

    try:
        answers = workers.run_in_workers(job, [b"%06d" % at for at in range(len(parts))], count, _DEADLINE)
    except OSError:  # no process to be had
        return
    for answer in answers:
        if isinstance(answer, bytes):
            summaries.add(answer)


__all__ = ["processes_of", "summarise_ahead"]
