"""Who does work that is a map over bytes: this process, processes of its own, or machines elsewhere."""

from __future__ import annotations

import gc
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol

from archlint.records import dataclass
from archlint.syntax import workers
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.syntax.workers import Answer, Job, OnDone


class Pool(Protocol):
    """``map`` gives one answer for each source, in their order.

    ``job`` depends on nothing but the source.  ``deadline`` is the processor time in seconds that one source may take;
    ``on_done`` is called with each that is done.  Raises ``OSError`` where the system has no process to give.
    """

    def map(self, job: Job, sources: Sequence[bytes], deadline: float, on_done: OnDone) -> list[Answer]: ...


class OneProcess:
    """This process does it all, one after the other; there is no deadline."""

    def map(self, job: Job, sources: Sequence[bytes], deadline: float, on_done: OnDone) -> list[Answer]:
        def answer(number: int, source: bytes) -> Answer:
            began = time.process_time()
            payload = job(source)
            on_done(number, time.process_time() - began)
            return payload

        with paused_collection():
            return call_with_deep_stack(lambda: [answer(*row) for row in enumerate(sources)])


@dataclass(frozen=True)
class Processes:
    """Up to ``count`` forked processes, each of which may take so many bytes beside what it begins with."""

    count: int
    most_bytes: int | None = None

    def map(self, job: Job, sources: Sequence[bytes], deadline: float, on_done: OnDone) -> list[Answer]:
        return workers.run_in_workers(job, sources, self.count, deadline, on_done, self.most_bytes)


@contextmanager
def paused_collection() -> Iterator[None]:
    """No garbage collection: the trees hold no cycles, and looking for some costs a tenth of the time."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


__all__ = ["OneProcess", "Pool", "Processes", "paused_collection"]
