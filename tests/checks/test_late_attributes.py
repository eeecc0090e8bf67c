"""API002: attributes that one callback assigns and another reads before there is a value."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge
from robot_package import TALKER

NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32
from std_srvs.srv import Trigger


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.speed = None
        self.pub = self.create_publisher(Float32, 'command', 10)
        self.sub = self.create_subscription(Float32, 'height', self.on_height, 10)
        {init}

    def on_height(self, msg):
        self.height = msg.data

{methods}


def main():
    rclpy.init()
    rclpy.spin(Pilot())


main()
"""
TIMER = "self.timer = self.create_timer(0.1, self.steer)"
SECOND = "self.other = self.create_subscription(Float32, 'speed', self.steer, 10)"

SERVICE = "self.srv = self.create_service(Trigger, 'set', self.on_set)"
SETS = ("def on_set(self, request, response):", "    self.goal = 1.0", "    return response")
ASKS = ("def is_ready(self):", "    return self.ready", "ready = False")


def _node(init: str, *lines: str) -> str:
    return NODE.format(init=init, methods="\n".join(f"    {line}" for line in lines))


def test_a_timer_that_reads_what_the_first_message_brings(judge: Judge):
    source = _node(TIMER, "def steer(self):", "    self.pub.publish(Float32(data=self.height))  # here")
    (finding,) = judge("API002", source)
    assert finding.message == (
        "only on_height() assigns self.height: this line fails with an AttributeError if the timer's callback steer() "
        "comes here first"
    )
    assert finding.help == "assign self.height in __init__(), and do without it here until it has a value"
    assert finding.severity is Severity.WARNING
    assert [row.place.line for row in finding.related] == [16]


@pytest.mark.parametrize(
    "lines",
    [
        ("def steer(self, msg):", "    self.pub.publish(Float32(data=msg.data - self.height))  # here"),
        ("def steer(self, msg):", "    if msg.data > 1.0:", "        print(self.height)  # here"),
        ("def steer(self, msg):", "    low = abs(msg.data)", "    if low:", "        print(self.height)  # here"),
        ("def steer(self, msg):", "    self.log(msg)", "", "def log(self, msg):", "    print(self.height)  # here"),
        ("def steer(self, msg):", "    if self.height is None:  # here", "        return"),
        (
            "def steer(self, msg):",
            "    def is_low(value):",
            "        return value < 1.0",
            "    low = [each for each in (msg.data,) if is_low(each)]",
            "    if 0.5 in low:",
            "        print(self.height)  # here",
        ),
    ],
)
def test_a_second_subscription(judge: Judge, lines: tuple[str, ...]):
    judge("API002", _node(SECOND, *lines))


def test_a_condition_about_what_another_message_brings(judge: Judge):
    judge(
        "API002",
        _node(
            f"{TIMER}; {SECOND.replace('steer', 'on_speed')}",
            "def on_speed(self, msg):",
            "    self.speed = msg.data",
            "def steer(self):",
            "    if self.speed is None:",
            "        return",
            "    print(self.speed, self.height)  # here",
        ),
    )


OTHER = """
class Operator:
    def __init__(self, steering):
        self.steering = steering

    def slow_down(self):
        {call}
"""


@pytest.mark.parametrize(
    ("call", "here"),
    [("self.steering.set_limit(1.0)", ""), ("self.set_limit(1.0)", "  # here")],
    ids=["an object that it is given", "a method of its own"],
)
def test_a_method_that_another_file_calls_without_a_word_for_the_module(judge: Judge, call: str, here: str):
    source = _node(
        TIMER,
        "def steer(self):",
        f"    print(self.limit){here}",
        "def set_limit(self, limit):",
        "    self.limit = limit",
    )
    judge("API002", source, OTHER.replace("{call}", call) + "\n    def set_limit(self, limit):\n        pass\n")


def test_the_constructor_itself(judge: Judge):
    (finding,) = judge("API002", _node("self.report()", "def report(self):", "    print(self.height)  # here"))
    assert finding.message.endswith("if its __init__() comes here first")
    assert finding.severity is Severity.ERROR


def test_a_callback_that_assigns_only_afterwards(judge: Judge):
    (finding,) = judge(
        "API002",
        _node(TIMER, "def steer(self):", "    print(self.last)  # here", "    self.last = 1.0", "    print(self.last)"),
    )
    assert finding.message == (
        "steer() reads self.last before anything assigns it: the first time that is an AttributeError"
    )


