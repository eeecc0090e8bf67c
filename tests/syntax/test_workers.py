"""Worker processes: one answer for each source, whatever happens to the process that works on it."""

from __future__ import annotations

import ctypes
import os
import select
import signal
import sys
import threading
import time
from collections.abc import Callable
from multiprocessing import resource_tracker
from pathlib import Path
from types import FrameType

import pytest

from archlint.syntax.python.deep_stack import DEEP_LIMIT, call_with_deep_stack, recursion_limit
from archlint.syntax.workers import Crashed, TimedOut, Work, can_fork, run_in_workers

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")


def work(source: bytes) -> bytes:
    """Does what the source says."""
    text = source.decode()
    if text == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if text == "segfault":
        ctypes.string_at(0)
    while text == "hang":
        pass
    if text == "kept waiting":
        time.sleep(1)
    if text == "raise":
        raise ValueError(text)
    if text == "pid":
        return str(os.getpid()).encode()
    return source * 2


@pytest.mark.parametrize("count", [1, 2, 5])
def test_answers_come_in_the_order_of_the_sources(count):
    sources = [str(number).encode() * (number % 7 + 1) for number in range(40)]
    assert run_in_workers(work, sources, count, 30) == [source * 2 for source in sources]


def test_nothing_to_do_takes_no_process():
    assert run_in_workers(work, [], 2, 30) == []


def test_the_work_is_done_elsewhere():
    (pid,) = run_in_workers(work, [b"pid"], 1, 30)
    assert int(pid) != os.getpid()


@pytest.mark.parametrize("count", [1, 2])
def test_the_rest_is_done_while_nobody_waits(count, tmp_path):
    def leaves_a_file(source: bytes) -> bytes:
        (tmp_path / source.decode()).touch()
        return source * 30_000  # more than a pipe holds unless it is asked to

    rest = [b"b", b"c", b"d", b"e"]
    left = Work(leaves_a_file, [b"a", *rest], count, 30)
    try:
        assert left.answers_to(1) == [b"a" * 30_000]
        left.hand_out()
        until = time.monotonic() + 20
        while len(list(tmp_path.iterdir())) < 5 and time.monotonic() < until:
            time.sleep(0.01)
        assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b", "c", "d", "e"]
        assert left.answers_to(5)[1:] == [source * 30_000 for source in rest]
    finally:
        left.close()


@pytest.mark.parametrize("killer", [b"die", b"hang"])
def test_what_was_given_to_a_process_that_ends_is_done_by_another(killer):
    left = Work(work, [b"first", killer, b"c", b"d"], 1, 0.5)  # the longest first
    try:
        assert left.answers_to(1) == [b"firstfirst"]
        left.hand_out()
        answers = left.answers_to(4)
    finally:
        left.close()
    assert isinstance(answers[1], Crashed if killer == b"die" else TimedOut)
    assert answers[2:] == [b"cc", b"dd"]


def test_work_that_nobody_waits_for_ends_with_it():
    left = Work(work, [b"pid", b"hang", b"hang"], 1, 30)
    (pid,) = left.answers_to(1)
    left.hand_out()
    left.close()
    with pytest.raises(ProcessLookupError):
        os.kill(int(pid), 0)


def test_a_large_answer_arrives_whole():
    source = b"x" * 3_000_000
    assert run_in_workers(work, [source], 1, 30) == [source * 2]


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize("killer", [b"die", b"segfault", b"raise"])
def test_what_kills_its_process_is_named_and_the_rest_is_answered(killer, count):
    answers = run_in_workers(work, [b"a", killer, b"b", b"c"], count, 30)
    assert isinstance(answers[1], Crashed)
    assert [answers[0], answers[2], answers[3]] == [b"aa", b"bb", b"cc"]


def test_a_process_that_dies_once_is_forgiven(tmp_path):
    marker = tmp_path / "seen"

    def dies_once(source: bytes) -> bytes:
        if not marker.exists():
            marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return source

    assert run_in_workers(dies_once, [b"a", b"b"], 1, 30) == [b"a", b"b"]


