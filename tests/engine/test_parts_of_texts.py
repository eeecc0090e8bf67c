"""Rules ask for what they need of the text of a node's file: a comment at its end is no reason to judge again."""

from __future__ import annotations

import re
import textwrap
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

import pytest

from archlint.cli import main

FILES = {
    "robot/package.xml": """\
        <package format="3"><name>robot</name><version>1.0.0</version><description>d</description>
        <maintainer email="a@b.org">m</maintainer><license>MIT</license>
        <buildtool_depend>ament_cmake</buildtool_depend><depend>ros_of_ours</depend>
        <exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend>
        <export><build_type>ament_cmake</build_type></export></package>
        """,
    "robot/CMakeLists.txt": """\
        cmake_minimum_required(VERSION 3.8)
        project(robot)
        find_package(ament_cmake REQUIRED)
        install(PROGRAMS scripts/exercise.py scripts/reader.py DESTINATION lib/${PROJECT_NAME})
        install(DIRECTORY config DESTINATION share/${PROJECT_NAME})
        ament_package()
        """,
    "robot/config/speeds.yaml": "reader:\n  ros__parameter:\n    speed: 1.0\n",
    # No first line for the kernel, a name that is to be defined, a module that is imported for nothing.
    "robot/scripts/exercise.py": """\
        import numpy  # for later
        import requests
        import rclpy
        from rclpy.node import Node


        class Exercise(Node):
            def __init__(self) -> None:
                super().__init__('exercise')
                # TODO: compute speed


                self.create_timer(speed, self.tick)

            def tick(self, kind: 'str' = '') -> None:
                pass


        if __name__ == '__main__':
            rclpy.init()
            rclpy.spin(Exercise())
        """,
    "robot/scripts/reader.py": """\
        #!/usr/bin/env python3
        import rclpy
        import yaml
        from rclpy.node import Node
        from std_msgs.msg import String


        class Reader(Node):
            def __init__(self, file: str) -> None:
                super().__init__('reader')
                self.told = self.create_publisher(String, 'told', 10)
                self.config = yaml.safe_load(open(file))
                self.tell_all()


        if __name__ == '__main__':
            rclpy.init()
            rclpy.spin(Reader('config/speeds.yaml'))
        """,
}
CODE = sorted(name for name in FILES if name.endswith(".py"))


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in FILES.items():
        file = tmp_path / "ws" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(textwrap.dedent(text))
    monkeypatch.chdir(tmp_path / "ws")
    return tmp_path


def checked(*cache: str) -> str:
    with redirect_stdout(StringIO()) as output:
        main(["check", ".", "--exit-zero", "--isolated", "--format", "json", "--jobs", "1", *cache])
    return re.sub(r'"elapsed_s": [\d.e-]+', "", output.getvalue())


def codes(printed: str) -> set[str]:
    return set(re.findall(r'"code": "(\w+)"', printed))


@pytest.mark.parametrize("name", CODE)
def test_a_comment_below_all_that_is_asked_for_changes_nothing(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    cache = "--cache-dir", str(workspace / "cache")
    before = checked(*cache)
    assert codes(before) == {"API002", "PKG006", "PKG008"}
    with (workspace / "ws" / name).open("a") as stream:
        stream.write("# nobody looks for this\n")
    with monkeypatch.context() as patch:
        patch.setattr("archlint.engine.findings.judged_in_parts", None)
        assert checked(*cache) == before
    assert checked("--no-cache") == before


def test_a_comment_that_is_asked_for_counts(workspace: Path) -> None:
    """With three of them that ask for code the script is an exercise, which nobody starts."""
    cache = "--cache-dir", str(workspace / "cache")
    assert "PKG006" in codes(checked(*cache))
    with (workspace / "ws/robot/scripts/exercise.py").open("a") as stream:
        stream.write("# TODO: stop\n# TODO: tell what was done\n")
    after = checked(*cache)
    assert "PKG006" not in codes(after)
    assert after == checked("--no-cache")