def test_a_method_that_nothing_calls(judge: Judge):
    (finding,) = judge(
        "API002",
        _node(
            TIMER,
            "def steer(self):",
            "    if rclpy.ok():",
            "        print(self.limit)  # here",
            "def set_limit(self, limit):",
            "    self.limit = limit",
        ),
    )
    assert finding.message == (
        "only set_limit() assigns self.limit, and nothing calls it: this line fails with an AttributeError"
    )
    assert finding.help == "assign self.limit in __init__(), or call or register set_limit()"


@pytest.mark.parametrize(("registers", "told"), [("'a', self.report", 2), ("'a', print", 0)])
def test_what_is_wrong_in_a_method_that_nothing_calls(findings, registers: str, told: int):
    methods = """
    def report(self, message):
        print(self.width)
        print(self.heard)
"""
    timer = f"        self.create_timer(1.0, print); self.create_subscription(String, {registers}, 10)\n"
    talker = TALKER.replace("\ndef main", f"{timer}{methods}\ndef main")
    rows = findings("API002", **{"robot/talker.py": talker})
    assert sum(1 + len(row.related) for row in rows) == told


def test_all_of_a_class_are_one_finding(judge: Judge):
    source = _node(
        f"{TIMER}; {SECOND.replace('steer', 'on_width')}",
        "def on_width(self, msg):",
        "    self.width = msg.data",
        "def steer(self):",
        "    print(self.height, self.width)  # here",
    )
    (finding,) = judge("API002", source)
    assert finding.message.endswith("; another attribute of the class is read too early")


@pytest.mark.parametrize(
    ("init", "lines"),
    [
        ("self.height = 0.0; " + TIMER, ("def steer(self):", "    print(self.height)")),
        (TIMER, ("height = 0.0", "def steer(self):", "    print(self.height)")),
        (TIMER, ("def steer(self):", "    if hasattr(self, 'height'):", "        print(self.height)")),
        (
            TIMER,
            (
                "def steer(self):",
                "    try:",
                "        print(self.height)",
                "    except AttributeError:",
                "        pass",
            ),
        ),
        # a flag that the same message sets, or a method that may ask for it
        (TIMER, ("def steer(self):", "    if self.ready:", "        print(self.height)", "ready = False")),
        (
            TIMER,
            (
                "def steer(self):",
                "    if self.is_ready():",
                "        print(self.height)",
                "def is_ready(self):",
                "    return self.seen",
                "seen = False",
                "def see(self):",
                "    self.seen = True",
            ),
        ),
        # begun by the message, or waiting for it
        ("pass", ("def steer(self):", "    print(self.height)")),
        ("self.other = None", ("def begin(self):", f"    {TIMER}", "def steer(self):", "    print(self.height)")),
        (TIMER, ("def steer(self):", "    self.event.wait()", "    print(self.height)", "event = None")),
        (TIMER, ("def steer(self):", "    while self.speed is None:", "        pass", "    print(self.height)")),
        (
            f"{TIMER}; self.timer.cancel()",
            ("def steer(self):", "    print(self.height)", "def go(self):", "    self.timer.reset()"),
        ),
        (f"{TIMER}; rclpy.spin_once(self)", ("def steer(self):", "    print(self.height)")),
        # assigned on the way
        (TIMER, ("def steer(self):", "    self.on_height(Float32())", "    print(self.height)")),
        (TIMER, ("def steer(self):", "    self.height = 1.0", "    print(self.height)")),
        ("self.on_height(Float32()); " + TIMER, ("def steer(self):", "    print(self.height)")),
        # a request is sent by who knows when
        (f"{SERVICE}; {SECOND}", (*SETS, "def steer(self, msg):", "    print(self.goal)")),
    ],
)
def test_what_is_there_by_then_or_may_be(judge: Judge, init: str, lines: tuple[str, ...]):
    ready = _node(init, *lines).replace("self.height = msg.data", "self.height = msg.data; self.ready = True")
    judge("API002", ready)


def test_attributes_that_others_give_the_node(judge: Judge):
    source = _node(TIMER, "def steer(self):", "    print(self.height)")
    judge("API002", source.replace("rclpy.spin(Pilot())", "pilot = Pilot(); pilot.height = 1.0; rclpy.spin(pilot)"))


def test_a_method_that_the_program_calls(judge: Judge):
    source = _node(TIMER, "def steer(self):", "    print(self.limit)", "def set_limit(self):", "    self.limit = 1.0")
    judge("API002", source.replace("rclpy.spin(Pilot())", "pilot = Pilot(); pilot.set_limit(); rclpy.spin(pilot)"))


