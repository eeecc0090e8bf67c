"""The package ``robot`` with one node and a launch file, which tests of launch files, rules and systems write."""

from __future__ import annotations

from pathlib import Path

MANIFEST = """<package format="3"><name>{name}</name>
<exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend>{more}
<export><build_type>{type}</build_type></export></package>
"""
SETUP_OF = """\
from glob import glob
from setuptools import setup
setup(
    name='{name}',
    data_files=[('share/{name}/launch', glob('launch/*')), ('share/{name}/config', glob('config/*'))],
    entry_points={{'console_scripts': ['talker = {name}.talker:main']}},
)
"""
SETUP = SETUP_OF.format(name="robot")
SETUP_CFG = "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n"
TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)
        self.create_publisher(String, 'chatter', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def manifest(name: str = "robot", build_type: str = "ament_python", more: str = "") -> str:
    """A package.xml that declares what the talker needs."""
    return MANIFEST.format(name=name, type=build_type, more=more)


def write_files(root: Path, files: dict[str, str]) -> Path:
    """Write texts by their paths below a folder."""
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


def write_robot(root: Path, launch: str = "", **files: str) -> Path:
    """The package at the top of a folder, with the content of its launch file in XML; ``files`` are more, or others."""
    texts = {
        "package.xml": manifest(),
        "setup.py": SETUP,
        "setup.cfg": SETUP_CFG,
        "robot/talker.py": TALKER,
        "launch/it.launch.xml": f"<launch>{launch}</launch>",
    }
    return write_files(root, texts | files)


def node(inner: str = "", **attributes: str) -> str:
    """The XML that starts the talker, or another node."""
    given = {"pkg": "robot", "exec": "talker"} | attributes
    return f"<node {' '.join(f'{k}={v!r}' for k, v in given.items())}>{inner}</node>"


def two(inner: str) -> str:
    """The XML that starts the talker twice, under two names."""
    return '<arg name="config"/>' + node(inner, name="a") + node(inner, name="b")


CMAKE = manifest(build_type="ament_cmake")
TALKER_OF_CPP = """\
project(robot)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
ament_target_dependencies(talker rclcpp)
ament_package()
"""
SCRIPTS = "install(PROGRAMS scripts/drive.py DESTINATION lib/robot)\n"
CMAKE_TESTS = """if(BUILD_TESTING)
  foreach(path test/test_a.py)
    ament_add_pytest_test(${path} ${path})
  endforeach()
endif()
"""
UNDER_CONDITIONS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from somewhere.launch import AsBool

def generate_launch_description():
    real = IfCondition(LaunchConfiguration('real'))
    return LaunchDescription([
        DeclareLaunchArgument('real'),
        Node(package='robot', executable='talker', condition={first}),
        Node(package='robot', executable='talker', condition={second}),
    ])
"""
"""Starts the talker twice, under the conditions ``first`` and ``second``."""
