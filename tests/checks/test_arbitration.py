"""OWN001 where publishers of one topic do not speak at once."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

TWO_DRIVERS = """
    import rclpy
    from geometry_msgs.msg import Twist, Vector3
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Bool, String
    from std_srvs.srv import SetBool

    FAST = Twist(linear=Vector3(x=1.0))


    class Pad(Node):
        def __init__(self):
            super().__init__('pad')
            self.drives = True
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
            self.create_timer(0.1, self.tick)
            {pad_hears}

        def on_word(self, msg):
            self.drives = msg.data == 'pad'

        def on_switch(self, request, response):
            self.drives = request.data
            self.pub.publish(Twist())
            return response

        def tick(self):
            {pad_asks}
            self.drive()

        def drive(self):
            self.pub.publish(FAST)


    class Web(Node):
        def __init__(self):
            super().__init__('web')
            self.drives = False
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)  # here
            self.create_timer(0.1, self.tick)
            {web_hears}

        def on_word(self, msg):
            if msg.data == 'web':
                self.drives = True
            else:
                self.drives = False

        def on_web_switch(self, request, response):
            self.drives = request.data
            return response

        def tick(self):
            {web_asks}


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        for node in (Pad(), Web()):
            executor.add_node(node)
        executor.spin()


    if __name__ == '__main__':
        main()
"""
HEARS = "self.create_subscription(String, '{}', self.on_word, 10)"
TURNED_ON = "self.create_service(SetBool, '~/enable', self.{})"
GIVES = "self.words = self.create_publisher(String, 'turn', 10)"
ASKS = "if not self.drives: return"
SPEAKS = "self.pub.publish(FAST)"
IF_ASKED = "if self.drives: self.pub.publish(FAST)"


def drivers(pad: tuple[str, str], web: tuple[str, str]) -> str:
    return TWO_DRIVERS.format(pad_hears=pad[0], pad_asks=pad[1], web_hears=web[0], web_asks=web[1])


ONE_TURN = HEARS.format("turn")


@pytest.mark.parametrize(
    ("pad", "web"),
    [
        ((ONE_TURN, ASKS), (ONE_TURN, IF_ASKED)),  # both are told whose turn it is
        ((ONE_TURN, ASKS), (GIVES, SPEAKS)),  # the one tells the other
        (
            (TURNED_ON.format("on_switch"), ASKS),
            (TURNED_ON.format("on_web_switch"), IF_ASKED),
        ),  # somebody turns each on and off
    ],
    ids=["one word", "the other's word", "switches"],
)
def test_publishers_that_take_turns(judge: Judge, pad: tuple[str, str], web: tuple[str, str]):
    judge("OWN001", drivers(pad, web).replace("  # here", ""))


@pytest.mark.parametrize(
    ("pad", "web"),
    [
        (("pass", "pass"), ("pass", SPEAKS)),
        ((ONE_TURN, "pass"), (ONE_TURN, IF_ASKED)),  # the pad is told, and does not ask
        (("pass", ASKS), ("pass", IF_ASKED)),  # nobody tells them
        ((ONE_TURN, ASKS), ("pass", SPEAKS)),  # nobody tells the other one
        ((HEARS.format("one"), ASKS), (HEARS.format("other"), IF_ASKED)),  # two words that do not depend on each other
        ((HEARS.format("emergency_stop"), ASKS), (HEARS.format("emergency_stop"), IF_ASKED)),  # it stops both
    ],
    ids=["nothing", "not asked", "not told", "one alone", "two words", "a stop"],
)
def test_publishers_that_speak_at_once(judge: Judge, pad: tuple[str, str], web: tuple[str, str]):
    [found] = judge("OWN001", drivers(pad, web))
    assert found.severity is Severity.WARNING


def test_a_condition_that_only_chooses_what_is_said(judge: Judge):
    either = "if self.drives: self.pub.publish(FAST)\n            else: self.pub.publish(Twist(angular=None))"
    judge("OWN001", drivers((ONE_TURN, ASKS), (ONE_TURN, either)))
    early = "if self.drives:\n                self.pub.publish(FAST)\n                return\n"
    judge("OWN001", drivers((ONE_TURN, ASKS), (ONE_TURN, f"{early}            self.pub.publish(Twist(angular=None))")))


@pytest.mark.parametrize(
    "asks",
    [
        "if not self.drives:\n                self.pub.publish(Twist())\n                return",
        "if not self.drives:\n                if self.moves: self.pub.publish(Twist())\n                return",
    ],
    ids=["with a stop", "with a stop of what moves"],
)
def test_who_gives_the_turn_away_may_stop(judge: Judge, asks: str):
    judge("OWN001", drivers((ONE_TURN, asks), (GIVES, SPEAKS)).replace("  # here", ""))


@pytest.mark.parametrize(
    "asks",
    [
        "while not self.drives: return",
        "try:\n                if not self.drives: return\n            finally:\n                pass",
        "if not self.drives:\n                print('not my turn')\n                if self.pub: return\n"
        "                else: raise RuntimeError",
    ],
    ids=["in a loop", "in a try", "nested"],
)
def test_a_way_out_counts_wherever_it_stands(judge: Judge, asks: str):
    judge("OWN001", drivers((ONE_TURN, asks), (ONE_TURN, IF_ASKED)).replace("  # here", ""))


ENDING = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
            self.create_timer(0.1, self.drive)

        def drive(self):
            self.pub.publish(Twist())


    class Mission(Node):
        def __init__(self):
            super().__init__('mission')
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)  # here
            {timer}

        def stop(self):
            self.pub.publish(Twist())


    def main():
        rclpy.init()
        driver, mission = Driver(), Mission()
        executor = SingleThreadedExecutor()
        executor.add_node(driver)
        executor.add_node(mission)
        executor.spin()
        mission.stop()


    if __name__ == '__main__':
        main()
"""


