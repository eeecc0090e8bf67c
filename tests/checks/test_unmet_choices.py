"""Mistakes behind choices that a program never makes: nobody meets them."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

PROGRAM = """\
from enum import Enum

import rclpy
from rclpy.node import Node


class State(Enum):
    START = 'drive_a'
    CURVE = 'curve_b'


class Car{number}(Node):
    def __init__(self):
        super().__init__('car{number}')
        self.mode = 'slow'
        self.state = State.START
        self.pace = self.choose(self.mode)
        self.create_timer(1.0, self.drive)

    def drive(self):
        if {test}:
            print(self.lost)

    def choose(self, mode):
        if mode == {chosen!r}:
            return self.missing
        return 1.0


def main():
    rclpy.init()
    rclpy.spin(Car{number}())


if __name__ == '__main__':
    main()
"""


def _told(root: Path, test: str = "self.pace", chosen: str = "slow", **more: str) -> list[str]:
    """The attributes that API002 misses in a program of a workspace with some others."""
    programs = {f"car{n}.py": PROGRAM.format(number=n, test="self.pace > 2", chosen="slow") for n in range(1, 7)}
    programs["car0.py"] = PROGRAM.format(number=0, test=test, chosen=chosen)
    for name, text in {**programs, **more, "archlint.toml": 'select = ["API002"]\n'}.items():
        (root / name).write_text(text, encoding="utf-8")
    rows = check(Request((".",), load(root), cached=False, jobs=1)).findings
    return [name for row in rows if row.place.file == "car0.py" for name in ("lost", "missing") if name in str(row)]


@pytest.fixture(autouse=True)
def _there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("test", "told"),
    [
        ("self.mode == 'slow'", True),
        ("self.mode == 'fast'", False),
        ("self.pace and self.mode == 'fast'", False),
        ("self.pace or self.mode == 'fast'", True),
        ("self.mode != 'fast'", True),
        ("self.state.value == 'drive_a'", True),
        ("self.state.value == 'park_c'", False),
        ("self.state.value[:-2] == 'curve'", True),
        ("self.state.value[:-2] == 'park'", False),
        ("self.state.value[:self.pace] == 'park'", True),
        ("self.get_name() == 'fast'", True),
    ],
)
def test_a_branch_for_a_text_that_is_never_there(tmp_path: Path, test: str, told: bool):
    assert ("lost" in _told(tmp_path, test=test)) is told


@pytest.mark.parametrize(("chosen", "told"), [("slow", True), ("fast", False)])
def test_a_branch_for_a_text_that_no_call_gives(tmp_path: Path, chosen: str, told: bool):
    assert ("missing" in _told(tmp_path, chosen=chosen)) is told


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("tuner.py", "def tune(car):\n    car.mode = 'fast'\n    car.choose('fast')\n"),
        ("other.py", "import car0\n\nclass Fast(car0.Car0):\n    def go(self, where):\n        self.mode = where\n"),
    ],
)
def test_another_file_may_make_the_choice(tmp_path: Path, name: str, text: str):
    assert "lost" in _told(tmp_path, test="self.mode == 'fast'", **{name: text})
