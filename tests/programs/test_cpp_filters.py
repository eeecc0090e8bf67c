"""Filters of C++ that are made before they subscribe."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "message_filters/subscriber.h"
#include "image_transport/subscriber_filter.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    %s
  }
private:
  message_filters::Subscriber<sensor_msgs::msg::CameraInfo> info_;
  std::shared_ptr<message_filters::Subscriber<sensor_msgs::msg::CameraInfo>> pointer_;
  image_transport::SubscriberFilter image_;
  bool subscribe_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def subscriptions(statements: str) -> list[dict[str, Any]]:
    (node,) = graph({"src/robot.cpp": PROGRAM % statements})["nodes"]
    return list(node["subscribers"])


def test_a_filter_that_is_a_field_subscribes_later() -> None:
    (found,) = subscriptions('info_.subscribe(this, "camera_info", rclcpp::SensorDataQoS().get_rmw_qos_profile());')
    assert (found["name"], found["type"]) == ("/camera_info", "sensor_msgs/msg/CameraInfo")
    assert found["qos"]["reliability"] == "best_effort"


def test_a_filter_behind_a_pointer() -> None:
    statements = """
      pointer_ = std::make_shared<message_filters::Subscriber<sensor_msgs::msg::CameraInfo>>();
      pointer_->subscribe(this, declare_parameter<std::string>("topic", "info"));
    """
    (found,) = subscriptions(statements)
    assert (found["name"], found["type"]) == ("/info", "sensor_msgs/msg/CameraInfo")


def test_images_name_their_transport_before_the_profile() -> None:
    (found,) = subscriptions('image_.subscribe(this, "image_raw", "raw", rmw_qos_profile_sensor_data);')
    assert (found["name"], found["type"]) == ("/image_raw", "sensor_msgs/msg/Image")
    assert found["qos"]["reliability"] == "best_effort"


def test_a_filter_that_never_subscribes_is_no_subscription() -> None:
    assert subscriptions("subscribe_ = false;") == []
    assert subscriptions("info_.unsubscribe();") == []


IN_A_HEADER = """
#include "rclcpp/rclcpp.hpp"
#include "message_filters/subscriber.h"
#include "sensor_msgs/msg/camera_info.hpp"
class Robot : public rclcpp::Node {
public:
  Robot();
private:
  message_filters::Subscriber<sensor_msgs::msg::CameraInfo> info_;
  acme::Driver driver_;
};
"""
SOURCE = """
#include "robot.hpp"
Robot::Robot() : Node("robot"), %s {}
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def robot(members: str) -> dict[str, Any]:
    (node,) = graph({"src/robot.hpp": IN_A_HEADER, "src/robot.cpp": SOURCE % members})["nodes"]
    return dict(node)


def test_a_filter_that_the_list_of_a_constructor_makes() -> None:
    (found,) = robot('info_(this, "camera_info")')["subscribers"]
    assert (found["name"], found["type"]) == ("/camera_info", "sensor_msgs/msg/CameraInfo")


def test_a_member_of_a_class_from_elsewhere_may_subscribe_to_anything() -> None:
    node = robot('driver_(this, "camera_info")')
    assert (node["subscribers"], node["complete"]) == ([], False)
