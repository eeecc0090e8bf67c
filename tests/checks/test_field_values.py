"""MSG003: values that fields do not take, and values that look like them and fit."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import math
import random
import time

import numpy as np
import rclpy
from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import Point, Pose, PoseArray, PoseStamped, PoseWithCovariance, Twist, Vector3
from rclpy.node import Node
from sensor_msgs.msg import Image, JointState, Joy
from std_msgs.msg import Bool, Float32, Float64, Float64MultiArray, Header, Int32, String, UInt8
from std_srvs.srv import SetBool


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('speed', 1)
        self.declare_parameter('rate', 1.5)
        self.speed = 0
        self.create_subscription(Twist, 'in', self.listen, 10)
        self.create_subscription(Joy, 'joy', self.steer, 10)
        self.create_service(SetBool, 'set', self.set_it)

    def set_it(self, request, response):
        response.success = request.data
        response.message = 'set to ' + str(request.data)
        return response

    def listen(self, message):
        self.speed = message.linear.x
        now = self.get_clock().now()
        {line}

    def steer(self, joy):
        {of_joy}

    def name(self):
        return 'robot'


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


def test_a_number_for_a_string_may_stand_for_another(judge: Judge):
    [finding] = judge("MSG003", NODE.format(line="String().data = 5  # here", of_joy="pass"))
    assert finding.help == "give it the string that is meant: str() would send '5'"


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (
            "String().data = 5",
            "'data' of std_msgs/msg/String takes a string, not the int 5: sending it fails (on humble",
        ),
        ("message.linear.x = '1'", "takes a float, not the string '1': something else is sent"),
        ("message.linear.x = 1", "takes a float, not the int 1: something else is sent"),
        ("message.linear.x = self.get_parameter('speed').value", "takes a float, not the int 1"),
        ("message.linear.x = self.get_parameter('rate')", "takes a float, not a Parameter"),
        ("message.linear.x = len(message.linear.x)", "takes a float, not an int"),
        ("message.linear.x = str(message.linear.x)", "takes a float, not a string"),
        ("Int32(data=1.5)", "takes an int, not the float 1.5: sending it fails"),
        ("Time().sec = time.time()", "takes an int, not a float"),
        ("UInt8(data=300)", "takes an int from 0 to 255, not the int 300: something else is sent"),
        ("UInt8(data=-1)", "takes an int from 0 to 255, not the int -1: sending it fails"),
        ("Bool(data='yes')", "takes a bool, not the string 'yes': False is sent"),
        ("Bool(data=1)", "takes a bool, not the int 1: False is sent"),
        ("SetBool.Response().success = 'yes'", "'success' of std_srvs/srv/SetBool.Response takes a bool"),
        ("PoseWithCovariance(covariance=[0.1, 0.1, 0.1])", "takes 36 floats, not 3 values: something else is sent"),
        ("PoseWithCovariance(covariance=0.1)", "takes 36 floats, not the float 0.1: the process crashes"),
        ("Header(stamp=self.get_clock().now())", "takes a builtin_interfaces/msg/Time, not a Time of rclpy"),
        ("Header(stamp=now)", "takes a builtin_interfaces/msg/Time, not a Time of rclpy: sending it fails"),
        ("Header(stamp=time.time())", "takes a builtin_interfaces/msg/Time, not a float"),
        ("Header(frame_id=self.name)", "takes a string, not a function"),
        ("Float64(data=np.float32(1.5))", "takes a float, not a float32 of numpy: something else is sent"),
        ("Float64(data=np.argmax([1, 2]))", "takes a float, not an int of numpy: something else is sent"),
        ("Float64(data=np.zeros(3))", "takes a float, not an array of numpy: something else is sent"),
        ("Bool(data=np.any([0, 1]))", "takes a bool, not a bool of numpy: False is sent"),
        (
            "String('ok')",
            "std_msgs/msg/String takes its fields by name, not an argument without a name: this line fails",
        ),
        ("PoseStamped(pose=PoseWithCovariance())", "takes a geometry_msgs/msg/Pose, not a geometry_msgs/msg/PoseWith"),
        ("PoseArray(poses=Pose())", "takes a list of geometry_msgs/msg/Poses, not a geometry_msgs/msg/Pose"),
        ("Float64MultiArray(data=['1', '2'])", "takes a list of floats, not the string '1' in a list: this line fails"),
        ("Float64MultiArray(data=1.0)", "takes a list of floats, not the float 1.0: this line fails"),
        ("JointState(name='arm')", "takes a list of strings, not the string 'arm': something else is sent"),
        ("JointState(name=[1])", "takes a list of strings, not the int 1 in a list: sending it fails"),
    ],
)
def test_a_value_that_a_field_does_not_take(judge: Judge, line: str, says: str):
    [finding] = judge("MSG003", NODE.format(line=f"{line}  # here", of_joy="pass"))
    assert says in finding.message


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("Int32(data=0.6)", "use a whole number, or another field: int() would cut the fraction off"),
        ("Int32(data=6.0)", "convert it with int()"),
        ("Int32().data = time.time()", "convert it with int()"),
    ],
)
def test_what_to_do_about_a_float_for_an_int(judge: Judge, line: str, help: str):
    [finding] = judge("MSG003", NODE.format(line=f"{line}  # here", of_joy="pass"))
    assert (finding.help or "").startswith(help)


@pytest.mark.parametrize(
    "line",
    [
        "String().data = '5'",
        "String().data = f'{message}'",
        "message.linear.x = 1.0",
        "message.linear.x = 0",  # is sent as 0.0; only humble refuses it
        "message.linear.x = np.float64(1)",
        "message.linear.x = self.get_parameter('rate').value",
        "message.linear.x = self.speed",
        "message.linear.x = min(1.0, message.linear.x)",
        "message.linear.x = min(0, message.linear.x)",  # 0 is sent as 0.0
        "message.linear.x = float(min(1, message.linear.x))",
        "message.linear.x = 1.0 if message.linear.y else message.linear.z",
        "message.linear = Point()",  # has the same fields
        "message.linear = Vector3(x=1.0)",
        "Int32(data=True)",
        "UInt8(data=255)",
        "Bool(data=message.linear.x > 0)",
        "Bool(data=0)",
        "PoseWithCovariance(covariance=[0.1] * 36)",
        "PoseWithCovariance(covariance=[0] * 36)",  # converted when it is set; only humble refuses it
        "PoseWithCovariance(covariance=np.zeros(36))",
        "Float64MultiArray(data=np.zeros(3))",
        "Float64MultiArray(data=[np.float32(1.0)])",
        "Float64MultiArray(data=np.float32(message.linear.x))",
        "Int32(data=np.argmax([1, 2]))",
        "PoseWithCovariance(covariance=[message.linear.x for _ in range(36)])",
        "Header(stamp=self.get_clock().now().to_msg())",
        "Header(stamp=now.to_msg())",
        "Header(stamp=message.stamp)",
        "Header(frame_id=self.name())",
        "PoseArray(poses=[Pose()])",
        "PoseArray(poses=[])",
        "Float64MultiArray(data=[1, 2])",
        "Float64MultiArray(data=(1.0, 2.0))",
        "JointState(name=['arm'], position=[0.5])",
        "Image(data=b'123')",
        "DiagnosticStatus(level=DiagnosticStatus.OK)",
        "String(data=None)",  # may be a placeholder
    ],
)
def test_a_value_that_fits(judge: Judge, line: str):
    assert not judge("MSG003", NODE.format(line=line, of_joy="pass"))


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("String().data = joy.axes[0]", "takes a string, not a float: sending it fails"),
        ("Float32().data = joy.buttons[0]", "takes a float, not an int: something else is sent"),
        ("Bool(data=joy.buttons[0])", "takes a bool, not an int: False is sent"),
        ("Int32().data = joy.axes[0]", "takes an int, not a float: sending it fails"),
        ("Int32().data = joy.axes[0] * 100", "takes an int, not a float"),
        ("Int32().data = 2 * len(joy.axes) / 3", "takes an int, not a float"),
        ("Int32().data = round(joy.axes[0], 1)", "takes an int, not a float"),
        ("Int32().data = max(joy.axes)", "takes an int, not a float"),
        ("Float32().data = joy.buttons[0] - joy.buttons[1]", "takes a float, not an int"),
        ("Float32().data = round(joy.axes[0])", "takes a float, not an int"),
        ("Float32().data = -joy.buttons[0]", "takes a float, not an int"),
        ("Float32().data = random.randint(0, 10)", "takes a float, not an int"),
        ("Int32().data = random.uniform(0, 10)", "takes an int, not a float"),
        ("Int32().data = math.sqrt(len(joy.axes))", "takes an int, not a float"),
        ("Float32().data = joy.header.frame_id", "takes a float, not a string"),
        ("Float32().data = joy.axes", "takes a float, not a list"),
        ("Header(stamp=self.get_clock().now().nanoseconds)", "takes a builtin_interfaces/msg/Time, not an int"),
        ("String().data = joy.header.stamp.sec", "takes a string, not an int"),
    ],
)
def test_a_field_of_one_message_that_does_not_fit_another(judge: Judge, line: str, says: str):
    [finding] = judge("MSG003", NODE.format(line="pass", of_joy=f"{line}  # here"))
    assert says in finding.message


@pytest.mark.parametrize(
    "line",
    [
        "Float32().data = joy.axes[0]",
        "Float32().data = joy.axes[0] * 2",
        "Float32().data = joy.axes[0] - joy.buttons[0]",
        "Float32().data = joy.buttons[0] / 2",
        "Float32().data = float(joy.buttons[0])",
        "Float32().data = joy.buttons[0] * np.pi",
        "Float32().data = joy.buttons[0] ** -1",
        "Float32().data = math.pi * joy.buttons[0]",
        "Float32().data = round(joy.axes[0], 1)",
        "Float32().data = max(joy.axes)",
        "Float32().data = joy.stamp",
        "Int32().data = joy.buttons[0] // 2",
        "Int32().data = int(joy.axes[0] * 100)",
        "Int32().data = round(joy.axes[0])",
        "Int32().data = math.floor(joy.axes[0])",
        "Int32().data = joy.buttons[0] == 1",
        "Bool().data = bool(joy.buttons[0])",
        "Bool().data = joy.buttons[0] == 1",
        "String().data = str(joy.axes[0])",
        "String().data = joy.header.frame_id",
        "Float64MultiArray().data = joy.axes",
        "Time().sec = joy.header.stamp.sec",
        "Time().sec = int(time.time())",
        "Time().nanosec = now.nanoseconds % 10**9",
        "joy.axes = joy.buttons",
    ],
)
def test_a_field_of_one_message_that_fits_another(judge: Judge, line: str):
    assert not judge("MSG003", NODE.format(line="pass", of_joy=line))


TWO_TYPES = """
from rclpy.node import Node
from std_msgs.msg import Float32, Int32


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(Int32, 'count', self.forward, 10)
        self.create_subscription(Float32, 'speed', self.forward, 10)

    def forward(self, message):
        out = Float32()
        out.data = message.data
