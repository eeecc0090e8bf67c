"""TMO003: loops that ask for a flag between spins which last until ROS is shut down."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import sys
    import threading

    import rclpy
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import Bool

    class Camera(Node):
        def __init__(self):
            super().__init__('camera')
            self.closed = False
            self.over = threading.Event()
            self.create_subscription(Bool, 'close', self.on_close, 10)

        def on_close(self, message):
            self.closed = message.data
            self.over.set()
            {then}

    def main():
        rclpy.init()
        camera = Camera()
        executor = MultiThreadedExecutor()
        executor.add_node(camera)
        running = True
        {loop}
        rclpy.shutdown()

    if __name__ == '__main__':
        main()
"""


def camera(*loop: str, then: str = "pass") -> str:
    return NODE.replace("{loop}", "\n        ".join(loop)).replace("{then}", then)


@pytest.mark.parametrize(
    ("loop", "asked", "help"),
    [
        (
            ("while rclpy.ok() and not camera.closed:", "    executor.spin()  # here"),
            "camera.closed",
            "write spin_once(timeout_sec=0.1), after which the loop asks again",
        ),
        (
            ("while not camera.over.is_set():", "    rclpy.spin(camera)  # here"),
            "camera.over",
            "write rclpy.spin_once(…, timeout_sec=0.1), after which the loop asks again",
        ),
        (
            ("while running:", "    rclpy.spin(camera)  # here"),
            "running",
            "write rclpy.spin_once(…, timeout_sec=0.1), after which the loop asks again",
        ),
    ],
    ids=["an executor", "an event", "a variable"],
)
def test_a_loop_that_never_asks_again(judge: Judge, loop: tuple[str, ...], asked: str, help: str):
    (finding,) = judge("TMO003", camera(*loop))
    assert finding.message.endswith(f" returns only when ROS is shut down: the loop does not ask for {asked} again")
    assert finding.help == help


@pytest.mark.parametrize(
    ("loop", "then"),
    [
        (("while rclpy.ok() and not camera.closed:", "    executor.spin_once(timeout_sec=0.1)"), "pass"),
        (("while rclpy.ok():", "    executor.spin()"), "pass"),
        (("while True:", "    rclpy.spin(camera)"), "pass"),
        (("while running:", "    rclpy.spin(camera)", "    running = False"), "pass"),
        (("while not camera.closed:", "    rclpy.spin(camera)"), "rclpy.shutdown()"),
        (("while not camera.closed:", "    rclpy.spin(camera)"), "self.executor.shutdown()"),
        (("while not camera.closed:", "    rclpy.spin(camera)"), "sys.exit()"),
        (
            (
                "while not camera.closed:",
                "    try:",
                "        rclpy.spin(camera)",
                "    except RuntimeError:",
                "        pass",
            ),
            "pass",
        ),
    ],
    ids=[
        "once",
        "while ROS runs",
        "for ever",
        "the loop ends itself",
        "the callback ends ROS",
        "the callback ends the executor",
        "the callback ends the program",
        "anew after an error",
    ],
)
def test_a_loop_that_asks_again_or_is_left(judge: Judge, loop: tuple[str, ...], then: str):
    judge("TMO003", camera(*loop, then=then))


@pytest.mark.parametrize(
    "loop",
    [
        ("for node in (camera, Camera()):", "    rclpy.spin(node)  # here"),
        ("for node in make():", "    rclpy.spin(node)  # here", "    node.destroy_node()"),
        ("for number, one in enumerate([executor, MultiThreadedExecutor()]):", "    one.spin()  # here"),
    ],
)
def test_a_loop_over_nodes_that_spins_the_first_alone(judge: Judge, loop: tuple[str, ...]):
    (finding,) = judge("TMO003", camera(*loop))
    assert finding.message.endswith("spin() returns only when ROS is shut down: the loop does not come to the next one")
    assert finding.help == "add the nodes to one executor, and spin that"


@pytest.mark.parametrize(
    "loop",
    [
        ("for node in (camera, Camera()):", "    executor.add_node(node)", "executor.spin()"),
        ("for node in (camera, Camera()):", "    rclpy.spin_once(node, timeout_sec=0.1)"),
        ("for node in (camera, Camera()):", "    rclpy.spin(node)", "    break"),
        ("for node in [camera]:", "    rclpy.spin(node)"),
        ("for node in (camera, Camera()):", "    threading.Thread(target=rclpy.spin, args=(node,)).start()"),
        ("for _ in range(3):", "    try:", "        rclpy.spin(camera)", "    except RuntimeError:", "        pass"),
        ("for _ in range(3):", "    rclpy.spin(camera)"),
    ],
)
def test_loops_that_spin_all_or_are_not_over_nodes(judge: Judge, loop: tuple[str, ...]):
    judge("TMO003", camera(*loop))
