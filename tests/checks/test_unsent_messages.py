"""MSG003: fields of messages that never leave the function that makes them, which only humble's setters look at."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
import tf2_geometry_msgs
from geometry_msgs.msg import Point, PointStamped, PoseArray, Pose
from rclpy.node import Node


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.publisher = self.create_publisher(PointStamped, 'seen', 10)
        self.create_timer(0.1, self.look)
        self.seen = []

    def look(self):
        corner = Point()
        corner.x = 1{mark}
        point = PointStamped()
        point.point = corner
        {line}


def main():
    rclpy.init()
    rclpy.spin(Camera())
"""

STAYS = (
    "print(point.point.x + 1.0)",
    "self.get_logger().info(f'{point}')",
    "seen = tf2_geometry_msgs.do_transform_point(point, None)",
    "self.publisher.publish(tf2_geometry_msgs.do_transform_point(point, None))",
    "poses = PoseArray()\n        poses.poses.append(Pose(position=corner))",
)


@pytest.mark.parametrize("line", STAYS)
def test_a_message_that_only_computes(judge: Judge, line: str) -> None:
    """No distribution later than humble looks at the field, and nothing converts it."""
    assert not judge("MSG003", NODE.format(mark="", line=line))


@pytest.mark.parametrize("line", STAYS)
def test_humble_refuses_it_all_the_same(judge: Judge, line: str) -> None:
    (judge.folder / "Dockerfile").write_text("FROM ros:humble\n", encoding="utf-8")
    [finding] = judge("MSG003", NODE.format(mark="  # here", line=line))
    assert finding.message.endswith("not the int 1: this line raises AssertionError on humble")


def test_two_distributions_of_which_one_refuses_it(judge: Judge) -> None:
    (judge.folder / "README.md").write_text("# Camera\n\nFor ROS 2 Humble and Jazzy.\n", encoding="utf-8")
    assert not judge("MSG003", NODE.format(mark="", line="print(point)"))


@pytest.mark.parametrize(
    "line",
    [
        "self.publisher.publish(point)",
        "self.seen.append(point)",
        "self.last = point",
        "return corner",
        "poses = PoseArray(poses=[Pose(position=corner)])",  # of lists nothing is followed
        "seen = point\n        self.publisher.publish(seen)",
        "self.work(lambda: point)",
    ],
)
def test_a_message_that_goes_elsewhere(judge: Judge, line: str) -> None:
    [finding] = judge("MSG003", NODE.format(mark="  # here", line=line))
    assert "takes a float, not the int 1: something else is sent (on humble" in finding.message


def test_what_is_put_into_a_list_runs_no_setter(judge: Judge) -> None:
    """Humble's messages check what is assigned to a field, and a list takes anything: the line raises nothing."""
    (judge.folder / "Dockerfile").write_text("FROM ros:humble\n", encoding="utf-8")
    line = "self.poses = PoseArray()\n        self.poses.poses.append(corner)  # here"
    [finding] = judge("MSG003", NODE.replace("corner.x = 1", "corner.x = 1.0").format(mark="", line=line))
    assert finding.message.endswith("not a geometry_msgs/msg/Point in a list: sending it fails")


ROW = """
import rclpy
from geometry_msgs.msg import Point, Twist
from rclpy.node import Node
from std_msgs.msg import Float64MultiArray, String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.names = self.create_publisher(String, 'name', 10)
        self.points = self.create_publisher(Point, 'point', 10)
        self.values = self.create_publisher(Float64MultiArray, 'values', 10)
        self.create_timer(0.1, self.look)

    def look(self):
        {first}  # here
        name = String()
        name.data = 5{other}
        if self.values:
            point = Point()
            point.x = 'left'{other}
            self.points.publish(point)
        self.names.publish(name)


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize("distro", ["humble", "jazzy"])
def test_lines_behind_one_that_fails_are_one_finding(judge: Judge, distro: str) -> None:
    (judge.folder / "Dockerfile").write_text(f"FROM ros:{distro}\n", encoding="utf-8")
    first = "self.values.publish(Float64MultiArray(data=['1']))"
    [finding] = judge("MSG003", ROW.format(first=first, other=""))
    assert finding.message.endswith("; 2 more lines behind it are wrong, too")
    assert [row.place.line for row in finding.related] == [19, 22]


def test_lines_behind_one_that_fails_when_it_is_sent_are_findings_of_their_own(judge: Judge) -> None:
    """In jazzy the line itself raises nothing, and another message is what fails next."""
    (judge.folder / "Dockerfile").write_text("FROM ros:jazzy\n", encoding="utf-8")
    text = ROW.format(first="twist = Twist(); twist.linear.x = 1; self.publisher.publish(twist)", other="  # here")
    assert len(judge("MSG003", text)) == 3


UNTIL = """
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.speed = 5
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.create_timer(0.1, self.drive)

    def on_odom(self, odom):
        self.speed = odom.twist.twist.linear.x

    def drive(self):
        twist = Twist()
        twist.linear.x = {value}
        self.publisher.publish(twist)


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize("value", ["self.speed", "max(self.speed, 0.5)", "min(0.5, self.speed)"])
def test_what_an_attribute_holds_until_a_callback_has_set_it(judge: Judge, value: str) -> None:
    """Whether that is ever sent depends on what comes first."""
    assert not judge("MSG003", UNTIL.format(value=value))


def test_a_whole_number_that_the_callback_itself_gives(judge: Judge) -> None:
    [finding] = judge("MSG003", UNTIL.format(value="max(self.speed, 2)  # here"))
    assert "not the int 2 that it gets in one branch" in finding.message
