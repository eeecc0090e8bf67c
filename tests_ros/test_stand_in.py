"""The stand-in for rclpy, under which ``benchmarks/accuracy`` runs nodes, is held against rclpy itself.

Both execute the same programs and classes, under the same recorder: each node, endpoint, timer, parameter and refused
name must be the same at the same line, with owner, final name, type, QoS, callback, period and value. The programs of
``calls`` call rclpy as it should be called and as it should not, and say what each call gave, or raised.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from benchmarks.accuracy.environment import real_python
from benchmarks.accuracy.oracle.processes import Pool, Python
from benchmarks.accuracy.oracle.run import Oracle

from tests_ros.conftest import asked_for
from tests_ros.environments import OWN_INTERFACES, ROOT, Environment

FORMS = ROOT / "fixtures" / "forms"
CALLS = ROOT / "tests_ros" / "calls"
WORKSPACES = sorted(
    path.parent for path in (ROOT / "fixtures").glob("*/expected.toml") if path.parent.name != "bad_input"
)
FOLDERS_AT_ONCE = 4
"""Each runs two programs at a time, which mostly wait."""
NOT_INSTALLED = ("tf2_msgs",)
"""Packages of interfaces without a wheel: rclpy is given another type, and none is recorded."""

OTHERWISE_IN = {
    "jazzy": {},
    "kilted": {
        "profile_7/TypeError": "profile_7/ValueError",
        "profile_17/AssertionError": "profile_17/TypeError",
    },
}
"""What a call of ``calls`` gives in a distribution, and another in the stand-in, which follows Jazzy."""

Record = dict[str, Any]


class Records:
    """What both make of each folder that is asked for, several at a time."""

    def __init__(self, folders: list[Path], environment: Environment) -> None:
        self._environment = environment
        self._stand_in = Pool(Python())
        self._real: dict[tuple[Path, ...], Pool] = {}
        self._threads = ThreadPoolExecutor(FOLDERS_AT_ONCE)
        pools = {folder: self._pool_for(folder) for folder in folders}
        self._futures = {
            folder: [self._threads.submit(record, folder, one) for one in (pool, self._stand_in)]
            for folder, pool in pools.items()
        }

    def of(self, folder: Path) -> list[Record]:
        """Under rclpy, and under the stand-in."""
        return [future.result() for future in self._futures[folder]]

    def _pool_for(self, folder: Path) -> Pool:
        """The processes that have a folder's interfaces: as a rule, those of the other folders, too."""
        everything = [path for one in (FORMS, *WORKSPACES) for path in self._environment.interfaces(one)]
        needed = self._environment.interfaces(folder, OWN_INTERFACES)
        for prefixes, pool in self._real.items():
            if set(needed) <= set(prefixes):
                return pool
        packages = {path.name.rpartition("-")[0]: path for path in [*everything, *needed]}
        prefixes = tuple(packages.values())
        return self._real.setdefault(prefixes, Pool(real_python(self._environment, list(prefixes))))

    def close(self) -> None:
        self._threads.shutdown(cancel_futures=True)
        for pool in (self._stand_in, *self._real.values()):
            pool.close()


def record(folder: Path, pool: Pool) -> Record:
    return Oracle(folder, processes=pool, patience=5).run(plain=True)


@pytest.fixture(scope="module")
def records(request: pytest.FixtureRequest, environment: Environment) -> Iterator[Records]:
    made = Records(asked_for(request.session, "folder"), environment)
    yield made
    made.close()


@pytest.mark.parametrize("folder", [FORMS, CALLS, *WORKSPACES], ids=lambda folder: folder.name)
def test_the_stand_in_makes_what_rclpy_makes(folder: Path, records: Records, environment: Environment):
    expected, recorded = records.of(folder)
    for jazzy, here in OTHERWISE_IN[environment.distro].items():
        recorded = json.loads(json.dumps(recorded).replace(jazzy, here))

    assert expected["entities"]
    for what in ("nodes", "entities", "parameters", "refused"):
        assert lines(recorded, what) == lines(expected, what)
    assert ends(recorded) == ends(expected)


def lines(record: Record, what: str) -> list[str]:
    return sorted({line(one) for one in record[what]})


def line(one: Record) -> str:
    """One thing that was recorded, as a line that shows in a failure what is different."""
    kept = {key: value for key, value in one.items() if key not in ("file", "line", "by", "via", "reason")}
    if str(kept.get("type")).startswith(NOT_INSTALLED):
        kept["type"] = None
    return f"{one['file']}:{one['line']} {json.dumps(kept, sort_keys=True)}"


def ends(record: Record) -> dict[str, str]:
    """What stopped each program, or each class."""
    return {
        f"{run['target']} {failure['target']}": failure["reason"].partition(":")[0]
        for run in record["runs"]
        for failure in run["failures"]
    }
