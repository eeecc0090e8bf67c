"""What is counted in the source of archlint itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.structure.source import complexities, files_of, timed_asserts

CODE = """\
import os
from robot import names


class Arm:
    def move(self, to):
        from robot.arm import joints

        if isinstance(to, int):
            return joints
        return os.path

    async def stop(self):
        def inner():
            from . import names
            import robot.arm
        import json
        return inner, names, isinstance
"""

TESTS = """\
import time
from time import perf_counter


def test_one():
    start = perf_counter()
    work()
    taken = perf_counter() - start
    assert taken < 5


def test_two():
    assert time.process_time() < 5


def test_three():
    start = time.monotonic()
    wait(start)
    assert work() == 5
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    folder = tmp_path / "robot"
    (folder / "arm").mkdir(parents=True)
    (folder / "__init__.py").write_text("")
    (folder / "arm" / "joints.py").write_text(CODE)
    return folder


def test_what_a_file_holds(package: Path):
    [first, joints] = files_of(package)
    assert (first.folder, first.lines) == ("", 0)
    assert (joints.folder, joints.lines, joints.instance_checks) == ("arm", 18, 1)
    assert joints.late_imports == (7, 15, 16)  # json is no module of the package
    assert set(joints.functions) == {("move", 6, 6), ("stop", 13, 6), ("inner", 14, 3)}


def test_complexity_is_one_and_one_for_each_branch(package: Path):
    assert complexities(package) == [1, 2, 2]  # a function inside another counts as a branch of that


def test_asserts_that_a_clock_decides(tmp_path: Path):
    (tmp_path / "test_arm.py").write_text(TESTS)
    assert timed_asserts(tmp_path) == ["test_arm.py:9", "test_arm.py:13"]
