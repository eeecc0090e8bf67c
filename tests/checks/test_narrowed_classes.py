"""What a test of a class proves: behind ``isinstance`` that leaves, an attribute is none of that class."""

from __future__ import annotations

import pytest

from checks.judging import Judge

ARM = """
    import time

    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger

    try:
        from arm_driver import Arm
    except ImportError:
        Arm = None


    class Mock:
        def move(self):
            time.sleep(5.0){mark}


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            try:
                self.arm = Arm()
            except OSError:
                self.arm = Mock()
            self.create_service(Trigger, 'home', self.home)

        def home(self, request, response):
            {body}
            return response


    def main():
        rclpy.init()
        rclpy.spin(Driver())


    if __name__ == '__main__':
        main()
"""

NEVER = {
    "a test that returns": ["if isinstance(self.arm, Mock):", "    return response", "self.arm.move()"],
    "its negation": ["if not isinstance(self.arm, Mock):", "    self.arm.move()"],
    "one of several reasons to leave": [
        "if request is None or isinstance(self.arm, Mock):",
        "    return response",
        "self.arm.move()",
    ],
    "a tuple of classes": ["if isinstance(self.arm, (Mock, str)):", "    raise RuntimeError", "self.arm.move()"],
    "an elif": [
        "if request is None:",
        "    return response",
        "elif isinstance(self.arm, Mock):",
        "    return response",
        "else:",
        "    self.arm.move()",
    ],
    "a turn of a loop": [
        "for _ in range(3):",
        "    if isinstance(self.arm, Mock):",
        "        continue",
        "    self.arm.move()",
    ],
    "a local name": ["arm = self.arm", "if isinstance(arm, Mock):", "    return response", "arm.move()"],
}
MAY_BE = {
    "a test that goes on": ["if isinstance(self.arm, Mock):", "    response.message = 'mock'", "self.arm.move()"],
    "the branch of the class": ["if isinstance(self.arm, Mock):", "    self.arm.move()"],
    "another class": ["if isinstance(self.arm, str):", "    return response", "self.arm.move()"],
    "a negation that returns": ["if not isinstance(self.arm, Mock):", "    return response", "self.arm.move()"],
    "one of two conditions": [
        "if isinstance(self.arm, Mock) and request is None:",
        "    return response",
        "self.arm.move()",
    ],
    "another callback": ["self.arm.move()"],
}


def driver(body: list[str], mark: str) -> str:
    return ARM.format(body="\n            ".join(body), mark=mark)


@pytest.mark.parametrize("body", NEVER.values(), ids=NEVER)
def test_a_class_that_the_test_has_ruled_out(judge: Judge, body: list[str]):
    judge("SRV008", driver(body, ""))


@pytest.mark.parametrize("body", MAY_BE.values(), ids=MAY_BE)
def test_a_class_that_may_still_be_there(judge: Judge, body: list[str]):
    judge("SRV008", driver(body, "  # here"))
