"""API001: calls of the workspace's own functions, methods and classes."""

from __future__ import annotations

import pytest

from archlint.finding import Finding, Severity
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


def mix(first, second=0, *, loud=False):
    return first + second


def log(text, *values, **options):
    print(text, values, options)


class Point:
    def __init__(self, x, y=0.0):
        self.x = x


class Arm:
    def __init__(self, limit_of_near=0.1, limit_of_far=0.9):
        self.limits = limit_of_near, limit_of_far


class Gripper:
    def __init__(self, node):
        self.node = node


class Base(Node):
    def stop(self, hard):
        pass


class Motor(Base):
    def __init__(self):
        super().__init__('motor')
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
{body}

    def drive(self, speed, turn=0.0):
        pass

    def replaced(self):
        pass

    @staticmethod
    def check(value):
        pass

    @cached
    def known(self):
        pass
"""


def _node(*lines: str) -> str:
    return NODE.format(body="\n".join(f"        {line}" for line in lines))


@pytest.mark.parametrize(
    ("line", "what", "help"),
    [
        ("mix()", "mix() fails: 'first' is missing", "give what it takes: mix(first)"),
        (
            "mix(1, 2, 3)",
            "mix() fails: it takes at most 2 arguments by position",
            "give what it takes: mix(first, second)",
        ),
        ("mix(1, quiet=True)", "mix() fails: it has no parameter 'quiet'", "take out quiet="),
        (
            "mix(quiet=True)",
            "mix() fails: it has no parameter 'quiet', and 'first' is missing",
            "give what it takes: mix(first)",
        ),
        ("mix(frist=1)", "mix() fails: it has no parameter 'frist'", "write first= instead of frist="),
        ("mix(1, lowd=True)", "mix() fails: it has no parameter 'lowd'", "write loud= instead of lowd="),
        (
            "Arm(near_limit=1.0, far_limit=2.0)",
            "Arm() fails: it has no parameters 'near_limit' and 'far_limit'",
            "write limit_of_near= instead of near_limit=, and limit_of_far= instead of far_limit=",
        ),
        ("Arm(limit=1.0)", "Arm() fails: it has no parameter 'limit'", "take out limit="),
        ("Gripper()", "Gripper() fails: 'node' is missing", "write Gripper(self)"),
        ("mix(1, first=2)", "mix() fails: 'first' is given by position and by name", "give what it takes: mix(first)"),
        ("log()", "log() fails: 'text' is missing", "give what it takes: log(text)"),
        (
            "Point(1.0, 2.0, 3.0)",
            "Point() fails: it takes at most 2 arguments by position",
            "give what it takes: Point(x, y)",
        ),
        ("self.drive()", "drive() fails: 'speed' is missing", "give what it takes: self.drive(speed)"),
        (
            "self.drive(self, 1.0, 0.5)",
            "drive() fails: it takes at most 2 arguments by position",
            "give what it takes: self.drive(speed, turn)",
        ),
        ("self.stop()", "stop() fails: 'hard' is missing", "give what it takes: self.stop(hard)"),
        (
            "self.check(1, 2)",
            "check() fails: it takes at most 1 argument by position",
            "give what it takes: self.check(value)",
        ),
    ],
)
def test_arguments_that_a_function_does_not_take(judge: Judge, line: str, what: str, help: str) -> None:
    (finding,) = judge("API001", _node(f"{line}  # here"))
    assert (finding.message, finding.help) == (what, help)
    assert [place.message for place in finding.related] == [f"{what.partition(' ')[0]} is defined here"]


def test_a_main_function_that_takes_the_words_of_the_command_line(judge: Judge) -> None:
    code = "{}\n\nif __name__ == '__main__':\n    main()  # here\n"
    (finding,) = judge("API001", code.format("import rclpy\n\ndef main(args):\n    rclpy.init(args=args)\n"))
    assert finding.help == "write main(sys.argv), or give it a default: def main(args=None)"
    (finding,) = judge("API001", code.format("import rclpy\n\ndef main(node):\n    print(node)\n"))
    assert finding.help == "give what it takes: main(node)"


@pytest.mark.parametrize(
    "line",
    [
        "mix(1, 2, loud=True)",
        "mix(*[1])",
        "mix(**{'first': 1})",
        "log('a', 1, 2, three=3)",
        "Point(x=1.0)",
        "self.drive(1.0, turn=0.5)",
        "self.check(1)",
        "self.known(1, 2)",
        "self.replaced(1)",
        "redefined(1)",
        "try:\n            mix()\n        except TypeError:\n            pass",
        "(lambda mix: mix())(print)",
    ],
)
def test_arguments_that_fit_or_are_not_known(judge: Judge, line: str) -> None:
    more = "\n\ndef redefined(): ...\n\n\ndef redefined(a): ...\n\n\nMotor.replaced = print\n"
    judge("API001", _node(line) + more)


def test_a_method_without_self(judge: Judge) -> None:
    (finding,) = judge("API001", _node("self.turn(0.5)  # here") + "\n    def turn(angle):\n        pass\n")
    assert finding.message == "turn() fails: it is a method without self, and it takes no argument"
    assert finding.help == "define it with self first: def turn(self, …)"


def test_a_function_of_another_file(judge: Judge) -> None:
    source = "from node1 import rotate\n" + _node("rotate()  # here", "rotate(1)")
    judge("API001", source, "def rotate(angle): ...\n")


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("words.rotate()", "rotate() fails: 'angle' is missing"),
        ("words.Arm(1, 2)", "Arm() fails: it takes at most 1 argument by position"),
        (
            "x, y, z = words.pose()",
            "pose() returns 2 values, and there are 3 variables for them: this line raises ValueError",
        ),
    ],
)
@pytest.mark.parametrize("how", ["import node1 as words", "from . import node1 as words"])
def test_what_is_in_a_module(judge: Judge, how: str, line: str, says: str) -> None:
    (finding,) = judge("API001", f"{how}\n{_node(f'{line}  # here')}", WORDS)
    assert finding.message == says


@pytest.mark.parametrize(
    "line",
    [
        "words.rotate(1)",
        "words.Arm(1)",
        "x, y = words.pose()",
        "words.either(1)",
        "words.absent(1)",
        "words.set_later(1)",
    ],
)
def test_what_is_in_a_module_and_fits_or_is_not_known(judge: Judge, line: str) -> None:
    judge("API001", f"import node1 as words\n{_node(line)}", WORDS)


def test_a_name_that_is_also_something_else_than_a_module(judge: Judge) -> None:
    judge("API001", f"import node1 as words\n{_node('words = self', 'words.rotate()')}", WORDS)
    judge("API001", f"import node1\nwords = node1\n{_node('words.rotate()')}", WORDS)


WORDS = """
def rotate(angle):
    pass


