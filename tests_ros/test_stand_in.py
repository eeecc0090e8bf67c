"""The stand-in for rclpy, under which ``benchmarks/accuracy`` runs nodes, is held against rclpy itself.

Both execute the same programs and classes, under the same recorder: each node, endpoint, timer, parameter and refused
name must be the same at the same line, with owner, final name, type, QoS, callback, period and value. The programs of
``calls`` call rclpy as it should be called and as it should not, and say what each call gave, or raised.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from benchmarks.accuracy.environment import real_python
from benchmarks.accuracy.oracle.processes import Pool, Python
from benchmarks.accuracy.oracle.run import Oracle

from tests_ros.environments import OWN_INTERFACES, ROOT, Environment

FORMS = ROOT / "fixtures" / "forms"
CALLS = ROOT / "tests_ros" / "calls"
WORKSPACES = sorted(
    path.parent for path in (ROOT / "fixtures").glob("*/expected.toml") if path.parent.name != "bad_input"
)
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


@pytest.fixture(scope="module")
def stand_in() -> Iterator[Pool]:
    pool = Pool(Python())
    yield pool
    pool.close()


@pytest.fixture(scope="module")
def real(environment: Environment) -> Iterator[Callable[[Path], Pool]]:
    """Gives a folder the processes that have its interfaces: as a rule, those of the other folders, too."""
    pools: dict[tuple[Path, ...], Pool] = {}

    def pool_for(folder: Path) -> Pool:
        needed = environment.interfaces(folder, OWN_INTERFACES)
        for prefixes, pool in pools.items():
            if set(needed) <= set(prefixes):
                return pool
        packages = {path.name.rpartition("-")[0]: path for path in everything}
        prefixes = tuple((packages | {path.name.rpartition("-")[0]: path for path in needed}).values())
        return pools.setdefault(prefixes, Pool(real_python(environment, list(prefixes))))

    everything = [path for folder in (FORMS, *WORKSPACES) for path in environment.interfaces(folder)]
    yield pool_for
    for pool in pools.values():
        pool.close()


@pytest.mark.parametrize("folder", [FORMS, CALLS, *WORKSPACES], ids=lambda folder: folder.name)
def test_the_stand_in_makes_what_rclpy_makes(
    folder: Path, stand_in: Pool, real: Callable[[Path], Pool], environment: Environment
):
    expected = Oracle(folder, processes=real(folder), patience=5).run(plain=True)
    recorded = Oracle(folder, processes=stand_in, patience=5).run(plain=True)
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
