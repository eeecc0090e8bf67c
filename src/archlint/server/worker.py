"""The thread that analyses: it waits for a pause in the typing, and gives up what has been overtaken."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

from archlint.monitor import Monitor

PAUSE = 0.05
"""Seconds without an edit after which an analysis begins."""
REST = 1.0
"""Seconds with nothing to do after which what analyses have left over is cleared away."""
MOST = 10
"""After so many analyses without such a pause it is cleared away all the same."""
PATIENCE = 5.0
"""Seconds after which an analysis is finished though there are newer edits: who types without a pause gets
answers, too."""

Result = TypeVar("Result")


class Overtaken(BaseException):
    """There is something newer to analyse.  No ``Exception``: nothing that contains faults holds it up."""


class Worker:
    """Analyses workspaces, by their roots, one after the other, in a thread of its own.

    ``analyse`` is called with a root and with who may raise :class:`Overtaken`; ``failed`` with what it raised;
    ``rest`` when there is time to clear away what analyses have left over.
    """

    def __init__(
        self,
        analyse: Callable[[str, Monitor], None],
        failed: Callable[[str, Exception], None],
        rest: Callable[[], object] = lambda: None,
    ) -> None:
        self._analyse = analyse
        self._failed = failed
        self._rest = rest
        self._since_rest = 0
        """How many analyses have begun since then."""
        self._changed = threading.Condition()
        self._due: dict[str, float] = {}
        self._tasks: deque[Callable[[], None]] = deque()
        self._began: dict[str, float] = {}
        """When a workspace was first to be analysed since its last analysis."""
        self._ends = False
        self._thread = threading.Thread(target=self._run, name="archlint-analysis", daemon=True)
        self._thread.start()

    def touch(self, root: str, pause: float = PAUSE) -> None:
        """Something has changed in a workspace."""
        with self._changed:
            now = time.monotonic()
            self._due[root] = now + pause
            self._began.setdefault(root, now)
            self._changed.notify()

    def forget(self, root: str) -> None:
        with self._changed:
            self._due.pop(root, None)
            self._began.pop(root, None)

    def ask(self, task: Callable[[], Result], about: str | None = None) -> Future[Result]:
        """Do something between two analyses; first the one of the workspace that it is ``about``, if it is due."""
        future: Future[Result] = Future()

        def act() -> None:
            if about is not None and about in self._due:
                self._analyse_now(about)
            if future.set_running_or_notify_cancel():
                try:
                    future.set_result(task())
                except Exception as error:
                    future.set_exception(error)

        with self._changed:
            self._tasks.append(act)
            self._changed.notify()
        return future

    def close(self) -> None:
        """End the thread, once what it does is done or overtaken."""
        with self._changed:
            self._ends = True
            self._changed.notify()
        self._thread.join()

    def _run(self) -> None:
        while True:
            with self._changed:
                self._wait()
                if self._ends:
                    return
                task = self._tasks.popleft() if self._tasks else None
                root = min(self._due, key=lambda root: self._due[root]) if self._next_due() == 0 else None
            if task is not None:
                task()
            elif root is not None and self._since_rest < MOST:
                self._analyse_now(root)
            else:
                self._since_rest = 0
                self._rest()

    def _wait(self) -> None:
        """Until there is something to do, or time for a rest that is due."""
        while not (self._ends or self._tasks or self._next_due() == 0):
            rests = self._since_rest > 0 and not self._due
            if not self._changed.wait(REST if rests else self._next_due()) and rests:
                return

    def _next_due(self) -> float | None:
        """Seconds until the next analysis; None where there is none to come."""
        return max(0.0, min(self._due.values()) - time.monotonic()) if self._due else None

    def _analyse_now(self, root: str) -> None:
        with self._changed:
            self._due.pop(root, None)
            began = self._began.get(root, time.monotonic())
            self._since_rest += 1

        def is_overtaken() -> bool:
            newer = root in self._due and time.monotonic() - began < PATIENCE
            return self._ends or newer

        try:
            self._analyse(root, _Watching(is_overtaken))
        except Overtaken:
            return
        except Exception as error:
            self._failed(root, error)
        with self._changed:
            if root in self._due:
                self._began[root] = time.monotonic()
            else:
                self._began.pop(root, None)


class _Watching(Monitor):
    """Ends an analysis that is overtaken, at the next thing that it reports."""

    def __init__(self, is_overtaken: Callable[[], bool]) -> None:
        self._is_overtaken = is_overtaken

    def _look(self) -> None:
        if self._is_overtaken():
            raise Overtaken

    def compiling(self, files: int) -> None:
        self._look()

    def compiled(self, file: str, seconds: float) -> None:
        self._look()

    def followed(self, key: str, program: str, seconds: float) -> None:
        self._look()

    def known(self, key: str) -> None:
        self._look()

    def judging(self, systems: int) -> None:
        self._look()

    def asking(self) -> None:
        self._look()

    def judged(self) -> None:
        self._look()


__all__ = ["PAUSE", "Overtaken", "Worker"]
