"""Whose endpoint is it?  Small workspaces, and the node under which each endpoint stands."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.render.json import document

Owners = Callable[..., dict[str, list[str]]]

IMPORTS = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger
"""
LISTS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")


class Workspace:
    """``owners(source, …)`` writes files and tells which names each node has; what is no node is in brackets."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __call__(self, *sources: str, **modules: str) -> dict[str, list[str]]:
        return {_shown(entry): _names(entry) for entry in self.entries(*sources, **modules)}

    def entries(self, *sources: str, **modules: str) -> list[dict[str, Any]]:
        named = {f"node{number or ''}": source for number, source in enumerate(sources)} | modules
        for name, source in named.items():
            (self.folder / f"{name}.py").write_text(IMPORTS + dedent(source), encoding="utf-8")
        nodes: list[dict[str, Any]] = document(graph(self.request()))["nodes"]
        return nodes

    def request(self) -> Request:
        return Request((".",), load(self.folder), cached=False, jobs=1)


def _shown(entry: dict[str, Any]) -> str:
    return (entry["name"] or entry["class"]) if entry["is_node"] else f"({entry['class']})"


def _names(entry: dict[str, Any]) -> list[str]:
    return sorted(str(endpoint["name"]) for one in LISTS for endpoint in entry[one])


@pytest.fixture
def owners(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workspace:
    monkeypatch.chdir(tmp_path)
    return Workspace(tmp_path)


TALKER = """\
class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.helper = Helper(self)
"""
HELPER = """\
class Helper:
    def __init__(self, node):
        self.out = node.create_publisher(String, "chatter", 10)
"""


# ------------------------------------------------------------------------------------------ what is no node


def test_a_helper_that_nothing_hands_a_node_is_no_node(owners):
    assert owners(HELPER) == {"(Helper)": ["/chatter"]}


def test_a_helper_of_a_known_node_stands_for_nothing_else(owners):
    again = """\
    def report():
        Helper().out.publish(String())  # one of them is made without a node: a singleton's second use
    """
    assert owners(HELPER + TALKER + dedent(again)) == {"/talker": ["/chatter"]}


def test_another_name_of_the_same_line_is_kept(owners):
    source = """\
    def listen(node, name):
        node.create_subscription(String, name, print, 10)

    class Talker(Node):
        def __init__(self):
            super().__init__("talker")
            listen(self, "chatter")

    class Plugin:
        def start(self, context):
            listen(context.node, f"{context.node.get_name()}/log")
            listen(context.node, "whisper")
    """
    assert owners(source) == {"/talker": ["/chatter"], "(listen)": ["/whisper"]}


@pytest.mark.parametrize(
    ("base", "body"),
    [
        ("from framework import Plugin", "self.declare_parameter('rate', 10)"),
        ("from framework import Plugin", "self.pub = self.create_publisher(String, 'chatter', 10)"),
        ("from framework.parts import Component as Plugin", "self.timer = self.create_timer(1.0, self.tick)"),
        ("import framework; Plugin = framework.base()", "self.pub = self.create_publisher(String, 'chatter', 10)"),
    ],
)
def test_a_base_from_elsewhere_makes_no_node(owners, base, body):
    source = f"""\
    {base}

    class Thing(Plugin):
        def __init__(self):
            super().__init__()
            {body}

        def tick(self):
            pass
    """
    [entry] = owners.entries(source)
    assert (entry["name"], entry["class"], entry["is_node"]) == (None, "Thing", False)


@pytest.mark.parametrize(
    ("base", "use"),
    [
        ("from framework import HelloNode as Base", ""),
        ("from framework.node import Node as Base", ""),
        ("from nav2_simple_commander.robot_navigator import BasicNavigator as Base", ""),
        ("from framework import Robot as Base", "rclpy.spin(Thing())"),
        ("from framework import Robot as Base", "rclpy.get_global_executor().add_node(Thing()); rclpy.spin(Thing())"),
    ],
)
def test_a_base_that_is_called_a_node_or_used_as_one_makes_one(owners, base, use):
    source = f"""\
    {base}

    class Thing(Base):
        def __init__(self):
            super().__init__()
            self.pub = self.create_publisher(String, "chatter", 10)

    if __name__ == "__main__":
        {use or "pass"}
    """
    assert owners(source) == {"Thing": ["/chatter"]}


def test_what_ros_takes_for_a_node_is_one(owners):
    source = """\
    from framework import Robot
    from rclpy.action import ActionClient
    from example_interfaces.action import Fibonacci

    class Thing(Robot):
        def __init__(self):
            super().__init__()
            self.goals = ActionClient(self, Fibonacci, "fibonacci")
    """
    assert owners(source) == {"Thing": ["/fibonacci"]}


def test_an_object_of_a_node_class_whose_constructor_never_runs_is_no_node(owners):
    source = """\
    class Arm(Node):
        def __init__(self):
            super().__init__("arm")
            self.out = self.create_publisher(String, "pose", 10)

    class Gripper(Arm):
        def __init__(self, node):
            self.node = node  # not super().__init__(): there is nothing of a node in it
            self.out = node.create_publisher(String, "grip", 10)

    if __name__ == "__main__":
        gripper = Gripper(Arm())
    """
    assert owners(source) == {"/arm": ["/grip", "/pose"]}


# ------------------------------------------------------------------------------------- how it is handed on


@pytest.mark.parametrize("arguments", ["self, node", "self=self, node=node"])
def test_a_constructor_that_is_called_by_way_of_its_class(owners, arguments):
    source = f"""\
    class Arm:
        def __init__(self, node):
            self.out = node.create_publisher(String, "pose", 10)

    class Gripper(Arm):
        def __init__(self, node):
            super().__init__(node)

    class Hand(Gripper):
        def __init__(self, node):
            Gripper.__init__({arguments})

    class Robot(Node):
        def __init__(self):
            super().__init__("robot")
            self.hand = Hand(self)
    """
    assert owners(source) == {"/robot": ["/pose"]}


# ------------------------------------------------------------------------------------- how it is followed

PARTS = """\
class Camera(Plugin):
    def __init__(self, node):
        self.pub = node.create_publisher(String, "camera", 10)

