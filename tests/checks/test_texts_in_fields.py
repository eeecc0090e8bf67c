"""MSG003: texts that come from somewhere and go into fields of numbers, and bytes that go into fields of texts."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import json

import rclpy
import serial
from rclpy.node import Node
from std_msgs.msg import Float32, Int32, String


class Gauge(Node):
    def __init__(self):
        super().__init__('gauge')
        self.port = serial.Serial('/dev/ttyUSB0', 9600)
        self.create_subscription(String, 'raw', self.on_raw, 10)
        self.timer = self.create_timer(1.0, self.tick)

    def on_raw(self, raw):
        level, count, text = Float32(), Int32(), String()
        {on_raw}

    def tick(self):
        level, count, text = Float32(), Int32(), String()
        line = self.port.readline().decode('utf-8').strip()
        {tick}


def main():
    rclpy.init()
    rclpy.spin(Gauge())


main()
"""


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("level.data = raw.data.split(',')[0]", "takes a float, not a string: something else is sent"),
        ("count.data = raw.data.strip()", "takes an int, not a string: sending it fails"),
        ("count.data = raw.data.split()", "takes an int, not a list: sending it fails"),
        ("text.data = raw.data.encode()", "takes a string, not bytes: sending it fails"),
        ("text.data = raw.data.find('a')", "takes a string, not an int: sending it fails"),
    ],
)
def test_what_methods_of_a_text_give(judge: Judge, line: str, says: str) -> None:
    (finding,) = judge("MSG003", NODE.format(on_raw=f"{line}  # here", tick="pass"))
    assert says in finding.message


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("level.data = line", "takes a float, not a string: something else is sent"),
        ("level.data = line.split(';')[1]", "takes a float, not a string: something else is sent"),
        ("count.data = input()", "takes an int, not a string: sending it fails"),
        ("text.data = json.dumps([1]).encode('utf-8')", "takes a string, not bytes: sending it fails"),
    ],
)
def test_a_text_from_outside(judge: Judge, line: str, says: str) -> None:
    (finding,) = judge("MSG003", NODE.format(on_raw="pass", tick=f"{line}  # here"))
    assert says in finding.message


@pytest.mark.parametrize(
    "line",
    [
        "level.data = float(line)",
        "count.data = int(line.split(',')[0])",
        "count.data = line.count(',')",
        "text.data = line",
        "text.data = line.upper().replace('A', 'B')",
        "text.data = ','.join(line.split(';'))",
        "text.data = input()",
        "level.data = self.port.read()",
        "level.data = self.port.decode(line)",
        "text.data = json.dumps([1])",
    ],
)
def test_what_fits_or_is_not_known(judge: Judge, line: str) -> None:
    judge("MSG003", NODE.format(on_raw="pass", tick=line))
