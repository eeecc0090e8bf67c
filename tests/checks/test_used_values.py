"""API001: None and numbers that code uses as something else."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import random
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.speed = 0.5
        self.name = 'pilot'
        self.latest = None
        self.goal = [0.0, 0.0]
        self.link = None
        self.sub = self.create_subscription(Float32, 'height', self.fly, 10)

    def fly(self, msg):
        {lines}

    def stop(self):
        self.speed = 0.0

    def rest(self):
        if self.speed > 0.0:
            return
        self.speed = 0.1
        return None

    def pose(self):
        if self.speed:
            return 1.0, 2.0
        return None

    def todo(self):
        pass

    def must(self):
        raise NotImplementedError

    def note(self, msg):
        self.latest = msg.data


def main():
    rclpy.init()
    rclpy.spin(Pilot())


main()
"""


def _node(lines: str) -> str:
    return NODE.format(lines=lines.replace("; ", "\n        "))


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        ("x, y = self.stop()  # here", "stop() returns None: this line raises TypeError"),
        ("x = self.rest(); print(x[0])  # here", "rest() returns None: this line raises TypeError"),
        ("print(self.stop().x)  # here", "stop() returns None: this line raises AttributeError"),
        ("for each in self.stop():  # here;     print(each)", "stop() returns None: this line raises TypeError"),
        ("print(self.stop() + 1.0)  # here", "stop() returns None: this line raises TypeError"),
        ("self.pub.publish(self.stop())  # here", "stop() returns None: this line raises TypeError"),
        ("print([each for each in self.stop()])  # here", "stop() returns None: this line raises TypeError"),
        ("way = [1, 2]; for each in random.shuffle(way):  # here;     print(each)", "random.shuffle() returns None: "),
        ("way = [1, 2]; way = random.shuffle(way)  # here; print(way)", "random.shuffle() returns None: "),
        ("way = [2, 1]; self.latest = way.sort()  # here", "way.sort() returns None: that is what this line keeps"),
    ],
)
def test_what_is_none(judge: Judge, lines: str, says: str):
    (finding,) = judge("API001", _node(lines))
    assert finding.message.startswith(says)
    assert finding.severity is Severity.ERROR


def test_a_condition_that_never_holds(judge: Judge):
    (finding,) = judge("API001", _node("if self.rest():  # here;     print('rests')"))
    assert finding.message == "rest() returns None: this condition never holds"
    assert finding.severity is Severity.WARNING
    assert finding.help == "let rest() return a value"
    assert [row.message for row in finding.related] == ["rest() is defined here, and returns nothing"]


@pytest.mark.parametrize(
    "lines",
    [
        "self.stop()",
        "x = self.stop(); print(x)",
        "return self.rest()",
        "x = self.pose(); print(x[0])",
        "x, y = self.pose()",
        "x = self.rest(); print(x[0] if x else 0)",
        "x = self.rest(); if x is not None:;     print(x[0])",
        "if self.todo():;     print('done')",
        "if self.must():;     print('done')",
        "try:;     x, y = self.stop(); except TypeError:;     pass",
        "way = [1]; way.sort(); print(way)",
        "way = sorted([2, 1]); print(way)",
        "way = msg.data; way = way.append(1); print(way)",
        "print([way.append(1) for way in ([], [])])",
        "way = []; _ = way.append(1)",
    ],
)
def test_what_is_a_value_or_not_used(judge: Judge, lines: str):
    judge("API001", _node(lines))


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        ("print('speed ' + self.speed)  # here", "self.speed is a number, and '+' with a text raises TypeError"),
        ("print('at ' + len('abc'))  # here", "this adds a text and a number, which raises TypeError"),
        ("n = 3; print('at ' + n + ' m')  # here", "n is a number, and '+' with a text raises TypeError"),
        ("n = int(msg.data) - 1; print(f'{n}' + n)  # here", "n is a number, and '+' with a text raises TypeError"),
        ("print('at ' + [1.0])  # here", "this adds a text and a list, which raises TypeError"),
    ],
)
def test_a_text_and_what_is_none(judge: Judge, lines: str, says: str):
    (finding,) = judge("API001", _node(lines))
    assert finding.message == says


@pytest.mark.parametrize(
    "lines",
    [
        "print('speed ' + str(self.speed))",
        "print('speed ' + self.name)",
        "print('at ' + self.latest)",
        "print('-' * 3 + '>')",
        "n = 3; n = str(n); print('at ' + n)",
        "for n in 'abc':;     print('at ' + n)",
        "try:;     print('at ' + 3); except TypeError:;     pass",
    ],
)
def test_two_texts(judge: Judge, lines: str):
    judge("API001", _node(lines))


