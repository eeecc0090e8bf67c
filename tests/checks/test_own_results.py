"""API001: lines that name a function and do not call it, and results in another number of variables."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


def split(text):
    return text[:1], text[1:]


class Arm:
    def ends(self):
        return 1, 2


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.arm = Arm()
        self.timer = self.create_timer(1.0, self.drive)
        self.callback = None

    def pose(self):
        if self.callback:
            return 0.0, 0.0, 0.0
        return 1.0, 2.0, 0.5

    def some(self):
        return (1, 2) if self.callback else (1, 2, 3)

    def several(self):
        if self.callback:
            return 1, 2
        return 1, 2, 3

    def each(self):
        yield 1
        return 1, 2, 3

    @property
    def place(self):
        return 1, 2, 3

    def on_pose(self, pose):
        self.callback = pose

    def drive(self):
        {line}


def main():
    rclpy.init()
    node = Driver()
    rclpy.spin_once(node)
    {end}


if __name__ == '__main__':
    {guard}
"""


def _node(line: str = "pass", end: str = "pass", guard: str = "main()") -> str:
    return NODE.format(line=line, end=end, guard=guard)


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("x, y = self.pose()  # here", "pose() returns 3 values, and there are 2 variables for them"),
        ("(x, y, z, w) = self.pose()  # here", "pose() returns 3 values, and there are 4 variables for them"),
        ("a, b, c = split('ab')  # here", "split() returns 2 values, and there are 3 variables for them"),
        ("a, b, c = self.arm.ends()  # here", "ends() returns 2 values, and there are 3 variables for them"),
    ],
)
def test_another_number_of_variables(judge: Judge, line: str, says: str):
    (finding,) = judge("API001", _node(line))
    assert finding.message == f"{says}: this line raises ValueError"
    assert finding.related[0].message.endswith("returns them here")


@pytest.mark.parametrize(
    "line",
    [
        "x, y, z = self.pose()",
        "x, *others = self.pose()",
        "pose = self.pose()",
        "x, y = self.some()",
        "x, y = self.several()",
        "x, y = self.each()",
        "x, y = self.pose()[:2]",
        "a, b = split('ab')",
        "a, b = self.arm.ends()",
        "a, b, c = self.arms.ends()",
        "try:\n            x, y = self.pose()\n        except ValueError:\n            pass",
    ],
)
def test_as_many_variables_or_perhaps_as_many(judge: Judge, line: str):
    judge("API001", _node(line))


@pytest.mark.parametrize(
    ("source", "name"),
    [
        (_node("self.timer.cancel  # here"), "self.timer.cancel"),
        (_node("self.pose  # here"), "self.pose"),
        (_node(end="node.destroy_node  # here"), "node.destroy_node"),
        (_node(end="rclpy.shutdown  # here"), "rclpy.shutdown"),
        (_node(guard="main  # here"), "main"),
    ],
)
def test_a_line_that_calls_nothing(judge: Judge, source: str, name: str):
    (finding,) = judge("API001", source)
    assert finding.message == f"this line does not call {name}(): without parentheses it does nothing"
    assert finding.severity is Severity.WARNING


@pytest.mark.parametrize(
    "line", ["self.place", "self.callback", "self.timer.cancel()", "self.timer.clock", "Driver", "self.on_pose"]
)
def test_a_line_that_may_do_something(judge: Judge, line: str):
    """A property runs code; a class or a value is looked at by whoever tries things out, and what is called with a
    message is named so that it is used."""
    judge("API001", _node(line))


@pytest.mark.parametrize("test", ["self.pose == False", "self.pose is True", "not (self.pose != True)"])
def test_a_method_that_is_compared_with_true_or_false(judge: Judge, test: str):
    (finding,) = judge("API001", _node(f"print({test})  # here"))
    assert finding.message == "this line does not call pose(): the method itself is neither True nor False"
    assert finding.help == "write self.pose()"


@pytest.mark.parametrize(
    "line",
    [
        "print(self.pose() == False)",
        "print(self.place == False)",
        "print(self.callback == False)",
        "print(self.pose == other)",
        "print(self.pose is None)",
        "self.pose = self.pose() == 3\n        print(self.pose == True)",
    ],
)
def test_what_may_be_true_or_false(judge: Judge, line: str):
    """A property, an attribute that is set, and one that takes the place of the method."""
    judge("API001", _node(line))


