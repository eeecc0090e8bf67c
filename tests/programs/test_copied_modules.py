"""Modules that the build copies under the package's name: they are imported by that name, and by where they lie."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check, graph
from robot_package import manifest, write_files

MISSION = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
{imports}


class Mission(Node):
    def __init__(self):
        super().__init__('mission')
        self.rate = self.create_rate(20.0)
        self.sender = {sender}(self, 'setpoint')
        self.create_subscription(String, 'start', print, 10)

    def run(self):
        while rclpy.ok():
            self.rate.sleep()


def main():
    rclpy.init()
    Mission().run()


if __name__ == '__main__':
    main()
"""
HELPER = """\
from std_msgs.msg import String


class Sender:
    def __init__(self, node, topic):
        self.publisher = node.create_publisher(String, topic, 10)
"""
COPIES = "install(DIRECTORY scripts/ DESTINATION ${PYTHON_INSTALL_DIR}/${PROJECT_NAME})\n"
STARTS = "install(PROGRAMS scripts/mission.py DESTINATION lib/${PROJECT_NAME} RENAME mission)\n"
SETUP = """\
from setuptools import setup

setup(
    name='robot',
    packages=['robot'],
    package_dir={'robot': 'scripts'},
    entry_points={'console_scripts': ['mission = robot.mission:main']},
)
"""


def topics(**options: bool) -> list[str]:
    """The topics of the node ``mission``."""
    [node] = graph(Request((".",), Settings(), jobs=1, **options)).nodes
    assert node.name == "/mission"
    return sorted(endpoint.written for endpoint in node.endpoints if endpoint.written is not None)


def write(folder: Path, cmake: str, imports: str = "from robot.helper import Sender", sender: str = "Sender") -> None:
    mission = MISSION.format(imports=imports, sender=sender)
    texts = {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": "project(robot)\n" + cmake}
    write_files(folder, texts | {"scripts/mission.py": mission, "scripts/helper.py": HELPER})


@pytest.mark.parametrize(
    ("imports", "sender"),
    [
        ("from robot.helper import Sender", "Sender"),
        ("from robot import helper", "helper.Sender"),
        ("import robot.helper", "robot.helper.Sender"),
        ("from helper import Sender", "Sender"),
    ],
)
def test_a_folder_that_cmake_copies_is_imported_by_either_name(tmp_path, monkeypatch, imports, sender):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, COPIES + STARTS, imports, sender)
    assert topics(cached=False) == ["setpoint", "start"]
    found = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [finding.code for finding in found] == ["EXE009"]  # what the node is passed to does not spin it


def test_the_installed_name_means_nothing_where_the_folder_is_not_copied(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, STARTS)
    assert check(Request((".",), Settings(), cached=False, jobs=1)).findings == []  # it may spin the node


def test_the_package_dir_of_a_setup_py(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, "")
    write_files(tmp_path, {"package.xml": manifest(), "setup.py": SETUP})
    assert topics(cached=False) == ["setpoint", "start"]


def test_programs_that_are_kept_are_followed_again_once_cmake_copies_the_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, STARTS)
    settings = Settings(cache_dir=str(tmp_path / "cache"))
    graph(Request((".",), settings, jobs=1))
    write(tmp_path, STARTS + COPIES)
    [node] = graph(Request((".",), settings, jobs=1)).nodes
    assert len(node.endpoints) == 2
