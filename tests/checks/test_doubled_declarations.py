"""PRM008: names with a prefix that one function of C++ declares twice."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, TALKER_OF_CPP

SOURCE = """\
#include <rclcpp/rclcpp.hpp>

void configure(const {node} & node, std::string prefix, const std::string & other)
{{
{lines}
}}

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<rclcpp::Node>("talker"));
}}
"""
RATE = 'rate = node->declare_parameter<double>(prefix + ".rate", 1.0);'
SIZE = 'node->declare_parameter(prefix + ".size", 1);'


@pytest.fixture
def told(findings):
    def run(*lines: str, node: str = "rclcpp::Node::SharedPtr"):
        source = SOURCE.format(node=node, lines="\n".join(lines))
        return findings("PRM008", **{"package.xml": CMAKE, "CMakeLists.txt": TALKER_OF_CPP, "src/talker.cpp": source})

    return run


def test_a_name_with_a_prefix_that_is_declared_twice(told):
    (found,) = told(RATE, SIZE, RATE)
    message = "the parameter prefix + '.rate' is declared twice: the second declaration raises an exception"
    assert (found.message, found.place.line) == (message, 7)
    assert [(row.place.line, row.message) for row in found.related] == [(5, "it is declared here first")]


def test_a_function_is_one_finding(told):
    (found,) = told(RATE, SIZE, RATE, SIZE)
    assert found.message.endswith("raises an exception; so is another one")
    assert found.related[1].message == "prefix + '.size' is declared again here"


@pytest.mark.parametrize(
    "lines",
    [
        (RATE, SIZE),
        (RATE, RATE.replace("prefix", "other")),
        (RATE, 'prefix = "arm";', RATE),
        (RATE, 'prefix += "arm";', RATE),
        (RATE, 'prefix.append("arm");', RATE),
        ("if (old)", RATE, "else", RATE),
        ("if (old) {", RATE, "}", RATE),
        (RATE, "return;", RATE),
        (RATE, 'if (!node->has_parameter(prefix + ".rate")) {', RATE, "}"),
        (RATE, 'node->undeclare_parameter(prefix + ".rate");', RATE),
    ],
)
def test_names_that_differ_or_may_be_declared_once(told, lines):
    assert told(*lines) == []


def test_what_is_no_node_may_declare_as_often_as_it_likes(told):
    assert told(RATE, RATE, node="Settings::Ptr") == []