@pytest.mark.parametrize(
    ("lines", "advice"),
    [
        (
            "if not self.pose():\n            return\n        print(self.pose == False)  # here",
            "keep what the call of pose() above returns and compare that, or remove the check: another call may act",
        ),
        (
            "print(self.switch == False)  # here\n        self.pose()",
            "call it with the arguments that are meant, self.switch(…), or remove the check",
        ),
    ],
)
def test_a_method_that_must_not_be_called_there(judge: Judge, lines: str, advice: str):
    """It was called already, or its defaults do something that nobody has asked for."""
    source = _node(lines).replace(
        "    def pose(self)", "    def switch(self, on=False):\n        return on\n\n    def pose(self)"
    )
    (finding,) = judge("API001", source)
    assert finding.help == advice


TESTS = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = self.create_client(Trigger, 'ask')
        self.future = None
        self.ready = False
        self.timer = self.create_timer(1.0, self.tick)

    def is_ready(self):
        return self.ready

    def may_go(self, place):
        return place in self.places

    @property
    def places(self):
        return ['kitchen']

    def replaced(self):
        pass

    def tick(self):
        self.future = self.client.call_async(Trigger.Request())
        asked = self.client.call_async(Trigger.Request())
        {line}
            self.get_logger().info('yes')


class Other(Asker):
    replaced = None


def main():
    rclpy.init()
    node = Asker()
    while rclpy.ok():
        rclpy.spin_once(node)


main()
"""


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("while rclpy.ok:  # here", "write rclpy.ok()"),
        ("if self.is_ready:  # here", "write self.is_ready()"),
        ("if self.ready and not self.is_ready:  # here", "write self.is_ready()"),
        ("if self.may_go:  # here", "write self.may_go(…)"),
        ("if self.client.service_is_ready:  # here", "write self.client.service_is_ready()"),
        ("while not self.client.wait_for_service:  # here", "write self.client.wait_for_service()"),
        ("if asked.done:  # here", "go on in a done callback: asked.add_done_callback(…)"),
        ("while not asked.done:  # here", "write asked.done()"),
        ("if self.future.done:  # here", "write self.future.done()"),
    ],
)
def test_a_function_for_whose_truth_a_condition_asks(judge: Judge, line: str, help: str):
    (finding,) = judge("API001", TESTS.format(line=line))
    assert finding.message.startswith("this condition does not call ")
    assert finding.message.endswith("(): the function itself is always true")
    assert finding.help == help


@pytest.mark.parametrize(
    "line",
    [
        "if self.ready and self.is_ready() and asked.done():",
        "if self.places:",
        "if self.replaced:",
        "if self.other.done:",
        "if self.may_go and self.may_go('kitchen'):",
        "if (ask := self.is_ready) is not None:",
    ],
)
def test_a_condition_that_asks_for_a_value(judge: Judge, line: str):
    """Values, properties, what a derived class sets to None, and what is called as soon as it is there."""
    judge("API001", TESTS.format(line=line))


LOOK_UP = """
import rclpy
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener


class Looker(Node):
    def __init__(self):
        super().__init__('looker')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.timer = self.create_timer(1.0, self.tick)

    def {method}(self, to, of):
        return None

    def tick(self):
        {line}
            self.get_logger().info('waiting')


def main():
    rclpy.init()
    rclpy.spin(Looker())


main()
"""


@pytest.mark.parametrize("word", ["while not", "if"])
def test_a_look_up_that_never_gives_nothing(judge: Judge, word: str):
    line = f"{word} self.buffer.lookup_transform('map', 'base', Time()):  # here"
    (finding,) = judge("API001", LOOK_UP.format(method="other", line=line))
    assert finding.message == (
        "lookup_transform() gives a transform or raises a TransformException: this condition asks in vain"
    )


@pytest.mark.parametrize(
    ("method", "line"),
    [
        ("other", "if self.buffer.can_transform('map', 'base', Time()):"),
        ("lookup_transform", "while not self.lookup_transform('map', 'base'):"),
        ("lookup_transform", "while not self.buffer.lookup_transform('map', 'base', Time()):"),
    ],
)
def test_a_look_up_that_may_give_nothing(judge: Judge, method: str, line: str):
    """A method of the workspace's own by that name may return anything, and be anyone's."""
    judge("API001", LOOK_UP.format(method=method, line=line))
