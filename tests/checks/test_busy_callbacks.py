"""EXE012: loops of callbacks whose number of iterations the file says."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image, LaserScan
{extra}

class Planner(Node):
    def __init__(self, count):
        super().__init__('planner')
        self.steps = 20_000_000
        self.count = count
        self.create_timer({period}, self.plan)
        self.create_subscription(Image, 'image', self.on_image, 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)

    def plan(self):
        total = 0
{plan}

    def helper(self):
        total = 0
{helper}

    def on_image(self, msg):
{on_image}

    def on_scan(self, msg):
{on_scan}


def main():
    rclpy.init()
    rclpy.spin(Planner(10))


if __name__ == '__main__':
    main()
"""


def node(period: str = "0.1", extra: str = "", **bodies: str) -> str:
    names = ("plan", "helper", "on_image", "on_scan")
    return NODE.format(
        period=period, extra=extra, **{name: indent(bodies.get(name, "pass"), " " * 8) for name in names}
    )


@pytest.mark.parametrize(
    "plan",
    [
        "for i in range(20_000_000):  # here\n    total += i",
        "for i in range(self.steps):  # here\n    total += i",
        "for i in range(5_000):  # here\n    for j in range(5_000):\n        total += i * j",
        "for i in range(10 ** 7):  # here\n    total = max(total, i * i)",
        "n = 0\nwhile n < 20_000_000:  # here\n    n += 1",
        "total = sum(range(200_000_000))  # here",
        "squares = [x * x for x in range(10_000_000)]  # here",
        "if self.count is None:\n    return\nfor i in range(20_000_000):  # here\n    total += i",
    ],
)
def test_a_loop_that_takes_longer_than_the_period(judge: Judge, plan: str):
    judge("EXE012", node(plan=plan))


def test_the_finding_says_how_long_it_takes_and_how_much_time_there_is(judge: Judge):
    (finding,) = judge("EXE012", node(plan="for i in range(20_000_000):  # here\n    total += i"))
    assert finding.message == (
        "the timer callback, Planner.plan, calculates for at least 0.4 s, in 20,000,000 iterations, and it has 0.1 s "
        "until the next time"
    )


def test_a_loop_in_a_method_that_the_callback_calls(judge: Judge):
    (finding,) = judge(
        "EXE012", node(plan="total = self.helper()", helper="for i in range(20_000_000):  # here\n    total += i")
    )
    assert "in helper()" in finding.message


@pytest.mark.parametrize(
    "plan",
    [
        "for i in range(1_000):\n    total += i",  # fits
        "for i in range(self.count):\n    total += i",  # not known
        "for i in range(20_000_000):\n    if i > total:\n        break",
        "for i in range(20_000_000):\n    if total:\n        return",
        "if self.count is None:\n    for i in range(20_000_000):\n        total += i",  # once, perhaps
        "found = any(x * x == 49 for x in range(100_000_000))",  # ends with the first
        "numbers = range(10 ** 9)",  # nothing is done with it yet
        "def later():\n    for i in range(20_000_000):\n        pass",
        "lazy = (x * x for x in range(100_000_000))",
    ],
)
def test_what_is_short_or_may_be(judge: Judge, plan: str):
    judge("EXE012", node(plan=plan))


def test_a_long_loop_fits_into_a_long_period(judge: Judge):
    judge("EXE012", node(period="10.0", plan="for i in range(20_000_000):\n    total += i"))


def test_without_a_known_period_half_a_second_is_too_long(judge: Judge):
    judge("EXE012", node(on_scan="for i in range(60_000_000):  # here\n    pass"))
    judge("EXE012", node(on_scan="for i in range(10_000_000):\n    pass"))


def test_an_attribute_that_is_set_again_is_not_known(judge: Judge):
    judge(
        "EXE012",
        node(plan="for i in range(self.steps):\n    total += i", on_scan="self.steps = 10"),
    )


@pytest.mark.parametrize(
    "on_image",
    [
        "for y in range(msg.height):  # here\n    for x in range(msg.width):\n        self.count += msg.data[y + x]",
        "h, w = self.image.shape[:2]\nfor x in range(w):  # here\n    for y in range(h):\n        self.image[y, x] = 0",
        "rows = self.image.shape[0]\nfor y in range(rows):  # here\n"
        "    for x in range(self.image.shape[1]):\n        self.image[y, x] = 0",
    ],
)
def test_every_pixel_of_an_image(judge: Judge, on_image: str):
    judge("EXE012", node(on_image=on_image))


@pytest.mark.parametrize(
    "on_image",
    [
        "for y in range(0, msg.height, 10):\n    for x in range(0, msg.width, 10):\n        self.count += y * x",
        "for y in range(msg.height):\n    self.count += y",
        "for y in range(msg.height):\n    for x in range(msg.width):\n        if self.count:\n            return",
        "for y in range(msg.height):\n    for x in range(8):\n        self.count += y * x",
    ],
)
def test_rows_alone_or_few_pixels(judge: Judge, on_image: str):
    judge("EXE012", node(on_image=on_image))
