"""API004: parameter callbacks that do not say whether the new values are right."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('speed', 1.0)
        self.{register}(self.on_parameters)

    def on_parameters(self, parameters):{mark}
        {body}

    def judged(self, parameters):
        return SetParametersResult(successful=True)
"""


def node(*lines: str, register: str = "add_on_set_parameters_callback", mark: str = "") -> str:
    return NODE.format(body="\n        ".join(lines), register=register, mark=mark)


@pytest.mark.parametrize(
    ("source", "what"),
    [
        (node("self.speed = parameters[0].value", mark="  # here"), "can reach its end without a result"),
        (node("print(parameters)", "return True  # here"), "returns True here"),
        (node("if parameters:", "    return  # here", "return self.judged(parameters)"), "returns nothing here"),
        (
            node(
                "for parameter in parameters:",
                "    if parameter.value:",
                "        return self.judged([])",
                mark="  # here",
            ),
            "can reach its end without a result",
        ),
        (node("return [self.judged(parameters)]  # here"), "returns a list here"),
    ],
    ids=["nothing", "True", "one way of two", "another value", "a list"],
)
def test_a_callback_without_a_result(judge: Judge, source: str, what: str):
    [finding] = judge("API004", source)
    assert what in finding.message


@pytest.mark.parametrize(
    "source",
    [
        node("return SetParametersResult(successful=True)"),
        node("return self.judged(parameters)"),
        node("result = self.judged(parameters)", "return result"),
        node("for parameter in parameters:", "    return self.judged([parameter])"),
        node(
            "for parameter in parameters:",
            "    if parameter.name == 'speed':",
            "        self.speed = parameter.value",
            "        return self.judged([parameter])",
            "    elif parameter.name == 'mode':",
            "        return self.judged([])",
            "    else:",
            "        return self.judged(parameters)",
        ),
        node("raise NotImplementedError"),
        node("pass"),
        node("self.speed = parameters[0].value", register="add_post_set_parameters_callback"),
        node("return [parameters[0]]", register="add_pre_set_parameters_callback"),
    ],
    ids=[
        "a result",
        "of a method",
        "of a variable",
        "of the first",
        "of the first, in each branch",
        "raises",
        "still to be written",
        "afterwards",
        "before",
    ],
)
def test_a_callback_that_says_what_it_has_to(judge: Judge, source: str):
    judge("API004", source)
