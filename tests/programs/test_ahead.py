"""Programs are followed in several processes, and the same comes of it."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from textwrap import dedent

import pytest

import archlint
from archlint.interpreter.modules import ModuleIndex
from archlint.programs.ahead import independent_groups
from archlint.syntax.python.lowering import lower
from archlint.workspace.model import SourceFile

MANIFEST = """\
<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">m</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend><export><build_type>ament_python</build_type></export></package>
"""
SETUP = """\
from setuptools import setup

setup(name='{name}', packages=['{name}'], data_files=[('share/{name}/launch', ['launch/{name}.launch.py'])],
      entry_points={{'console_scripts': ['node = {name}.node:main']}})
"""
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('{name}')
        topic = self.declare_parameter('topic', '{name}').value
        self.publisher = self.create_publisher(String, topic, 10)
        self.create_subscription(String, '/shared', self.publisher.publish, 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='{name}', executable='node', parameters=[{{'topic': '{name}_launched'}}])])
"""
RUN = """\
import os, signal, sys
from archlint.cli import main
from archlint.programs.kept import KeptPrograms

taken = KeptPrograms.add
KeptPrograms.add = lambda self, payload: (sys.stderr.write('taken\\n'), taken(self, payload))[1]
if sys.argv[1] == 'kill':
    KeptPrograms.take_new = lambda self: os.kill(os.getpid(), signal.SIGKILL)
main(sys.argv[2:])
"""
pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="only POSIX can fork")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Four packages that have nothing to do with one another, with so much source that two processes pay."""
    for name in ("arm", "base", "camera", "door"):
        files = {
            f"{name}/package.xml": MANIFEST,
            f"{name}/setup.py": SETUP,
            f"{name}/resource/{name}": "",
            f"{name}/{name}/__init__.py": "",
            f"{name}/{name}/node.py": NODE + "# " + "x" * 60_000 + "\n",
            f"{name}/launch/{name}.launch.py": LAUNCH,
        }
        for path, text in files.items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(text.format(name=name), "utf-8")
    return tmp_path


def run(folder: Path, *arguments: str, way: str = "") -> tuple[str, int]:
    """What a command prints, less the time, and how often programs of another process were taken."""
    environment = {**os.environ, "PYTHONPATH": str(Path(archlint.__file__).parents[1])}
    command = [sys.executable, "-c", dedent(RUN), way, *arguments, ".", "--format", "json", "--isolated"]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    return re.sub(r'"elapsed_s": [\d.e-]+', "", done.stdout), done.stderr.count("taken")


@pytest.mark.parametrize("command", ["check", "graph"])
def test_two_processes_print_what_one_prints(workspace, command):
    alone, taken = run(workspace, command, "--jobs", "1", "--no-cache")
    assert taken == 0
    together, taken = run(workspace, command, "--jobs", "2", "--no-cache")
    assert taken >= 4
    assert together == alone


def test_what_processes_have_followed_is_launched(workspace):
    launch = "--launch", "arm/launch/arm.launch.py"
    output, taken = run(workspace, "graph", "--jobs", "2", "--no-cache", *launch)
    assert taken >= 4
    assert '"/arm_launched"' in output


def test_a_process_that_dies_leaves_its_part_to_the_run(workspace):
    alone, _ = run(workspace, "check", "--jobs", "1", "--no-cache")
    assert run(workspace, "check", "--jobs", "2", "--no-cache", way="kill") == (alone, 0)


def test_what_processes_have_followed_is_kept(workspace, tmp_path_factory):
    cache = ["--cache-dir", str(tmp_path_factory.mktemp("cache"))]
    cold, taken = run(workspace, "graph", "--jobs", "2", *cache)
    assert taken >= 4
    assert run(workspace, "graph", "--jobs", "2", *cache) == (cold, 0)


def test_modules_that_import_the_same_belong_together():
    texts = {
        "a/a/node.py": "from a import names\n",
        "a/a/other.py": "def later():\n    import a.names\n",
        "a/a/names.py": "X = 1\n",
        "b/b/node.py": "import rclpy\n",
    }
    names = {path: path.partition("/")[2].removesuffix(".py").replace("/", ".") for path in texts}
    files = [SourceFile(f"/ws/{path}", path, "python", path[0], name) for path, name in names.items()]
    index = ModuleIndex(files, lambda file: lower(texts[file.relative]))
    modules = [index.module(file) for file in files if file.module != "a.names"]
    groups = independent_groups([module for module in modules if module is not None], index)
    assert sorted(sorted(module.path for module in group) for group in groups) == [
        ["a/a/node.py", "a/a/other.py"],
        ["b/b/node.py"],
    ]
