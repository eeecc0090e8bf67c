"""MSG003: fields of type byte that are compared with numbers."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rclpy.node import Node

OK = 0


class Monitor(Node):
    def __init__(self):
        super().__init__('monitor')
        self.create_subscription(DiagnosticArray, '/diagnostics', self.check, 10)

    def check(self, message: DiagnosticArray):
        for status in message.status:
            if {test}:{mark}
                self.get_logger().warning(status.name)
"""


@pytest.mark.parametrize(
    ("test", "end"),
    [
        ("status.level == 0", "it never equals 0"),
        ("2 != status.level", "it never equals 2"),
        ("status.level in (1, 2)", "it never equals 1"),
        ("status.level > 0", "this line raises TypeError"),
        ("message.status[0].level == 1", "it never equals 1"),
    ],
)
def test_a_byte_is_no_number(judge: Judge, test: str, end: str):
    (finding,) = judge("MSG003", NODE.format(test=test, mark="  # here"))
    assert finding.message == (
        "'level' of diagnostic_msgs/msg/DiagnosticStatus is a byte, which Python has as bytes of length one: " + end
    )
    assert finding.help == "compare it with a constant of the message, or level[0] with the number"


@pytest.mark.parametrize(
    "test",
    [
        "status.level == DiagnosticStatus.OK",
        "status.level != b'\\x00'",
        "status.level[0] > 0",
        "ord(status.level) == 2",
        "int.from_bytes(status.level, 'big') in (1, 2)",
        "len(status.values) == 0",
        "status.name == 'arm'",
    ],
)
def test_a_byte_among_bytes(judge: Judge, test: str):
    judge("MSG003", NODE.format(test=test, mark=""))