def test_a_publisher_that_only_says_stop_as_it_ends(judge: Judge):
    judge("OWN001", ENDING.format(timer="pass").replace("  # here", ""))
    judge("OWN001", ENDING.format(timer="self.create_timer(1.0, self.stop)"))


STOPPING = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Bool


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
            self.create_timer(0.1, lambda: self.pub.publish(Twist()))


    class Guard(Node):
        def __init__(self):
            super().__init__('guard')
            self.near = input()
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10)  # here
            {when}

        def stop(self, msg=None):
            {stop}


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        executor.add_node(Driver())
        executor.add_node(Guard())
        executor.spin()


    if __name__ == '__main__':
        main()
"""
ON_WORD, ON_TIME = "self.create_subscription(Bool, 'near', self.stop, 10)", "self.create_timer(0.1, self.stop)"
ON_TIME_AFTER_A_WORD = "self.create_subscription(Bool, 'near', lambda msg: self.create_timer(0.02, self.stop), 10)"
ZERO = "self.pub.publish(Twist())"


@pytest.mark.parametrize(
    ("when", "stop", "told"),
    [
        (ON_WORD, ZERO, False),
        (ON_WORD, "zero = Twist(); self.pub.publish(zero)", False),
        (ON_TIME, f"if self.near: {ZERO}", False),
        (ON_TIME_AFTER_A_WORD, ZERO, False),
        (ON_TIME, ZERO, True),  # it holds the driver back at all times
        (ON_WORD, "slow = Twist(); slow.linear.x = 0.1; self.pub.publish(slow)", True),
        (ON_WORD, "slow = Twist(); self.fill(slow); self.pub.publish(slow)", True),
        (ON_WORD, f"{ZERO}; self.pub.publish(msg)", True),
    ],
    ids=[
        "a word",
        "a variable",
        "a condition",
        "a timer that a word starts",
        "always",
        "slower",
        "filled elsewhere",
        "and more",
    ],
)
def test_a_publisher_that_only_stops_what_another_moves(judge: Judge, when: str, stop: str, told: bool):
    text = STOPPING.format(when=when, stop=stop)
    judge("OWN001", text if told else text.replace("  # here", ""))


MANAGED = """
    import rclpy
    from lifecycle_msgs.msg import Transition
    from lifecycle_msgs.srv import ChangeState
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.lifecycle import LifecycleNode
    from rclpy.node import Node
    from std_msgs.msg import Float64


    class Search(LifecycleNode):
        def __init__(self):
            super().__init__('search')
            self.pub = self.create_publisher(Float64, 'desired_depth', 10)
            self.create_timer(0.1, lambda: self.pub.publish(Float64()))


    class Approach({approach}):
        def __init__(self):
            super().__init__('approach')
            self.pub = self.create_publisher(Float64, 'desired_depth', 10)  # here
            self.create_timer(0.1, lambda: self.pub.publish(Float64()))


    class Modes(Node):
        def __init__(self):
            super().__init__('modes')
            self.search = self.create_client(ChangeState, 'search/change_state')
            self.create_subscription(Float64, 'distance', self.on_distance, 10)

        def on_distance(self, msg):
            request = ChangeState.Request()
            request.transition.id = Transition.{transition}
            self.search.call_async(request)


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        executor.add_node(Search())
        executor.add_node(Approach())
        executor.add_node(Modes())
        executor.spin()


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("approach", "transition", "told"),
    [
        ("LifecycleNode", "TRANSITION_DEACTIVATE", False),
        ("LifecycleNode", "TRANSITION_ACTIVATE", True),  # both are active in the end
        ("Node", "TRANSITION_DEACTIVATE", True),  # one always is
    ],
)
def test_lifecycle_nodes_that_are_active_in_turn(judge: Judge, approach: str, transition: str, told: bool):
    text = MANAGED.format(approach=approach, transition=transition)
    judge("OWN001", text if told else text.replace("  # here", ""))


