"""Findings about lines of code to which no program here comes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

MANIFEST = """
<package format="3">
  <name>car</name> <version>1.0.0</version> <description>A car.</description>
  <maintainer email="ann@example.org">Ann</maintainer> <license>MIT</license>
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP = """
from setuptools import setup

setup(name='car', packages=['car'], entry_points={'console_scripts': ['drive = car.drive:main']})
"""
LIBRARY = "from setuptools import setup\n\nsetup(name='car', packages=['car'])\n"
PARTS = """
class Brake:
    def press(self):
        return missing_1

    def release(self):
        return missing_2

    def check(self):
        return self.press()


class Horn:
    def __init__(self):
        self.tone = missing_3


def stop():
    return missing_4


def wait():
    return stop()
"""
ALL = [1, 2, 3, 4]


def told(folder: Path, program: str, parts: str = PARTS, setup: str = SETUP, **more: str) -> list[int]:
    """The numbers of the missing names of ``parts.py`` that are reported, where this is the program of a package."""
    files = {"package.xml": MANIFEST.lstrip(), "setup.py": setup, "car/__init__.py": ""}
    files |= {
        "car/drive.py": f"import rclpy\n\n{program}",
        "car/parts.py": f"import rclpy\n\n{parts}",
        "archlint.toml": 'select = ["API005"]\n',
    }
    files |= {f"car/{name}.py": text for name, text in more.items()}
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    findings = check(Request((str(folder),), load(folder), cached=False, jobs=1)).findings
    return sorted(int(finding.message.split("'")[1].rpartition("_")[2]) for finding in findings)


@pytest.mark.parametrize(
    ("lines", "reached"),
    [
        ("pass", []),
        ("Brake().press()", [1]),
        ("Brake().check()", [1]),  # by way of another method
        ("Brake()", []),
        ("Horn()", [3]),
        ("stop()", [4]),
        ("wait()", [4]),
        ("Timer(0.1, stop)", [4]),
        ("getattr(Brake(), 'release')()", [2]),
        ("START = {'brake': Brake}['brake']().release", [2]),
        ("globals()[input()]()", [3]),  # any class
    ],
)
def test_what_a_program_names_and_what_that_names(tmp_path: Path, lines: str, reached: list[int]) -> None:
    program = (
        f"from threading import Timer\n\nfrom car.parts import Brake, Horn, stop, wait\n\n\ndef main():\n    {lines}\n"
    )
    assert told(tmp_path, program) == reached


IDLE = "import car.parts\n\n\ndef main():\n    print(car.parts)\n"
NAMES_BOTH = "import car.parts\n\n\ndef main():\n    car.parts.Brake()\n"


def test_a_function_of_the_program_that_nothing_names(tmp_path: Path) -> None:
    assert told(tmp_path, f"{IDLE}\n\ndef unused():\n    car.parts.stop()\n") == []
    assert told(tmp_path, f"{IDLE}\n\nprint(car.parts.stop)\n") == [4]


@pytest.mark.parametrize(
    ("old", "new", "reached"),
    [
        ("class Brake:", "@registered\nclass Brake:", []),  # it is made, and no name leads to its methods
        ("    def press(self):", "    @on('press')\n    def press(self):", [1]),
        ("    def press(self):", "    @property\n    def press(self):", []),
        ("class Brake:", "from somewhere import Part\n\n\nclass Brake(Part):", [1, 2]),  # it may call any of them
        ("class Brake:", "class Part:\n    pass\n\n\nclass Brake(Part):", []),
        ("def stop():", "@atexit.register\ndef stop():", [4]),
    ],
)
def test_what_else_calls_a_method(tmp_path: Path, old: str, new: str, reached: list[int]) -> None:
    parts = "import atexit\nfrom somewhere import on, registered\n" + PARTS.replace(old, new, 1)
    assert told(tmp_path, NAMES_BOTH, parts) == reached


def test_other_programs_of_the_package(tmp_path: Path) -> None:
    by_hand = "from car.parts import wait\n\nif __name__ == '__main__':\n    wait()\n"
    assert told(tmp_path, IDLE, try_wait=by_hand) == [4]
    assert told(tmp_path, IDLE, test_parts="from car.parts import Horn\n\n\ndef test_it():\n    Horn()\n") == [3, 4]


def test_what_a_package_offers_is_for_others_to_call(tmp_path: Path) -> None:
    assert told(tmp_path, IDLE, setup=LIBRARY) == ALL


def test_what_is_not_reached_is_counted_and_shown_on_request(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert told(tmp_path, IDLE.replace("print(car.parts)", "print(missing_5, car.parts.stop)")) == [4, 5]
    monkeypatch.chdir(tmp_path)
    assert main(["check", "--no-cache"]) == 1
    said = "1 finding in a function or class that nothing calls is not shown; --all-files shows it."
    assert said in capsys.readouterr().err.splitlines()
    main(["check", "--no-cache", "--all-files", "--format", "json"])
    report = json.loads(capsys.readouterr().out)
    shown = [(row["file"], row["line"]) for row in report["diagnostics"]]
    assert shown == [("car/drive.py", 7), ("car/parts.py", 17), ("car/parts.py", 21)]
    assert report["summary"]["unreached"] == 0


def test_names_that_a_list_of_exports_has_call_nothing(tmp_path: Path) -> None:
    assert told(tmp_path, IDLE, f"__all__ = ['Brake', 'stop']\n{PARTS}") == []


@pytest.mark.parametrize(
    ("lines", "reached"),
    [
        ("if False:\n        stop()", []),
        ("if 0:\n        stop()\n    else:\n        Horn()", [3]),
        ("while False:\n        Brake().press()", []),
        ("if True:\n        Horn()\n    else:\n        stop()", [3]),
        ("if False:\n        print(missing_5)", []),
        ("if DEBUG:\n        stop()", [4]),
        ("while True:\n        stop()", [4]),
    ],
)
def test_what_a_literal_condition_switches_off_names_nothing(tmp_path: Path, lines: str, reached: list[int]) -> None:
    program = f"from car.parts import Brake, Horn, stop\n\nDEBUG = False\n\n\ndef main():\n    {lines}\n"
    assert told(tmp_path, program) == reached