class Lidar(Plugin):
    def __init__(self, node):
        self.pub = node.create_publisher(String, "lidar", 10)
"""
ROBOT = """\
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.parts = [cls(self) for cls in {classes}]
"""


@pytest.mark.parametrize(
    ("plugin", "parts", "classes"),
    [
        pytest.param("pass", PARTS, "Plugin.__subclasses__()", id="subclasses"),
        pytest.param(
            """\
    known = []
    def __init_subclass__(cls, **options):
        super().__init_subclass__(**options)
        Plugin.known.append(cls)
""",
            PARTS,
            "Plugin.known",
            id="__init_subclass__",
        ),
        pytest.param(
            """\
    known = {}
    @classmethod
    def register(cls, name):
        def keep(part):
            cls.known[name] = part
            return part
        return keep
""",
            PARTS.replace("class Camera", '@Plugin.register("c")\nclass Camera').replace(
                "class Lidar", '@Plugin.register("l")\nclass Lidar'
            ),
            "Plugin.known.values()",
            id="a decorator with a name",
        ),
        pytest.param(
            """\
    known = []

def plugin(part):
    Plugin.known.append(part)
    return part
""",
            PARTS.replace("class", "@plugin\nclass"),
            "Plugin.known",
            id="a decorator",
        ),
        pytest.param("pass", PARTS + 'KNOWN = {"c": Camera, "l": Lidar}\n', "KNOWN.values()", id="a dictionary"),
        pytest.param("pass", PARTS + 'KNOWN = {"c": Camera, "l": Lidar}\n', "[KNOWN[input()]]", id="one of them"),
    ],
)
def test_classes_that_a_registry_holds(owners, plugin, parts, classes):
    body = plugin if plugin.startswith(" ") else f"    {plugin}\n"
    source = "class Plugin:\n" + body + parts + ROBOT.format(classes=classes)
    assert owners(source) == {"/robot": ["/camera", "/lidar"]}


def test_subclasses_are_those_that_a_program_imports(owners):
    run = "if __name__ == '__main__':\n    Robot()\n"
    found = owners(
        base="class Plugin:\n    pass\n",
        camera="from base import Plugin\n" + PARTS.partition("\n\n")[0],
        lidar="from base import Plugin\nclass Lidar" + PARTS.partition("class Lidar")[2],
        front="import camera\nfrom base import Plugin\n" + ROBOT.format(classes="Plugin.__subclasses__()") + run,
        rear="import lidar\nfrom base import Plugin\n"
        + ROBOT.format(classes="Plugin.__subclasses__()").replace('"robot"', '"rear"')
        + run,
    )
    assert found == {"/robot": ["/camera"], "/rear": ["/lidar"]}


@pytest.mark.parametrize(
    "handed",
    ["helper.node = self", "Helper.node = self", "setattr(helper, 'node', self)", "helper.__dict__['node'] = self"],
)
def test_a_node_that_is_set_from_outside(owners, handed):
    source = f"""\
    class Helper:
        node = None

        def start(self):
            self.out = self.node.create_publisher(String, "chatter", 10)

    class Talker(Node):
        def __init__(self):
            super().__init__("talker")
            helper = Helper()
            {handed}
            helper.start()
    """
    assert owners(source) == {"/talker": ["/chatter"]}


SINGLETONS = {
    "decorator": """\