KINDS = """
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from {package}.msg import {type}


    class Said(Node):
        def __init__(self, name):
            super().__init__(name)


    class Left(Said):
        def __init__(self):
            super().__init__('left')
            self.pub = self.create_publisher({type}, '{topic}', 10)
            self.create_timer(0.1, self.tick)

        def tick(self):
            self.pub.publish({type}())


    class Right(Said):
        def __init__(self):
            super().__init__('right')
            self.pub = self.create_publisher({type}, '{topic}', 10)  # here
            self.create_timer(0.1, self.tick)

        def tick(self):
            self.pub.publish({type}())


    class Reader(Said):
        def __init__(self):
            super().__init__('reader')
            self.create_subscription({type}, '{heard}', print, 10)


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        for node in (Left(), Right(), Reader()):
            executor.add_node(node)
        executor.spin()


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("type_", "topic", "heard", "severity"),
    [
        (
            "geometry_msgs.Twist",
            "go",
            "other",
            Severity.WARNING,
        ),  # the motors obey, whether their driver is seen or not
        ("std_msgs.Float64", "arm_command", "other", Severity.WARNING),
        ("geometry_msgs.Twist", "debug/cmd_vel", "other", Severity.WARNING),
        ("std_msgs.Float64", "depth", "depth", Severity.WARNING),
        ("std_msgs.Float64", "depth", "other", Severity.WARNING),  # who listens may be written in C++
        ("std_msgs.String", "words", "words", Severity.INFO),
        ("std_msgs.String", "robot_mode", "robot_mode", Severity.WARNING),
        ("sensor_msgs.Image", "debug/lane", "debug/lane", None),
    ],
)
def test_what_is_published(judge: Judge, type_: str, topic: str, heard: str, severity: Severity | None):
    package, _, name = type_.partition(".")
    text = KINDS.format(package=package, type=name, topic=topic, heard=heard)
    found = judge("OWN001", text if severity is not None else text.replace("  # here", ""))
    assert [one.severity for one in found] == ([] if severity is None else [severity])


TWO_TOPICS = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Left(Node):
        def __init__(self):
            super().__init__('left')
            self.arm = self.create_publisher(Twist, 'arm/cmd', 10)
            self.base = self.create_publisher(Twist, 'cmd_vel', 10)
            self.create_timer(0.1, self.tick)

        def tick(self):
            self.arm.publish(Twist())
            self.base.publish(Twist())


    class Right(Node):
        def __init__(self):
            super().__init__('right')
            self.arm = self.create_publisher(Twist, 'arm/cmd', 10)  # here
            self.base = self.create_publisher(Twist, 'cmd_vel', 10)
            self.create_timer(0.1, self.tick)

        def tick(self):
            self.arm.publish(Twist())
            self.base.publish(Twist())


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        for node in (Left(), Right()):
            executor.add_node(node)
        executor.spin()


    if __name__ == '__main__':
        main()
"""


def test_all_that_the_same_nodes_publish_is_one_finding(judge: Judge):
    [found] = judge("OWN001", TWO_TOPICS)

    assert found.message == "/left and /right both publish the topics '/arm/cmd' and '/cmd_vel'"
    assert [row.message for row in found.related] == [
        "/left publishes '/arm/cmd' here",
        "/left publishes '/cmd_vel' here",
        "/right publishes '/cmd_vel' here",
    ]
