"""What is known of a declared parameter, and of a program that is followed in part."""

from __future__ import annotations

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.render.json import document

NODE = """\
import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

class Anything(Node):
    def __init__(self):
        super().__init__('anything')
        self.declare_parameter('fixed', 1, ParameterDescriptor(description='one type'))
        self.declare_parameter('any', 1, ParameterDescriptor(dynamic_typing=True))
        self.declare_parameters('many', [('any', 1.0, ParameterDescriptor(dynamic_typing=True)), ('fixed', 'a')])
        {more}

rclpy.init()
rclpy.spin(Anything())
"""


def node_of(tmp_path, monkeypatch, more="pass"):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "anything.py").write_text(NODE.format(more=more), encoding="utf-8")
    [node] = graph(Request((".",), Settings(), cached=False, jobs=1)).nodes
    return node


def test_dynamic_typing_leaves_the_type_open(tmp_path, monkeypatch):
    found = node_of(tmp_path, monkeypatch).parameters
    assert [(p.name.text, p.type, p.dynamic) for p in found] == [
        ("fixed", "integer", False),
        ("any", None, True),
        ("many.any", None, True),
        ("many.fixed", "string", False),
    ]


def test_a_program_that_is_cut_short_is_not_complete(tmp_path, monkeypatch):
    loop = (
        "for a in range(400):\n            for b in range(400):\n                self.get_logger().info('x')\n        "
    )
    endless = loop * 20  # one of them leaves something for what follows it
    assert node_of(tmp_path, monkeypatch).blueprint.complete
    cut_short = node_of(tmp_path, monkeypatch, endless).blueprint
    assert not cut_short.complete
    assert [reason for _, reason in cut_short.gaps] == ["its program has too much code to follow all of it"]


def test_the_type_of_a_parameter_value_is_that_of_its_default(tmp_path, monkeypatch):
    read = (
        "value = self.get_parameter('many.fixed').get_parameter_value()\n"
        "        name = value.string_value if value.type == 4 else ''\n"
        "        self.create_publisher(ParameterDescriptor, name, 10)"
    )
    found = node_of(tmp_path, monkeypatch, read).endpoints
    assert [endpoint.name for endpoint in found] == ["/a"]


def test_what_stands_in_for_an_empty_parameter_is_set_by_that_parameter(tmp_path, monkeypatch):
    read = (
        "value = self.get_parameter('many.fixed').value\n"
        "        self.create_publisher(ParameterDescriptor, 'c' if value is None else value + 'd', 10)\n"
        "        self.create_publisher(ParameterDescriptor, value or 'b', 10)"
    )
    found = node_of(tmp_path, monkeypatch, read).endpoints
    # A text is never None: nothing is called 'c'.
    assert [(e.name, e.creation.name.parameter) for e in found] == [
        ("/a", "many.fixed"),
        ("/ad", "many.fixed"),
        ("/b", "many.fixed"),
    ]


def test_an_empty_list_as_default_decides_nothing(tmp_path, monkeypatch):
    read = (
        "robots = self.declare_parameter('robots', []).value\n"
        "        if len(robots) == 1:\n"
        "            self.create_publisher(ParameterDescriptor, 'alone', 10)\n"
        "        for robot in robots:\n"
        "            self.create_publisher(ParameterDescriptor, f'{robot}/state', 10)"
    )
    found = node_of(tmp_path, monkeypatch, read).endpoints
    assert [(e.name, e.creation.conditional) for e in found] == [("/*/state", True), ("/alone", True)]


def test_the_else_of_a_loop_that_a_try_may_leave(tmp_path, monkeypatch):
    read = (
        "for device in ('can0', 'can1'):\n"
        "            try:\n"
        "                self.bus = connect(device)\n"
        "                break\n"
        "            except OSError:\n"
        "                pass\n"
        "        else:\n"
        "            raise RuntimeError('no bus')\n"
        "        self.create_publisher(ParameterDescriptor, 'battery', 10)"
    )
    assert [e.name for e in node_of(tmp_path, monkeypatch, read).endpoints] == ["/battery"]


def test_a_value_that_the_constructor_gives_wins_over_the_default(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    given = NODE.replace("super().__init__('anything')", "super().__init__('anything', parameter_overrides=[GIVEN])")
    given = given.replace("GIVEN", "rclpy.parameter.Parameter('fixed', value=7)").format(more="pass")
    (tmp_path / "anything.py").write_text(given, encoding="utf-8")
    [node] = document(graph(Request((".",), Settings(), cached=False, jobs=1)))["nodes"]
    rows = {one["name"]: (one["default"], one.get("override")) for one in node["parameters"]}
    assert rows == {"fixed": (1, 7), "any": (1, None), "many.any": (1.0, None), "many.fixed": ("a", None)}


def described(tmp_path, monkeypatch, more):
    """What the descriptor of the last parameter says."""
    description = node_of(tmp_path, monkeypatch, more).parameters[-1].description
    assert description is not None
    return description


RANGES = "from rcl_interfaces.msg import FloatingPointRange, IntegerRange\n        "


def test_a_descriptor_says_what_a_parameter_means(tmp_path, monkeypatch):
    rate = described(
        tmp_path,
        monkeypatch,
        RANGES + "self.declare_parameter('rate', 2.0, ParameterDescriptor(description='How often [Hz]', "
        "additional_constraints='a multiple of 0.5', read_only=True, "
        "floating_point_range=[FloatingPointRange(from_value=0.5, to_value=10.0, step=0.5)]))",
    )
    assert (rate.text, rate.constraints, rate.read_only) == ("How often [Hz]", "a multiple of 0.5", True)
    assert (rate.lowest, rate.highest, rate.step) == (0.5, 10.0, 0.5)


def test_a_descriptor_may_be_filled_step_by_step(tmp_path, monkeypatch):
    count = described(
        tmp_path,
        monkeypatch,
        RANGES + "limits = IntegerRange()\n        limits.from_value = 1\n        limits.to_value = 5\n"
        "        limits.step = 0\n        descriptor = ParameterDescriptor()\n"
        "        descriptor.description = 'How many'\n        descriptor.integer_range = [limits]\n"
        "        self.declare_parameter('count', 1, descriptor)",
    )
    assert (count.text, count.lowest, count.highest, count.step) == ("How many", 1, 5, None)


def test_what_only_data_decides_is_not_said(tmp_path, monkeypatch):
    odd = described(
        tmp_path,
        monkeypatch,
        RANGES + "import sys\n        limits = [IntegerRange(from_value=0)] * len(sys.argv)\n"
        "        self.declare_parameter('odd', 1, ParameterDescriptor(description=input(), integer_range=limits))",
    )
    assert (odd.text, odd.lowest, odd.highest) == ("", None, None)


def test_without_a_descriptor_nothing_is_said(tmp_path, monkeypatch):
    assert [p.description and p.description.text for p in node_of(tmp_path, monkeypatch).parameters] == [
        "one type",
        "",
        "",
        None,
    ]
