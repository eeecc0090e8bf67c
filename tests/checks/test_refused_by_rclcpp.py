"""API001 and API002 in C++: what no maintained distribution of rclcpp has."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, TALKER_OF_CPP

SOURCE = """\
#include <rclcpp/rclcpp.hpp>

class Talker : public rclcpp::Node {{
public:
  Talker() : Node("talker")
  {{
    {line}
  }}
}};

void configure(rclcpp::Node * node, Settings * settings, const std::string & name)
{{
  {function}
}}

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}}
"""
CALL = "if (rclcpp::spin_until_future_complete(node, future) != {}::SUCCESS) {{ return; }}"
GONE = "rclcpp::executor::FutureReturnCode"


@pytest.fixture
def told(findings):
    """What a rule finds in a node of C++, by the lines of its constructor and of a function."""

    def run(code: str, line: str = "", function: str = "", readme: str = ""):
        files = {"package.xml": CMAKE, "CMakeLists.txt": TALKER_OF_CPP, "README.md": readme}
        return findings(code, **files, **{"src/talker.cpp": SOURCE.format(line=line, function=function)})

    return run


@pytest.mark.parametrize("name", ["executor::FutureReturnCode", "callback_group::CallbackGroupType"])
def test_a_name_in_a_namespace_that_is_gone(told, name):
    (found,) = told("API002", CALL.format(f"rclcpp::{name}"))
    assert found.message == f"rclcpp has no '{name}' since Galactic: this does not compile"
    assert (found.place.line, found.help) == (7, f"write rclcpp::{name.partition('::')[2]}")


def test_a_name_that_is_gone_is_told_once(told):
    (found,) = told("API002", CALL.format(GONE), CALL.format(GONE))
    assert found.message.endswith("; another line does the same")
    assert [other.place.line for other in found.related] == [13]


@pytest.mark.parametrize(
    "line",
    [
        CALL.format("rclcpp::FutureReturnCode"),
        "rclcpp::executors::SingleThreadedExecutor executor;",
        f"\n#if USES_THE_OLD\n{CALL.format(GONE)}\n#else\n{CALL.format('rclcpp::FutureReturnCode')}\n#endif\n",
        CALL.format("ours::executor::FutureReturnCode"),
    ],
)
def test_a_name_that_rclcpp_has_or_may_have(told, line):
    assert told("API002", line) == []


@pytest.mark.parametrize(("readme", "number"), [("For ROS 2 Foxy.", 0), ("For ROS 2 Foxy and Humble.", 1)])
def test_a_workspace_for_a_release_that_had_the_name(told, readme, number):
    assert len(told("API002", CALL.format(GONE), readme=readme)) == number


@pytest.mark.parametrize(("macro", "number"), [("ROS_FOXY", 0), ("POST_FOXY", 0), ("USES_OLD", 1)])
def test_a_file_for_several_releases(told, macro: str, number: int):
    """Its conditions ask for the release: what stands outside of them may be an alias that they choose."""
    assert len(told("API002", f"\n#ifdef {macro}\n  old();\n#endif\n{CALL.format(GONE)}")) == number


@pytest.mark.parametrize(
    ("line", "function", "at"),
    [
        ('declare_parameter("rate");', "", 7),
        ('this->declare_parameter("rate");', "", 7),
        ("", "node->declare_parameter(name);", 13),
    ],
)
def test_a_parameter_with_neither_a_value_nor_a_type(told, line, function, at):
    (found,) = told("API001", line, function)
    assert found.message == (
        "declare_parameter() is given neither a value nor a type, which rclcpp takes no more since Humble: "
        "this does not compile"
    )
    assert (found.place.line, found.help) == (at, "give it a default, or the type: declare_parameter<…>(name)")


@pytest.mark.parametrize(
    ("line", "function"),
    [
        ('declare_parameter<double>("rate");', ""),
        ('declare_parameter("rate", 1.0);', ""),
        ('declare_parameter("rate", rclcpp::ParameterType::PARAMETER_DOUBLE);', ""),
        ('declare_parameter("rate", rclcpp::ParameterValue());', ""),
        ("", "settings->declare_parameter(name);"),
        ("", "node->declare_parameter<double>(name);"),
    ],
)
def test_a_parameter_with_a_value_or_a_type(told, line, function):
    assert told("API001", line, function) == []


def test_a_duration_of_one_number(told):
    (found,) = told("API001", "rclcpp::Duration limit(5);")
    assert found.message.startswith("rclcpp::Duration() is given one number, which rclcpp takes no more since Humble")
    assert found.place.line == 7


@pytest.mark.parametrize(
    "duration", ["limit(5, 0)", "limit(5s)", "limit(500ms)", "limit(std::chrono::seconds(5))", "limit(other)"]
)
def test_a_duration_that_says_what_it_counts(told, duration):
    assert told("API001", f"rclcpp::Duration {duration};") == []


def test_galactic_takes_what_humble_does_not(told):
    assert told("API001", "rclcpp::Duration limit(5);", readme="For ROS 2 Galactic.") == []