def singleton(cls):
    made = {}
    def get(*arguments):
        if cls not in made:
            made[cls] = cls(*arguments)
        return made[cls]
    return get

@singleton
class Helper:
    def __init__(self, node):
        self.node = node
""",
    "new": """\
class Helper:
    one = None
    def __new__(cls, node=None):
        if cls.one is None:
            cls.one = super().__new__(cls)
            cls.one.node = node
        return cls.one
""",
    "object": """\
class Helper:
    one = None
    def __new__(cls, *arguments):
        if not cls.one:
            cls.one = object.__new__(cls)
        return cls.one
    def __init__(self, node=None):
        if node is not None:
            self.node = node
""",
}


@pytest.mark.parametrize("form", SINGLETONS)
def test_the_one_object_of_a_class(owners, form):
    more = """\
    def start(self):
        self.out = self.node.create_publisher(String, "chatter", 10)

def work():
    Helper().start()

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        Helper(self)
        work()
"""
    assert owners(SINGLETONS[form] + more) == {"/talker": ["/chatter"]}


LOADER = """\
import importlib

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        importlib.import_module(input()).make(self)
"""


@pytest.mark.parametrize(
    "part",
    [
        "    def __init__(self, talker: Talker):\n        talker.create_publisher(String, 'chatter', 10)\n",
        "    def __init__(self, talker: 'Talker'):\n        talker.create_publisher(String, 'chatter', 10)\n",
        "    def __init__(self, talker: Talker | None):\n        talker.create_publisher(String, 'chatter', 10)\n",
        "    talker: Talker\n    def start(self):\n        self.talker.create_publisher(String, 'chatter', 10)\n",
        "    def __init__(self, owner):\n        self.talker: Talker = owner\n"
        "        self.talker.create_publisher(String, 'chatter', 10)\n",
    ],
)
def test_an_annotation_tells_the_node(owners, part):
    [entry] = owners.entries(LOADER, part="from node import Talker\n\nclass Part:\n" + part)
    assert (entry["name"], _names(entry)) == ("/talker", ["/chatter"])
    assert entry["publishers"][0]["conditional"]  # nothing shows that the part is ever made


def test_an_annotation_tells_what_holds_the_node(owners):
    connector = """\
    class Connector:
        def __init__(self):
            self._node = rclpy.create_node("connector")

        @property
        def node(self):
            return self._node

    if __name__ == "__main__":
        Connector()
    """
    tool = """\
    from framework import Tool
    from node import Connector

    class Mover(Tool):
        connector: Connector

        def run(self):
            self.connector.node.create_client(Trigger, "move")
    """
    assert owners(connector, tool=tool) == {"/connector": ["/move"]}


def test_an_annotation_that_may_mean_several_nodes_tells_none(owners):
    source = """\
    class Base(Node):
        pass

    class Left(Base):
        def __init__(self):
            super().__init__("left")

    class Right(Base):
        def __init__(self):
            super().__init__("right")

    class Part:
        def __init__(self, node: Base, other: Node):
            node.create_publisher(String, "chatter", 10)
            other.create_publisher(String, "whisper", 10)
    """
    assert [names for name, names in owners(source).items() if name.startswith("/")] == [[], []]


@pytest.mark.parametrize("made", ["Node('bridge')", "rclpy.create_node('bridge')"])
def test_a_node_that_a_later_method_makes(owners, made):
    source = f"""\
    class Gateway:
        def __init__(self):
            self._node: Node | None = None

        def ask(self):
            if self._node is None:
                raise RuntimeError("not started")
            self._client = self._node.create_client(Trigger, "ask")

        def start(self):
            self._node = {made}
    """
    assert owners(source) == {"/bridge": ["/ask"]}


def test_a_base_that_is_generic(owners):
    source = """\
    from typing import Generic, TypeVar
    T = TypeVar("T")

    class Component(Generic[T]):
        def attach(self, node):
            self.out = node.create_publisher(String, self.topic, 10)

    class Lamp(Component[String]):
        topic = "lamp"

    class Robot(Node):
        def __init__(self):
            super().__init__("robot")
            Lamp().attach(self)
    """
    assert owners(source) == {"/robot": ["/lamp"]}


def test_a_function_that_makes_it_later(owners):
    source = """\
    class Cache:
        known = {}

        @classmethod
        def client(cls, node, name):
            return cls.get(name, lambda: node.create_client(Trigger, name))

        @classmethod
        def get(cls, key, factory):
            if key not in cls.known:
                cls.known[key] = factory()
            return cls.known[key]

    class Robot(Node):
        def __init__(self):
            super().__init__("robot")
            self.client = Cache.client(self, "ask")
    """
    assert owners(source) == {"/robot": ["/ask"]}


def test_a_node_whose_helper_is_not_followed_is_not_complete(owners):
    used = """\
    import parts

    class Talker(Node):
        def __init__(self):
            super().__init__("talker")
            self.names = ["Helper"]

        def load(self):
            return parts.Helper
    """
    other = """\
    class Quiet(Node):
        def __init__(self):
            super().__init__("quiet")
    """
    entries = {_shown(one): one["complete"] for one in owners.entries(used, other, parts=HELPER)}
    assert entries == {"/talker": False, "/quiet": True, "(Helper)": True}


# --------------------------------------------------------------------------------------- how it is shown


UNKNOWN_USER = """\
class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.out = self.create_publisher(String, "chatter", 10)

