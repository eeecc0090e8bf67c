"""Made-up workspaces of any size, all of one kind, so that what grows with them is the program that reads them.

A package is a node with two topics and a service, a client of the package before it, a parameter file and a launch
file; the launch file of each tenth package includes those of the nine after it.  Each has the same few mistakes, for
what a finding costs counts, too: a remapping of a name that the node does not have, an absolute name, waits without
a limit.
"""

from __future__ import annotations

from pathlib import Path

GROUP = 10
"""Packages that one launch file starts together, so that the size of a launched system does not grow."""

_NODE = '''\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String
from std_srvs.srv import Trigger


class {cls}(Node):
    """Passes on what the node before it measures."""

    def __init__(self):
        super().__init__("{name}")
        self.declare_parameter("rate", 10.0)
        self.declare_parameter("limit", 1.5)
        self.limit = self.get_parameter("limit").value
        self.values = []
        self.publisher = self.create_publisher(Float64, "{name}/value", 10)
        self.subscription = self.create_subscription(Float64, "{before}/value", self.on_value, 10)
        self.service = self.create_service(Trigger, "{name}/reset", self.on_reset)
        self.state = self.create_publisher(String, "/{name}/state", 10)
        self.client = self.create_client(Trigger, "{before}/reset")
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("waiting")
        self.timer = self.create_timer(1.0 / self.get_parameter("rate").value, self.on_timer)

    def on_value(self, message):
        if abs(message.data) > self.limit:
            self.get_logger().warning(f"{{message.data}} is above {{self.limit}}")
            return
        self.values.append(message.data)
        del self.values[:-100]

    def on_timer(self):
        total = 0.0
        for value in self.values:
            total += value
        self.publisher.publish(Float64(data=total / max(1, len(self.values))))
        self.state.publish(String(data="running"))

    def on_reset(self, request, response):
        self.values.clear()
        response.success = True
        return response


def main():
    rclpy.init()
    node = {cls}()
    future = node.client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
'''

_LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory("{name}")
    return LaunchDescription(
        [
            DeclareLaunchArgument("rate", default_value="20.0"),
            Node(
                package="{name}",
                executable="{name}",
                name="{name}",
                parameters=[os.path.join(share, "config", "{name}.yaml"), {{"rate": LaunchConfiguration("rate")}}],
                remappings=[("{before}/value", "{name}/input"), ("{name}/speed", "speed")],
            ),
{includes}        ]
    )
"""

_INCLUDE = """\
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(
                    os.path.join(get_package_share_directory("{other}"), "launch", "{other}.launch.py")
                )
            ),
"""

_SETUP = """\
from glob import glob

from setuptools import setup

setup(
    name="{name}",
    version="0.1.0",
    packages=["{name}"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/{name}"]),
        ("share/{name}", ["package.xml"]),
        ("share/{name}/launch", glob("launch/*.launch.py")),
        ("share/{name}/config", glob("config/*.yaml")),
    ],
    entry_points={{"console_scripts": ["{name} = {name}.node:main"]}},
)
"""

_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>Number {number} of a made-up workspace</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>MIT</license>
{depends}  <export><build_type>ament_python</build_type></export>
</package>
"""

_PARAMETERS = """\
{name}:
  ros__parameters:
    limit: 2.5
"""

_ALWAYS = ("rclpy", "std_msgs", "std_srvs", "launch", "launch_ros", "ament_index_python")


def make_workspace(folder: Path, packages: int) -> None:
    """Write a workspace of so many packages, of two Python files and a setup.py each."""
    for number in range(packages):
        _make_package(folder / "src", number, packages)


def _make_package(folder: Path, number: int, packages: int) -> None:
    name, before = _name(number), _name((number or packages) - 1)
    after = range(number + 1, min(number + GROUP, packages)) if number % GROUP == 0 else ()
    included = [_name(other) for other in after]
    depends = [f"  <depend>{one}</depend>\n" for one in (*_ALWAYS, *included)]
    files = {
        f"{name}/__init__.py": "",
        f"{name}/node.py": _NODE.format(cls=f"Stage{number:04}", name=name, before=before),
        f"launch/{name}.launch.py": _LAUNCH.format(
            name=name, before=before, includes="".join(_INCLUDE.format(other=other) for other in included)
        ),
        f"config/{name}.yaml": _PARAMETERS.format(name=name),
        f"resource/{name}": "",
        "setup.py": _SETUP.format(name=name),
        "setup.cfg": f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n",
        "package.xml": _MANIFEST.format(name=name, number=number, depends="".join(depends)),
    }
    for path, text in files.items():
        file = folder / name / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def _name(number: int) -> str:
    return f"stage_{number:04}"
