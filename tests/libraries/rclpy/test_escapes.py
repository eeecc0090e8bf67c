"""A node that escapes: what takes it out of sight, and what only looks like it."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.model import Blueprint

NODE = """\
import functools, os, queue, threading, weakref
import dashboard
import rclpy
from dashboard import Window, registry
from rclpy.node import Node
from rclpy.action import ActionServer
from tf2_ros import Buffer, TransformListener
from std_msgs.msg import String
from std_srvs.srv import Trigger
from example_interfaces.action import Fibonacci
import shared

NODES = {}
WAITING = []

class Helper:
    def __init__(self, node):
        self.node = node
        self.publisher = node.create_publisher(String, 'helped', 10)

    def again(self, node):
        return node.get_logger()

    def own(self):
        return self.node

class Robot(Node):
    latest = None
    every = []

    def __init__(self):
        super().__init__('robot')
        self.create_publisher(String, 'said', 10)
        self.kept = {}
        self.others = []
BODY

    def on_timer(self):
        self.get_logger().info(f'{self}')

    def on_text(self, text):
        self.file, self.heard = text.data, text.data.split()

    def execute(self, goal):
        return None

MORE
def follow(node):
    node.get_logger().info('followed')

def main():
    rclpy.init()
    node = Robot()
    rclpy.spin(node)

if __name__ == '__main__':
    main()
