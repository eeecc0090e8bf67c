"""Where names lead."""

from __future__ import annotations

from pathlib import Path

from lookup.asking import Editor
from robot_package import manifest, write_files

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from robot.names import CHATTER


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 2.0)
        self.declare_parameters('', [('frame', 'map')])
        self.create_publisher(String, CHATTER, 10)
        self.rate, self.frame = self.get_parameters(['rate', 'frame'])

    def tick(self):
        return self.get_parameter('frame').value


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
SETUP = """\
from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['talker = robot.talker:main']})
"""


def test_the_other_end_of_a_topic(lesson: Editor):
    assert lesson.definition("control_node.py", "'sensor^_data'") == ["sensor_node.py:13 'sensor_data'"]
    assert lesson.definition("sensor_node.py", "'sensor^_data'") == ["control_node.py:14 'sensor_data'"]


def test_the_other_end_of_a_service(lesson: Editor):
    assert lesson.definition("control_node.py", "'query^_sensor'") == ["sensor_node.py:18 'query_sensor'"]
    assert lesson.definition("sensor_node.py", "'query^_sensor'") == ["control_node.py:20 'query_sensor'"]


def test_a_type_leads_to_its_file(lesson: Editor):
    assert lesson.definition("sensor_node.py", "^SensorReading, 'sensor_data'") == ["SensorReading.msg:1"]


def test_the_type_of_a_field_and_its_import(robot: Path):
    scaffold = "project(robot_msgs)\nrosidl_generate_interfaces(robot_msgs msg/Wheel.msg msg/Base.msg srv/Turn.srv)\n"
    files = {
        "package.xml": manifest(
            "robot_msgs", "ament_cmake", "<member_of_group>rosidl_interface_packages</member_of_group>"
        ),
        "CMakeLists.txt": scaffold,
        "msg/Wheel.msg": "float64 speed\n",
        "msg/Base.msg": "# The wheels, left and right.\nWheel[2] wheels\nstd_msgs/Header header\n",
        "srv/Turn.srv": "robot_msgs/Wheel wheel\n---\nbool done\n",
        "it.py": "import rclpy\nfrom robot_msgs.msg import Wheel as Wheel\n",
    }
    write_files(robot, files)
    editor = Editor()
    assert editor.definition("Base.msg", "Whe^el[2] wheels") == ["Wheel.msg:1"]
    assert editor.definition("it.py", "import Whe^el as") == ["Wheel.msg:1"]
    assert editor.references("Turn.srv", "robot_msgs/Whe^el wheel") == [
        "it.py:2 Wheel",
        "Base.msg:2 Wheel",
        "Turn.srv:1 robot_msgs/Wheel",
    ]
    assert "float64 speed" in (editor.hover("Base.msg", "Whe^el[2] wheels") or "")
    assert editor.definition("Base.msg", "std_msgs/Head^er") == []


def test_a_remapping_leads_to_the_create_call(launched: Editor):
    assert launched.definition("robot.launch.xml", 'from="sc^an"') == ["driver.py:10 'scan'"]
    assert launched.definition("fleet.launch.py", "'/north^/front/scan'") == ["driver.py:10 'scan'"]


def test_all_that_mentions_a_topic(launched: Editor):
    assert launched.references("fleet.launch.py", "'/north^/front/scan'") == [
        "patrol.yaml:4 front/scan",
        "fleet.launch.py:24 '/north/front/scan'",
        'robot.launch.xml:9 from="scan"',
        "driver.py:10 'scan'",
        "scanner.py:10 topic",
    ]


def test_an_executable_leads_to_its_function(launched: Editor):
    assert launched.definition("robot.launch.xml", 'exec="driv^er"') == ["driver.py:16 main"]
    assert launched.definition("setup.py", "'driver = patrol.driver^:main'") == ["driver.py:16 main"]
    assert launched.references("driver.py", "super().__init__('dri^ver')") == [
        'robot.launch.xml:8 name="wheels"',
        "driver.py:8 'driver'",
    ]


def test_a_file_that_is_named(launched: Editor):
    assert launched.definition("fleet.launch.py", "'robot.launch^.xml'") == ["robot.launch.xml:1"]
    assert launched.definition("robot.launch.xml", "config/patrol^.yaml") == ["patrol.yaml:1"]


def test_a_parameter_that_a_file_sets(launched: Editor):
    assert launched.definition("patrol.yaml", "to^pic: front") == ["scanner.py:9 'topic'"]
    assert launched.definition("scanner.py", "'to^pic'") == ["patrol.yaml:4 topic"]


def test_parameters_of_lists_and_constants_of_other_files(robot: Path):
    files = {
        "robot/talker.py": TALKER,
        "robot/__init__.py": "",
        "robot/names.py": "CHATTER = 'chatter'\n",
        "setup.py": SETUP,
        "launch/it.launch.yaml": (
            "launch:\n  - node:\n      pkg: robot\n      exec: talker\n      param:\n"
            "        - name: rate\n          value: 4.0\n"
        ),
        "package.xml": manifest(),
    }
    editor = Editor() if write_files(robot, files) else None
    assert editor is not None
    assert editor.definition("talker.py", "get_parameter('fr^ame')") == ["talker.py:11 'frame'"]
    assert editor.references("talker.py", "('fr^ame', 'map')") == [
        "talker.py:11 'frame'",
        "talker.py:13 'frame'",
        "talker.py:16 'frame'",
    ]
    assert editor.definition("it.launch.yaml", "name: ra^te") == ["talker.py:10 'rate'"]
    assert editor.references("names.py", "'chat^ter'") == ["names.py:1 'chatter'", "talker.py:12 CHATTER"]


def test_a_name_of_a_node_from_elsewhere_leads_to_where_that_is_started(launched: Editor):
    [place] = launched.definition("fleet.launch.py", "'events^/write_split'")
    assert place.startswith("fleet.launch.py:31 Node(")
