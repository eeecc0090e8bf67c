"""API001: what a logger of ROS refuses, which takes one text."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy.logging
from rclpy.node import Node
from somewhere import logging_tools


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.log = self.get_logger()
        self.other = logging_tools.Logger('robot')
        self.either = self.get_logger() if self.other else self.other

    def report(self, count, values, error):
        logger = rclpy.logging.get_logger('robot')
        try:
            values.sort()
        except ValueError as e:
            {call}
"""


@pytest.mark.parametrize(
    ("call", "message", "help"),
    [
        (
            "self.get_logger().info('%d of %s', count, values)",
            "info() fails: it takes at most 1 argument by position",
            "put the values into the text: info(f'… {value}')",
        ),
        (
            "self.log.warning('failed', e)",
            "warning() fails: it takes at most 1 argument by position",
            "put the values into the text: warning(f'… {value}')",
        ),
        (
            "self.get_logger().error(self, 'failed')",
            "error() fails: it takes at most 1 argument by position",
            "take self out: error(…)",
        ),
        (
            "logger.error('failed', exc_info=True)",
            "error() fails: it has no parameter 'exc_info'",
            "put traceback.format_exc() into the text",
        ),
        ("logger.fatal()", "fatal() fails: 'message' is missing", "write fatal(message)"),
        (
            "self.get_logger().error(e)",
            "error() fails: 'message' takes a text, not an exception",
            "write error(str(e))",
        ),
        (
            "logger.info(3.5)",
            "info() fails: 'message' takes a text, not the number 3.5",
            "write info(str(…))",
        ),
        (
            "self.log.info([count])",
            "info() fails: 'message' takes a text, not a list",
            "write info(str(…))",
        ),
    ],
)
def test_what_a_logger_refuses(judge: Judge, call: str, message: str, help: str):
    [finding] = judge("API001", NODE.format(call=f"{call}  # here"))
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "call",
    [
        "self.get_logger().info(f'{count} of {values}')",
        "self.get_logger().info('%d of %s' % (count, values))",
        "self.get_logger().info(str(e), throttle_duration_sec=1.0, once=True)",
        "self.get_logger().info(message='failed')",
        "self.get_logger().info(error)",
        "self.get_logger().info(*values)",
        "self.get_logger().debug('%s', e)",
        "self.other.info('%s', e)",
        "self.either.info('%s', e)",
        "logging_tools.get_logger().info('%s', e)",
        "count.info('%s', e)",
        "e = str(e); self.get_logger().error(e)",
    ],
)
def test_what_a_logger_takes_and_what_is_none(judge: Judge, call: str):
    judge("API001", NODE.format(call=call))


def test_calls_that_are_alike_are_one_finding(judge: Judge):
    [finding] = judge(
        "API001",
        """
        from rclpy.node import Node

        class Robot(Node):
            def report(self, value):
                self.get_logger().info('%s', value)  # here
                self.get_logger().info('%d', value)
        """,
    )
    assert finding.message.endswith("; another call in this file fails in the same way")


def test_calls_of_several_levels_are_one_finding(judge: Judge):
    lines = (
        "self.log.info('%d', count)  # here\n            self.log.error('%s', e)\n            self.log.warn('%s', e)"
    )
    (finding,) = judge("API001", NODE.format(call=lines))
    assert finding.message.endswith("; 2 more calls in this file fail in the same way")
    assert [row.message.partition(":")[0] for row in finding.related] == ["error() fails", "warn() fails"]


def test_a_call_that_is_expected_to_be_refused(judge: Judge):
    judge(
        "API001",
        """
        from rclpy.node import Node

        class Robot(Node):
            def report(self, value):
                try:
                    self.get_logger().info('%s', value)
                except TypeError:
                    self.get_logger().info(str(value))
        """,
    )


def test_a_logger_of_the_workspace_s_own(judge: Judge):
    judge(
        "API001",
        """
        import logging
        from rclpy.node import Node

        class Robot(Node):
            def get_logger(self):
                return logging.getLogger('robot')

            def report(self, value):
                self.get_logger().info('%s', value)
        """,
    )


def test_the_loggers_of_a_module_that_is_called_alike(judge: Judge):
    judge(
        "API001",
        """
        import multiprocessing
        import structlog
        from rclpy.node import Node

        class Robot(Node):
            def report(self, value):
                multiprocessing.get_logger().info('%s', value)
                structlog.get_logger().info('%s', value)
        """,
    )


def test_a_text_for_the_node_instead_of_its_logger(judge: Judge):
    [finding] = judge("API001", NODE.format(call="self.get_logger(f'failed: {e}')  # here"))
    assert finding.message == "get_logger() fails: it takes no argument"
    assert finding.help == "write get_logger().info(…)"


@pytest.mark.parametrize(
    "source",
    [
        "from rclpy.logging import get_logger\nlogger = get_logger('robot')\n",
        "import rclpy\nfrom somewhere import Base\n\n\nclass Robot(Base):\n    def report(self):\n"
        "        self.get_logger('robot')\n",
    ],
)
def test_loggers_by_name(judge: Judge, source: str):
    judge("API001", source)