def pose():
    return 1.0, 2.0


class Arm:
    def __init__(self, length):
        self.length = length


try:
    from fast import either
except ImportError:
    def either():
        pass


def set_later():
    pass


def replace(module):
    module.set_later = print
"""


def test_a_method_that_a_derived_class_replaces(judge: Judge) -> None:
    derived = "\n\nclass Fast(Motor):\n    def drive(self):\n        pass\n"
    judge("API001", _node("self.drive()") + derived)


def test_calls_that_are_wrong_in_the_same_way(judge: Judge) -> None:
    findings: list[Finding] = judge("API001", _node("mix()  # here", "mix()"))
    assert findings[0].message.endswith("; another call in this file fails in the same way")


@pytest.mark.parametrize(
    "line",
    [
        "super.__init__('stopper')  # here",
        "super.__init__(self, 'stopper')  # here",
        "super().__init__('stopper')",
        "super(Stopper, self).__init__('stopper')",
        "super.__init__(super(Stopper, self), 'stopper')",
        "print(super.__init__)",
        "try:\n            super.__init__('stopper')\n        except TypeError:\n            pass",
    ],
)
def test_super_without_its_parentheses(judge: Judge, line: str) -> None:
    stopper = f"""

class Stopper(Node):
    def __init__(self):
        {line}


rclpy.init()
Stopper()
"""
    for finding in judge("API001", _node("pass") + stopper):
        assert finding.message == "super.__init__() fails: super lacks its parentheses"


WITHOUT_SELF = """
import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class Talker(Node):
    def __init__(self, name, **options):
        super().__init__(name, **options)
        self.listener = TransformListener(Buffer(), self)


class Robot(Talker):
    def __init__(self, name, other=None, *more):
        {line}
        self.rate = self.has_parameter('rate')


rclpy.init()
Robot('robot')
"""


@pytest.mark.parametrize(
    "line",
    [
        "Talker.__init__(name)  # here",
        "Talker.__init__('talker', use_global_arguments=False)  # here",
        "if more:\n            Talker.__init__(name)  # here",
        "Talker.__init__(self, name)",
        "super().__init__(name)",
        "super(Robot, self).__init__(name)",
        "Talker.__init__(*(self, name))",
        "Talker.__init__(name=name, self=self)",
        "me = self\n        Talker.__init__(me, name)",
        "try:\n            Talker.__init__(name)\n        except TypeError:\n            super().__init__(name)",
    ],
)
def test_a_constructor_of_a_base_without_self(judge: Judge, line: str) -> None:
    code = WITHOUT_SELF.replace("{line}", line)
    for finding in judge("API001", code):
        assert finding.message == "Talker.__init__() fails: 'self' is missing"
        assert finding.help == "pass the object first: Talker.__init__(self, …)"


CONSTRUCTING = """
import rclpy
from rclpy.node import Node


class Wheel{bases}:
    def {name}(self, radius):
        self.radius = radius


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.wheel = Wheel(0.1)  {mark}


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""


@pytest.mark.parametrize("name", ["_init_", "__init_", "_init__", "__int__"])
def test_a_constructor_whose_name_is_misspelt(judge: Judge, name: str):
    (finding,) = judge("API001", CONSTRUCTING.format(name=name, bases="", mark="# here"))
    assert finding.message == f"Wheel() fails: it takes no argument, as {name}() is no constructor"
    assert finding.help == f"rename {name}() to __init__()"