def test_a_class_that_derives_from_it(judge: Judge):
    source = _node(TIMER, "def steer(self):", "    print(self.limit)", "def set_limit(self):", "    self.limit = 1.0")
    derived = "class Second(Pilot):\n    def begin(self):\n        self.set_limit()\n\n\ndef main():"
    judge("API002", source.replace("def main():", derived).replace("spin(Pilot", "spin(Second"))


@pytest.mark.parametrize(
    ("loop", "told"),
    [
        ("while rclpy.ok(): time.sleep(0.1)", 0),
        ("while True: time.sleep(0.1)", 0),
        ("while True: break", 1),
        ("while self.busy: time.sleep(0.1)", 1),
    ],
)
def test_callbacks_of_a_constructor_that_never_returns(findings, loop: str, told: int):
    talker = TALKER.replace(
        "\ndef main",
        f"""
        self.busy = False
        self.create_subscription(String, 'left', self.on_left, 10)
        self.create_subscription(String, 'right', self.on_right, 10)
        self.drive()

    def on_left(self, message):
        self.left = message.data

    def on_right(self, message):
        print(self.left)

    def drive(self):
        {loop}

def main""",
    ).replace("import rclpy\n", "import rclpy\nimport time\n", 1)
    assert len(findings("API002", **{"robot/talker.py": talker})) == told


STEERS = """\
def steer(self):
    {first}
    if self.speed != 'slow':
        self.pub.publish(Float32(data=self.height))
"""
CHOOSES = ("def choose(self):", "    self.speed = 'fast' if self.speed else 'slow'")


def test_a_condition_that_holds_with_what_the_constructor_assigns(judge: Judge):
    lines = STEERS.format(first="self.get_logger().info('steers')").splitlines()
    judge("API002", _node(TIMER, *lines[:-1], f"{lines[-1]}  # here", *CHOOSES))


@pytest.mark.parametrize("first", ["self.speed = 'slow' if self.speed is None else 'fast'", "self.choose()"])
def test_a_condition_for_a_state_that_the_callback_has_set_by_then(judge: Judge, first: str):
    judge("API002", _node(TIMER, *STEERS.format(first=first).splitlines(), *CHOOSES))


# ------------------------------------------------------------------------------------- None until a callback has run

EMPTY = """
import math

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.odom = None
        self.cmd: Twist | None = None
        self.start, self.ready = None, False
        self.seen = []
        self.table = {'seen': False}
        self.pub = self.create_publisher(Twist, 'command', 10)
        self.sub = self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.timer = self.create_timer(0.1, self.steer)

    def on_odom(self, msg):
        self.odom, self.cmd, self.ready = msg, Twist(), True
        self.seen.append(msg)
        self.table['seen'] = True
        {odom}

    def steer(self):
        {steer}

    def is_ready(self):
        return self.odom is not None


def main():
    rclpy.init()
    rclpy.spin(Pilot())


main()
"""


def _empty(steer: str, odom: str = "pass") -> str:
    return EMPTY.replace("{steer}", steer.replace("\n", "\n        ")).replace("{odom}", odom)


def test_a_timer_that_uses_what_is_none_before_the_first_message(judge: Judge):
    (finding,) = judge("API002", _empty("print(self.odom.pose.pose.position.x)  # here"))
    assert finding.message == (
        "self.odom is None until on_odom() has run: this line fails with an AttributeError if the timer's callback "
        "steer() comes here first"
    )
    assert finding.help == "do without self.odom here as long as it is None"
    assert finding.severity is Severity.WARNING
    assert [row.place.line for row in finding.related] == [22]


@pytest.mark.parametrize(
    "use",
    [
        "print(self.odom[0])",
        "print(self.odom())",
        "print(self.odom + 1)",
        "print(2.0 * self.odom)",
        "print(-self.odom)",
        "print(self.odom > 1.0)",
        "print(len(self.odom), f'{self.odom}')",
        "print(f'{self.odom:.2f}')",
        "print(math.cos(self.odom))",
        "self.odom += 1.0",
        "self.pub.publish(self.odom)",
        "self.pub.publish(self.cmd)",
        "if self.cmd.linear.x > 1.0:",
    ],
)
def test_what_fails_for_none(judge: Judge, use: str):
    body = "\n    pass" if use.endswith(":") else ""
    (finding,) = judge("API002", _empty(f"{use}  # here{body}"))
    assert ("a TypeError" in finding.message) == (".linear" not in use)


