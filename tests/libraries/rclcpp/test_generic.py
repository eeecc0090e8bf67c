"""Endpoints of C++ whose type is a text."""

from __future__ import annotations

from tests.cpp_nodes import graph_of


def test_the_type_of_a_generic_publisher_is_its_second_argument():
    [node] = graph_of('create_generic_publisher("chatter", "std_msgs/msg/String", rclcpp::QoS(3).best_effort());')
    [end] = node["publishers"]
    assert (end["name"], end["type"], end["qos"]["depth"]) == ("/chatter", "std_msgs/msg/String", 3)


def test_of_a_generic_subscription_that_a_function_creates():
    [node] = graph_of('rclcpp::create_generic_subscription(this, "chatter", "std_msgs/msg/String", 10, nullptr);')
    assert [(end["name"], end["type"]) for end in node["subscribers"]] == [("/chatter", "std_msgs/msg/String")]


def test_a_type_that_data_decides_is_not_known():
    [node] = graph_of('create_generic_publisher("chatter", read_type(), 10);')
    assert [(end["name"], end["type"]) for end in node["publishers"]] == [("/chatter", None)]