"""


@pytest.fixture(autouse=True)
def inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def robot(tmp_path: Path, body: str = "pass", more: str = "", shared: str = "nodes = {}\n") -> Blueprint:
    text = NODE.replace("BODY", indent(dedent(body).strip(), " " * 8)).replace("MORE", more)
    (tmp_path / "robot.py").write_text(text, encoding="utf-8")
    (tmp_path / "shared.py").write_text(dedent(shared), encoding="utf-8")
    found = graph(Request((".",), Settings(), cached=False, jobs=1))
    [node] = [node for node in found.nodes if node.name == "/robot"]
    assert node.blueprint is not None
    return node.blueprint


ESCAPES = {
    "an argument": "dashboard.show(self)",
    "a keyword argument": "dashboard.show(title='robot', node=self)",
    "arguments in a dict": "dashboard.show(**{'node': self})",
    "arguments in a list": "dashboard.show(*[self])",
    "the constructor of a foreign class": "self.window = Window(self)",
    "a method of a foreign object": "self.window = Window()\nself.window.attach(self)",
    "a variable of a foreign module": "dashboard.supervisor = self",
    "a variable of another module": "shared.supervisor = self",
    "an attribute of a foreign object": "self.window = Window()\nself.window.node = self",
    "an attribute of what is not known": "dashboard.current().node = self",
    "an attribute of a function": "follow.node = self",
    "an item of a foreign container": "registry['robot'] = self",
    "an item of what is not known": "dashboard.nodes()['robot'] = self",
    "a list": "dashboard.show([self])",
    "a tuple": "dashboard.show(('robot', self))",
    "a set": "dashboard.show({self})",
    "a dict": "dashboard.show({'robot': self})",
    "a list in a dict": "dashboard.show({'robots': [self]})",
    "a comprehension": "dashboard.show([node for node in (self,)])",
    "a list that has been given away": "dashboard.show(self.others)\nself.others.append(self)",
    "a dict that has been given away": "dashboard.show(self.kept)\nself.kept['robot'] = self",
    "an object that holds it": "helper = Helper(self)\ndashboard.show(helper)",
    "an object that will hold it": "helper = Helper(self)\nhelper.node = 1\ndashboard.show(helper)\nhelper.node = self",
    "setattr": "setattr(dashboard, 'robot', self)",
    "setattr with a name that is not known": "setattr(Helper(self), dashboard.name(), self)",
    "a partial": "self.create_timer(1.0, functools.partial(dashboard.show, self))",
    "a partial that is given away": "dashboard.later(functools.partial(dashboard.show, node=self))",
    "a lambda": "dashboard.later(lambda: dashboard.show(self))",
    "a lambda that gives it": "dashboard.later(lambda: self)",
    "a lambda with a default": "dashboard.later(lambda node=self: dashboard.show(node))",
    "a function inside": "def show():\n    dashboard.show(self)\ndashboard.later(show)",
    "a function inside that gives it": "def mine():\n    return self\ndashboard.later(mine)",
    "a generator inside": "def mine():\n    yield self\ndashboard.later(mine)",
    "a method that creates": "dashboard.later(self.create_publisher)",
    "a weak reference": "self.me = weakref.ref(self)",
    "a queue": "self.queue = queue.Queue()\nself.queue.put(self)",
    "a thread": "threading.Thread(target=dashboard.show, args=(self,)).start()",
    "a thread with keywords": "threading.Thread(target=dashboard.show, kwargs={'node': self}).start()",
    "a conditional": "dashboard.show(self if dashboard.on() else None)",
    "a condition": "if self.get_name() == dashboard.name():\n    dashboard.show(self)",
    "an operand": "dashboard.bus << self",
    "a for loop": "for node in [self]:\n    dashboard.show(node)",
    "a class made by type": "self.type = type('Bound', (), {'node': self})",
    "what main gives away": "self.manager = dashboard.Manager(nodes=self.others)\nself.others += [self]",
}


@pytest.mark.parametrize("body", ESCAPES.values(), ids=ESCAPES.keys())
def test_what_takes_a_node_out_of_sight(tmp_path, body):
    node = robot(tmp_path, body)
    assert not node.complete
    [(place, reason)] = node.gaps
    assert place.file.endswith("robot.py") and reason.startswith("the node escapes: ")
    line = (tmp_path / "robot.py").read_text(encoding="utf-8").splitlines()[place.line - 1]
    assert line.strip() in [one.strip() for one in body.splitlines()]


STAYS = {
    "nothing": "pass",
    "its own methods": "self.on_timer()\nself.create_timer(1.0, self.on_timer)",
    "a timer's lambda": "self.create_timer(1.0, lambda: self.on_timer())",
    "a timer's partial": "self.create_timer(1.0, functools.partial(follow, self))",
    "a function that is followed": "follow(self)\nfollow(node=self)",
    "a helper": "self.helper = Helper(self)\nself.helper.again(self)\nself.helper.own().on_timer()",
    "a list of its own": "self.others = [self]\nself.others.append(self)\nfor one in self.others:\n    one.on_timer()",
    "a dict of its own": "self.kept['robot'] = self\nself.kept['robot'].on_timer()",
    "a tuple that is unpacked": "name, node = 'robot', self\nnode.on_timer()",
    "setattr on its own": "setattr(self, 'me', self)\nself.me.on_timer()",
    "rclpy": "self.server = ActionServer(self, Fibonacci, 'count', self.execute)",
    "tf2": "self.buffer = Buffer()\nself.listener = TransformListener(self.buffer, self)",
    "what Python keeps nothing of": "print(self, id(self), repr(self), isinstance(self, Node), hasattr(self, 'x'))",
    "an attribute by name": "if hasattr(self, 'others'):\n    delattr(self, 'others')",
    "what a callback sets": "os.path.getsize(self.file)\nfor _, one in enumerate(self.heard):\n    print(one)",
    "a log": "self.get_logger().info('made %s', self)",
    "texts": "dashboard.show(f'{self}', 'robot {}'.format(self), str(self))",
    "what it holds": "dashboard.show(self.get_name(), self.kept, self.others)",
    "a method that is given away": "dashboard.later(self.on_timer)\ndashboard.later(self.destroy_node)",
    "a lambda that calls a method": "dashboard.later(lambda: self.on_timer())",
    "a comparison": "self.same = self == dashboard.current() or self in dashboard.nodes()",
    "a thread that is followed": "threading.Thread(target=follow, args=(self,)).start()",
    "an attribute of its class": "Robot.latest = self",
    "a list of its class": "self.every.append(self)",
    "a dict of its module": "NODES['robot'] = self",
    "a variable of its module": "global current\ncurrent = self",
}


@pytest.mark.parametrize("body", STAYS.values(), ids=STAYS.keys())
def test_what_does_not(tmp_path, body):
    node = robot(tmp_path, body)
    assert node.gaps == [] and node.complete and not node.escapes


def test_a_method_that_nothing_calls_may_give_the_node_away(tmp_path):
    assert not robot(tmp_path, more="    def attach(self, window):\n        window.add(self)\n").complete
    assert robot(tmp_path, more="    def close(self, window):\n        self.on_timer()\n").complete


SHARED = {
    "an attribute of the class": ("Robot.latest = self", "Robot.latest"),
    "a list of the class": ("self.every.append(self)", "Robot.every[0]"),
    "a dict of the module": ("NODES['robot'] = self", "NODES['robot']"),
    "a list in a list of the module": ("WAITING.append([self])", "WAITING[0][0]"),
    "a variable of the module": ("global current\ncurrent = self", "current"),
}


@pytest.mark.parametrize(("body", "use"), SHARED.values(), ids=SHARED.keys())
def test_what_a_function_uses_that_nothing_here_calls(tmp_path, body, use):
    handler = f"@dashboard.route('/')\ndef page():\n    {use}.create_publisher(String, 'paged', 10)\n\n"
    node = robot(tmp_path, body, handler)
    [(_, reason)] = node.gaps
    assert "page() in robot.py can access it, and nothing here calls that function" in reason


def test_what_another_module_keeps(tmp_path):
    keep = "nodes = {}\n\ndef keep(node):\n    nodes['robot'] = node\n"
    assert robot(tmp_path, "shared.keep(self)", shared=keep).complete
    uses = "import dashboard\n" + keep + "\n@dashboard.route('/')\ndef page():\n    nodes['robot'].create_rate(1)\n"
    assert not robot(tmp_path, "shared.keep(self)", shared=uses).complete
