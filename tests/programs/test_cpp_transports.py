"""Images of C++: by which topics they go, and what else describes their camera."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "image_transport/image_transport.hpp"
#include "image_transport/subscriber_filter.hpp"
#include "camera_info_manager/camera_info_manager.hpp"
class Camera : public rclcpp::Node {
public:
  Camera() : Node("camera") {
    %s
  }
private:
  void on_image(const sensor_msgs::msg::Image::ConstSharedPtr & image) {}
  image_transport::Publisher publisher_;
  image_transport::Subscriber subscriber_;
  image_transport::CameraPublisher camera_;
  image_transport::SubscriberFilter filter_;
  std::shared_ptr<camera_info_manager::CameraInfoManager> manager_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Camera>());
}
"""
ON_IMAGE = "std::bind(&Camera::on_image, this, std::placeholders::_1)"


def camera(statements: str) -> dict[str, Any]:
    [only] = graph({"src/camera.cpp": PROGRAM % statements})["nodes"]
    return dict(only)


def ends(rows: list[dict[str, Any]]) -> list[tuple[str | None, str | None]]:
    return sorted(((row["name"], row["type"]) for row in rows), key=repr)


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        (
            f'subscriber_ = image_transport::create_subscription(this, "in/image", {ON_IMAGE}, "raw");',
            [("/in/image", "sensor_msgs/msg/Image")],
        ),
        (
            f'subscriber_ = image_transport::create_subscription(this, "in/image", {ON_IMAGE}, "compressed");',
            [("/in/image/compressed", "sensor_msgs/msg/CompressedImage")],
        ),
        (
            "image_transport::TransportHints hints(this);"
            f'subscriber_ = image_transport::create_subscription(this, "image", {ON_IMAGE}, hints.getTransport());',
            [("/image", "sensor_msgs/msg/Image")],
        ),
        (
            'image_transport::TransportHints hints(this, "compressed");'
            f'subscriber_ = image_transport::create_subscription(this, "image", {ON_IMAGE}, hints.getTransport());',
            [("/image/compressed", "sensor_msgs/msg/CompressedImage")],
        ),
        (
            'declare_parameter<std::string>("image_transport", "compressed");'
            "image_transport::ImageTransport transport(shared_from_this());"
            f'subscriber_ = transport.subscribe("image", 1, {ON_IMAGE});',
            [("/image/compressed", "sensor_msgs/msg/CompressedImage")],
        ),
        (
            f'subscriber_ = image_transport::create_subscription(this, "image", {ON_IMAGE}, "ffmpeg");',
            [(None, None)],
        ),
        ('filter_.subscribe(this, "image", "compressed");', [("/image/compressed", "sensor_msgs/msg/CompressedImage")]),
        (
            f'image_transport::create_camera_subscription(this, "left/image", {ON_IMAGE}, "raw");',
            [("/left/camera_info", "sensor_msgs/msg/CameraInfo"), ("/left/image", "sensor_msgs/msg/Image")],
        ),
    ],
)
def test_a_subscription_has_the_topic_of_its_transport(
    statement: str, expected: list[tuple[str | None, str | None]]
) -> None:
    assert ends(camera(statement)["subscribers"]) == expected


@pytest.mark.parametrize(
    "statement",
    [
        'camera_ = image_transport::create_camera_publisher(this, "left/image");',
        "image_transport::ImageTransport transport(shared_from_this());"
        'camera_ = transport.advertiseCamera("left/image", 1);',
    ],
)
def test_a_camera_is_published_beside_its_images(statement: str) -> None:
    assert ends(camera(statement)["publishers"]) == [
        ("/left/camera_info", "sensor_msgs/msg/CameraInfo"),
        ("/left/image", "sensor_msgs/msg/Image"),
    ]


def test_plug_ins_of_a_publisher_declare_parameters_of_their_own() -> None:
    of_node = camera('publisher_ = image_transport::create_publisher(this, "image");')
    assert [(row["name"], row["type"]) for row in of_node["parameters"]] == [("*.enable_pub_plugins", "string_array")]
    assert of_node["complete"]


@pytest.mark.parametrize(
    ("given", "names"),
    [
        ("this", ["/camera/set_camera_info", "/set_camera_info"]),
        ('this, "left", "file:///left.yaml"', ["/camera/set_camera_info", "/set_camera_info"]),
        ('this, "left", "file:///left.yaml", "left"', ["/left/set_camera_info"]),
        (
            "get_node_base_interface(), get_node_services_interface(), get_node_logging_interface(), "
            '"left", "", rmw_qos_profile_default, "left"',
            ["/left/set_camera_info"],
        ),
    ],
)
def test_the_manager_of_a_camera_takes_its_calibration(given: str, names: list[str]) -> None:
    of_node = camera(f"manager_ = std::make_shared<camera_info_manager::CameraInfoManager>({given});")
    assert ends(of_node["services"]) == [(name, "sensor_msgs/srv/SetCameraInfo") for name in names]
    assert of_node["complete"]
