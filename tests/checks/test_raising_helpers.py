"""SRV007 and ACT003: a path ends at a helper that always raises."""

from __future__ import annotations

import pytest

from checks.judging import Judge

SOURCE = """
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    def stop(text):
        {stop}


    class Control(Node):
        def __init__(self):
            super().__init__('control')
            self.known = False
            self.create_service(Trigger, 'status', self.status)

        def fail(self, text):
            self.get_logger().error(text)
            {fail}

        def give_up(self, text):
            if text:
                self.fail(text)
            else:
                stop(text)

        def status(self, request, response):
            if not self.known:
                {call}
                return{mark}
            response.success = True
            return response
"""
RAISE = "raise RuntimeError(text)"
BELOW = """
    from node import Control


    class Quiet(Control):
        def fail(self, text):
            self.get_logger().info(text)
"""


def source(call: str, mark: str = "", fail: str = RAISE, stop: str = RAISE) -> str:
    return SOURCE.format(call=call, mark=mark, fail=fail, stop=stop)


@pytest.mark.parametrize("call", ["self.fail('unknown')", "stop('unknown')", "self.give_up('unknown')"])
def test_what_stands_behind_it_is_never_reached(judge: Judge, call: str):
    judge("SRV007", source(call))


@pytest.mark.parametrize(
    ("call", "fail"),
    [
        ("self.fail('unknown')", "if text: raise RuntimeError(text)"),
        ("self.fail('unknown')", "raise NotImplementedError"),  # a subclass is to define it
        ("self.give_up('unknown')", "self.known = True"),
        ("self.on_error = self.fail", RAISE),
        ("self.elsewhere('unknown')", RAISE),
    ],
)
def test_what_may_come_back_does_not_end_the_path(judge: Judge, call: str, fail: str):
    judge("SRV007", source(call, "  # here", fail))


def test_a_subclass_may_come_back(judge: Judge):
    judge("SRV007", source("self.fail('unknown')", "  # here"), BELOW)


def test_a_handler_catches_what_the_helper_raises(judge: Judge):
    caught = (
        "try:\n                    self.fail('unknown')\n                except RuntimeError:\n                    pass"
    )
    judge("SRV007", source(caught, "  # here"))


@pytest.mark.parametrize(("fail", "mark"), [(RAISE, ""), ("self.known = True", "  # here")])
def test_a_goal_is_aborted_where_the_helper_raises(judge: Judge, fail: str, mark: str):
    judge(
        "ACT003",
        f"""
        from example_interfaces.action import Fibonacci
        from rclpy.action import ActionServer
        from rclpy.node import Node


        class Counter(Node):
            def __init__(self):
                super().__init__('counter')
                self.server = ActionServer(self, Fibonacci, 'count', self.count)

            def fail(self, text):
                {fail}

            def count(self, goal_handle):
                if goal_handle.request.order < 1:
                    self.fail('too small')
                    return Fibonacci.Result(){mark}
                goal_handle.succeed()
                return Fibonacci.Result()
        """,
    )
