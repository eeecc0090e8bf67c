"""API003: programs that make a node and never call rclpy.init()."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding

SETUP = """
from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['talker = robot.talker:main']})
"""
TALKER = """
import rclpy
{imported}
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')


def main():
    {made}
"""


@pytest.fixture
def said(findings: Callable[..., list[Finding]]) -> Callable[..., list[Finding]]:
    def run(made: str, imported: str = "", **files: str) -> list[Finding]:
        talker = TALKER.format(made=made, imported=imported)
        own = {"setup.py": SETUP, "robot/__init__.py": "", "robot/talker.py": talker}
        return findings("API003", **(own | files))

    return run


@pytest.mark.parametrize(
    ("made", "name"),
    [
        ("rclpy.spin(Talker())", "Talker"),
        ("rclpy.spin(rclpy.create_node('talker'))", "create_node"),
    ],
)
def test_a_program_that_never_initialises(said: Callable[..., list[Finding]], made: str, name: str) -> None:
    (finding,) = said(made, "from mavros import mavlink\nfrom std_msgs.msg import String")
    assert finding.message == f"{name}() fails: the program never calls rclpy.init()"
    assert (finding.place.file, finding.place.line) == ("robot/talker.py", 14)


@pytest.mark.parametrize(
    ("made", "imported"),
    [
        ("rclpy.init()\n    rclpy.spin(Talker())", ""),
        ("with rclpy.init():\n        rclpy.spin(Talker())", ""),
        ("init()\n    rclpy.spin(Talker())", "from rclpy import init"),
        ("rclpy.spin(Talker())", "import some_framework"),
        ("start()\n    rclpy.spin(Talker())", "from robot.start import start"),
    ],
)
def test_programs_that_do_or_may(said: Callable[..., list[Finding]], made: str, imported: str) -> None:
    start = "import rclpy\n\n\ndef start():\n    rclpy.init()\n"
    assert said(made, imported, **{"robot/start.py": start}) == []


PART = """
import rclpy


def start():
    pass


def main():
    rclpy.init()


{more}
"""


@pytest.mark.parametrize(
    ("more", "imported", "made", "told"),
    [
        ("if __name__ == '__main__':\n    main()", "from robot.start import start", "", 1),
        ("", "from robot.start import start", "", 1),
        ("main()", "from robot.start import start", "", 0),
        ("", "from robot.start import main as prepare", "prepare()", 0),
        ("", "from robot import start", "start.main()", 0),
        ("def begin():\n    rclpy.init()", "from robot.start import start", "", 0),
        ("def begin():\n    main()", "from robot.start import start", "", 0),
    ],
)
def test_the_program_of_another_module_initialises_for_itself(
    said: Callable[..., list[Finding]], more: str, imported: str, made: str, told: int
) -> None:
    start = PART.format(more=more)
    assert len(said(f"{made}\n    rclpy.spin(Talker())", imported, **{"robot/start.py": start})) == told


def test_a_module_without_a_program(findings: Callable[..., list[Finding]]) -> None:
    talker = TALKER.format(made="rclpy.spin(Talker())", imported="")
    assert (
        findings("API003", **{"setup.py": "from setuptools import setup\nsetup()\n", "robot/talker.py": talker}) == []
    )


TRY_OUT = "\n\nif __name__ == '__main__':\n    main()\n"
STARTS_IT = """
import rclpy
from robot import talker


def main():
    rclpy.init()
    talker.main()
"""


@pytest.mark.parametrize(
    ("program", "importer", "number"),
    [
        ("start", "robot/start.py", 0),  # start.py initialises rclpy and then calls talker.main()
        ("talker", "robot/start.py", 1),  # ros2 run starts talker.py itself
        ("other", "test/test_talker.py", 1),  # who starts it by hand is all there is
    ],
)
def test_a_module_whose_importer_initialises(
    said: Callable[..., list[Finding]], program: str, importer: str, number: int
) -> None:
    talker = TALKER.format(made="rclpy.spin(Talker())", imported="") + TRY_OUT
    setup = SETUP.replace("robot.talker:main", f"robot.{program}:main")
    files = {"setup.py": setup, "robot/talker.py": talker, importer: STARTS_IT, "robot/other.py": "def main(): ...\n"}
    assert [row.place.file for row in said("", **files)] == ["robot/talker.py"] * number
