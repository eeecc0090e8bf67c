"""NME004: what is started once, or gone by then, shares its name with nobody."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import write_robot

SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main']},
)
"""
TALKER = """\
import rclpy
from rclpy.node import Node

class Talker(Node):
    def __init__(self, rate=1.0):
        super().__init__('talker')
        self.create_timer(rate, self.tick)

    def tick(self):
        pass

def main():
    rclpy.init()
    {}
"""
LAUNCH = """\
import os
from launch import LaunchDescription
from launch.actions import GroupAction, OpaqueFunction, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace

def setup(context):
    talker = Node(package='robot', executable='talker', name='talker')
    other = Node(package='robot', executable='talker', name='talker')
    nodes = []
    {}
    return nodes

def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=setup)])
"""


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def run(lines: list[str] | None = None, main: list[str] | None = None) -> list[Finding]:
        texts = {
            "archlint.toml": 'select = ["NME004"]',
            "package.xml": "<package format='3'><name>robot</name><exec_depend>rclpy</exec_depend>"
            "<export><build_type>ament_python</build_type></export></package>",
            "setup.py": SETUP,
            "robot/talker.py": TALKER.replace("{}", "\n    ".join(main or ["rclpy.spin(Talker())"])),
            "launch/it.launch.py": LAUNCH.replace("{}", "\n    ".join(lines or ["nodes.append(talker)"])),
        }
        for name, text in texts.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


UNDECIDED = "if os.environ.get('LATE'):"
LATE = "    nodes.append(TimerAction(period=5.0, actions=[{}]))"


@pytest.mark.parametrize(
    "lines",
    [
        pytest.param([UNDECIDED, LATE.format("talker"), "else:", "    nodes.append(talker)"], id="bare or later"),
        pytest.param(
            [
                UNDECIDED,
                LATE.format("talker"),
                "else:",
                "    nodes.append(talker)",
                "    nodes.append(PushRosNamespace('x'))",
            ],
            id="and more in one arm",
        ),
        pytest.param(
            [
                UNDECIDED,
                "    nodes.append(GroupAction([PushRosNamespace('a'), talker]))",
                "else:",
                "    nodes.append(talker)",
                "    nodes.append(Node(package='robot', executable='talker', name='talker', namespace='b'))",
            ],
            id="in a namespace or not",
        ),
    ],
)
def test_one_action_in_both_arms_of_an_undecided_if_is_started_once(findings, lines):
    assert findings(lines) == []


GROUP = "GroupAction([PushRosNamespace(ns), {}])"
TIMER = "TimerAction(period=5.0, actions=[{}])"
EACH = "Node(package='robot', executable='talker', name='{}')"


@pytest.mark.parametrize(
    ("around", "told"),
    [
        (GROUP.format(TIMER), 1),  # the group ends before the timer fires
        (TIMER.format(GROUP), 0),
        (GROUP, 0),
    ],
)
def test_a_timer_in_a_group_starts_its_nodes_without_the_namespace(findings, around: str, told: int):
    both = f"{EACH.format('a')}, {EACH.format('b')}"
    found = findings([f"for ns in ('left', 'right'):\n        nodes.append({around.format(both)})"])
    assert len(found) == told
    for one in found:
        assert "starts a node with the name '/a': the namespace of the group around it is gone" in one.message
        assert one.message.endswith("; another node is started in the same way")
        assert one.help.startswith("put the timer or event handler around the group")


def test_several_pairs_of_one_launch_file_are_one_finding(findings):
    pair = (
        "Node(package='robot', executable='talker', name='{0}'), Node(package='robot', executable='talker', name='{0}')"
    )
    (found,) = findings([f"nodes += [{pair.format('a')}, {pair.format('b')}]"])
    assert found.message.endswith("; another node is started in the same way")


@pytest.mark.parametrize(
    ("lines", "at", "related"),
    [
        (["nodes += [talker, other]"], 9, [8]),
        ([UNDECIDED, LATE.format("talker"), "else:", "    nodes.append(talker)", "nodes.append(other)"], 9, [8]),
        ([UNDECIDED, LATE.format("talker, other"), "else:", "    nodes.append(talker)"], 9, [8]),
        (["for _ in range(2):", "    nodes.append(Node(package='robot', executable='talker'))"], 12, [6]),  # its name
    ],
)
def test_two_actions_of_one_name_are_told(findings, lines, at, related):
    (found,) = findings(lines)
    assert (found.place.line, [one.place.line for one in found.related]) == (at, related)


def test_all_nodes_of_one_name_are_told(findings):
    third = "Node(package='robot', executable='talker', name='talker')"
    (found,) = findings([f"nodes += [talker, other, {third}]"])
    assert found.message.startswith("three nodes of this system have the name '/talker'")
    assert [(one.place.line, one.message) for one in found.related][1:] == [(11, "another one is started here")]


READER = ["reader = Node('reader')", "rate = reader.declare_parameter('rate', 1.0).value"]


