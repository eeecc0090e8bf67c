"""Which distribution to try, and what its tests share: everything is started at the beginning, several at a time."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from tests_ros.cases import CANNOT_RUN, Case, Preparation, Ready
from tests_ros.environments import Environment
from tests_ros.judging import counted, problems
from tests_ros.reading import not_built
from tests_ros.running import Observed, Servers, observe

DISTROS = ("jazzy", "kilted")
AT_ONCE = 2 + 2 * (os.cpu_count() or 1)
"""How many cases run at the same time: most of what they do is waiting."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--full", action="store_true", help="what is marked so, too: minutes more")
    parser.addoption("--distro", choices=DISTROS, default="jazzy", help="the ROS 2 distribution to try against")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "full: only with --full")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--full"):
        left = [item for item in items if item.get_closest_marker("full")]
        config.hook.pytest_deselected(items=left)
        items[:] = [item for item in items if item not in left]


def asked_for(session: pytest.Session, parameter: str) -> list[Any]:
    """The values of a parameter over all tests that will run."""
    calls = [getattr(item, "callspec", None) for item in session.items]
    return [call.params[parameter] for call in calls if call and parameter in call.params]


@pytest.fixture(scope="session")
def environment(pytestconfig: pytest.Config) -> Environment:
    one = Environment(pytestconfig.getoption("--distro"))
    if not one.ready():
        pytest.skip(f"no environment for {one.distro}: run `make test-ros`")
    return one


@pytest.fixture(scope="session")
def servers(environment: Environment, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Servers]:
    made = Servers(environment, tmp_path_factory.mktemp("servers"))
    yield made
    made.close()


class Runs:
    """All cases that were asked for, each run once, from the moment that archlint has read what it is."""

    def __init__(self, cases: list[Case], preparation: Preparation, servers: Servers) -> None:
        self._servers = servers
        self._builds = ThreadPoolExecutor(2)
        self._pool = ThreadPoolExecutor(AT_ONCE)
        self._ready: dict[Case, Ready] = {}
        self._futures: dict[Case, Future[Future[Observed]]] = {}
        for case in cases:
            self._ready[case] = preparation.ready(case)
            self._futures[case] = self._builds.submit(self._start, case)

    def of(self, case: Case) -> tuple[Ready, Observed]:
        return self._ready[case], self._futures[case].result().result()

    def again(self, case: Case) -> Observed:
        """Runs a case once more: on a busy machine a process may come up too late to be seen."""
        return self._start(case).result()

    def _start(self, case: Case) -> Future[Observed]:
        """Puts a case in line for running once its interfaces are built."""
        ready = self._ready[case]
        server = self._servers.of(self._servers.environment.interfaces(*ready.interfaces))
        return self._pool.submit(
            observe, server, ready.programs, ready.root, lambda now: not problems(case, ready, now)
        )

    def close(self) -> None:
        self._builds.shutdown(cancel_futures=True)
        self._pool.shutdown(cancel_futures=True)


@pytest.fixture(scope="session")
def preparation(environment: Environment, tmp_path_factory: pytest.TempPathFactory) -> Preparation:
    return Preparation(environment, Path(tmp_path_factory.mktemp("workspaces")))


@pytest.fixture(scope="session")
def runs(request: pytest.FixtureRequest, preparation: Preparation, servers: Servers) -> Iterator[Runs]:
    cases = [case for case in asked_for(request.session, "case") if case.name not in CANNOT_RUN]
    made = Runs(cases, preparation, servers)
    yield made
    made.close()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    one = Environment(config.getoption("--distro"))
    if not counted.runs:
        return
    versions = ", ".join(f"{name} {'.'.join(map(str, one.version(name)))}" for name in ("rclpy", "rcl_action"))
    kinds = ", ".join(f"{number} {kind.replace('_', ' ')}" for kind, number in sorted(counted.entities.items()))
    for line in (
        f"ROS 2 {one.distro} ({versions}): {counted.runs} runs, {counted.differences} differences",
        f"{sum(counted.entities.values())} entities compared: {kinds}",
        f"{counted.left_open} more run of which archlint gives no name",
    ):
        terminalreporter.write_line(line)
    if not_built:
        terminalreporter.write_line(f"{len(not_built)} nodes in C++ are left out: {', '.join(sorted(not_built))}")
