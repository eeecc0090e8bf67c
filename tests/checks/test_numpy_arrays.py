"""API001 and API002: arrays of numpy that code takes for messages, or for whose truth it asks."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import cv2
    import numpy as np
    import rclpy
    from cv_bridge import CvBridge
    from rclpy.node import Node
    from sensor_msgs.msg import Image, LaserScan

    class Viewer(Node):
        def __init__(self):
            super().__init__('viewer')
            self.bridge = CvBridge()
            self.picture = None
            self.ranges, self.count = [], 0
            self.depth = self.other = None
            self.gray = np.zeros((48, 64))
            self.one = np.zeros(1)
            self.create_subscription(Image, 'image', self.on_image, 10)
            self.create_subscription(LaserScan, 'scan', self.on_scan, 10)
            self.create_timer(1.0, self.show)

        def on_image(self, message):
            self.picture = self.bridge.imgmsg_to_cv2(message, 'bgr8')
            depth = self.bridge.imgmsg_to_cv2(message)
            self.depth = np.array(depth, dtype=np.uint16)
            self.other = np.array(message.data)

        def on_scan(self, scan):
            self.ranges = np.array(scan.ranges)

        def show(self):
            local = cv2.cvtColor(self.gray, cv2.COLOR_GRAY2BGR)
            if self.picture is None:
                return
            {line}

    def main():
        rclpy.init()
        rclpy.spin(Viewer())

    if __name__ == '__main__':
        main()
"""


def viewer(line: str) -> str:
    return NODE.replace("{line}", line)


MANY = "of many elements, it is neither true nor false, and this line fails with a ValueError"
EACH = "comparing it with None compares each element, and this line fails with a ValueError"


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "if not self.picture: return  # here",
            f"self.picture is an array of numpy: {MANY}",
            "write self.picture is None",
        ),
        (
            "if self.picture and self.count: return  # here",
            f"self.picture is an array of numpy: {MANY}",
            "write self.picture is not None",
        ),
        (
            "if self.picture == None: return  # here",
            f"self.picture is an array of numpy: {EACH}",
            "write self.picture is None",
        ),
        (
            "while self.picture != None: pass  # here",
            f"self.picture is an array of numpy: {EACH}",
            "write self.picture is not None",
        ),
        (
            "if self.ranges: return  # here",
            f"self.ranges is an array of numpy: {MANY}",
            "ask what you mean: self.ranges.any(), .all() or .size",
        ),
        (
            "if not self.depth: return  # here",
            f"self.depth is an array of numpy: {MANY}",
            "write self.depth is None",
        ),
        (
            "print(1 if local else 0)  # here",
            f"local is an array of numpy: {MANY}",
            "ask what you mean: local.any(), .all() or .size",
        ),
    ],
    ids=["not", "and", "equal to None", "not equal to None", "of a list before", "made of a variable", "a variable"],
)
def test_the_truth_of_an_array(judge: Judge, line: str, message: str, help: str):
    (finding,) = judge("API001", viewer(line))
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "line",
    [
        "if self.picture is None: return",
        "if self.picture is not None and self.picture.any(): return",
        "if self.one: return",
        "if self.other: return",
        "if self.count and len(self.ranges): return",
        "picture = self.picture == None",
        "if isinstance(self.picture, list) and self.picture: return",
        "try:\n                if self.picture: return\n            except ValueError:\n                pass",
    ],
    ids=[
        "is None",
        "any",
        "one element",
        "of who knows how many",
        "a number",
        "no test",
        "asked for its class",
        "expected",
    ],
)
def test_what_may_be_asked_of_an_array(judge: Judge, line: str):
    judge("API001", viewer(line))


EACH_OF = "compares each element, of which many are neither true nor false, and this line fails with a ValueError"


@pytest.mark.parametrize(
    ("line", "comparison", "help"),
    [
        pytest.param(
            "near = self.ranges > 0.1 and self.ranges < 0.5",
            ">",
            "put each comparison in parentheses, and join them by &",
        ),
        pytest.param(
            "far = self.ranges < 0.1 or self.ranges > 9.0",
            "<",
            "put each comparison in parentheses, and join them by |",
        ),
        pytest.param("near = 0.1 <= self.ranges < 0.5", "<=", "put each comparison in parentheses, and join them by &"),
        pytest.param(
            "if self.ranges < 0.5: return", "<", "ask what you mean: .any() or .all() of what self.ranges < … gives"
        ),
        pytest.param(
            "if 0.1 < self.ranges < 0.5: return",
            "<",
            "ask what you mean: .any() or .all() of what self.ranges < … gives",
        ),
    ],
    ids=["and", "or", "a chain", "a condition", "a chain as a condition"],
)
def test_the_truth_of_a_comparison(judge: Judge, line: str, comparison: str, help: str):
    (finding,) = judge("API001", viewer(f"{line}  # here"))
    assert finding.message == f"self.ranges is an array of numpy: '{comparison}' {EACH_OF}"
    assert finding.help == help


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("angles = np.linspace(-1.0, 1.0)", True),
        ("angles = np.linspace(-1.0, 1.0, self.count)", True),
        ("angles = np.linspace(-1.0, 1.0, num=1)", False),
        ("angles = np.arange(self.count)", False),
    ],
)
def test_the_steps_of_a_line(judge: Judge, line: str, told: bool):
    judge("API001", viewer(f"{line}\n            print(angles > 0.0 and angles < 0.5){'  # here' if told else ''}"))


@pytest.mark.parametrize(
    "line",
    [
        "near = (self.ranges > 0.1) & (self.ranges < 0.5)",
        "near = self.ranges < 0.5",
        "near = self.count and self.ranges < 0.5",
        "near = self.ranges[self.ranges < 0.5]",
        "if (self.ranges < 0.5).any() and self.count: return",
        "if self.ranges[0] < 0.5 and min(self.ranges) < 0.5: return",
        "near = 0.1 < self.count < self.ranges",
        "if self.one > 0.5 or self.other > 0.5: return",
        "picture = self.count and self.picture",
    ],
    ids=[
        "&",
        "no truth",
        "the last of several",
        "a mask",
        "any",
        "items",
        "the last of a chain",
        "maybe one",
        "a value",
    ],
)
def test_comparisons_of_whose_truth_nobody_asks(judge: Judge, line: str):
    judge("API001", viewer(line))


def test_what_an_array_does_not_have(judge: Judge):
    (finding,) = judge("API002", viewer("print(self.picture.header)  # here"))
    assert finding.message == (
        "self.picture is an array of numpy: it has no 'header', and this line fails with an AttributeError"
    )


@pytest.mark.parametrize("name", ["shape", "tobytes()", "__array_interface__", "T"])
def test_what_an_array_has(judge: Judge, name: str):
    judge("API002", viewer(f"print(self.picture.{name})"))


def test_another_class_may_put_something_else_there(judge: Judge):
    other = """
    class Other:
        def __init__(self, viewer):
            self.viewer = viewer
            viewer.picture = Image()
    """
    source = viewer("print(self.picture.header)").replace("spin(Viewer())", "spin(Other(Viewer()).viewer)")
    judge("API002", source + other)
