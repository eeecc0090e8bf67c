"""PKG013: modules of a Python package that are meant to be programs, and that no entry point makes one of."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import CMAKE, SETUP, TALKER

ENTRY = "'console_scripts': ['talker = robot.talker:main']"
NO_ENTRY = SETUP.replace("['talker = robot.talker:main']", "[]")
LISTENER = TALKER.replace("Talker", "Listener").replace("'talker'", "'listener'")
README = "# The robot\n\n    ros2 run robot listener\n"
QUIET = TALKER.replace("rclpy.spin(Talker())", "Talker().destroy_node()")


def files(**more: str) -> dict[str, str]:
    """A package with two nodes, of which one has an entry point, and a document that starts the other one."""
    assert ENTRY in SETUP
    return {"robot/__init__.py": "", "robot/listener.py": LISTENER, "README.md": README} | more


def test_a_module_that_a_document_says_to_start(findings):
    (told,) = findings("PKG013", **files())
    assert told.message == (
        "ros2 run does not find 'listener', though robot.listener has a main(): no entry point names it"
    )
    assert told.help == "add 'listener = robot.listener:main' to console_scripts"
    assert told.severity is Severity.ERROR
    assert (told.place.file, told.place.line) == ("setup.py", 6)
    assert [(row.place.file, row.place.line) for row in told.related] == [("README.md", 3), ("robot/listener.py", 11)]


def test_a_tool_that_a_document_says_to_start(findings):
    assert len(findings("PKG013", **files(**{"robot/listener.py": "def main():\n    print('a tool')\n"}))) == 1


def test_a_package_without_any_program(findings):
    (told,) = findings("PKG013", **files(**{"setup.py": NO_ENTRY, "README.md": ""}))
    assert told.severity is Severity.WARNING
    assert told.message.endswith("the package has no entry points; another module is no program, either")
    assert {row.place.file for row in told.related} == {"robot/listener.py", "setup.py"}


@pytest.mark.parametrize(
    "more",
    [
        {"setup.py": SETUP.replace("]}", ", 'listener = robot.listener:main']}")},
        {"setup.py": SETUP.replace("]}", ", 'listener = robot.listener:run']}")},  # PKG002
        {"setup.py": "from names import NAMES\n" + SETUP.replace("['talker = robot.talker:main']", "NAMES")},
        {"robot/listener.py": LISTENER.replace("def main", "def run")},
        {"README.md": "    ros2 run other listener\n    ros2 run robot talker\n    ros2 run robot speaker\n"},
        {"launch/it.launch.xml": "<launch><node pkg='robot' exec='listener'/></launch>"},  # LCH001
        {"package.xml": CMAKE},
    ],
)
def test_what_is_a_program_or_no_module_of_that_name(findings, more):
    assert findings("PKG013", **files(**more)) == []


@pytest.mark.parametrize(
    "more",
    [
        {"robot/listener.py": "def main():\n    print('a tool')\n"},
        {"robot/listener.py": QUIET},  # a single one may be there to try it out
        {"README.md": "    python3 robot/listener.py\n"},
        {"bin/start.sh": "python3 -m robot.talker\n"},
        {"launch/it.launch.xml": "<launch><node pkg='robot' exec='talker'/></launch>"},
        {"setup.py": SETUP},
    ],
)
def test_packages_whose_modules_are_started_otherwise(findings, more):
    assert findings("PKG013", **files(**{"setup.py": NO_ENTRY, "README.md": ""} | more)) == []
