"""Worker processes for the compiler: for speed, and to survive a file that kills the parser.

A worker inherits the sources by ``fork``; only the number of a source goes to it and only bytes come back.
One source is under way in each worker at a time, so when a worker dies it is known on which one.
"""

from __future__ import annotations

import contextlib
import gc
import os
import selectors
import signal
import struct
import sys
import time
import warnings
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import field
from typing import NoReturn

from archlint.records import dataclass
from archlint.syntax.memory import own_bytes
from archlint.syntax.python.deep_stack import call_with_deep_stack

Job = Callable[[bytes], bytes]

_NUMBER = struct.Struct("=I")
_HEADER = struct.Struct("=Qd")
"""The size of an answer, and how many seconds of processor time it took."""
_STOP = 2**32 - 1

_PATIENCE = 20
"""How many times the deadline a source may be under way by the clock on the wall: a process that does nothing at all
would never use up its processor time."""


class Crashed:
    """The source killed the process that worked on it, twice."""


class TimedOut:
    """The source was under way for longer than allowed."""


class Lost:
    """Whoever worked on the source, elsewhere, is gone; it says nothing of the source."""


Answer = bytes | Crashed | TimedOut | Lost

OnDone = Callable[[int, float], None]
"""Is called with the number of each source that is done, and the seconds of processor time that it took."""


def ignore_done(number: int, seconds: float) -> None:
    """Nobody wants to know what is done."""


def can_fork(waiting: int = 0) -> bool:
    """Whether this process may fork: only POSIX can, and only while no other thread runs.  ``waiting`` is how many
    others do nothing but wait for this one."""
    threading = sys.modules.get("threading")
    alone = threading is None or threading.active_count() == 1 + waiting
    return hasattr(os, "fork") and alone


def run_in_workers(
    job: Job,
    sources: Sequence[bytes],
    count: int,
    deadline: float,
    on_done: OnDone = ignore_done,
    most_bytes: int | None = None,
) -> list[Answer]:
    """One answer for each source, in their order, from up to ``count`` forked processes.

    ``job`` is called in a thread with a deep stack.  ``deadline`` is the processor time in seconds that one source
    may take: on a machine that has much else to do no file takes longer.  ``on_done`` is called here as answers come
    in.  ``most_bytes`` is how much address space a process may take beside what it begins with.  Raises ``OSError``
    where the system has no process to give.
    """
    work = Work(job, sources, count, deadline, on_done, most_bytes)
    try:
        return work.answers_to(len(sources))
    finally:
        work.close()


@dataclass
class _Worker:
    pid: int
    requests: int
    answers: int
    numbers: deque[int] = field(default_factory=deque)
    """The sources that it was given, the one that is under way first."""
    since: float = 0.0
    """When that was begun, or could have been."""

    def give(self, number: int) -> None:
        """Send the number of a source.  That the worker is gone shows when its answer is awaited."""
        if not self.numbers:
            self.since = time.monotonic()
        self.numbers.append(number)
        self._send(number)

    def stop(self) -> None:
        """Nothing is left for it."""
        self._send(_STOP)

    def _send(self, number: int) -> None:
        try:
            os.write(self.requests, _NUMBER.pack(number))
        except BrokenPipeError:
            return

    def take(self) -> tuple[bytes, float] | None:
        """The answer that is ready, and the seconds that it took; None where the worker has died."""
        header = _read_exactly(self.answers, _HEADER.size)
        if header is None:
            return None
        size, seconds = _HEADER.unpack(header)
        payload = _read_exactly(self.answers, size)
        return None if payload is None else (payload, seconds)


