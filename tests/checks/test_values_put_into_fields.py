"""MSG003: what is put into the array of a field, and objects of the workspace's own classes."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
import rclpy.time
from enum import Enum, IntEnum
from geometry_msgs.msg import Point, Pose, PoseArray, PoseStamped
from nav_msgs.msg import Path
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Int32, String
from visualization_msgs.msg import Marker


class State(Enum):
    IDLE = 'idle'


class Level(IntEnum):
    LOW = 1


class Place:
    def __init__(self):
        self.name = 'kitchen'


class Spot:
    def __init__(self):
        self.x, self.y, self.z = 1.0, 2.0, 0.0


class Name(str):
    pass


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.places = [Place(), Place()]
        self.kept = Path()
        self.path_publisher = self.create_publisher(Path, 'path', 10)
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        path, poses, joints, marker = Path(), PoseArray(), JointState(), Marker()
        {line}
        print(path, poses, joints, marker)


def main():
    rclpy.init()
    rclpy.spin(Planner())


main()
"""


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (
            "path.poses.append(Pose())",
            "takes a list of geometry_msgs/msg/PoseStampeds, not a geometry_msgs/msg/Pose in a list: sending it fails",
        ),
        (
            "self.kept.poses.append(Pose())",
            "takes a list of geometry_msgs/msg/PoseStampeds, not a geometry_msgs/msg/Pose in a list: sending it fails",
        ),
        (
            "poses.poses.append([1.0, 2.0])",
            "not a list in a list: sending it fails",
        ),
        ("poses.poses.insert(0, Point())", "not a geometry_msgs/msg/Point in a list: sending it fails"),
        ("poses.poses = self.places", "not an object of class Place in a list: sending it fails"),
        ("poses.poses.extend([Place() for _ in range(2)])", "not an object of class Place in a list: sending it fails"),
        ("joints.name.append(3)", "takes a list of strings, not the int 3 in a list: sending it fails"),
        ("joints.position.append('0.5')", "takes a list of floats, not the string '0.5' in a list: this line fails"),
        ("marker.header.stamp = rclpy.time.Time(seconds=1)", "not a Time of rclpy: sending it fails"),
        ("marker.text = self.places[0]", "takes a string, not an object of class Place: sending it fails"),
        ("marker.text = State.IDLE", "takes a string, not a member of an enum: sending it fails"),
        ("marker.type = State.IDLE", "takes an int, not a member of an enum: sending it fails"),
    ],
)
def test_what_an_array_or_a_field_does_not_take(judge: Judge, line: str, says: str) -> None:
    (finding,) = judge("MSG003", NODE.format(line=f"{line}  # here"))
    assert says in finding.message


@pytest.mark.parametrize(
    "line",
    [
        "path.poses.append(PoseStamped())",
        "poses.poses.append(self.kept.poses[0].pose)",
        "joints.position.append(1)",
        "joints.name.append(Name('wheel'))",
        "joints.name.append(Level.LOW.name)",
        "joints.name.insert(0, 'wheel')",
        "joints.name.extend('wheels')",
        "marker.points.append(Spot())",
        "marker.type = Level.LOW",
        "marker.text = State.IDLE.value",
        "marker.text = Name('wheel')",
        "self.places.append(Pose())",
        "try:\n            joints.position.append('a')\n        except TypeError:\n            pass",
    ],
)
def test_what_an_array_or_a_field_takes(judge: Judge, line: str) -> None:
    """What has the fields of a message is sent as one, but by humble."""
    judge("MSG003", NODE.format(line=line))
