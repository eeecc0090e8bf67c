"""What stands behind a call that Python refuses never runs: nothing is said about it."""

from __future__ import annotations

import pytest

from checks.callbacks import Run, codes, source

CREATE = """
self.settings = (1, 2)
self.create_subscription(Empty, 'stop', print, 10)
self.create_timer(5.0, self.tick)
"""


def refused(call: str, rest: str) -> str:
    return source(CREATE, f"def tick(self):\n    {call}\n\n{rest}")


MEASURE = "def measure(self, port, period=1.0, *, average=1):\n    time.sleep(3.0)\n"


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        pytest.param("self.measure()", [], id="an argument is missing"),
        pytest.param("self.measure(1, 2, 3)", [], id="one too many"),
        pytest.param("self.measure(1, speed=2)", [], id="no such keyword"),
        pytest.param("self.measure(1, port=2)", [], id="given twice"),
        pytest.param("self.measure(self.settings)", ["EXE003"], id="a tuple is one argument"),
        pytest.param("self.measure(*self.settings)", ["EXE003"], id="an unpacked tuple is several"),
        pytest.param("self.measure(*load())", ["EXE003"], id="nobody knows how many"),
        pytest.param("self.measure(1, average=3)", ["EXE003"], id="a keyword"),
        pytest.param("self.measure(port=1, period=2)", ["EXE003"], id="by name"),
    ],
)
def test_a_call_is_followed_if_its_arguments_fit(run: Run, call: str, expected: list[str]):
    assert codes(run(refused(call, MEASURE))) == expected


@pytest.mark.parametrize(
    "head",
    ["def measure(self, *values):", "def measure(self, **options):", "@wraps\n    def measure(self):"],
)
def test_some_functions_take_anything_or_may_be_another_function(run: Run, head: str):
    call = "self.measure(port=1)" if "**" in head else "self.measure(1, 2)"
    method = head.replace("    def", "def") + "\n    time.sleep(3.0)\n"
    assert codes(run(refused(call, method))) == ["EXE003"]


def test_what_follows_a_refused_call_does_not_run(run: Run):
    assert codes(run(refused("self.measure()\n    time.sleep(2.0)", "def measure(self, port):\n    pass\n"))) == []


def test_a_handler_of_the_error_goes_on(run: Run):
    body = "try:\n        self.measure()\n    except TypeError:\n        pass\n    time.sleep(2.0)"
    assert codes(run(refused(body, "def measure(self, port):\n    pass\n"))) == ["EXE003"]


def test_a_call_that_may_not_be_made_ends_nothing(run: Run):
    body = "ready() and self.measure()\n    if ready():\n        self.measure()\n    time.sleep(2.0)"
    assert codes(run(refused(body, "def measure(self, port):\n    pass\n"))) == ["EXE003"]


@pytest.mark.parametrize(("rounds", "expected"), [("len(range(5))", []), ("range(5)", ["EXE003"])])
def test_a_loop_over_a_number_has_no_rounds(run: Run, rounds: str, expected: list[str]):
    assert codes(run(refused(f"for i in {rounds}:\n        time.sleep(1.0)", ""))) == expected


def test_a_node_is_what_its_constructor_means_it_to_be(run: Run):
    create = "self.prepare()\nself.create_subscription(Empty, 'stop', print, 10)\nself.create_timer(5.0, self.tick)\n"
    methods = "def prepare(self, port):\n    pass\n\ndef tick(self):\n    time.sleep(2.0)\n"
    assert codes(run(source(create, methods))) == ["EXE003"]


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        pytest.param("self.get_logger('tick')", [], id="one too many"),
        pytest.param("self.create_client(Trigger)", [], id="one too few"),
        pytest.param("self.create_publisher(Empty, 'out', 10, qos_profile=10)", [], id="given twice"),
        pytest.param("self.get_logger().info('tick')", ["EXE003"], id="it fits"),
        pytest.param("self.get_logger(*load())", ["EXE003"], id="nobody knows how many"),
        pytest.param("self.get_parameter(name='speed')", ["EXE003"], id="by name"),
    ],
)
def test_methods_of_a_node_refuse_as_well(run: Run, call: str, expected: list[str]):
    assert [one for one in codes(run(refused(f"{call}\n    time.sleep(2.0)", ""))) if one == "EXE003"] == expected


def test_a_node_may_have_a_method_of_its_own(run: Run):
    methods = "def get_logger(self, text=''):\n    return Node.get_logger(self)\n"
    assert codes(run(refused("self.get_logger('tick')\n    time.sleep(2.0)", methods))) == ["EXE003"]


@pytest.mark.parametrize(
    ("imported", "expected"),
    [
        ("import rclpy.node as Node", []),
        ("from rclpy import node as Node", []),
        ("from rclpy.node import Node", ["EXE003"]),
    ],
)
def test_no_class_inherits_from_a_module(run: Run, imported: str, expected: list[str]):
    text = refused("time.sleep(2.0)", "").replace("from rclpy.node import Node", imported)
    assert imported in text
    assert codes(run(text)) == expected


NEVER_MADE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


{before}
class Approach(Node{base}):
    def __init__(self):
        super().__init__('approach')
        self.create_subscription(String, 'chatter', print, 10)
{method}

def main():
    rclpy.init()
    approach = Approach({given})
    print(approach)


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("given", "before", "base", "method", "expected"),
    [
        pytest.param("", "", "", "", ["EXE008"], id="it fits"),
        pytest.param("1.5, [2]", "", "", "", [], id="the constructor takes nothing"),
        pytest.param("speed=1.5", "", "", "", [], id="no such keyword"),
        pytest.param("*load()", "", "", "", ["EXE008"], id="nobody knows how many"),
        pytest.param("1.5", "@single", "", "", ["EXE008"], id="a decorator may be in between"),
        pytest.param("1.5", "from here import Meta", ", metaclass=Meta", "", ["EXE008"], id="or a metaclass"),
        pytest.param(
            "1.5",
            "",
            "",
            "\n    def __new__(cls, *given):\n        return super().__new__(cls)\n",
            ["EXE008"],
            id="__new__",
        ),
    ],
)
def test_no_node_is_made_where_the_constructor_refuses(
    run: Run, given: str, before: str, base: str, method: str, expected: list[str]
):
    text = NEVER_MADE.format(given=given, before=before, base=base, method=method)
    assert codes(run(text)) == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        pytest.param("rclpy.init()", [], id="rclpy raises"),
        pytest.param("rclpy.ok()", ["EXE008"], id="another call"),
        pytest.param("if not rclpy.ok(): rclpy.init()", ["EXE008"], id="it asks before"),
    ],
)
def test_no_node_is_made_where_its_constructor_initialises_once_more(run: Run, line: str, expected: list[str]):
    text = NEVER_MADE.format(given="", before="", base="", method="")
    text = text.replace("        super().__init__", f"        {line}\n        super().__init__", 1)
    assert codes(run(text)) == expected
