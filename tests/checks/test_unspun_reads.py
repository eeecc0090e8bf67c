"""API002 and TMO003: what a program reads of a node before any callback has run."""

from __future__ import annotations

import pytest

from checks.judging import Judge

LAMP = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import SetBool


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.client = self.create_client(SetBool, 'switch')
        self.create_subscription(Bool, 'dark', self.on_dark, 10)

    def on_dark(self, msg):
        self.switch(msg.data)

    def switch(self, on):
        self.answer = self.client.call_async(SetBool.Request(data=on))

    def describe(self):
        return 'a lamp'


def main():
    rclpy.init()
    lamp = Lamp()
    {line}
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""
SPIN = "rclpy.spin_until_future_complete(lamp, lamp.answer)"
LIMIT = SPIN.replace(")", ", timeout_sec=2.0)")


def lines(*several: str) -> str:
    return LAMP.replace("{line}", "\n    ".join(several))


def test_a_future_that_a_callback_sends_for(judge: Judge):
    (told,) = judge("API002", lines(f"{SPIN}  # here"))
    assert told.message == (
        "only switch() assigns lamp.answer, and nothing has spun lamp yet: this line fails with an AttributeError"
    )
    assert told.help == "spin lamp until switch() has run, or assign self.answer in __init__()"
    assert [row.place.line for row in told.related] == [17]
    judge("TMO003", lines(SPIN))  # it never comes to spin


@pytest.mark.parametrize(
    "before",
    [
        ("print(lamp.describe())", "lamp.get_logger().info('on')"),
        ("print('a line that is about something else')",),
    ],
)
def test_what_runs_no_callback_changes_nothing(judge: Judge, before: tuple[str, ...]):
    judge("API002", lines(*before, "print(lamp.answer.done())  # here"))
    judge("API002", lines(*before, "while not lamp.answer.done():  # here", "    pass"))


@pytest.mark.parametrize(
    "several",
    [
        ("lamp.switch(True)", LIMIT),
        ("lamp.on_dark(Bool())", LIMIT),
        ("rclpy.spin_once(lamp)", LIMIT),
        ("switched_on(lamp)", LIMIT),
        ("lamp.answer = None", LIMIT),
        ("print(hasattr(lamp, 'answer') and lamp.answer)",),
        ("print(rclpy.ok() and lamp.answer)",),
        ("try:", f"    {LIMIT}", "except AttributeError:", "    print('not yet')"),
        ("if rclpy.ok():", "    lamp.switch(True)", LIMIT),
        ("later = lambda: lamp.answer", "rclpy.spin(lamp)"),
    ],
    ids=[
        *("called", "the callback is called", "spun", "given away", "assigned", "asked for", "perhaps", "tried"),
        *("called in a branch", "later"),
    ],
)
def test_what_may_have_a_value_by_then(judge: Judge, several: tuple[str, ...]):
    judge("API002", lines(*several))


def test_a_future_that_the_program_has_sent_for_is_waited_for(judge: Judge):
    judge("TMO003", lines("lamp.switch(True)", f"{SPIN}  # here"))
