"""Code that looks dead where only the constructor or the defaults are looked at, and that others bring to life."""

from __future__ import annotations

import itertools

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph

NODE = """\
import collections
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.items = {empty}
        self.create_timer(1.0, self.tick)
        self.create_subscription(String, 'news', self.on_news, 10)
        self.create_client(String, 'ask')

    def tick(self):
{tick}

    def on_news(self, message):
        {news}

    def later(self):
        {later}

def main():
    rclpy.init()
    rclpy.spin(Robot())

if __name__ == '__main__':
    main()
"""


def endpoints(tmp_path, monkeypatch, text):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.py").write_text(text, encoding="utf-8")
    found = graph(Request((".",), Settings(), cached=False, jobs=1))
    ends = [end for node in found.nodes for end in node.endpoints if end.kind == "publisher"]
    return [(end.name, end.conditional) for end in ends]


def robot(tick: str, empty: str = "{}", news: str = "pass", later: str = "pass") -> str:
    lines = "\n".join(f"        {line}" for line in tick.splitlines())
    return NODE.format(empty=empty, tick=lines, news=news, later=later)


@pytest.mark.parametrize(
    ("empty", "filled"),
    [
        ("{}", "self.items[message.data] = message"),
        ("{}", "self.items.update(a=message)"),
        ("dict()", "self.items.setdefault(message.data, 1)"),
        ("[]", "self.items.append(message)"),
        ("[]", "self.items += [message]"),
        ("[]", "self.items = [message.data, 'more']"),
        ("set()", "self.items.add(message)"),
        ("collections.deque()", "self.items.append(message)"),
        ("collections.defaultdict(list)", "self.items[message.data].append(message)"),
    ],
)
@pytest.mark.parametrize(
    "tick",
    [
        "for item in self.items:\n    self.create_publisher(String, 'said', 10)",
        "if self.items:\n    self.create_publisher(String, 'said', 10)",
        "if not self.items:\n    return\nself.create_publisher(String, 'said', 10)",
        "while len(self.items) > 0:\n    self.create_publisher(String, 'said', 10)",
        "[self.create_publisher(String, 'said', 10) for item in list(self.items)]",
    ],
)
def test_a_collection_that_another_method_fills(tmp_path, monkeypatch, empty, filled, tick):
    assert [name for name, _ in endpoints(tmp_path, monkeypatch, robot(tick, empty, news=filled))] == ["/said"]


def test_what_depends_on_it_is_conditional_and_its_names_are_unknown(tmp_path, monkeypatch):
    tick = "for name, item in self.items.items():\n    self.create_publisher(String, name, 10)"
    text = robot(tick, later="self.items['x'] = 1")
    assert endpoints(tmp_path, monkeypatch, text) == [(None, True)]


@pytest.mark.parametrize(
    "later", ["self.items.clear()", "self.items = {}", "print(self.items)", "self.other = {'a': 1}"]
)
def test_a_collection_that_nothing_fills_stays_empty(tmp_path, monkeypatch, later):
    tick = "for item in self.items:\n    self.create_publisher(String, 'said', 10)"
    assert endpoints(tmp_path, monkeypatch, robot(tick, later=later)) == []


LIBRARY = """\
from rclpy.node import Node
from std_msgs.msg import String

class Robot(Node):
    def __init__(self, use_nav=False, topic='said', *, debug: bool = True):
        super().__init__('robot')
        self.use_nav = use_nav
        self.create_publisher(String, topic, 10)
        if use_nav:
            self.create_publisher(String, 'path', 10)
        if not debug:
            return
        self.create_publisher(String, 'debug', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        if self.use_nav:
            self.create_publisher(String, 'goal', 10)
"""


def test_flags_of_what_nothing_here_makes(tmp_path, monkeypatch):
    assert endpoints(tmp_path, monkeypatch, LIBRARY) == [
        ("/debug", False),  # what follows an early return is not called conditional
        ("/goal", True),
        ("/path", True),
        ("/said", False),
    ]