@pytest.mark.parametrize(
    ("main", "told"),
    [
        pytest.param([*READER, "reader.destroy_node()", "rclpy.spin(Talker(rate))"], False, id="destroyed"),
        pytest.param([*READER, "rclpy.spin(Talker(rate))", "reader.destroy_node()"], True, id="destroyed later"),
        pytest.param(
            [*READER, "if rate > 2:", "    reader.destroy_node()", "rclpy.spin(Talker(rate))"], True, id="perhaps"
        ),
        pytest.param(
            ["old = Talker()", "rclpy.spin_once(old)", "old.destroy_node()", "rclpy.spin(Node('talker'))"],
            False,
            id="with callbacks",
        ),
        pytest.param(
            [*READER, "if rate > 2:", "    reader.destroy_node()", "    rclpy.spin(Talker(rate))"],
            False,
            id="in the same branch",
        ),
        pytest.param(
            [
                "old = Talker()",
                "if old.get_name() == 'a':",
                "    try:",
                "        old.destroy_node()",
                "    except Exception as error:",
                "        print(error)",
                "    for _ in range(3):",
                "        rclpy.spin_once(Node('talker'))",
            ],
            False,
            id="in the same branch, tried",
        ),
    ],
)
def test_a_node_that_is_destroyed_before_the_next_is_made_is_gone(findings, main, told):
    assert bool(findings(None, main)) is told


@pytest.mark.parametrize(
    ("main", "told"),
    [
        pytest.param(["node = Talker()", "rclpy.spin(node)\n\n\nmain()"], False, id="the import runs main, too"),
        pytest.param(["old = Talker()", "rclpy.spin_once(old)", "rclpy.spin(Node('talker'))"], True, id="a moment"),
        pytest.param(
            [
                "from threading import Thread",
                "old = Talker()",
                "Thread(target=rclpy.spin, args=(old,)).start()",
                "new = Node('talker')",
                "rclpy.spin(new)",
            ],
            True,
            id="in a thread",
        ),
    ],
)
def test_an_import_that_spins_leaves_no_node(findings, main, told):
    assert bool(findings(None, main)) is told


@pytest.mark.parametrize(("called", "told"), [("robot.again()", True), ("plugins.run(robot)", False)])
def test_a_node_of_a_method_that_perhaps_nothing_calls(findings, called, told):
    lines = ["import plugins", "class Robot:", "    def __init__(self):", "        self.node = Node('talker')"]
    lines += ["    def again(self):", "        self.other = Node('talker')", "robot = Robot()", called]
    assert bool(findings(None, [*lines, "rclpy.spin(robot.node)"])) is told


def test_a_callback_makes_its_node_before_main_destroys_the_first(findings):
    """``destroy_node()`` stands above nothing that runs later: the callback runs while main spins."""
    two = ["class Two(Talker):", "    def tick(self):", "        self.helper = Node('helper')"]
    (found,) = findings(None, [*two, "node = Two()", "rclpy.spin(node)", "node.destroy_node()"])
    assert len(found.related) == 2


@pytest.mark.parametrize(("decorator", "argument"), [("@classmethod", "cls"), ("@staticmethod", "")])
def test_a_class_method_that_main_has_run_makes_no_second_node(findings, decorator, argument):
    runner = ["class Runner(Talker):", f"    {decorator}", f"    def main({argument}):"]
    body = ["        node = Runner()", "        rclpy.spin(node)"]
    assert findings(None, [*runner, *body, "Runner.main()"]) == []
    more = ["Runner.main()", "other = Runner()", "rclpy.spin(other)"]
    assert len(findings(None, [*runner, "        global node", *body, *more])) == 1


INNER = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def setup(context):
    {reads}
    return [Node(package='robot', executable='talker', name='talker')]

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='a'),
        TimerAction(period=0.0, actions=[OpaqueFunction(function=setup)]),
    ])
"""
OUTER = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource

def inner(robot):
    path = os.path.join(get_package_share_directory('robot'), 'launch', 'inner.launch.py')
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments={'robot': robot}.items())

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('{declared}', default_value='x'),
        GroupAction([inner('b')]),
        GroupAction([inner('c')]),
    ])
"""


@pytest.mark.parametrize(
    ("reads", "declared", "told"),
    [
        ("LaunchConfiguration('robot').perform(context)", "other", 0),  # launch stops here: the argument is gone
        ("LaunchConfiguration('robot').perform(context)", "robot", 1),  # the one around the groups is still there
        ("pass", "other", 1),
    ],
)
def test_a_timer_in_a_group_starts_nothing_with_an_argument_that_is_gone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reads: str, declared: str, told: int
):
    monkeypatch.chdir(tmp_path)
    launch = {
        "launch/inner.launch.py": INNER.format(reads=reads),
        "launch/outer.launch.py": OUTER.replace("{declared}", declared),
        "archlint.toml": 'select = ["NME004"]',
    }
    write_robot(tmp_path, **launch)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


def test_a_coroutine_that_the_import_runs_and_the_script_only_makes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    talker = TALKER.replace("{}", "Talker()").replace("def main", "async def main")
    files = {
        "robot/talker.py": f"import asyncio\n{talker}\nasyncio.run(main())\n",
        "archlint.toml": 'select = ["NME004"]',
    }
    write_robot(tmp_path, '<node pkg="robot" exec="talker"/>', **files)
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert report.findings == []