def test_a_class_without_a_constructor(judge: Judge):
    (finding,) = judge("API001", CONSTRUCTING.format(name="turn", bases="", mark="# here"))
    assert finding.message == "Wheel() fails: it takes no argument"


@pytest.mark.parametrize("bases", ["(dict)", "(metaclass=Made)", "(Exception)"])
def test_a_class_whose_constructor_may_be_elsewhere(judge: Judge, bases: str):
    judge("API001", CONSTRUCTING.format(name="turn", bases=bases, mark=""))


def test_a_node_whose_constructor_has_an_underscore_less(judge: Judge):
    (finding,) = judge(
        "API001",
        """
        import rclpy
        from rclpy.node import Node


        class Robot(Node):
            def __init_(self):
                super().__init__('robot')


        def main():
            rclpy.init()
            rclpy.spin(Robot())  # here


        main()
        """,
    )
    assert finding.help == "rename __init_() to __init__()"


SWITCHED = """
import rclpy

FAST = {value}


def mix(first): ...


def start():
    if FAST:
        mix(1)
    else:
        mix()  # here


{more}
start()
"""


@pytest.mark.parametrize(
    ("value", "more", "told"),
    [
        ("True", "", False),
        ("False", "", True),
        ("1 > 0", "", True),
        ("True", "FAST = False", True),
        ("True", "def slow():\n    global FAST\n    FAST = False", True),
        ("True", "if FAST and rclpy.ok():\n    mix(1)", False),
    ],
)
def test_a_branch_that_a_constant_of_the_module_switches_off(judge: Judge, value: str, more: str, told: bool) -> None:
    source = SWITCHED.format(value=value, more=more)
    judge("API001", source if told else source.replace("  # here", ""))


@pytest.mark.parametrize(
    ("test", "told"),
    [("not FAST", False), ("FAST", True), ("FAST or rclpy.ok()", True), ("rclpy.ok() and not FAST", False)],
)
def test_what_a_constant_decides(judge: Judge, test: str, told: bool) -> None:
    source = SWITCHED.format(value="True", more="").replace("if FAST", f"if not ({test})")
    judge("API001", source if told else source.replace("  # here", ""))


def test_a_constant_that_another_file_sets(judge: Judge) -> None:
    (finding,) = judge(
        "API001", SWITCHED.format(value="True", more=""), "import rclpy\nimport node\nnode.FAST = False\n"
    )
    assert finding.severity is Severity.ERROR


OBJECTS = """
import rclpy
from rclpy.node import Node


class Wheel:
    def __init__(self, radius):
        self.radius = radius

    def turn(self, angle, fast=False):
        pass

    def brake(self):
        pass


class Motor(Node):
    def __init__(self):
        super().__init__('motor')
        self.wheel = Wheel(0.1)
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        wheel = Wheel(0.2)
        {in_method}

    def other(self, wheel):
        front = Wheel(0.3)
        front = wheel
        front.turn()
        wheel.turn()
        self.wheel.brake = print
        self.wheel.brake(1)

    def destroy_node(self, message):
        self.get_logger().info(message)
        super().destroy_node()


def main():
    rclpy.init()
    node = Motor()
    try:
        rclpy.spin(node)
    finally:
        {in_main}


main()
"""


@pytest.mark.parametrize(
    ("in_method", "in_main", "what", "help"),
    [
        ("self.wheel.turn()  # here", "pass", "turn() fails: 'angle' is missing", "self.wheel.turn(angle)"),
        ("wheel.turn()  # here", "pass", "turn() fails: 'angle' is missing", "wheel.turn(angle)"),
        (
            "wheel.turn(1.0, False, 2)  # here",
            "pass",
            "turn() fails: it takes at most 2 arguments by position",
            "wheel.turn(angle, fast)",
        ),
        (
            "pass",
            "node.destroy_node()  # here",
            "destroy_node() fails: 'message' is missing",
            "node.destroy_node(message)",
        ),
    ],
)
def test_arguments_that_a_method_of_an_object_does_not_take(
    judge: Judge, in_method: str, in_main: str, what: str, help: str
) -> None:
    (finding,) = judge("API001", OBJECTS.format(in_method=in_method, in_main=in_main))
    assert (finding.message, finding.help) == (what, f"give what it takes: {help}")


@pytest.mark.parametrize(
    "line",
    [
        "wheel.turn(1.0, fast=True)",
        "self.wheel.brake(1)",
        "wheel.turn(*[])",
        "wheel = self.get_parameter('wheel').value\n        wheel.turn()",
        "try:\n            wheel.turn()\n        except TypeError:\n            pass",
    ],
)
def test_arguments_that_fit_a_method_of_an_object_or_of_one_that_is_not_known(judge: Judge, line: str) -> None:
    judge("API001", OBJECTS.format(in_method=line, in_main="node.destroy_node('end')"))
