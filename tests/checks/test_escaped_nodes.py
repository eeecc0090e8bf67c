"""What is said of a node that lacks something, and not said of one that code which is not here has got hold of."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.render.json import document
from checks.judging import Judge

FILES = {
    "package.xml": """<package format="3"><name>robot</name>
<exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend><exec_depend>std_srvs</exec_depend>
<exec_depend>example_interfaces</exec_depend><exec_depend>dashboard</exec_depend>
<export><build_type>ament_python</build_type></export></package>
""",
    "setup.py": """from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main', 'other = robot.other:main']},
)
""",
    "robot/other.py": """import rclpy
from rclpy.node import Node
from std_msgs.msg import Int8

class Other(Node):
    def __init__(self):
        super().__init__('other')
        self.create_publisher(Int8, 'alone', 10)

def main():
    rclpy.init()
    rclpy.spin(Other())
""",
    "launch/it.launch.xml": """<launch>
<node pkg="robot" exec="talker">
  <remap from="word" to="words"/>
  <remap from="said" to="spoken"/>
  <param name="rat" value="1.0"/>
</node>
<node pkg="robot" exec="other"><param from="$(find-pkg-share robot)/config/it.yaml"/></node>
<node pkg="robot" exec="talker" name="second"><param from="$(find-pkg-share robot)/config/it.yaml"/></node>
</launch>
""",
    "config/it.yaml": "far_away:\n  ros__parameters:\n    rate: 1.0\n",
}
TALKER = """import dashboard
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)
        self.period = self.get_parameter('period').value
        self.create_publisher(String, 'said', 10)
        self.create_subscription(String, 'heard', self.on_heard, 10)
        self.create_client(Trigger, 'ask')
        ActionClient(self, Fibonacci, 'count')
        {body}

    def on_heard(self, message):
        pass

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
OF_ABSENCE = ("LCH002", "PRM003", "PRM004", "PRM005", "PRM006", "TOP002", "TOP003", "SRV001", "ACT001", "GRF001")


def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str, *codes: str) -> set[str]:
    monkeypatch.chdir(tmp_path)
    config = f"select = {list(codes)}\nclosed-world = true\n"
    for name, text in {**FILES, "archlint.toml": config, "robot/talker.py": TALKER.format(body=body)}.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return {one.code for one in check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings}


@pytest.mark.parametrize("body", ["pass", "self.nodes = [self]", "self.create_timer(1.0, lambda: self.on_heard(None))"])
def test_a_node_that_stays_in_sight(tmp_path, monkeypatch, body):
    assert told(tmp_path, monkeypatch, body, *OF_ABSENCE) == set(OF_ABSENCE)


@pytest.mark.parametrize(
    "body", ["dashboard.supervisor = self", "dashboard.nodes['talker'] = self", "dashboard.show(nodes=[self])"]
)
def test_a_node_that_escapes(tmp_path, monkeypatch, body):
    assert told(tmp_path, monkeypatch, body, *OF_ABSENCE) == set()


# ------------------------------------------------------------------------------------- what was not understood


def launched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, inner: str, talker: str) -> tuple[list[str], bool]:
    """What LCH002 and PRM004 say of a launched node, and whether the graph calls it complete."""
    monkeypatch.chdir(tmp_path)
    launch = f"<launch><node pkg='robot' exec='talker'>{inner}</node></launch>"
    config = "select = ['LCH002', 'PRM004']\n"
    for name, text in {
        **FILES,
        "archlint.toml": config,
        "robot/talker.py": talker,
        "launch/it.launch.xml": launch,
    }.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    request = Request((".",), load(tmp_path), cached=False, jobs=1, launch="launch/it.launch.xml")
    [node] = document(graph(request))["nodes"]
    return [one.code for one in check(request).findings], node["complete"]


def remaps(count: int) -> str:
    return "".join(f"<remap from='from{number}' to='to{number}'/>" for number in range(count))


def values(count: int) -> str:
    return "".join(f"<param name='p{number}' value='1'/>" for number in range(count))