class Work:
    """Some sources that up to ``count`` forked processes work on, see :func:`run_in_workers`.  Who has asked for the
    answers to the first ones may do something else while the processes go on with the rest."""

    def __init__(
        self,
        job: Job,
        sources: Sequence[bytes],
        count: int,
        deadline: float,
        on_done: OnDone = ignore_done,
        most_bytes: int | None = None,
    ) -> None:
        self._most_bytes = most_bytes
        self.answers: dict[int, Answer] = {}
        self._job = job
        self._sources = sources
        self._count = count
        self._deadline = deadline
        self._on_done = on_done
        # The longest first: nobody waits at the end for one that was begun late.
        self._waiting = deque(sorted(range(len(sources)), key=lambda number: -len(sources[number])))
        self._crashed_once: set[int] = set()
        self._workers: dict[int, _Worker] = {}
        self._selector = selectors.DefaultSelector()

    def answers_to(self, first: int) -> list[Answer]:
        """The answers to the first so many sources, once they are in; ``OSError`` as for :func:`run_in_workers`."""
        left = {number for number in range(first) if number not in self.answers}
        while left:
            self._step()
            left.difference_update(self.answers)
        return [self.answers[number] for number in range(first)]

    def hand_out(self) -> None:
        """Give the processes all that is left: nobody waits for their answers in the meantime."""
        for worker in self._workers.values():
            _widen(worker.answers)
        while self._waiting and self._workers:
            worker = min(self._workers.values(), key=lambda worker: len(worker.numbers))
            worker.give(self._waiting.popleft())

    def _step(self) -> None:
        """Start what can be started, then wait for an answer."""
        while self._waiting and len(self._workers) < self._count:
            self._start()
        for worker in self._ready():
            self._collect(worker)
        for worker in self._late():
            self._lose(worker, TimedOut(), 0.0)
            self._end(worker, kill=True)

    def close(self) -> None:
        for worker in list(self._workers.values()):
            self._end(worker, kill=True)
        self._selector.close()

    def _record(self, number: int, answer: Answer, seconds: float) -> None:
        self.answers[number] = answer
        self._on_done(number, seconds)

    def _start(self) -> None:
        request_reader, requests = os.pipe()
        answers, answer_writer = os.pipe()
        # An interrupt waits: in a process that is just being made, Python would show a traceback of its own.
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        try:
            worker = _Worker(self._fork(request_reader, requests, answers, answer_writer), requests, answers)
            self._selector.register(answers, selectors.EVENT_READ)
            self._workers[answers] = worker
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        os.close(request_reader)
        os.close(answer_writer)
        worker.give(self._waiting.popleft())

    def _fork(self, request_reader: int, requests: int, answers: int, answer_writer: int) -> int:
        """Make a worker, which never returns from here."""
        parent = os.getpid()
        with warnings.catch_warnings():
            # Python counts the threads of the system, among them those that have just ended.
            warnings.simplefilter("ignore", DeprecationWarning)
            pid = os.fork()
        if pid == 0:
            # Whoever keeps the ends of others keeps them waiting for a parent that is gone.
            others = (end for worker in self._workers.values() for end in (worker.requests, worker.answers))
            for end in (requests, answers, *others):
                os.close(end)
            _end_with(parent)
            _limit_memory(self._most_bytes)
            _serve(self._job, self._sources, request_reader, answer_writer, self._deadline)
        return pid

    def _collect(self, worker: _Worker) -> None:
        answer = worker.take()
        if answer is not None:
            self._record(worker.numbers.popleft(), *answer)
            worker.since = time.monotonic()
            if self._waiting:
                worker.give(self._waiting.popleft())
            elif not worker.numbers:
                worker.stop()
                self._end(worker, kill=False)
            return
        # It may have been the machine's doing (no memory left): once more, in a fresh process.
        status, number = self._end(worker, kill=False), worker.numbers[0]
        if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGPROF:
            self._lose(worker, TimedOut(), self._deadline)
        elif number in self._crashed_once:
            self._lose(worker, Crashed(), 0.0)
        else:
            self._crashed_once.add(number)
            self._waiting.extend(worker.numbers)

    def _lose(self, worker: _Worker, answer: Answer, seconds: float) -> None:
        """Record what has become of the source that a worker was at; others have the rest of what it was given."""
        self._record(worker.numbers.popleft(), answer, seconds)
        self._waiting.extend(worker.numbers)

    def _ready(self) -> list[_Worker]:
        oldest = min(worker.since for worker in self._workers.values())
        patience = max(0.0, oldest + _PATIENCE * self._deadline - time.monotonic()) + 0.01
        return [self._workers[key.fd] for key, _ in self._selector.select(patience)]

    def _late(self) -> list[_Worker]:
        now = time.monotonic()
        return [worker for worker in self._workers.values() if now - worker.since > _PATIENCE * self._deadline]

    def _end(self, worker: _Worker, kill: bool) -> int:
        """Wait for a worker to end, and return how it did."""
        del self._workers[worker.answers]  # first: an interrupt from here on leaves it to end by itself
        self._selector.unregister(worker.answers)
        os.close(worker.requests)
        os.close(worker.answers)
        if kill:
            os.kill(worker.pid, signal.SIGKILL)
        return os.waitpid(worker.pid, 0)[1]


