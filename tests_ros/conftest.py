"""Which distributions to try, and what the tests of one share."""

from __future__ import annotations

import pytest

from tests_ros.comparing import counted
from tests_ros.environments import Environment

DISTROS = ("jazzy", "kilted")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--distro", choices=DISTROS, default="jazzy", help="the ROS 2 distribution to try against")


@pytest.fixture(scope="session")
def environment(pytestconfig: pytest.Config) -> Environment:
    one = Environment(pytestconfig.getoption("--distro"))
    if not one.ready():
        pytest.skip(f"no environment for {one.distro}: run `make test-ros`")
    return one


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    entities = f"{counted['compared']} nodes, endpoints, timers and parameters compared in {counted['runs']} runs"
    left = f"{counted['left open']} of which archlint gives no name"
    terminalreporter.write_line(f"ROS 2 {config.getoption('--distro')}: {entities}; {left}")