"""


def test_a_callback_of_two_types(judge: Judge):
    assert not judge("MSG003", TWO_TYPES)


ARRAYS = """
from geometry_msgs.msg import PoseWithCovariance
from rclpy.node import Node
from std_msgs.msg import Float64MultiArray, Int32MultiArray


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        {line}
"""


def test_a_constructor_makes_an_array_of_numbers_itself(judge: Judge):
    """It calls array.array() or numpy.array(), which convert; humble checks what comes of that."""
    judge("MSG003", ARRAYS.format(line="Float64MultiArray().data = [1, 2]  # here"), config='distro = "humble"')
    for right in ("Float64MultiArray(data=[1, 2])", "PoseWithCovariance(covariance=[0] * 36)"):
        assert not judge("MSG003", ARRAYS.format(line=right), config='distro = "humble"')
    wrong = ARRAYS.format(line="Int32MultiArray(data=[1.5])  # here")
    [finding] = judge("MSG003", wrong, config='distro = "humble"')
    assert finding.message.endswith("takes a list of ints, not the float 1.5 in a list: this line fails")


def test_a_helper_that_is_given_right_and_wrong_values(judge: Judge):
    source = """
from rclpy.node import Node
from std_msgs.msg import Float64


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.publisher = self.create_publisher(Float64, 'speed', 10)
        self.send(1.5)
        self.send(2)

    def send(self, speed):
        self.publisher.publish(Float64(data=speed))  # here
