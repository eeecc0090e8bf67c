"""What is offered where somebody types, in files that need not be complete."""

from __future__ import annotations

from pathlib import Path

import pytest

from lookup.asking import Editor
from robot_package import manifest, write_files

CREATED = "SensorReading, 'sensor_data', 10)"


def test_topics_of_the_type_at_hand(lesson: Editor):
    assert lesson.complete("control_node.py", "'sensor_data',", "'se^',") == ["sensor_data"]
    assert lesson.complete("control_node.py", "'sensor_data',", "'/^',") == ["/sensor_data"]


def test_a_call_that_nobody_has_finished(lesson: Editor):
    typed = "\n        self.other = self.create_subscription(SensorReading, 'se^"
    assert lesson.complete("control_node.py", "\n        self.latest_temp = 0.0\n", typed) == ["sensor_data"]
    assert lesson.complete("control_node.py", "\n        self.latest_temp = 0.0\n", f"{typed}\n\n") == ["sensor_data"]


@pytest.mark.parametrize(
    ("call", "names"),
    [
        ("create_subscription(SensorReading, '^'", ["sensor_data"]),
        ("create_subscription(topic='^'", ["sensor_data"]),
        ("create_subscription(GetSensorData, '^'", []),
        ("create_client(GetSensorData, '^'", ["query_sensor"]),
        ("create_client(SetMotorSpeed, srv_name='^'", ["set_motor"]),
        ("create_client(Unknown, '^'", []),
        ("create_timer('^'", []),
        ("create_subscription(SensorReading, 'sensor_data', '^'", []),
        ("get_logger().info('^'", []),
        ("create_subscription(SensorReading, f'{name}/^'", []),
    ],
)
def test_names_by_kind_and_type(lesson: Editor, call: str, names: list[str]):
    typed = f"\n        self.other = self.{call}\n"
    assert lesson.complete("control_node.py", "\n        self.latest_temp = 0.0\n", typed) == names


def test_the_other_end_comes_first(launched: Editor):
    answers = launched.completions("driver.py", "String, 'scan',", "String, '^',")
    assert [(each.text, each.rank) for each in answers] == [
        ("driver/state", 0),
        ("scan", 0),
        ("north/base/wheels/state", 1),
        ("south/base/wheels/state", 1),
    ]


def test_types_that_are_imported_and_the_import_of_others(lesson: Editor):
    old = "            SetMotorSpeed, 'set_motor')"
    assert lesson.complete("control_node.py", old, "            ^") == ["GetSensorData", "SetMotorSpeed"]
    answers = {each.detail: each for each in lesson.completions("control_node.py", old, "            Tri^")}
    [edit] = answers["std_srvs/srv/Trigger"].also
    assert (edit.place.line, edit.text) == (5, "from std_srvs.srv import Trigger\n")


def test_types_of_an_import(lesson: Editor):
    old = "from my_robot_interfaces.msg import SensorReading"
    assert lesson.complete("motor_node.py", "import rclpy\n", "from my_robot_interfaces.srv import ^") == [
        "GetSensorData",
        "SetMotorSpeed",
    ]
    assert "SensorReading" in lesson.complete("sensor_node.py", old, "from my_robot_interfaces.msg import Sens^")


def test_parameters_of_the_class(launched: Editor):
    added = "        self.get_parameter('^')\n    def scan(self):\n"
    assert launched.complete("scanner.py", "    def scan(self):\n", added) == ["topic"]
    assert launched.complete("driver.py", "    def drive(self, message):\n", added) == []


def test_packages_and_executables_of_a_python_launch_file(launched: Editor):
    old = "package='patrol',\n            executable='recorder'"
    assert launched.complete("fleet.launch.py", old, "package='^'") == ["patrol", "rosbag2_transport"]
    executables = ["driver", "recorder", "scanner"]
    assert launched.complete("fleet.launch.py", old, "package='patrol', executable='^") == executables
    assert launched.complete("fleet.launch.py", old, "executable='^', package='patrol'") == executables


