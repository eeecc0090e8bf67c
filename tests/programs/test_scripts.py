"""The executables of nodes: what a package installs, and not what its files are called."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.render.json import document

NODE = """
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class {name}(Node):
    def __init__(self):
        super().__init__('{name}'.lower())
        self.drive = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.drive.publish(Twist())


def main():
    rclpy.init()
    rclpy.spin({name}())


if __name__ == '__main__':
    main()
"""
MANIFEST = """<package format="3"><name>robot</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<export><build_type>ament_python</build_type></export></package>
"""
SETUP = """from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['cast = robot.automatic:main'%s]})
"""


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def write(more: str = "", **files: str) -> Path:
        texts = {"package.xml": MANIFEST, "setup.py": SETUP % more, "robot/__init__.py": "", **files}
        for name, text in texts.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path

    return write


def executables(folder: Path) -> dict[str, list[str]]:
    found = document(graph(Request((".",), load(folder), cached=False, jobs=1)))
    return {node["name"]: node["executables"] for node in found["nodes"]}


def test_a_script_that_is_not_installed_has_no_executable(workspace):
    files = {"robot/automatic.py": NODE.format(name="Automatic"), "robot/cast.py": NODE.format(name="Cast")}
    assert executables(workspace(**files)) == {"/automatic": ["cast"], "/cast": []}
    assert executables(workspace(", 'own = robot.cast:main'", **files)) == {"/automatic": ["cast"], "/cast": ["own"]}


def test_where_more_may_be_installed_than_is_known(workspace):
    files = {"robot/automatic.py": NODE.format(name="Automatic"), "robot/cast.py": NODE.format(name="Cast")}
    assert executables(workspace(", *load()", **files))["/cast"] == ["cast"]


def test_a_script_beside_no_package_is_called_after_its_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "talker.py").write_text(NODE.format(name="Talker"))
    assert executables(tmp_path) == {"/talker": ["talker"]}


def test_the_nodes_of_one_script_run_together(workspace):
    two = (
        NODE.format(name="One").partition("def main")[0]
        + "\n"
        + NODE.format(name="Two").replace("rclpy.spin(Two())", "one, two = One(), Two()\n    rclpy.spin(two)")
    )
    folder = workspace(**{"robot/automatic.py": "def main():\n    pass\n", "robot/pair.py": two})
    (folder / "archlint.toml").write_text('select = ["OWN001"]\nunused-files = true')
    [found] = check(Request((".",), load(folder), cached=False, jobs=1)).findings
    assert found.message == "/one and /two both publish the topic '/cmd_vel'"