def test_what_takes_too_long_is_given_up():
    answers = run_in_workers(work, [b"a", b"hang", b"b"], 2, 0.5)
    assert [answers[0], answers[2]] == [b"aa", b"bb"]
    assert isinstance(answers[1], TimedOut)


def test_time_that_the_machine_spends_on_others_does_not_count():
    sources = [b"kept waiting", b"b"]
    assert run_in_workers(work, sources, 2, 0.3) == [source * 2 for source in sources]


def test_workers_end_when_their_parent_is_killed(tmp_path):
    def tells_its_process(source: bytes) -> bytes:
        (tmp_path / str(os.getpid())).touch()
        time.sleep(0.2)
        return source

    parent = os.fork()
    if parent == 0:
        try:
            run_in_workers(tells_its_process, [b"a"] * 1000, 3, 30)
        finally:
            os._exit(0)
    assert _within(20, lambda: len(list(tmp_path.iterdir())) == 3)
    os.kill(parent, signal.SIGKILL)
    os.waitpid(parent, 0)
    workers = [int(one.name) for one in tmp_path.iterdir()]
    assert _within(20, lambda: not any(map(_runs, workers)))


def _within(seconds: float, holds: Callable[[], bool]) -> bool:
    end = time.monotonic() + seconds
    while not holds() and time.monotonic() < end:
        time.sleep(0.05)
    return holds()


def _runs(pid: int) -> bool:
    """Whether a process runs; one that has ended and that nobody has asked about does not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


@pytest.fixture
def no_tracker():
    """Other tests of this process may have left it a process that watches over what they shared."""
    resource_tracker._resource_tracker._stop()


@pytest.mark.usefixtures("no_tracker")
def test_no_process_is_left_behind():
    run_in_workers(work, [b"a", b"hang", b"die"], 3, 0.5)
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


AROUND_A_FORK = ("logging/__init__.py", "random.py", "threading.py", "weakref.py")
"""Modules of Python with functions that it calls before and after a fork."""


@pytest.mark.usefixtures("no_tracker")
def test_an_interrupted_run_leaves_no_process_behind():
    def interrupt(_: int, frame: FrameType | None) -> None:
        if frame is not None and frame.f_code.co_filename.endswith(AROUND_A_FORK):
            signal.setitimer(signal.ITIMER_REAL, 0.05)  # Python ignores what is raised there
        else:
            raise KeyboardInterrupt

    previous = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(KeyboardInterrupt):
            run_in_workers(work, [b"hang", b"hang"], 2, 30)
    finally:
        signal.signal(signal.SIGALRM, previous)
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def test_no_fork_while_another_thread_runs():
    release, others = threading.Event(), threading.active_count() - 1
    thread = threading.Thread(target=release.wait)
    assert can_fork(others)
    thread.start()
    try:
        assert not can_fork(others)
    finally:
        release.set()
        thread.join()


def nested(depth: int) -> int:
    return 0 if depth == 0 else 1 + nested(depth - 1)


def test_a_deep_stack_is_deep():
    def dig() -> int:
        with recursion_limit(DEEP_LIMIT):
            return nested(15_000)

    assert call_with_deep_stack(dig) == 15_000
    with pytest.raises(RecursionError):
        nested(15_000)


def test_errors_come_out_of_the_deep_stack():
    with pytest.raises(ZeroDivisionError):
        call_with_deep_stack(lambda: 1 // 0)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux tells a process that its parent has died")
def test_a_worker_does_not_outlive_a_parent_that_is_killed():
    reader, writer = os.pipe()

    def job(source: bytes) -> bytes:
        os.write(writer, b"%10d" % os.getpid())
        time.sleep(3600)
        return source

    parent = os.fork()
    if parent == 0:
        run_in_workers(job, [b"x"], 1, 3600.0)
        os._exit(0)
    os.close(writer)
    worker = int(os.read(reader, 10))
    os.kill(parent, signal.SIGKILL)
    os.waitpid(parent, 0)
    ready, _, _ = select.select([reader], [], [], 30)  # the last one who could write is gone
    if not ready:
        os.kill(worker, signal.SIGKILL)
    assert ready and os.read(reader, 1) == b""
    os.close(reader)
