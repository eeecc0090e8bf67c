"""OWN001 where one of the publishers says nothing of its own."""

from __future__ import annotations

import pytest

from checks.judging import Judge

HELPER = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Empty


    class Turn(Node):
        def __init__(self):
            super().__init__('turn')
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10){own}

        def turn(self):
            self.pub.publish(Twist())


    class Dock(Node):
        def __init__(self):
            super().__init__('dock')
            self.helper = Turn()
            self.pub = self.create_publisher(Twist, 'cmd_vel', 10){mark}
            self.create_subscription(Empty, 'go', self.on_go, 10)

        def on_go(self, msg):
            self.helper.turn()
            self.pub.publish(Twist(linear=self.fast))


    def main():
        rclpy.init()
        dock = Dock()
        executor = SingleThreadedExecutor()
        executor.add_node(dock)
        executor.add_node(dock.helper)
        executor.spin()


    main()
"""


@pytest.mark.parametrize(
    ("own", "mark"), [("", ""), ("\n            self.create_timer(0.1, self.turn)", "  # here")], ids=["driven", "not"]
)
def test_a_helper_that_another_node_calls(judge: Judge, own: str, mark: str):
    judge("OWN001", HELPER.format(own=own, mark=mark))


REPEATS = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Planner(Node):
        def __init__(self):
            super().__init__('planner')
            self.pub = self.create_publisher(Twist, 'goal', 10)
            self.create_timer(1.0, self.tick)

        def tick(self):
            self.pub.publish(Twist())


    class Keeper(Node):
        def __init__(self):
            super().__init__('keeper')
            self.last = None
            self.pub = self.create_publisher(Twist, 'goal', 10){mark}
            self.create_subscription(Twist, '{heard}', self.on_goal, 10)
            self.create_timer(5.0, self.tick)

        def on_goal(self, msg):
            self.last = {kept}

        def tick(self):
            if self.last is not None:
                self.pub.publish({said})


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        executor.add_node(Planner())
        executor.add_node(Keeper())
        executor.spin()


    main()
"""


@pytest.mark.parametrize(
    ("heard", "kept", "said", "mark"),
    [
        ("goal", "msg", "self.last", ""),
        ("other_goal", "msg", "self.last", "  # here"),
        ("goal", "msg", "Twist(linear=None)", "  # here"),
        ("goal", "Twist()", "self.last", "  # here"),
        ("goal", "msg\n            self.last = Twist()", "self.last", "  # here"),
        ("goal", "msg\n            self.last.linear.x = 0.0", "self.last", "  # here"),
    ],
    ids=[
        "repeats",
        "hears something else",
        "says something else",
        "keeps something else",
        "sets another",
        "changes it",
    ],
)
def test_a_node_that_repeats_what_it_has_heard(judge: Judge, heard: str, kept: str, said: str, mark: str):
    judge("OWN001", REPEATS.format(heard=heard, kept=kept, said=said, mark=mark))
