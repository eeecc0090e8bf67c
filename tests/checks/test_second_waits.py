"""TMO001: waits for a server that is there by then, and those that a reader lets pass."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.lamp = self.create_client(Trigger, 'light')
        self.door = self.create_client(Trigger, 'open')
        {start}

    def ask(self):
        {ask}
        return self.lamp.call_async(Trigger.Request())


def main():
    rclpy.init()
    lamp = Lamp()
    {rest}


if __name__ == '__main__':
    main()
"""
WAIT = "self.lamp.wait_for_service()"
LOOP = "while not self.lamp.wait_for_service(timeout_sec=1.0):\n            {body}"
SPIN = "lamp.create_timer(1.0, lamp.ask)\n    lamp.ask()\n    rclpy.spin(lamp)"


@pytest.mark.parametrize(
    ("start", "ask"),
    [
        (f"{LOOP.format(body='pass')}\n        {WAIT}", "pass"),
        (LOOP.format(body="self.get_logger().info('no lamp')"), WAIT),
        (f"{WAIT}  # here\n        {WAIT}", "pass"),
        (f"{WAIT}  # here", WAIT),
        (f"{LOOP.format(body='break')}\n        {WAIT}  # here", "pass"),
        (f"self.door.wait_for_service(timeout_sec=1.0)\n        {WAIT}  # here", "pass"),
    ],
)
def test_a_server_that_was_there_before(judge: Judge, start: str, ask: str) -> None:
    """The first wait is over only once the server is there; that of a loop which gives up is not."""
    judge("TMO001", NODE.format(start=start, ask=ask, rest=SPIN))


@pytest.mark.parametrize(("body", "told"), [("self.get_logger().info('no lamp')", False), ("pass", True)])
def test_a_start_in_a_loop_that_tells(judge: Judge, body: str, told: bool) -> None:
    start = f"while not {WAIT}:{'  # here' if told else ''}\n            {body}"
    judge("TMO001", NODE.format(start=start, ask="pass", rest=SPIN))


@pytest.mark.parametrize(
    ("rest", "told"),
    [
        ("answer = lamp.ask()\n    rclpy.spin_until_future_complete(lamp, answer)", False),
        ("for _ in range(2):\n        rclpy.spin_until_future_complete(lamp, lamp.ask())", True),
        ("answer = lamp.ask()\n    rclpy.spin(lamp)", True),
    ],
)
def test_a_program_that_sends_one_request(judge: Judge, rest: str, told: bool) -> None:
    """Whoever starts it in a terminal sees that it waits, and there is nothing else that it could do."""
    judge("TMO001", NODE.format(start=f"{WAIT}{'  # here' if told else ''}", ask="pass", rest=rest))
