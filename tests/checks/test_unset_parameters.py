"""PRM003: parameters that are declared with a type alone, and that no launch file gives a value."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, TALKER, TALKER_OF_CPP, node

WITH_TYPE = "self.declare_parameter('rate', rclpy.Parameter.Type.DOUBLE)"
READ = "self.rate = self.get_parameter('rate').value"
WRITTEN = "self.declare_parameter('rate', 1.0)"


def _talker(*lines: str) -> dict[str, str]:
    return {"robot/talker.py": TALKER.replace(WRITTEN, "\n        ".join(lines))}


def _param(name: str, value: str = "1.0") -> str:
    return f"<param name='{name}' value='{value}'/>"


FILE = "<param from='$(find-pkg-share {0})/config/talker.yaml'/>"


def test_a_parameter_that_no_launch_file_sets(findings):
    (finding,) = findings("PRM003", node(_param("other")), **_talker(WITH_TYPE, READ))
    assert finding.message == (
        "parameter 'rate' is read, and has no value, and no launch file that starts Talker gives it one: "
        "the node stops here"
    )
    assert (finding.place.file, finding.place.line) == ("robot/talker.py", 9)
    assert [(row.place.file, row.place.line) for row in finding.related] == [
        ("robot/talker.py", 8),
        ("launch/it.launch.xml", 1),
    ]


def test_a_parameter_file_that_has_another_parameter(findings):
    files = _talker(WITH_TYPE, READ) | {"config/talker.yaml": "talker:\n  ros__parameters:\n    other: 1\n"}
    assert len(findings("PRM003", node(FILE.format("robot")), **files)) == 1


def test_several_of_a_node_are_one_finding(findings):
    lines = [line.replace("rate", name) for name in ("rate", "size") for line in (WITH_TYPE, READ)]
    (finding,) = findings("PRM003", node(), **_talker(*lines))
    assert finding.message.endswith("the node stops here; another one has no value, either")


@pytest.mark.parametrize(
    "inner",
    [
        _param("rate"),
        FILE.format("robot"),
        FILE.format("elsewhere"),
        "<param from='$(env FILE)'/>",
        "<param name='$(env NAME)' value='1.0'/>",
    ],
)
def test_a_parameter_that_is_set_or_may_be(findings, inner: str):
    files = {"config/talker.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n"}
    assert findings("PRM003", node(inner), **_talker(WITH_TYPE, READ), **files) == []


@pytest.mark.parametrize("arguments", ["--ros-args -p rate:=1.0", "$(env WORDS)"])
def test_a_parameter_on_the_command_line(findings, arguments: str):
    assert findings("PRM003", node(args=arguments), **_talker(WITH_TYPE, READ)) == []


@pytest.mark.parametrize(
    "lines",
    [
        (WRITTEN, READ),
        (WITH_TYPE,),
        (WITH_TYPE, "self.rate = self.get_parameter_or('rate', rclpy.Parameter('rate', value=1.0)).value"),
        (WITH_TYPE, "self.set_parameters([rclpy.Parameter('rate', value=1.0)])", READ),
        (WITH_TYPE, "try:", f"    {READ}", "except Exception:", "    self.rate = 1.0"),
        (WITH_TYPE, "if input():", f"    {READ}"),
        ("self.declare_parameter('rate')", READ),
        (
            "from rcl_interfaces.msg import ParameterDescriptor",
            "self.declare_parameter('rate', None, ParameterDescriptor(dynamic_typing=True))",
            READ,
        ),
    ],
)
def test_a_node_that_does_not_stop(findings, lines: tuple[str, ...]):
    assert findings("PRM003", node(), **_talker(*lines)) == []


def test_a_node_that_no_launch_file_starts(findings):
    assert findings("PRM003", **_talker(WITH_TYPE, READ)) == []


def test_a_node_that_one_of_two_launch_files_gives_a_value(findings):
    other = {"launch/other.launch.xml": f"<launch>{node(_param('rate'))}</launch>"}
    assert findings("PRM003", node(), **_talker(WITH_TYPE, READ), **other) == []


def test_a_workspace_for_a_distribution_in_which_it_has_no_value_yet(findings):
    assert findings("PRM003", node(), **_talker(WITH_TYPE, READ), Dockerfile="FROM ros:foxy\n") == []


CPP = """
#include <rclcpp/rclcpp.hpp>
#include <string>

class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    %s
  }

private:
  std::string frame_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}
"""


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('frame_ = declare_parameter<std::string>("frame");', 1),
        ('frame_ = this->declare_parameter < std::string > ("frame");', 1),
        ('frame_ = declare_parameter<std::string>("frame", "map");', 0),
        ('declare_parameter("frame", rclcpp::PARAMETER_STRING);', 0),
        ('try { frame_ = declare_parameter<std::string>("frame"); } catch (const std::exception &) {}', 0),
    ],
)
def test_in_cpp_the_declaration_wants_a_value(findings, line: str, told: int):
    build = TALKER_OF_CPP.replace("ament_package()", "install(TARGETS talker DESTINATION lib/robot)\nament_package()")
    files = {"package.xml": CMAKE, "CMakeLists.txt": build, "src/talker.cpp": CPP % line}
    found = findings("PRM003", node(), **files)
    assert [finding.place.line for finding in found] == [10] * told
