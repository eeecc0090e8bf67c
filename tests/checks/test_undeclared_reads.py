"""PRM003: names of parameters as ROS 1 writes them."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


class Odometry(Node):
    def __init__(self):
        super().__init__('odometry')
        self.declare_parameter('scale', 1.0)
        self.declare_parameter('turn', 1.0)
        self.declare_parameter('~own', 1.0)
{lines}


def main():
    rclpy.init()
    rclpy.spin(Odometry())
"""


def _node(*lines: str) -> str:
    return NODE.format(lines="\n".join(f"        {line}" for line in lines))


def test_a_tilde_before_the_name_of_a_declared_parameter(judge: Judge):
    lines = ("print(self.get_parameter('~scale').value)  # here", "print(self.get_parameter('~turn').value)")
    (finding,) = judge("PRM003", _node(*lines))
    assert finding.message == (
        "parameter '~scale' is read, but Odometry never declares it; did you mean 'scale'?; another name has a ~, too"
    )
    assert finding.help == "take the ~ out: write 'scale'"
    assert [related.place.line for related in finding.related] == [12]


@pytest.mark.parametrize("name", ["~other", "~/other"])
def test_a_tilde_before_a_name_that_nothing_declares(judge: Judge, name: str):
    (finding,) = judge("PRM003", _node(f"print(self.get_parameter('{name}').value)  # here"))
    assert finding.help == f"declare it first: self.declare_parameter('{name}', …)"


def test_a_tilde_that_is_declared(judge: Judge):
    judge("PRM003", _node("print(self.get_parameter('~own').value)"))


CPP = """
#include <rclcpp/rclcpp.hpp>

class Odometry : public rclcpp::Node
{{
public:
  Odometry() : Node("odometry")
  {{
    double scale = 1.0;
    double turn = 1.0;
    {lines}
  }}
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Odometry>());
}}
"""
KEEPS = "get_parameter() returns false, and the variable keeps its value whatever is set"


@pytest.mark.parametrize(
    ("lines", "severity", "message"),
    [
        (
            'get_parameter("scale", scale);',
            Severity.WARNING,
            f"parameter 'scale' is read, but Odometry never declares it: {KEEPS}",
        ),
        (
            'get_parameter("scale", scale); this->get_parameter<double>("turn", turn);',
            Severity.WARNING,
            f"Odometry reads 2 parameters that it never declares, scale, turn: {KEEPS}",
        ),
        (
            'declare_parameter("scale", 1.0); get_parameter("scal", scale);',
            Severity.WARNING,
            f"parameter 'scal' is read, but Odometry never declares it: {KEEPS}; did you mean 'scale'?",
        ),
        (
            'scale = get_parameter("scale").as_double();',
            Severity.ERROR,
            "parameter 'scale' is read, but Odometry never declares it",
        ),
    ],
    ids=["into a variable", "two of them", "a slip", "a read that throws"],
)
def test_what_becomes_of_a_read_in_cpp(findings, lines: str, severity: Severity, message: str):
    (found,) = findings("PRM003", **{"src/odometry.cpp": CPP.format(lines=lines)})
    assert (found.severity, found.message) == (severity, message)


@pytest.mark.parametrize("lines", ['declare_parameter("scale", 1.0); get_parameter("scale", scale);', ""])
def test_a_read_in_cpp_that_finds_its_parameter(findings, lines: str):
    assert findings("PRM003", **{"src/odometry.cpp": CPP.format(lines=lines)}) == []


GTEST = """
#include <gtest/gtest.h>
#include <rclcpp/rclcpp.hpp>

TEST(Odometry, knows_no_scale)
{
  auto node = std::make_shared<rclcpp::Node>("odometry");
  double scale = 1.0;
  EXPECT_FALSE(node->get_parameter("scale", scale));
  EXPECT_ANY_THROW(node->get_parameter("scale"));
}
"""


@pytest.mark.parametrize("path", ["test/test_odometry.cpp", "src/odometry_checks.cpp"])
def test_a_read_in_a_test_of_cpp(findings, path: str):
    assert findings("PRM003", **{path: GTEST}) == []
