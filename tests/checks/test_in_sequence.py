"""OWN001: nodes that are started, or spun, one after the other never publish at once."""

from __future__ import annotations

import pytest

from checks.judging import Judge
from robot_package import TALKER

LAUNCH = """
from launch import LaunchDescription
from launch.actions import RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node

def talker(name, **more):
    return Node(package='robot', executable='talker', name=name, **more)

def then(first, second, event=OnProcessExit):
    return RegisterEventHandler({event}(target_action=first, {on}=[second]))

def generate_launch_description():
    a, b, c = talker('a'{more}), talker('b'), talker('c')
    return LaunchDescription([{actions}])
"""


def launch(actions: str, event: str = "OnProcessExit", on: str = "on_exit", more: str = "") -> dict[str, str]:
    text = LAUNCH.replace(", event=OnProcessExit", "")
    return {"launch/chain.launch.py": text.format(actions=actions, event=event, on=on, more=more)}


@pytest.mark.parametrize(
    "actions",
    [
        "a, then(a, b)",
        "then(a, b), a",
        "a, then(a, b), then(b, c)",
        "then(b, c), then(a, b), a",
    ],
)
def test_what_starts_when_another_node_has_ended(findings, actions: str):
    assert findings("OWN001", **launch(actions), **{"robot/talker.py": TALKER.replace("String", "Bool")}) == []


@pytest.mark.parametrize(
    ("files", "owners"),
    [
        (launch("a, b"), "/a and /b both"),
        (launch("a, b, then(a, b)"), "/a and /b both"),  # it is started at once, too
        (launch("then(a, b), b, a"), "/a and /b both"),
        (launch("a, then(a, b), then(a, c)"), "/b and /c both"),
        (launch("a, then(a, b), c"), "/a, /b and /c all"),
        (launch("a, then(a, b)", more=", respawn=True"), "/a and /b both"),
        (launch("a, then(a, b)", "OnProcessStart", "on_start"), "/a and /b both"),
        (launch("a, then(None, b)"), "/a and /b both"),  # when any process has ended
    ],
)
def test_what_runs_beside_another_node(findings, files: dict[str, str], owners: str):
    (finding,) = findings("OWN001", **files, **{"robot/talker.py": TALKER.replace("String", "Bool")})
    assert finding.message.startswith(owners)


TASKS = """
    import threading

    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Float64


    class Gate(Node):
        def __init__(self):
            super().__init__('gate')
            self.goal = self.create_publisher(Float64, 'goal', 10)
            self.create_timer(1.0, self.tick)
            self.done = False
            {more}

        def tick(self):
            self.goal.publish(Float64())

        def run(self):
            while not self.done:
                rclpy.spin_once(self)


    class Buoy(Node):
        def __init__(self):
            super().__init__('buoy')
            self.goal = self.create_publisher(Float64, 'goal', 10){mark}
            self.create_timer(1.0, self.tick)

        def tick(self):
            self.goal.publish(Float64())


    def main():
        rclpy.init()
{body}


    if __name__ == '__main__':
        main()
"""
IN_SEQUENCE = """
gate = Gate()
try:
    rclpy.spin(gate)
except SystemExit:
    pass
gate.destroy_node()
buoy = Buoy()
rclpy.spin(buoy)
"""
LOOPS_IN_SEQUENCE = """
gate, buoy = Gate(), Buoy()
gate.run()
while rclpy.ok():
    rclpy.spin_once(buoy)
"""
IN_TURN = """
gate, buoy = Gate(), Buoy()
while rclpy.ok():
    rclpy.spin_once(gate)
    rclpy.spin_once(buoy)
"""
TOGETHER = """
executor = SingleThreadedExecutor()
executor.add_node(Gate())
executor.add_node(Buoy())
executor.spin()
"""
ONE_IN_A_THREAD = """
gate, buoy = Gate(), Buoy()
threading.Thread(target=rclpy.spin, args=(gate,)).start()
rclpy.spin(buoy)
"""


def tasks(body: str, mark: str, more: str = "pass") -> str:
    indented = "".join(f"        {line}\n" for line in body.strip().splitlines())
    return TASKS.format(body=indented, mark=mark, more=more)


@pytest.mark.parametrize("body", [IN_SEQUENCE, LOOPS_IN_SEQUENCE])
def test_nodes_that_one_thread_spins_one_after_the_other(judge: Judge, body: str):
    judge("OWN001", tasks(body, ""))


@pytest.mark.parametrize("body", [IN_TURN, TOGETHER, ONE_IN_A_THREAD])
def test_nodes_that_are_spun_side_by_side(judge: Judge, body: str):
    judge("OWN001", tasks(body, "  # here"))


def test_a_node_that_publishes_in_a_thread_of_its_own(judge: Judge):
    judge("OWN001", tasks(LOOPS_IN_SEQUENCE, "  # here", "threading.Thread(target=self.tick).start()"))
