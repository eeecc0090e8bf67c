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
from archlint.programs.ahead import independent_groups, shares
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
from archlint.programs.linker import Linker
from archlint.programs.sweep import Sweep


def telling(function, word):
    def tell(self, *arguments):
        with open(os.environ['TOLD'], 'a') as file:  # the other processes have no stderr
            file.write(f"{'run' if os.getpid() == here else 'process'}: {word}\\n")
        return function(self, *arguments)
    return tell


here = os.getpid()
Linker._run_entry = telling(Linker._run_entry, 'an executable')
Sweep._run_class = telling(Sweep._run_class, 'a class')
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
    output, told = run_telling(folder, *arguments, way=way)
    return output, told.count("taken")


def run_telling(folder: Path, *arguments: str, way: str = "") -> tuple[str, str]:
    """What a command prints, less the time, and what it tells of programs that it takes or follows itself."""
    told = folder.parent / f"{folder.name} told"
    told.write_text("", "utf-8")
    environment = {**os.environ, "PYTHONPATH": str(Path(archlint.__file__).parents[1]), "TOLD": str(told)}
    command = [sys.executable, "-c", dedent(RUN), way, *arguments, ".", "--format", "json", "--isolated"]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    return re.sub(r'"elapsed_s": [\d.e-]+', "", done.stdout), done.stderr + told.read_text("utf-8")


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


@pytest.fixture
def one_robot(tmp_path: Path) -> Path:
    """One package in which all modules import one: four executables, and twelve node classes that nothing starts."""
    robot = tmp_path / "robot"
    (robot / "robot").mkdir(parents=True)
    (robot / "resource").mkdir()
    (robot / "resource" / "robot").touch()
    (robot / "package.xml").write_text(MANIFEST.format(name="robot"), "utf-8")
    starts = [f"'{name} = robot.{name}:main'" for name in ("arm", "base", "camera", "door")]
    setup = f"setup(name='robot', packages=['robot'], entry_points={{'console_scripts': [{', '.join(starts)}]}})\n"
    (robot / "setup.py").write_text("from setuptools import setup\n\n" + setup, "utf-8")
    (robot / "robot" / "__init__.py").touch()
    (robot / "robot" / "names.py").write_text("PREFIX = '/robot'\n", "utf-8")
    for name in ("arm", "base", "camera", "door"):
        text = NODE.format(name=name).replace("'/shared'", "PREFIX + '/shared'")
        (robot / "robot" / f"{name}.py").write_text("from robot.names import PREFIX\n" + text, "utf-8")
    spare = [NODE.format(name=f"spare{number}").partition("def main")[0] for number in range(12)]
    renamed = [text.replace("Talker", f"Spare{number}") for number, text in enumerate(spare)]
    big = "# " + "x" * 250_000 + "\n"
    (robot / "robot" / "spare.py").write_text("from robot.names import PREFIX\n" + "".join(renamed) + big, "utf-8")
    return tmp_path


@pytest.mark.parametrize("command", ["check", "graph"])
def test_what_is_started_from_one_package_is_divided_among_processes(one_robot, command):
    alone, told = run_telling(one_robot, command, "--jobs", "1", "--no-cache")
    assert told.count("run: an executable") == 4
    assert told.count("run: a class") == 12
    together, told = run_telling(one_robot, command, "--jobs", "2", "--no-cache")
    assert "run: an executable" not in told
    assert "run: a class" not in told
    assert together == alone


def test_what_a_process_has_divided_is_kept(one_robot, tmp_path_factory):
    cache = ["--cache-dir", str(tmp_path_factory.mktemp("cache"))]
    cold, _ = run_telling(one_robot, "graph", "--jobs", "2", *cache)
    node = one_robot / "robot" / "robot" / "door.py"
    node.write_text(node.read_text("utf-8").replace("'door'", "'gate'"), "utf-8")
    edited, told = run_telling(one_robot, "graph", "--jobs", "2", *cache)
    assert told.count("run: an executable") <= 1
    assert edited != cold
    assert edited == run_telling(one_robot, "graph", "--jobs", "1", "--no-cache")[0]


@pytest.mark.parametrize("command", ["check", "graph"])
def test_what_launch_files_share_is_followed_once(one_robot, command):
    for number in range(10):
        folder = one_robot / "robot" / f"launch{number}"
        folder.mkdir()
        text = LAUNCH.replace("_launched", str(number // 2 % 2)).format(name="robot")
        text = text.replace("'node'", "'arm'" if number % 2 else "'base'")
        (folder / "arm.launch.py").write_text(text, "utf-8")
    alone, told = run_telling(one_robot, command, "--jobs", "1", "--no-cache")
    launched = told.count("run: an executable") - 4
    assert launched <= 4  # two topics that ten launch files give to two executables
    together, told = run_telling(one_robot, command, "--jobs", "2", "--no-cache")
    assert "run: an executable" not in told
    assert told.count("process: an executable") == 4 + launched
    assert together == alone


HELPED = """\
import rclpy
import registry
from rclpy.node import Node
from std_msgs.msg import String


class Names:
    def __init__(self, node: Node):
        self.node = node

    def topic(self):
        return self.node.declare_parameter('topic', '{name}').value


class Talker(Node):
    def __init__(self):
        super().__init__('{name}')
        self.publisher = self.create_publisher(String, Names(self).topic(), 10)


def main():
    rclpy.init()
    talker = Talker()
    Names(registry.node()).topic()
    rclpy.spin(talker)
"""


def test_a_program_is_launched_as_it_is_once_all_have_run(workspace):
    """What the helper declares on a node that is not known, too, is no other node that a launch file gives a topic."""
    for name in ("arm", "base", "camera", "door"):
        text = HELPED.format(name=name) + "# " + "x" * 60_000 + "\n"
        (workspace / name / name / "node.py").write_text(text, "utf-8")
    alone, told = run_telling(workspace, "graph", "--jobs", "1", "--no-cache")
    assert told.count("run: an executable") == 8  # alone, and with its topic
    together, told = run_telling(workspace, "graph", "--jobs", "2", "--no-cache")
    assert "run: an executable" not in told
    assert told.count("process: an executable") == 8
    assert together == alone


def test_shares_are_neighbours_of_about_the_same_length():
    assert shares("abcde", 2) == [range(2), range(2, 5)]
    assert shares("ab", 4) == [range(1), range(1, 2)]
    assert shares("", 4) == []


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
