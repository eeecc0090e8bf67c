"""Which distribution to try, and what its tests share: everything is started at the beginning, several at a time."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from tests_ros.cases import Case, Preparation, Ready
from tests_ros.environments import Environment
from tests_ros.judging import counted, problems
from tests_ros.running import Observed, Servers, observe

DISTROS = ("jazzy", "kilted")
AT_ONCE = 2 + 2 * (os.cpu_count() or 1)
"""How many cases run at the same time: most of what they do is waiting."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--distro", choices=DISTROS, default="jazzy", help="the ROS 2 distribution to try against")


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
    """All cases that were asked for, each run once."""

    def __init__(self, cases: list[Case], preparation: Preparation, servers: Servers) -> None:
        self._servers = servers
        self._builds = ThreadPoolExecutor(2)
        self._pool = ThreadPoolExecutor(AT_ONCE)
        made = {case: preparation.ready(case) for case in cases}
        packages = dict.fromkeys(package for ready in made.values() for package in ready.interfaces)
        self._built = {one: self._builds.submit(servers.environment.interfaces, one) for one in packages}
        self._futures: dict[Case, Future[tuple[Ready, Observed]]] = {
            # Those for which nothing has to be built come first.
            case: self._pool.submit(self._run, case, made[case])
            for case in sorted(made, key=lambda case: len(made[case].interfaces))
        }

    def of(self, case: Case) -> tuple[Ready, Observed]:
        return self._futures[case].result()

    def _run(self, case: Case, ready: Ready) -> tuple[Ready, Observed]:
        prefixes = [prefix for package in ready.interfaces for prefix in self._built[package].result()]
        server = self._servers.of(prefixes)
        return ready, observe(server, ready.programs, ready.root, lambda now: not problems(case, ready, now))

    def close(self) -> None:
        self._pool.shutdown(cancel_futures=True)
        self._builds.shutdown(cancel_futures=True)


@pytest.fixture(scope="session")
def preparation(environment: Environment, tmp_path_factory: pytest.TempPathFactory) -> Preparation:
    return Preparation(environment, Path(tmp_path_factory.mktemp("workspaces")))


@pytest.fixture(scope="session")
def runs(request: pytest.FixtureRequest, preparation: Preparation, servers: Servers) -> Iterator[Runs]:
    asked = [getattr(item, "callspec", None) for item in request.session.items]
    made = Runs([one.params["case"] for one in asked if one and "case" in one.params], preparation, servers)
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
