"""The thread that analyses: a pause in the typing, newer edits, failures, and questions in between."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import pytest

from archlint.monitor import Monitor
from archlint.server.worker import Worker

PATIENCE = 30.0
"""Seconds; a busy machine is no reason for a test to fail."""


class Analyses:
    """What a worker was told to analyse; ``act`` is done each time."""

    def __init__(self, act: Callable[[str, Monitor], None] = lambda root, monitor: None) -> None:
        self.roots: list[str] = []
        self.failures: list[str] = []
        self._act = act
        self._heard = threading.Condition()
        self.worker = Worker(self._analyse, self._failed)

    def wait_until(self, holds: Callable[[], bool]) -> None:
        with self._heard:
            assert self._heard.wait_for(holds, PATIENCE)

    def _analyse(self, root: str, monitor: Monitor) -> None:
        self._act(root, monitor)
        with self._heard:
            self.roots.append(root)
            self._heard.notify_all()

    def _failed(self, root: str, error: Exception) -> None:
        with self._heard:
            self.failures.append(f"{root}: {error}")
            self._heard.notify_all()


@pytest.fixture
def started() -> Iterator[Callable[..., Analyses]]:
    running: list[Analyses] = []

    def start(act: Callable[[str, Monitor], None] = lambda root, monitor: None) -> Analyses:
        running.append(Analyses(act))
        return running[-1]

    yield start
    for each in running:
        each.worker.close()


def test_several_edits_without_a_pause_are_analysed_once(started: Callable[..., Analyses]) -> None:
    analyses = started()
    for _ in range(5):
        analyses.worker.touch("/a", pause=0.2)
    analyses.worker.touch("/b", pause=0.4)

    analyses.wait_until(lambda: "/b" in analyses.roots)

    assert analyses.roots == ["/a", "/b"]


def test_an_analysis_gives_up_when_there_is_something_newer(started: Callable[..., Analyses]) -> None:
    begun, newer = threading.Event(), threading.Event()
    looks: list[str] = []

    def act(root: str, monitor: Monitor) -> None:
        begun.set()
        assert newer.wait(PATIENCE)
        monitor.judged()
        looks.append("went on")

    analyses = started(act)
    analyses.worker.touch("/a", pause=0)
    assert begun.wait(PATIENCE)
    analyses.worker.touch("/a", pause=0)
    newer.set()

    analyses.wait_until(lambda: analyses.roots == ["/a"])
    assert looks == ["went on"]  # the second time only


def test_a_failure_is_told_and_the_next_analysis_runs(started: Callable[..., Analyses]) -> None:
    def act(root: str, monitor: Monitor) -> None:
        if root == "/broken":
            raise ValueError("no")

    analyses = started(act)
    analyses.worker.touch("/broken", pause=0)
    analyses.wait_until(lambda: analyses.failures == ["/broken: no"])
    analyses.worker.touch("/a", pause=0)

    analyses.wait_until(lambda: analyses.roots == ["/a"])


def test_a_question_about_a_workspace_waits_for_its_analysis_and_for_no_other(
    started: Callable[..., Analyses],
) -> None:
    analyses = started()
    analyses.worker.touch("/a", pause=3600)
    analyses.worker.touch("/b", pause=3600)

    answer = analyses.worker.ask(lambda: list(analyses.roots), about="/a")

    assert answer.result(PATIENCE) == ["/a"]


def test_a_question_that_fails_fails_alone(started: Callable[..., Analyses]) -> None:
    analyses = started()

    def fails() -> None:
        raise ValueError("no answer")

    with pytest.raises(ValueError, match="no answer"):
        analyses.worker.ask(fails).result(PATIENCE)
    assert analyses.worker.ask(lambda: 1).result(PATIENCE) == 1