"""
    [finding] = judge("MSG003", source)
    assert [(row.place.line, row.message) for row in finding.related] == [(10, "this call gives it the value")]
    assert not judge("MSG003", source.replace("(2)", "(2.0)").replace("  # here", ""))


GUARDED = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.message = Float64()
        {line}
"""


def test_an_exception_that_is_expected(judge: Judge):
    assignment = "self.message.data = 1"
    guarded = f"try:\n            {assignment}\n        except (AssertionError, TypeError):\n            pass"
    judge("MSG003", GUARDED.format(line=f"{assignment}  # here"))
    assert not judge("MSG003", GUARDED.format(line=guarded))


@pytest.mark.parametrize("value", ["1", "0"])
def test_humble_checks_what_is_assigned(judge: Judge, value: str):
    source = GUARDED.format(line=f"self.message.data = {value}  # here")
    [finding] = judge("MSG003", source, config='distro = "humble"')
    assert finding.message.endswith(f"takes a float, not the int {value}: this line raises AssertionError")


@pytest.mark.parametrize(
    "value",
    [
        "1 if message.linear.y else message.linear.z",
        "min(1, message.linear.x)",
        "max(-1, min(message.linear.x, 1.0))",
    ],
)
def test_a_whole_number_that_a_float_field_gets_in_one_branch(judge: Judge, value: str):
    [finding] = judge("MSG003", NODE.format(line=f"message.linear.x = {value}  # here", of_joy="pass"))
    assert "takes a float, not the int" in finding.message
    assert "that it gets in one branch: something else is sent" in finding.message