def test_flags_of_what_is_made_here_are_what_is_passed(tmp_path, monkeypatch):
    main = "\ndef main():\n    Robot(debug=False)\n\nif __name__ == '__main__':\n    main()\n"
    assert endpoints(tmp_path, monkeypatch, LIBRARY + main) == [("/said", False)]


def test_flags_of_a_function_that_nothing_here_calls(tmp_path, monkeypatch):
    text = LIBRARY + "\ndef make(nav=False):\n    if nav:\n        Robot(use_nav=True)\n"
    assert ("/path", True) in endpoints(tmp_path, monkeypatch, text)


# --------------------------------------------------------- what another callback leaves in an attribute


@pytest.mark.parametrize(
    ("before", "news", "tick"),
    [
        ("None", "self.items = message.data", "if self.items is None:\n    return\nSAY"),
        ("None", "self.items = message", "if not self.items:\n    return\nSAY"),
        ("False", "if message.data:\n            self.items = True", "if self.items:\n    SAY"),
        ("0", "self.items = int(message.data)", "if self.items == 2:\n    SAY"),
        ("0", "pass", "if self.items > 2:\n    SAY\nelse:\n    self.items += 1"),
        (
            "0",
            "pass",
            "if time() > 9:\n    if self.items == 0:\n        self.items = 1\n    elif self.items == 1:\n        SAY",
        ),
    ],
)
def test_what_a_callback_leaves_decides_a_test_in_another(tmp_path, monkeypatch, before, news, tick):
    text = robot(tick.replace("SAY", "self.create_publisher(String, 'said', 10)"), before, news=news)
    assert [name for name, _ in endpoints(tmp_path, monkeypatch, text)] == ["/said"]


STATES = """\
import enum

class State(enum.Enum):
    IDLE = 0
    TURN = 1
    DRIVE = 2
    SPEAK = 3

"""


def machine(*steps: str) -> str:
    lines = [f"if self.items == State.{steps[-1]}:", "    self.create_publisher(String, 'said', 10)"]
    for one, after in reversed(list(itertools.pairwise(steps))):
        lines += [f"elif self.items == State.{one}:", f"    self.items = State.{after}"]
    return STATES + robot("\n".join(lines), "State.IDLE")


def test_a_state_that_is_reached_over_others(tmp_path, monkeypatch):
    found = endpoints(tmp_path, monkeypatch, machine("IDLE", "TURN", "DRIVE", "SPEAK"))
    assert [name for name, _ in found] == ["/said"]


def test_a_state_that_nothing_sets_is_not_reached(tmp_path, monkeypatch):
    assert endpoints(tmp_path, monkeypatch, machine("IDLE", "TURN").replace("State.TURN:", "State.SPEAK:")) == []


def test_a_method_that_foreign_code_calls_runs_in_any_state(tmp_path, monkeypatch):
    later = "if self.items > 2:\n            self.create_publisher(String, 'said', 10)\n        self.items += 1"
    assert [name for name, _ in endpoints(tmp_path, monkeypatch, robot("pass", "0", later=later))] == ["/said"]


ACTION = """\
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import String

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.server = ActionServer(self, Fibonacci, 'go', self.execute)

    def execute(self, goal_handle):
        if {asked}:
            goal_handle.canceled()
            return Fibonacci.Result()
        self.create_publisher(String, 'said', 10)
        goal_handle.succeed()
        return Fibonacci.Result()

def main():
    rclpy.init()
    rclpy.spin(Robot())

if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    "asked", ["goal_handle.is_cancel_requested", "not goal_handle.is_active", "goal_handle.status == 5"]
)
def test_what_an_object_of_a_library_has_may_be_true_or_not(tmp_path, monkeypatch, asked):
    assert [name for name, _ in endpoints(tmp_path, monkeypatch, ACTION.format(asked=asked))] == ["/said"]