EMPTY = """import rclpy
from rclpy.node import Node

class Talker(Node):
    def __init__(self):
        super().__init__('talker')

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
FULL = EMPTY.replace("('talker')", "('talker')\n        self.create_client(Trigger, 'ask')\n").replace(
    "import rclpy\n", "import rclpy\nfrom std_srvs.srv import Trigger\n", 1
)


@pytest.mark.parametrize(
    ("inner", "talker"),
    [(remaps(20), EMPTY), (remaps(2) + values(1), EMPTY), (values(3), EMPTY), (remaps(4) + values(1), FULL)],
    ids=["twenty remappings", "two", "parameters", "none of its own meets"],
)
def test_many_names_that_a_node_lacks_are_a_node_that_was_not_understood(tmp_path, monkeypatch, inner, talker):
    assert launched(tmp_path, monkeypatch, inner, talker) == ([], False)


@pytest.mark.parametrize(
    ("inner", "talker", "codes"),
    [
        (remaps(1) + values(2), EMPTY, ["LCH002", "PRM004"]),
        (remaps(3) + values(3), FULL, ["LCH002", "PRM004"]),
        (remaps(6) + "<remap from='ask' to='please'/>", FULL, ["LCH002"]),
    ],
    ids=["few of a node without any", "few of a node with others", "one meets"],
)
def test_few_are_mistakes(tmp_path, monkeypatch, inner, talker, codes):
    assert launched(tmp_path, monkeypatch, inner, talker) == (codes, True)


BACKEND = """
    import rclpy
    from somewhere import start
    from std_msgs.msg import String


    class Backend:
        def __init__(self):
            self.running = True
            self.mode = 'idle'
            self.words = 'status'

        def run(self):
            rclpy.init()
            node = rclpy.create_node('backend'){mark}
            node.create_subscription(String, self.words, print, 10)
            while self.running and rclpy.ok():
                rclpy.spin_once(node, timeout_sec=0.05)

        def stop(self):
            self.running = False


    def main():
        ros = Backend()
        {before}
        start(ros.run)
        {after}


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(("before", "after"), [("pass", "ros.stop()"), ("pass", "pass"), ("ros.stop()", "pass")])
def test_a_method_that_escaped_runs_at_any_time(judge: Judge, before: str, after: str):
    judge("EXE008", BACKEND.format(before=before, after=after, mark=""))


def test_what_no_method_changes_is_what_it_is(judge: Judge):
    source = BACKEND.replace("self.running = False", "pass").replace("self.running = True", "self.running = False")
    judge("EXE008", source.format(before="pass", after="ros.stop()", mark="  # here"))


IDLE = """
    import time
    from std_msgs.msg import String
    from rclpy.node import Node


    class Door(Node):
        def __init__(self):
            super().__init__('door')
            self.open = False
            self.create_subscription(String, 'words', self.on_word, 10)
            hand_out(self.on_push)

        def on_word(self, word):
            pass

        def on_push(self):
            if self.open:
                self.create_subscription(String, 'late', self.on_push, 10)  # here

        def unlock(self):
            {change}
"""


@pytest.mark.parametrize("change", ["self.open = True", "self.open, self.closed = True, False", "self.open |= True"])
def test_code_behind_an_attribute_that_a_method_changes_is_live(judge: Judge, change: str):
    judge("EXE006", IDLE.format(change=change))


def test_code_behind_an_attribute_that_never_changes_is_dead(judge: Judge):
    judge("EXE006", IDLE.format(change="self.open = False").replace("  # here", ""))


NAVIGATOR = """
    import time
    import rclpy
    {imports}
    from nav_msgs.msg import OccupancyGrid


    class Navigator({base}):
        def __init__(self):
            super().__init__('navigator')
            self.create_subscription(OccupancyGrid, 'costmap', self.keep, 10)

        def keep(self, grid):
            self.grid = grid


    def main():
        rclpy.init()
        navigator = Navigator(){mark}
        {then}


    if __name__ == '__main__':
        main()
"""
COMMANDER = "from nav2_simple_commander.robot_navigator import BasicNavigator"
RCLPY = "from rclpy.node import Node"


@pytest.mark.parametrize(
    ("imports", "base", "then", "mark"),
    [
        (COMMANDER, "BasicNavigator", "navigator.waitUntilNav2Active()", ""),
        (COMMANDER, "BasicNavigator", "time.sleep(60)", "  # here"),  # its constructor does not spin
        (COMMANDER, "BasicNavigator", "navigator.get_logger().info('ready')", "  # here"),
        ("from robot_base import RobotNode", "RobotNode", "time.sleep(60)", ""),  # the constructor may start a thread
        (RCLPY, "Node", "time.sleep(60)", "  # here"),
        (RCLPY + "\n    from threading import Thread", "Node, Thread", "time.sleep(60)", "  # here"),
    ],
)
def test_methods_of_a_base_elsewhere_may_spin_a_node(judge: Judge, imports: str, base: str, then: str, mark: str):
    judge("EXE008", NAVIGATOR.format(imports=imports, base=base, then=then, mark=mark))


WRAPPER = """
    import rclpy
    from rclpy.node import Node


    class Clock:
        def __init__(self, node):
            self.node = node

        def start(self, period, callback):
            self.node.create_timer(period, callback)


    class Arm(Node):
        def __init__(self):
            super().__init__('arm')
            self.clock = Clock(self)
            {arm}

        def tick(self):
            pass


    class Base(Node):
        def __init__(self):
            super().__init__('base')
            self.arm = Arm(){mark}
            self.clock = Clock(self)
            {base}

        def tick(self):
            pass


    def main():
        rclpy.init()
        rclpy.spin(Base())


    if __name__ == '__main__':
        main()
"""
START = "self.clock.start(1.0, self.tick)"


@pytest.mark.parametrize(
    ("arm", "base", "mark"),
    [
        ("pass", START, ""),  # the timer is that of the other node
        ("pass", "pass", ""),
        (START, START, "  # here"),
        ("self.create_timer(1.0, self.tick)", START, "  # here"),
    ],
)
def test_a_helper_creates_only_what_it_is_asked_for(judge: Judge, arm: str, base: str, mark: str):
    judge("EXE008", WRAPPER.format(arm=arm, base=base, mark=mark))
