"""EXE003: waits of a timer's callback that are short each, and longer than its period together."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
    import time

    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
    from rclpy.duration import Duration
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from rclpy.time import Time
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger
    from tf2_ros import Buffer, TransformListener


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.base = self.create_client(Trigger, 'base')
            self.arm = self.create_client(Trigger, 'arm')
            self.buffer = Buffer()
            self.stopped = False
            {other}
            self.timer = self.create_timer({period}, self.tick{group})

        def on_stop(self, message):
            self.stopped = True

        def wait_for_arm(self):
            if not self.arm.wait_for_service(timeout_sec=0.8):
                self.get_logger().warning('no arm')

        def tick(self):
            {tick}


    def main():
        rclpy.init()
        node = Robot()
        {main}


    if __name__ == '__main__':
        main()
"""
SUBSCRIBES = "self.create_subscription(Empty, 'stop', self.on_stop, 10)"
THREADS = "executor = MultiThreadedExecutor(); executor.add_node(node); executor.spin()"
HERE = "  # here"


def robot(
    *tick: str, period: float = 1.0, other: str = SUBSCRIBES, main: str = "rclpy.spin(node)", group: str = ""
) -> str:
    return NODE.format(tick="\n            ".join(tick), period=period, other=other, main=main, group=group)


def warns(client: str, seconds: float, mark: str = "") -> str:
    return f"if not self.{client}.wait_for_service(timeout_sec={seconds}):{mark}\n                print('not there')"


def returns(client: str, seconds: float) -> str:
    return f"if not self.{client}.wait_for_service(timeout_sec={seconds}):\n                return"


class TestTogetherTooLong:
    def test_two_servers(self, judge: Judge):
        [finding] = judge("EXE003", robot(warns("base", 0.8, HERE), warns("arm", 0.8)))
        assert finding.message == (
            "the timer callback, Robot.tick, waits for up to 1.6 s in 2 calls one after the other, longer than its "
            "period of 1 s: its next turn is late, and so is every other callback on its thread"
        )
        assert finding.help == "check once without waiting, and try again in the next turn"
        assert finding.related[-1].message == "then it waits in wait_for_service() for up to 0.8 s"
        assert finding.severity == Severity.WARNING

    def test_only_the_timer_itself_is_late(self, judge: Judge):
        [finding] = judge("EXE003", robot(warns("base", 0.8, HERE), warns("arm", 0.8), other="pass"))
        assert finding.severity == Severity.INFO
        assert finding.message.endswith("its next turn is late")

    @pytest.mark.parametrize(
        "source",
        [
            robot(warns("base", 0.8, HERE), "self.wait_for_arm()"),
            robot(warns("base", 0.9, HERE), "time.sleep(0.2)"),
            robot("time.sleep(0.2)  # here", "time.sleep(0.2)", period=0.3),
            robot("if self.stopped:", "    return", warns("base", 0.8, HERE), warns("arm", 0.8)),
        ],
        ids=["in a method", "a wait and a sleep", "two sleeps", "behind a question"],
    )
    def test_other_forms(self, judge: Judge, source: str):
        judge("EXE003", source)

    @pytest.mark.parametrize(
        "source",
        [
            robot(warns("base", 0.4), warns("arm", 0.4)),
            robot(warns("base", 0.5), warns("arm", 0.5)),
            robot(returns("base", 0.8), returns("arm", 0.8)),
            robot("if self.stopped:", "    " + warns("base", 0.8).replace("\n", "\n    "), "else:", "    pass").replace(
                "else:", "else:\n                self.wait_for_arm()"
            ),
            robot(warns("base", 0.8), warns("arm", 0.8), period=2.0),
            robot(
                warns("base", 0.8),
                warns("arm", 0.8),
                main=THREADS,
                group=", callback_group=MutuallyExclusiveCallbackGroup()",
            ),
            robot("self.timer.cancel()", warns("base", 0.8), warns("arm", 0.8)),
            robot("if self.base.service_is_ready():", "    time.sleep(0.2)", "self.wait_for_arm()"),
        ],
        ids=[
            *("in time", "just in time", "the first that fails returns", "one or the other", "a longer period"),
            *("a thread of its own", "once", "on a condition"),
        ],
    )
    def test_in_time(self, judge: Judge, source: str):
        judge("EXE003", source)

    def test_where_one_wait_is_too_long_only_that_is_said(self, judge: Judge):
        [finding] = judge("EXE003", robot(warns("base", 2.0, HERE), warns("arm", 0.8)))
        assert "one after the other" not in finding.message

    def test_transforms_under_several_threads(self, judge: Judge):
        look_up = "self.buffer.lookup_transform('map', 'base', Time(), timeout=Duration(seconds=0.8))"
        listens = "self.listener = TransformListener(self.buffer, self)"
        judge("EXE003", robot(f"{look_up}  # here", warns("arm", 0.8), main=THREADS, other=listens))
        judge("EXE003", robot(look_up, warns("arm", 0.8), other=listens))  # EXE007 says that it cannot come