DRIVER = """
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.turns = 0
        self.nearest = -1
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)
        self.create_timer(1.0, self.tick)

    def on_scan(self, scan):
        self.nearest = scan.ranges[0]
        nearest = 100
        for distance in scan.ranges:
            if distance < nearest:
                nearest = distance
        if nearest < 100:
            self.drive(nearest)

    def tick(self):
        if self.nearest >= 0:
            self.drive(self.nearest)
        self.turns += 1
{line}

    def drive(self, speed):
        message = Twist()
        message.linear.x = speed{here}
        self.pub.publish(message)


rclpy.init()
rclpy.spin(Robot())
"""


def test_a_number_that_one_call_gives_a_field(judge: Judge):
    """The other calls give it floats."""
    [finding] = judge("MSG003", DRIVER.format(line="        self.drive(2)", here="  # here"))
    assert "takes a float, not the int 2: something else is sent" in finding.message
    [counted] = judge("MSG003", DRIVER.format(line="        Twist().linear.y = self.turns  # here", here=""))
    assert "takes a float, not an int" in counted.message


def test_calls_that_give_floats(judge: Judge):
    """A number that stands for nothing yet is ruled out by the test before the call."""
    for line in ("self.drive(2.0)", "self.drive(float(self.turns))", "self.drive(self.turns / 10)"):
        assert not judge("MSG003", DRIVER.format(line=f"        {line}", here=""))


@pytest.mark.parametrize(
    ("readme", "files", "told"),
    [
        ("# Robot\n\nFor ROS 2 Humble on Ubuntu 22.04.\n", {}, True),
        ("# Robot\n\nFor ROS 2 Humble and Jazzy.\n", {}, False),
        ("# Robot\n", {}, False),
        ("# Robot\n\nFor ROS 2 Humble.\n", {"Dockerfile": "FROM ros:jazzy\n"}, False),
    ],
)
def test_a_readme_that_names_humble_alone(judge: Judge, readme: str, files: dict[str, str], told: bool):
    for name, text in {"README.md": readme, **files}.items():
        (judge.folder / name).write_text(text, encoding="utf-8")
    mark = "  # here" if told else ""
    findings = judge("MSG003", DRIVER.format(line=f"        Twist().linear.y = 0{mark}", here=""))
    assert ["this line raises AssertionError on humble" in finding.message for finding in findings] == [True] * told


def test_fields_of_one_type_that_get_the_same_wrong_kind_are_one_finding(judge: Judge):
    line = "; ".join(
        ["point = self.kept = Point()", "point.x = 'a'", "point.y = 'b'", "point.z = 'c'", "Twist().linear.x = 'd'"]
    )
    text = NODE.replace("{line}", line.replace("; ", "\n        ")).replace("{of_joy}", "pass")
    text = text.replace("point.x = 'a'", "point.x = 'a'  # here").replace("linear.x = 'd'", "linear.x = 'd'  # here")
    first, other = judge("MSG003", text)
    assert "'x' of geometry_msgs/msg/Point takes a float" in first.message
    assert first.message.endswith("; 2 more lines do the same")
    assert ["'y'" in first.related[0].message, "'z'" in first.related[1].message] == [True, True]
    assert "'x' of geometry_msgs/msg/Vector3" in other.message


