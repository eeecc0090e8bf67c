"""QOS001: ends of the workspace's own types, in packages that do not depend on each other."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import manifest, write_files

SETUP = """
from setuptools import setup
setup(name='{name}', packages=['{name}'], entry_points={{'console_scripts': ['{name} = {name}.main:main']}})
"""
NODE = """
import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
{import_}


class {cls}(Node):
    def __init__(self):
        super().__init__('{name}')
        self.end = {end}

    def on_message(self, message):
        print(message)


def main():
    rclpy.init()
    rclpy.spin({cls}())
"""
INTERFACES = """
cmake_minimum_required(VERSION 3.8)
project(farm_interfaces)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Cow.msg")
ament_package()
"""
OWN, STANDARD = "from farm_interfaces.msg import Cow", "from std_msgs.msg import String as Cow"


def judged(root: Path, import_: str, publisher: str, subscription: str) -> list[Finding]:
    """What the rule says of a publisher in one package and a subscription in another."""
    files = {
        "farm_interfaces/package.xml": manifest("farm_interfaces", "ament_cmake"),
        "farm_interfaces/CMakeLists.txt": INTERFACES,
        "farm_interfaces/msg/Cow.msg": "float64 weight\n",
        "archlint.toml": 'select = ["QOS001"]\n',
    }
    for name, end in (("camera", publisher), ("counter", subscription)):
        files |= {
            f"{name}/package.xml": manifest(name),
            f"{name}/setup.py": SETUP.format(name=name),
            f"{name}/{name}/__init__.py": "",
            f"{name}/{name}/main.py": NODE.format(name=name, cls=name.title(), end=end, import_=import_),
        }
    write_files(root, files)
    return check(Request((".",), load(root), cached=False, jobs=1)).findings


@pytest.fixture(autouse=True)
def _in_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


SENDS = "self.create_publisher(Cow, '/cows', qos_profile_sensor_data)"
TAKES = "self.create_subscription(Cow, '/cows', self.on_message, {})"


@pytest.mark.parametrize(
    ("import_", "qos", "count"),
    [(OWN, "10", 1), (OWN, "qos_profile_sensor_data", 0), (STANDARD, "10", 0)],
)
def test_a_profile_that_does_not_fit(tmp_path: Path, import_: str, qos: str, count: int):
    """Of a standard type, a driver from elsewhere may have the other end."""
    told = judged(tmp_path, import_, SENDS, TAKES.format(qos))
    assert [finding.place.file for finding in told] == ["counter/counter/main.py"] * count