@pytest.mark.parametrize(
    "steer",
    [
        "print(self.odom, f'{self.odom}', '%s' % self.odom, self.odom == 1, str(self.odom), self.odom is None)",
        "if self.odom is not None:\n    print(self.odom.pose)",
        "if self.odom is None:\n    return\nprint(self.odom.pose)",
        "if not self.odom:\n    return\nprint(self.odom.pose)",
        "if not self.ready:\n    return\nprint(self.odom.pose)",
        "if not self.is_ready():\n    return\nprint(self.odom.pose)",
        "if self.cmd is None:\n    return\nprint(self.odom.pose)",
        "if None in (self.odom, self.cmd):\n    return\nprint(self.odom.pose)",
        "if not all(each is not None for each in (self.odom, self.cmd)):\n    return\nprint(self.odom.pose)",
        "print(self.odom.pose if self.odom else 0.0)",
        "print(self.odom and self.odom.pose)",
        "print([self.odom.pose for _ in range(2) if self.odom])",
        "odom = self.odom\nif odom is None:\n    return\nprint(self.odom.pose)",
        "assert self.odom is not None\nprint(self.odom.pose)",
        "try:\n    print(self.odom.pose)\nexcept AttributeError:\n    pass",
        "try:\n    print(self.odom + 1)\nexcept TypeError:\n    pass",
        "try:\n    print(self.odom + 1)\nexcept Exception:\n    pass",
        "try:\n    print(self.odom + 1)\nexcept:\n    pass",
        "self.odom = self.odom or Odometry()\nprint(self.odom.pose)",
        "if self.odom is None:\n    self.odom = Odometry()\nprint(self.odom.pose)",
        "self.odom.__class__",
        "def later():\n    print(self.odom.pose)\nself.later = later",
        "for each in self.seen:\n    print(each, self.odom.pose)",
        "if len(self.seen) > 0:\n    print(self.odom.pose)",
        "if self.table['seen']:\n    print(self.odom.pose)",
    ],
)
def test_what_asks_for_none_or_does_not_mind(judge: Judge, steer: str):
    judge("API002", _empty(steer))


def test_a_callback_that_uses_what_it_assigns_only_afterwards(judge: Judge):
    use = "dt = msg.header.stamp.sec - self.start  # here\n        self.start = msg.header.stamp.sec\n        print(dt)"
    (finding,) = judge("API002", _empty("pass", use))
    assert finding.message == (
        "on_odom() uses self.start before anything but None is assigned: the first time that is a TypeError"
    )
    assert finding.severity is Severity.ERROR


def test_a_first_time_that_is_told_apart(judge: Judge):
    use = "if self.start is None:\n            self.start = 1\n        print(msg.header.stamp.sec - self.start)"
    judge("API002", _empty("pass", use))


@pytest.mark.parametrize("first", ["self.odom = Odometry()", "self.reset()"])
def test_what_the_constructor_fills(judge: Judge, first: str):
    source = _empty("print(self.odom.pose)").replace("self.pub =", f"{first}\n        self.pub =", 1)
    judge(
        "API002",
        source + "\n"
        if "reset" not in first
        else source.replace(
            "    def is_ready(self):", "    def reset(self):\n        self.odom = Odometry()\n\n    def is_ready(self):"
        ),
    )


SPEED = """self.other = self.create_subscription(Float32, 'speed', self.on_speed, 10)

    def on_speed(self, msg):
        {line}"""


@pytest.mark.parametrize(
    ("line", "here"),
    [
        ("self.go = True", "  # here"),
        ("if self.odom is not None:\n            self.go = True", ""),
        ("self.go.append(self.odom)", ""),
    ],
)
def test_a_flag_of_another_message(judge: Judge, line: str, here: str):
    source = _empty(f"if self.go:\n    print(self.odom.pose){here}").replace(
        "from rclpy.node", "from std_msgs.msg import Float32\nfrom rclpy.node"
    )
    timer = "self.timer = self.create_timer(0.1, self.steer)"
    judge("API002", source.replace(timer, f"{timer}\n        self.go = []\n        {SPEED.replace('{line}', line)}"))


def test_what_the_program_gives_the_node(judge: Judge):
    source = _empty("print(self.odom.pose)").replace(
        "    rclpy.spin(Pilot())", "    node = Pilot()\n    node.odom = Odometry()\n    rclpy.spin(node)"
    )
    judge("API002", source)


def test_a_method_called_before_that_waits_for_it(judge: Judge):
    waits = "def look(self):\n        while self.odom is None:\n            pass\n\n    def is_ready(self):"
    judge("API002", _empty("self.look()\nprint(self.odom.pose)").replace("def is_ready(self):", waits))
    asks = "def look(self):\n        self.get_logger().info(str(self.ready))\n\n    def is_ready(self):"
    judge("API002", _empty("self.look()\nprint(self.odom.pose)  # here").replace("def is_ready(self):", asks))
