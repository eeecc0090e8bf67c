"""Quality of service as C++ builds it.  Source of what is expected: ``rclcpp/qos.hpp`` and rmw's ``qos_profiles.h``."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph, graph_of

DEFAULT = ("keep_last", 10, "reliable", "volatile")


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("10", DEFAULT),
        ("{3}", ("keep_last", 3, "reliable", "volatile")),
        (
            "rclcpp::QoS(rclcpp::QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, 3)).best_effort()",
            ("keep_last", 3, "best_effort", "volatile"),
        ),
        ("rclcpp::QoS(3)", ("keep_last", 3, "reliable", "volatile")),
        ("rclcpp::QoS{rclcpp::KeepLast(3)}.best_effort()", ("keep_last", 3, "best_effort", "volatile")),
        ("rclcpp::QoS(1).transient_local().reliable()", ("keep_last", 1, "reliable", "transient_local")),
        ("rclcpp::QoS(rclcpp::KeepAll())", ("keep_all", 10, "reliable", "volatile")),
        ("rclcpp::QoS(1000).keep_all()", ("keep_all", 0, "reliable", "volatile")),
        ("rclcpp::SensorDataQoS()", ("keep_last", 5, "best_effort", "volatile")),
        ("rclcpp::SensorDataQoS().keep_last(1).reliable()", ("keep_last", 1, "reliable", "volatile")),
        (
            "rclcpp::QoS(5).reliability(rclcpp::ReliabilityPolicy::BestEffort)",
            ("keep_last", 5, "best_effort", "volatile"),
        ),
        (
            "rclcpp::QoS(5).durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)",
            ("keep_last", 5, "reliable", "transient_local"),
        ),
        (
            "rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_sensor_data), "
            "rmw_qos_profile_sensor_data)",
            ("keep_last", 5, "best_effort", "volatile"),
        ),
        (
            "rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_sensor_data))",
            ("keep_last", 5, "reliable", "volatile"),
        ),
        (
            "rclcpp::QoS(rclcpp::QoS(2).best_effort().transient_local())",
            ("keep_last", 2, "best_effort", "transient_local"),
        ),
        (
            "rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_default), rmw_qos_profile_default)",
            DEFAULT,
        ),
        ("rclcpp::QoS(rclcpp::SensorDataQoS())", ("keep_last", 5, "best_effort", "volatile")),
        ("rclcpp::SystemDefaultsQoS()", ("system_default", None, "system_default", "system_default")),
    ],
)
def test_a_profile_is_what_its_builder_makes_it(written: str, expected: tuple[object, ...]) -> None:
    [node] = graph_of(f'create_publisher<std_msgs::msg::String>("a", {written});')
    qos = node["publishers"][0]["qos"]
    depth = qos["depth"] if qos["history"] == "keep_last" else expected[1]
    assert (qos["history"], depth, qos["reliability"], qos["durability"]) == expected


def test_a_copy_of_a_preset_may_be_changed() -> None:
    code = """
        rmw_qos_profile_t mine = rmw_qos_profile_default;
        auto qos = rclcpp::QoS(2);
        qos.best_effort();
        create_publisher<std_msgs::msg::String>("a", qos);
        create_publisher<std_msgs::msg::String>("b", 10);
    """
    [node] = graph_of(code)
    assert [end["qos"]["reliability"] for end in node["publishers"]] == ["best_effort", "reliable"]


def test_a_change_of_a_copy_leaves_the_first_as_it_is() -> None:
    code = """
        rclcpp::QoS qos(2);
        rclcpp::QoS copied(qos);
        copied.transient_local();
        create_publisher<std_msgs::msg::String>("a", qos);
        create_publisher<std_msgs::msg::String>("b", copied);
    """
    [node] = graph_of(code)
    assert [end["qos"]["durability"] for end in node["publishers"]] == ["volatile", "transient_local"]


MEMBER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Robot : public rclcpp::Node {
public:
  Robot();
private:
  rclcpp::QoS kept_, plain_;
  int depth_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr a_, b_, c_;
};
"""
CONSTRUCTOR = """Robot() : Node("robot"), kept_(3), plain_{4}, depth_(5) {
  kept_.best_effort();
  kept_.transient_local();
  a_ = create_publisher<std_msgs::msg::String>("a", kept_);
  b_ = create_publisher<std_msgs::msg::String>("b", plain_);
  c_ = create_publisher<std_msgs::msg::String>("c", depth_);
}
"""
MAIN = "int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }\n"


@pytest.mark.parametrize(
    "files",
    [
        {"src/robot.cpp": MEMBER.replace("Robot();\n", CONSTRUCTOR) + MAIN},
        {
            "src/robot.hpp": "#pragma once\n" + MEMBER,
            "src/robot.cpp": f'#include "robot.hpp"\nRobot::{CONSTRUCTOR}{MAIN}',
        },
    ],
)
def test_a_member_that_is_set_in_statements_of_their_own(files: dict[str, str]) -> None:
    [node] = graph(files)["nodes"]
    policies = [
        (end["qos"]["depth"], end["qos"]["reliability"], end["qos"]["durability"]) for end in node["publishers"]
    ]
    assert policies == [(3, "best_effort", "transient_local"), (4, "reliable", "volatile"), (5, "reliable", "volatile")]


def test_what_keeps_all_has_no_depth_left() -> None:
    """``keep_all()`` sets the depth to 0, so that nothing contradicts it (QOS004)."""
    [node] = graph_of('create_publisher<std_msgs::msg::String>("a", rclcpp::QoS(1000).keep_all());')
    assert node["publishers"][0]["qos"]["depth"] == 0
