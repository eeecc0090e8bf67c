"""Quality of service as C++ builds it.  Source of what is expected: ``rclcpp/qos.hpp`` and rmw's ``qos_profiles.h``."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph_of

DEFAULT = ("keep_last", 10, "reliable", "volatile")


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("10", DEFAULT),
        ("rclcpp::QoS(3)", ("keep_last", 3, "reliable", "volatile")),
        ("rclcpp::QoS{rclcpp::KeepLast(3)}.best_effort()", ("keep_last", 3, "best_effort", "volatile")),
        ("rclcpp::QoS(1).transient_local().reliable()", ("keep_last", 1, "reliable", "transient_local")),
        ("rclcpp::QoS(rclcpp::KeepAll())", ("keep_all", 10, "reliable", "volatile")),
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
