"""API001: defaults that no parameter of ROS can have."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import numpy as np
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        {line}

{more}

def main():
    rclpy.init()
    rclpy.spin(Driver())


main()
"""


@pytest.mark.parametrize(
    ("default", "what"),
    [
        ("{'p': 1.0}", "a dict"),
        ("{}", "a dict"),
        ("{1, 2}", "a set"),
        ("[[1.0], [2.0]]", "a list of lists or dicts"),
        ("[1, 0.5]", "a list with a float and an int"),
        ("['a', 1]", "a list with a text and an int"),
        ("[-1, 0.5]", "a list with a float and an int"),
        ("np.array([1.0, 2.0])", "an array of numpy"),
    ],
)
def test_a_default_that_no_parameter_can_have(judge: Judge, default: str, what: str) -> None:
    """Each of these raises a TypeError in rclpy of jazzy."""
    line = f"self.declare_parameter('gains', {default})  # here"
    (finding,) = judge("API001", NODE.format(line=line, more=""))
    assert finding.message == f"declare_parameter() fails with a TypeError: no parameter can be {what}"


@pytest.mark.parametrize(
    "default", ["[1.0, 0.5]", "[]", "(1, 2)", "[True, 1]", "['a', name]", "None", "'a'", "3", "list(range(3))"]
)
def test_a_default_that_a_parameter_can_have(judge: Judge, default: str) -> None:
    judge("API001", NODE.format(line=f"name = 'b'; self.declare_parameter('gains', {default})", more=""))


@pytest.mark.parametrize(
    ("descriptor", "what", "instead"),
    [
        ("{'description': 'how fast'}", "a dict", "description=…"),
        ("{'description': 'how fast', 'read_only': True}", "a dict", "description=…, read_only=…"),
        ("'how fast'", "a text", "description=…"),
        ("descriptor={}", "a dict", "description=…"),
    ],
)
def test_what_stands_for_a_descriptor_and_is_none(judge: Judge, descriptor: str, what: str, instead: str) -> None:
    (finding,) = judge(
        "API001", NODE.format(line=f"self.declare_parameter('rate', 1.0, {descriptor})  # here", more="")
    )
    assert finding.message == (
        f"declare_parameter() fails with a TypeError: its descriptor is a ParameterDescriptor, and not {what}"
    )
    assert finding.help.endswith(f"ParameterDescriptor({instead})")


@pytest.mark.parametrize("descriptor", ["None", "described", "descriptor=ParameterDescriptor(description='how fast')"])
def test_what_may_be_a_descriptor(judge: Judge, descriptor: str) -> None:
    line = f"from rcl_interfaces.msg import ParameterDescriptor; self.declare_parameter('rate', 1.0, {descriptor})"
    judge("API001", NODE.format(line=line, more=""))


def test_a_method_of_the_workspace_by_that_name(judge: Judge) -> None:
    more = "    def declare_parameter(self, name, value):\n        print(name, value)\n"
    judge("API001", NODE.format(line="self.declare_parameter('gains', {'p': 1.0})", more=more))