class Plugin:
    def start(self, context):
        context.node.create_subscription(String, "chatter", print, 10)
"""


def test_what_is_no_node_is_not_counted(owners):
    owners(UNKNOWN_USER)
    assert check(owners.request()).summary.nodes == 1


def test_it_is_shown_apart_in_text(owners):
    from archlint.render.text import render

    owners(UNKNOWN_USER)
    shown = render(graph(owners.request()))
    assert shown.startswith("1 node\n\n/talker")
    assert "\n\nused by an unknown node\n\nPlugin  node.py:" in shown
    assert "connected: 0 of 1 node" in shown and "hub" not in shown


def test_it_is_drawn_apart(owners):
    from archlint.render import render

    owners(UNKNOWN_USER)
    system = graph(owners.request())
    assert 'label="used by an unknown node"' in render("dot", system)
    assert "1 node, 1 topic" in render("dot", system)
    assert 'subgraph g0["used by an unknown node"]' in render("mermaid", system)


FALLBACK = """
    class Listener(Node):
        def __init__(self):
            super().__init__('listener')
            for topic in ['a', 'b']:
                try:
                    self.words = self.create_subscription(String, topic, print, 10)
                    {after}
                except Exception:
                    {handler}


    def main():
        rclpy.init()
        rclpy.spin(Listener())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("after", "handler", "expected"),
    [
        ("break", "continue", ["/a"]),
        ("break", "self.get_logger().warning('not this one')", ["/a"]),
        ("break", "self.spare = self.create_publisher(String, 'spare', 10)", ["/a", "/b", "/spare"]),
        ("pass", "continue", ["/a", "/b"]),
        ("if self.quick(): break", "continue", ["/a", "/b"]),
    ],
)
def test_a_loop_that_breaks_off_at_the_first_success(owners: Workspace, after: str, handler: str, expected: list[str]):
    assert owners(FALLBACK.format(after=after, handler=handler)) == {"/listener": expected}


TOOLBOX = """
    class Toolbox:
        def __init__(self, node):
            self.node = node

        def listen(self, topic):
            return self.node.create_subscription(String, topic, print, 10)

        def speak(self, topic):
            return self.node.create_publisher(String, topic, 10)


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.tools = Toolbox(self)
            self.tools.listen('words')
            {more}


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    if __name__ == '__main__':
        main()
"""


def test_a_wrapper_that_nothing_calls_creates_nothing(owners: Workspace):
    assert owners(TOOLBOX.format(more="pass")) == {"/robot": ["/words"]}
    assert owners(TOOLBOX.format(more="self.tools.speak(load())")) == {"/robot": ["/words", "None"]}
    assert "None" in owners(TOOLBOX.format(more="somewhere.hand_over(self)"))["/robot"]