def test_remappings_and_parameters_of_a_python_launch_file(launched: Editor):
    old = "package='patrol',\n            executable='recorder'"
    driver = "package='patrol', executable='driver', remappings="
    assert launched.complete("fleet.launch.py", old, f"{driver}[('^") == ["scan", "~/state"]
    targets = launched.complete("fleet.launch.py", old, f"{driver}[('scan', '^')]")
    assert "/north/front/scan" in targets and "/south/scan" in targets
    scanner = "package='patrol', executable='scanner', parameters="
    assert launched.complete("fleet.launch.py", old, f"{scanner}[{{'^'}}]") == ["topic"]
    assert launched.complete("fleet.launch.py", old, f"{scanner}[{{'topic': '^'}}]") == []


def test_an_xml_launch_file(launched: Editor):
    old = '<remap from="scan" to="$(var scan)"/>'
    assert launched.complete("robot.launch.xml", old, '<remap from="^') == ["scan", "~/state"]
    assert "/south/scan" in launched.complete("robot.launch.xml", old, '<remap from="scan" to="^"/>')
    assert launched.complete("robot.launch.xml", old, '</node><node pkg="^') == ["patrol", "rosbag2_transport"]
    node = '</node><node pkg="patrol" exec="'
    assert launched.complete("robot.launch.xml", old, f"{node}^") == ["driver", "recorder", "scanner"]
    assert launched.complete("robot.launch.xml", old, f'{node}scanner"><param name="^') == ["topic"]
    assert launched.complete("robot.launch.xml", old, f'{node}scanner"/><param name="^') == []
    assert launched.complete("robot.launch.xml", "$(find-pkg-share patrol)", "$(find-pkg-share p^") != []
    assert launched.complete("robot.launch.xml", old, '<!-- <remap from="^" -->') == []


def test_a_parameter_file(launched: Editor):
    assert launched.complete("patrol.yaml", "    topic: front/scan", "    to^") == ["topic"]
    assert "/north/scanner" in launched.complete("patrol.yaml", "/north/scanner:", "/no^")
    assert launched.complete("patrol.yaml", "    topic: front/scan", "    topic: fr^") == []


def test_a_yaml_launch_file_and_nested_parameters(robot: Path):
    talker = """\
from rclpy.node import Node
import rclpy
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('limits.speed', 1.0)
        self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
    setup = (
        "from setuptools import setup\nsetup(name='robot', entry_points={'console_scripts': ['talk = talker:main']})\n"
    )
    launch = "launch:\n  - node:\n      pkg: robot\n      exec: talk\n"
    files = {"talker.py": talker, "setup.py": setup, "package.xml": manifest(), "launch/it.launch.yaml": launch}
    write_files(robot, {**files, "config/params.yaml": "talker:\n  ros__parameters:\n    limits:\n      speed: 2.0\n"})
    editor = Editor()
    assert editor.complete("it.launch.yaml", "pkg: robot", "pkg: ^") == ["robot"]
    assert editor.complete("it.launch.yaml", "exec: talk", "exec: ^") == ["talk"]
    remap = "exec: talk\n      remap:\n        - from: "
    assert editor.complete("it.launch.yaml", "exec: talk", f"{remap}^") == ["chatter"]
    assert editor.complete("it.launch.yaml", "exec: talk", f"{remap}chatter\n          to: ^") == ["/chatter"]
    param = "exec: talk\n      param:\n        - name: ^"
    assert editor.complete("it.launch.yaml", "exec: talk", param) == ["limits.speed"]
    assert editor.complete("params.yaml", "      speed: 2.0", "      sp^") == ["speed"]


def test_nothing_in_a_comment_or_a_docstring(lesson: Editor):
    old = "        # Control loop\n"
    assert lesson.complete("control_node.py", old, "        # self.create_client(SetMotorSpeed, '^\n") == []
    assert lesson.complete("control_node.py", old, '        """self.create_client(SetMotorSpeed, ^\n"""\n') == []
