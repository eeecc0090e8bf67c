"""Work that other machines do, through any executor of the form of :mod:`concurrent.futures`.

What goes there and what comes back is bytes, and each answer says which archlint has made it.  An answer that does not
come because a machine is gone is worked out here, so the result is always the same.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import field
from typing import Protocol

import msgspec

from archlint import __version__
from archlint.engine.remote import Done, Task, identity, run_task
from archlint.records import dataclass
from archlint.syntax.workers import Answer, Crashed, Job, Lost, OnDone, TimedOut

PATIENCE = 15.0
"""For how many seconds nobody may be there to work before the run gives up."""
SILENCE = 1_800.0
"""For how many seconds no answer may come, whoever is there: twice as long as any task may work."""
_LOOK = 1.0
_BATCHES = 3
"""How many tasks each worker gets: the last ones are not long."""
_WORTH_IT = 100_000
"""From how many bytes on a task more is worth its way."""


class PoolError(Exception):
    """Machines that cannot be used; ``str()`` says why, and what to do."""


class Executor(Protocol):
    """What is needed of :class:`concurrent.futures.Executor`."""

    def submit(self, function: Callable[[str, bytes], bytes], /, *arguments: object) -> Future[bytes]: ...


@dataclass
class ExecutorPool:
    """A :class:`~archlint.syntax.pools.Pool` of machines that run the same archlint.  ``link`` is the job that links a
    part of a workspace, ``width`` how many of them work at a time; ``trouble`` says why nobody does at the moment."""

    executor: Executor
    link: Job
    width: int
    trouble: Callable[[], str | None] = lambda: None
    lost: int = field(default=0)
    """How many tasks did not come back, and were done here."""

    def map(self, job: Job, sources: Sequence[bytes], deadline: float, on_done: OnDone) -> list[Answer]:
        """As :meth:`archlint.syntax.pools.Pool.map`; raises :class:`PoolError`."""
        answers: list[Answer] = [Lost()] * len(sources)
        name = f"{job.__module__}.{job.__qualname__}"
        futures = {
            self._submit(Task(name, deadline, [sources[n] for n in batch])): batch for batch in self._batches(sources)
        }
        try:
            for future in self._as_completed(set(futures)):
                done = self._done(future)
                rows = [] if done is None else done.rows
                for number, row in zip(futures[future], rows, strict=False):
                    answers[number] = _ANSWERS[row.kind](row.payload)
                    on_done(number, row.seconds)
        finally:
            for future in futures:
                future.cancel()
        return answers

    def _submit(self, task: Task) -> Future[bytes]:
        try:
            return self.executor.submit(run_task, identity(), msgspec.msgpack.encode(task))
        except Exception as error:  # an executor may raise whatever it likes
            raise PoolError(self.trouble() or f"no work can be given to it: {_words(error)}") from None

    def _as_completed(self, waiting: set[Future[bytes]]) -> Iterator[Future[bytes]]:
        answered = well = time.monotonic()
        while waiting:
            completed, waiting = wait(waiting, _LOOK, FIRST_COMPLETED)
            yield from completed
            trouble, now = None if completed else self.trouble(), time.monotonic()
            answered = now if completed else answered
            well = now if trouble is None else well
            if trouble is not None and now - well > PATIENCE:
                raise PoolError(trouble)
            if now - answered > SILENCE:
                raise PoolError(f"its workers are there, but none has answered for {SILENCE:,.0f} seconds")

    def _done(self, future: Future[bytes]) -> Done | None:
        """What a task has come to; None where nobody can say.  Raises :class:`PoolError` for another archlint."""
        try:
            done = msgspec.msgpack.decode(future.result(), type=Done)
        except (ImportError, AttributeError) as error:
            raise PoolError(f"a worker has no archlint {__version__} ({_words(error)}): {_SAME}") from None
        except BaseException as error:
            if isinstance(error, KeyboardInterrupt):
                raise
            self.lost += 1
            return None
        if done.identity != identity():
            raise PoolError(f"a worker runs another archlint or Python ({done.identity}; here {identity()}): {_SAME}")
        if done.failed:
            self.lost += 1
        return done

    def _batches(self, sources: Sequence[bytes]) -> list[list[int]]:
        """The numbers of the sources in groups of about the same size, the largest sources first."""
        size = sum(map(len, sources))
        count = max(1, min(len(sources), self.width * _BATCHES, size // _WORTH_IT))
        batches: list[list[int]] = [[] for _ in range(count)]
        for place, number in enumerate(sorted(range(len(sources)), key=lambda number: -len(sources[number]))):
            batches[place % count].append(number)
        return [batch for batch in batches if batch]


_SAME = f"install archlint {__version__} with the same version of Python on every worker"


def _words(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def _bytes(payload: bytes) -> Answer:
    return payload


_ANSWERS: dict[str, Callable[[bytes], Answer]] = {
    "answer": _bytes,
    "crashed": lambda payload: Crashed(),
    "timed out": lambda payload: TimedOut(),
}

__all__ = ["PATIENCE", "SILENCE", "Executor", "ExecutorPool", "PoolError"]
