"""Settings of the test suite (a busy machine is no reason for a property test to fail), and what many tests run."""

from __future__ import annotations

import gc
import os
from collections.abc import Generator, Iterator
from functools import lru_cache
from itertools import count
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from archlint.syntax import compile as compiler
from archlint.syntax import workers
from checks.callbacks import Run, findings
from checks.judging import Judge
from installing import InstallsOf
from launching import Launches

settings.register_profile("archlint", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("archlint")


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Thousands of tests live as long as the process: no garbage collection need go through them."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.fixture(autouse=True, scope="session")
def bytecode_of_processes() -> Iterator[None]:
    """The processes that tests start leave archlint's bytecode to each other: compiling it is half of a short run."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
        yield


@pytest.fixture(autouse=True, scope="session")
def home_of_the_tests(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The key that signs the cache is not the one of who runs the tests."""
    folder = tmp_path_factory.mktemp("config")
    before = os.environ.get("XDG_CONFIG_HOME")
    os.environ["XDG_CONFIG_HOME"] = str(folder)
    yield folder
    if before is None:
        del os.environ["XDG_CONFIG_HOME"]
    else:
        os.environ["XDG_CONFIG_HOME"] = before


@pytest.fixture(autouse=True, scope="session")
def compiled_once() -> Iterator[None]:
    """Each text is compiled in this process, and once: a fork of a process with thousands of tests is slow.

    What tests the compiler and its processes undoes it (tests/syntax/conftest.py).
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(workers, "can_fork", lambda waiting=0: False)
        patch.setattr(compiler, "encoded", lru_cache(maxsize=20_000)(compiler.encoded))
        yield


_NUMBERS = count()


@pytest.fixture
def tmp_path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An empty folder.  pytest's own also moves a link to the newest one, which costs more than a small run."""
    folder = tmp_path_factory.getbasetemp() / f"t{next(_NUMBERS)}"
    folder.mkdir()
    return folder


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    monkeypatch.chdir(tmp_path)
    return Judge(tmp_path)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Runs the rules that are on by default over one file."""
    monkeypatch.chdir(tmp_path)
    return lambda text, distro=None: findings(tmp_path, text, distro)


@pytest.fixture
def launches(tmp_path: Path) -> Launches:
    return Launches(tmp_path)


@pytest.fixture
def installs_of(tmp_path: Path) -> InstallsOf:
    return InstallsOf(tmp_path)