_WIDE = 1 << 20
"""How many bytes of answers nobody has to have read before a process goes on."""


def _widen(answers: int) -> None:
    """Let a pipe hold more than usual, where the system can."""
    import fcntl  # only POSIX has it

    resize = getattr(fcntl, "F_SETPIPE_SZ", None)
    if resize is not None:
        with contextlib.suppress(OSError):
            fcntl.fcntl(answers, resize, _WIDE)


_PR_SET_PDEATHSIG = 1


def _end_with(parent: int) -> None:
    """Let this process end when its parent is killed, even in the middle of a source; only Linux offers that."""
    if not sys.platform.startswith("linux"):
        return
    import ctypes  # only workers need it

    try:
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    except (OSError, AttributeError):
        return
    if os.getppid() != parent:  # it was gone before
        os._exit(1)


def _limit_memory(most_bytes: int | None) -> None:
    """Let this process take no more address space than that beside what it has."""
    begins_with = own_bytes()
    if most_bytes is None or begins_with is None:
        return
    import resource

    most, hard = begins_with + most_bytes, resource.getrlimit(resource.RLIMIT_AS)[1]
    if hard == resource.RLIM_INFINITY or most < hard:
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))


def _serve(job: Job, sources: Sequence[bytes], requests: int, answers: int, deadline: float) -> NoReturn:
    """The life of a worker."""
    status = 1
    try:
        _settle()
        call_with_deep_stack(lambda: _answer_all(job, sources, requests, answers, deadline))
        status = 0
    finally:
        # Without the clean-up of an interpreter that is not ours alone.
        os._exit(status)


def _answer_all(job: Job, sources: Sequence[bytes], requests: int, answers: int, deadline: float) -> None:
    while True:
        request = _read_exactly(requests, _NUMBER.size)
        if request is None:
            return
        (number,) = _NUMBER.unpack(request)
        if number == _STOP:
            return
        signal.setitimer(signal.ITIMER_PROF, deadline)  # ends the process when it has run for so long
        began = time.process_time()
        payload = job(sources[number])
        seconds = time.process_time() - began
        signal.setitimer(signal.ITIMER_PROF, 0)
        _write_all(answers, _HEADER.pack(len(payload), seconds) + payload)


def _settle() -> None:
    """Nothing of what a worker does shows: its parent reports how it ended."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
    gc.disable()  # trees hold no cycles, and a worker does not live long
    faulthandler = sys.modules.get("faulthandler")
    if faulthandler is not None:
        faulthandler.disable()
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(nowhere, descriptor)


def _read_exactly(descriptor: int, size: int) -> bytes | None:
    chunks = []
    while size:
        chunk = os.read(descriptor, min(size, 1 << 20))
        if not chunk:
            return None
        chunks.append(chunk)
        size -= len(chunk)
    return b"".join(chunks)


def _write_all(descriptor: int, payload: bytes) -> None:
    view = memoryview(payload)
    while view:
        view = view[os.write(descriptor, view) :]