@pytest.mark.parametrize(
    ("code", "lines", "says"),
    [
        ("API002", "print(self.goal.x)  # here", "self.goal is a list: it has no 'x', and this line fails with an "),
        ("API002", "p = (1.0, 2.0); print(p.x)  # here", "p is a tuple: it has no 'x', and this line fails with an "),
        (
            "API002",
            "self.link.send(1)  # here",
            "nothing but None is assigned to self.link: it has no 'send'",
        ),
        ("API001", "print(self.goal(1))  # here", "self.goal is a list: calling it fails with a TypeError"),
        (
            "API001",
            "n = 3; print(n[0])  # here",
            "n is a number: taking an item of it fails with a TypeError",
        ),
    ],
)
def test_a_plain_value_that_is_taken_for_another(judge: Judge, code: str, lines: str, says: str):
    (finding,) = judge(code, _node(lines))
    assert finding.message.startswith(says)


@pytest.mark.parametrize(
    "lines",
    [
        "self.goal.append(1.0); print(self.goal[0], self.speed.is_integer())",
        "if self.link:;     self.link.send(1)",
        "if self.link is None:;     return; self.link.send(1)",
        "if isinstance(self.goal, Float32):;     print(self.goal.data)",
        "print(self.latest.data)",
        "p = None; p = msg; print(p.data)",
        "p = []; p = msg.data; print(p.x)",
        "try:;     print(self.goal.x); except AttributeError:;     pass",
    ],
)
@pytest.mark.parametrize("code", ["API001", "API002"])
def test_a_plain_value_as_what_it_is(judge: Judge, code: str, lines: str):
    judge(code, _node(lines))


def test_an_attribute_that_others_assign(judge: Judge):
    source = _node("print('speed ' + self.speed)")
    judge("API001", source.replace("rclpy.spin(Pilot())", "pilot = Pilot(); pilot.speed = 'fast'; rclpy.spin(pilot)"))


SETTING = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.declare_parameter('rate', 10.0)
        self.set_parameters([{parameter}])
"""


@pytest.mark.parametrize(
    ("parameter", "says"),
    [
        ("Parameter('rate', Parameter.Type.DOUBLE, 10)", "10 is no value of the type DOUBLE"),
        ("rclpy.parameter.Parameter('rate', rclpy.Parameter.Type.STRING, 1.5)", "1.5 is no value of the type STRING"),
        ("Parameter('rate', type_=Parameter.Type.BOOL, value=0)", "0 is no value of the type BOOL"),
        ("Parameter('rate', Parameter.Type.DOUBLE_ARRAY, [1, 2.0])", "[1, 2.0] is no value of the type DOUBLE_ARRAY"),
        ("Parameter('rate', Parameter.Type.INTEGER, [1])", "[1] is no value of the type INTEGER"),
    ],
)
def test_a_parameter_whose_value_has_another_type(judge: Judge, parameter: str, says: str):
    (finding,) = judge("API001", SETTING.format(parameter=f"{parameter}]) #").replace(" #])", "  # here"))
    assert finding.message == f"Parameter() fails with a ValueError: {says}"


@pytest.mark.parametrize(
    "parameter",
    [
        "Parameter('rate', Parameter.Type.DOUBLE, 10.0)",
        "Parameter('rate', Parameter.Type.INTEGER, True)",
        "Parameter('rate', Parameter.Type.STRING_ARRAY, ['a', 'b'])",
        "Parameter('rate', Parameter.Type.DOUBLE_ARRAY, (1.0, self.rate))",
        "Parameter('rate', value=10)",
    ],
)
def test_a_parameter_whose_value_has_its_type(judge: Judge, parameter: str):
    judge("API001", SETTING.format(parameter=parameter))


GUARDED = """
import sys
import rclpy


def main():
    rclpy.init()
    rclpy.spin(rclpy.create_node('talker'))


if __name__ == '__main__':
    if not main():
        sys.exit(1)
"""


def test_the_status_of_a_module_that_an_entry_point_starts_is_nobodys(findings) -> None:
    """The console script calls main() itself; who runs the file gets the status."""
    assert findings("API001", **{"robot/talker.py": GUARDED}) == []
    cmake = "install(PROGRAMS robot/talker.py DESTINATION lib/robot)\n"
    (told,) = findings("API001", **{"setup.py": "", "CMakeLists.txt": cmake, "robot/talker.py": GUARDED})
    assert told.message == "main() returns None: this condition always holds"
    asks = GUARDED.replace("rclpy.init()", "rclpy.init()\n    if not stop():\n        return")
    (told,) = findings("API001", **{"robot/talker.py": asks + "\n\ndef stop():\n    rclpy.shutdown()\n"})
    assert told.message == "stop() returns None: this condition always holds"


# --------------------------------------------------------------------------------- what functions return, looked into

RESULTS = """
import rclpy
from rclpy.node import Node


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.goal = [0.0] * 3
        self.timer = self.create_timer(1.0, self.fly)

    def fly(self):
        {lines}

    def pose(self):
        if self.goal[0]:
            return 1.0, 2.0
        return None, None

    def table(self):
        if self.goal[1]:
            return {'a': 1}

    def names(self):
        names = []
        names.append('a')
        return names

    def way(self):
        return [0.0] * len(self.goal)

    def either(self):
        return (1.0, 2.0) if self.goal[2] else self.goal

    def mixed(self):
        if self.goal[2]:
            return self.timer
        return 1.0, 2.0

    def factor(self):
        return self.timer

    async def later(self):
        return 1.0, 2.0