def test_values_of_one_line_count_as_this_line(judge: Judge):
    line = "print(Point(x='a', y='b'))  # here"
    [alone] = judge("MSG003", NODE.replace("{line}", line).replace("{of_joy}", "pass"))
    assert "more line" not in alone.message and "another line" not in alone.message
    assert ["'y'" in row.message for row in alone.related] == [True]
    lines = f"{line}\n        print(Point(x='c', y='d'))"
    [both] = judge("MSG003", NODE.replace("{line}", lines).replace("{of_joy}", "pass"))
    assert both.message.endswith("; another line does the same")


def test_a_name_that_no_interface_package_has_comes_from_another_star_import(judge: Judge):
    """visualization_msgs has a Marker, and neither a Pose nor an InteractiveMarkerServer."""
    judge(
        "MSG003",
        """
        import rclpy
        from elsewhere import *
        from visualization_msgs.msg import *

        def main():
            rclpy.init()
            node = rclpy.create_node('robot')
            server = InteractiveMarkerServer(node, 'goals')
            marker = Marker()
            marker.pose = Pose()
            marker.id = 'first'  # here
            rclpy.spin(node)
        """,
    )


SENT = """
        flags, counts = self.create_publisher(Bool, 'flags', 10), self.create_publisher(Int32, 'counts', 10)
        text = String()
        text.data = {value}
        {between}{publisher}.publish(text)"""


@pytest.mark.parametrize(
    ("between", "publisher", "told"),
    [
        ("", "counts", False),
        ("self.get_logger().info(text.data)\n        ", "counts", True),
        ("", "self.create_publisher(String, 'texts', 10)", True),
    ],
)
def test_the_wrong_message_is_told_where_it_is_sent(judge: Judge, between: str, publisher: str, told: bool):
    """TOP005 says that this publisher wants an Int32, to which the value would be right."""
    value = "1  # here" if told else "1"
    judge("MSG003", NODE.format(line=SENT.format(value=value, between=between, publisher=publisher), of_joy="pass"))
    if publisher == "counts":
        sent = SENT.format(value="1", between=between, publisher=publisher) + "  # here"
        judge("TOP005", NODE.format(line=sent, of_joy="pass"))


HELPER = """
    import rclpy
    from geometry_msgs.msg import Pose, Quaternion
    from rclpy.node import Node

    def pose_of(orientation):
        pose = Pose()
        if {test}:
            pose.orientation = orientation{found}
        else:
            pose.orientation.w = float(orientation[3])
        return pose

    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.publisher = self.create_publisher(Pose, 'pose', 10)
            self.publisher.publish(pose_of([0.0, 0.0, 0.0, 1.0]))
            {also}

    def main():
        rclpy.init()
        rclpy.spin(Robot())
"""


@pytest.mark.parametrize("also", ["pass", "self.publisher.publish(pose_of(Quaternion()))"])
@pytest.mark.parametrize(
    ("test", "found"),
    [
        ("hasattr(orientation, 'x')", ""),
        ("isinstance(orientation, Quaternion)", ""),
        ("not isinstance(orientation, (list, tuple))", ""),
        ("hasattr(orientation, 'x') and orientation.w", ""),
        ("hasattr(orientation, '__len__')", "  # here"),  # which a list has
    ],
)
def test_a_value_that_code_asks_for_what_only_a_message_has(judge: Judge, test: str, found: str, also: str):
    if found and "Quaternion" in also:
        return  # what is right in one run is not wrong each time
    judge("MSG003", HELPER.format(test=test, found=found, also=also))


def test_values_of_one_line_are_one_finding_whatever_comes_of_each(judge: Judge):
    """A float field that gets an int raises on humble; elsewhere 1 becomes something else, and 0 does not."""
    (judge.folder / "Dockerfile").write_text("FROM ros:humble\n", encoding="utf-8")
    line = "colour = ColorRGBA()\n        colour.r, colour.g, colour.b = (0, 0, 1)  # here"
    text = NODE.replace("{line}", line).replace("{of_joy}", "pass")
    [told] = judge("MSG003", f"from std_msgs.msg import ColorRGBA\n{text}")
    assert ["'r'" in told.message, *(row.message[:3] for row in told.related)] == [True, "'g'", "'b'"]