def length():
    return 3


def main():
    rclpy.init()
    rclpy.spin(Pilot())


main()
"""


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("print(self.pose().x)  # here", "self.pose() returns a tuple: it has no 'x'"),
        ("pose = self.pose()\n        print(pose.x)  # here", "self.pose() returns a tuple: it has no 'x'"),
        ("table = self.table()\n        print(table.a)  # here", "self.table() returns a dict: it has no 'a'"),
        ("self.names().add('b')  # here", "self.names() returns a list: it has no 'add'"),
        ("print(self.way().x)  # here", "self.way() returns a list: it has no 'x'"),
        ("print(length().x)  # here", "length() returns a number: it has no 'x'"),
        ("self.goal.x = 1.0  # here", "self.goal is a list: it has no 'x'"),
        ("goal = [1.0] + [2.0]\n        print(goal.x)  # here", "goal is a list: it has no 'x'"),
    ],
)
def test_an_attribute_of_what_a_function_returns(judge: Judge, lines: str, message: str):
    (finding,) = judge("API002", RESULTS.replace("{lines}", lines))
    assert finding.message == f"{message}, and this line fails with an AttributeError"


@pytest.mark.parametrize(
    "lines",
    [
        "print(self.pose()[0], self.pose().count(1.0), self.names().append('b'), self.table().items())",
        "print(self.either().x, self.mixed().x)",
        "pose = self.pose()\n        if isinstance(pose, tuple):\n            return\n        print(pose.x)",
        "pose = self.pose()\n        print(pose.x if hasattr(pose, 'x') else pose[0])",
        "pose = self.pose()\n        pose = Pilot()\n        print(pose.goal)",
        "try:\n            print(self.pose().x)\n        except AttributeError:\n            pass",
        "goal = self.goal * self.factor()\n        print(goal.x)",
        "goal = [1.0, 2.0] * self.factor()\n        print(goal.x)",
    ],
)
def test_what_such_a_result_has_or_may_have(judge: Judge, lines: str):
    judge("API002", RESULTS.replace("{lines}", lines))


# ----------------------------------------------------------------------------------------- items of an empty list

LISTS = """
import rclpy
from rclpy.node import Node


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.timer = self.create_timer(1.0, self.fly)

    def fly(self):
        way = []
        {lines}


def main():
    rclpy.init()
    rclpy.spin(Pilot())


main()
"""


def _lists(*lines: str) -> str:
    return LISTS.replace("{lines}", "\n        ".join(lines))


@pytest.mark.parametrize(
    "lines",
    [
        ("way[0] = 1.0  # here",),
        ("print(way[-1])  # here",),
        ("count = 3", "way[count] = 1.0  # here", "way.append(1.0)"),
        ("for i in range(3):", "    way[i] = 1.0  # here"),
        ("if way[0] > 1.0:  # here", "    way.append(1.0)"),
        ("if rclpy.ok():", "    way[0] = 1.0  # here", "else:", "    way.append(1.0)"),
        ("return way[0]  # here",),
        ("del way[0]  # here",),
        ("way[0], last = 1.0, 2.0  # here",),
    ],
)
def test_an_item_of_a_list_that_is_empty(judge: Judge, lines: tuple[str, ...]):
    (finding,) = judge("API001", _lists(*lines))
    assert finding.message == "the list way is still empty: an item of it is an IndexError"
    assert [row.place.line for row in finding.related] == [11]


@pytest.mark.parametrize(
    "lines",
    [
        ("way.append(1.0)", "print(way[0])"),
        ("way += [1.0]", "print(way[0])"),
        ("way[:] = [1.0]", "print(way[0])"),
        ("way[0:0] = [1.0]",),
        ("self.fill(way)", "print(way[0])"),
        ("for i in range(3):", "    if i:", "        print(way[i - 1])", "    way.append(i)"),
        ("for i in range(3):", "    for j in range(i):", "        print(way[j])", "    way.append(i)"),
        ("if rclpy.ok():", "    way.append(1.0)", "print(way[0])"),
        ("print(way[0] if rclpy.ok() and len(way) else 0.0)",),
        ("print([way[i] for i in range(0)])",),
        ("last = lambda: way[-1]", "way.append(1.0)"),
        ("try:", "    print(way[0])", "except IndexError:", "    pass"),
        ("try:", "    print(way[0])", "except:", "    pass"),
        ("def fill():", "    way.append(1.0)", "fill()", "print(way[0])"),
        ("way = {}", "way[0] = 1.0"),
        ("way = [1.0]", "way[0] = 1.0"),
    ],
)
def test_an_item_that_may_be_there(judge: Judge, lines: tuple[str, ...]):
    judge("API001", _lists(*lines))


def test_a_list_that_a_function_it_shares_may_fill(judge: Judge):
    judge(
        "API001",
        _lists("self.fill()", "print(way[0])").replace("        way = []", "        global way\n        way = []"),
    )
