"""Files that nothing of a workspace runs, and files that look alike and are run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

Told = Callable[[dict[str, str], str], "list[str]"]

MANIFEST = """<package format="3"><name>robot</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>rclcpp</exec_depend><exec_depend>std_msgs</exec_depend>
<export><build_type>{build}</build_type></export></package>
"""
SETUP = """
from setuptools import setup

setup(
    name='robot',
    packages=['robot'],
    data_files=[('share/robot/launch', ['launch/robot.launch.py'])],
    entry_points={'console_scripts': [
        'driver = robot.driver:main',
        # 'probe = robot.probe:main',
    ]},
)
"""
FAILS = """#!/usr/bin/env python3
import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('probe')
    node.get_logger().info(missing)


if __name__ == '__main__':
    main()
"""
LOADED = FAILS.replace("if __name__ == '__main__':\n    main()\n", "main()\n")
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='gone')])
"""
STARTS = LAUNCH.replace("gone", "driver")
INCLUDES = """
import os
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    spare = os.path.join(os.path.dirname(__file__), 'old', 'spare.launch.py')
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(spare))])
"""


@pytest.fixture
def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Told:
    """``told({path: text}, code)`` gives the files of a workspace in which a rule says something.  Its package
    ``robot`` installs the program ``robot/driver.py`` and the launch file ``launch/robot.launch.py``."""

    def files_told(files: dict[str, str], code: str) -> list[str]:
        texts = {
            "robot/package.xml": MANIFEST.replace("{build}", "ament_python"),
            "robot/setup.py": SETUP,
            "robot/robot/__init__.py": "",
            "robot/robot/driver.py": "def main():\n    pass\n",
            "robot/launch/robot.launch.py": STARTS,
            "archlint.toml": f'select = ["{code}"]\n',
        }
        for path, text in {**texts, **files}.items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(text, encoding="utf-8")
        monkeypatch.chdir(tmp_path)
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        return [finding.place.file for finding in report.findings]

    return files_told


@pytest.mark.parametrize(
    "files",
    [
        pytest.param({"robot/robot/probe.py": FAILS}, id="its entry point is commented out"),
        pytest.param({"robot/tools/measure.py": LOADED}, id="a tool that nothing installs"),
        pytest.param({"robot/robot/old/probe.py": FAILS, "robot/robot/old/__init__.py": ""}, id="put aside"),
        pytest.param({"robot/robot/2024_back_up/driver.py": FAILS}, id="an old copy of what runs"),
        pytest.param({"robot/tools/measure.py": FAILS}, id="whose author starts it by its path"),
    ],
)
def test_a_script_that_nothing_runs(told: Told, files: dict[str, str]):
    assert told(files, "API005") == []


@pytest.mark.parametrize(
    "files",
    [
        pytest.param({"robot/robot/driver.py": FAILS}, id="the program"),
        pytest.param(
            {"robot/robot/driver.py": "from robot.probe import main\n", "robot/robot/probe.py": FAILS}, id="imported"
        ),
        pytest.param({"robot/robot/probe.py": FAILS, "README.md": "    python3 robot/robot/probe.py\n"}, id="README"),
        pytest.param({"robot/robot/probe.py": FAILS, "run.sh": "python3 -m robot.probe &\n"}, id="a script starts it"),
        pytest.param(
            {"robot/robot/probe.py": FAILS, "robot/test/test_it.py": "import rclpy\nfrom robot import probe\n"},
            id="tested",
        ),
        pytest.param({"robot/robot/probe.py": FAILS, "robot/setup.py": "import setuptools\n"}, id="nothing installed"),
        pytest.param({"tools/probe.py": FAILS}, id="beside the packages"),
        pytest.param(
            {
                "robot/robot/probe.py": FAILS,
                "robot/setup.py": SETUP.replace("# 'probe = robot.probe:main',", "'probe = robot.probe.py',"),
            },
            id="its entry point is wrong",
        ),
    ],
)
def test_a_script_that_something_runs(told: Told, files: dict[str, str]):
    assert len(told(files, "API005")) == 1


HELPER = "import json\n{more}\nKNOWN = [missing]\n\n\ndef node(topic):\n    return json.dumps(topic)\n"


@pytest.mark.parametrize(
    ("files", "count"),
    [
        ({}, 0),
        ({"robot/robot/driver.py": "from robot.helper import node\n\n\ndef main():\n    node('a')\n"}, 1),
        ({"robot/robot/helper.py": HELPER.replace("{more}", "import rclpy")}, 0),
        ({"robot/robot/helper.py": HELPER.replace("{more}", "from std_msgs.msg import String\nrclpy = None")}, 0),
        ({"robot/robot/helper.py": HELPER + "\n\nnode('a')\n"}, 1),
        ({"robot/test/test_it.py": "import rclpy\nfrom robot import helper\n"}, 1),
        ({"robot/setup.py": SETUP.split("    entry_points")[0] + ")\n"}, 1),
    ],
    ids=["nobody", "a program", "of ROS", "of interfaces", "a program itself", "a test", "a library"],
)
def test_a_module_of_a_package_of_programs_that_none_of_them_imports(told: Told, files: dict[str, str], count: int):
    texts = {"robot/robot/helper.py": HELPER, **files}
    words = {path: text.replace("{more}", "rclpy = None") for path, text in texts.items()}
    assert told(words, "API005") == ["robot/robot/helper.py"] * count


SEARCHES = SETUP.replace("import setup\n", "import find_packages, setup\n").replace("['robot'],", "find_packages(),")
MODULE = """import rclpy
from rclpy.node import Node

NAME = missing


class Probe(Node):
    def __init__(self):
        super().__init__(NAME)
"""
PROBE = "robot/robot/probes/probe.py"


@pytest.mark.parametrize(
    ("files", "told_of"),
    [
        ({}, []),
        ({"robot/robot/probes/__init__.py": ""}, [PROBE]),
        ({"robot/robot/driver.py": "from robot.probes.probe import Probe\n\n\ndef main():\n    Probe()\n"}, [PROBE]),
        ({"robot/setup.py": SEARCHES.replace("'launch/r", "'robot/probes/probe.py', 'launch/r")}, [PROBE]),
    ],
    ids=["left out", "a package", "the program needs it", "installed as data"],
)
def test_a_module_that_find_packages_leaves_out(told: Told, files: dict[str, str], told_of: list[str]):
    assert told({"robot/setup.py": SEARCHES, PROBE: MODULE, **files}, "API005") == told_of


@pytest.mark.parametrize(
    ("files", "told_of"),
    [
        ({}, []),
        ({"robot/setup.py": SETUP.replace("['robot']", "['robot', 'robot.probes']")}, [PROBE]),
        ({"robot/robot/driver.py": "from robot.probes.probe import Probe\n\n\ndef main():\n    Probe()\n"}, [PROBE]),
        ({"robot/README.md": "Run it: `python3 robot/probes/probe.py`\n"}, [PROBE]),
    ],
    ids=["left out", "in the list", "the program needs it", "told to run"],
)
def test_a_module_whose_folder_a_list_of_packages_lacks(told: Told, files: dict[str, str], told_of: list[str]):
    assert told({"robot/robot/probes/__init__.py": "", PROBE: MODULE, **files}, "API005") == told_of


SONAR = "robot/robot/sonar.py"
OTHER = """<package format="3"><name>arm</name><exec_depend>robot</exec_depend>
<export><build_type>ament_python</build_type></export></package>"""


@pytest.mark.parametrize(
    ("files", "told_of"),
    [
        ({}, []),
        ({"robot/robot/robots.py": "from robot.sonar import NAME\nimport rclpy\n"}, []),
        ({"robot/robot/driver.py": "KINDS = ['sonar']\n\n\ndef main():\n    print(KINDS)\n"}, [SONAR]),
        ({"robot/robot/sonar.py": f"{MODULE}\n\nif __name__ == '__main__':\n    Probe()\n"}, []),
        ({"robot/robot/driver.py": "import importlib\n\n\ndef main():\n    print()\n"}, [SONAR]),
        ({"robot/test/test_it.py": "import rclpy\nfrom robot import sonar\n"}, [SONAR]),
        ({"arm/package.xml": OTHER, "arm/setup.py": "import setuptools\n"}, [SONAR]),
        ({"robot/setup.py": SETUP.replace("'console_", "'probes': ['p = robot.sonar:Probe'], 'console_")}, [SONAR]),
        ({"robot/plugin.xml": "<library><class type='robot.sonar.Probe'/></library>"}, [SONAR]),
    ],
    ids=[
        *("nobody", "an idle module", "a text", "a script", "a loader", "a test", "a package that others need"),
        *("an entry point of another kind", "a plugin"),
    ],
)
def test_a_module_of_ros_that_only_idle_ones_name(told: Told, files: dict[str, str], told_of: list[str]):
    assert told({"robot/robot/sonar.py": MODULE, **files}, "API005") == told_of


SPARE = "robot/launch/spare.launch.py"
OLD = "robot/launch/old/spare.launch.py"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        pytest.param({"robot/launch/_old/spare.launch.py": LAUNCH}, [], id="put aside"),
        pytest.param({"robot/launch/spare_backup.launch.py": LAUNCH}, [], id="a copy"),
        pytest.param({"robot/launch/robot.launch.py": LAUNCH}, ["robot/launch/robot.launch.py"], id="installed"),
        pytest.param({SPARE: LAUNCH}, [SPARE], id="perhaps forgotten in setup.py"),
        pytest.param({OLD: LAUNCH, "robot/launch/robot.launch.py": INCLUDES}, [OLD], id="included"),
    ],
)
def test_launch_files(told: Told, files: dict[str, str], expected: list[str]):
    assert told(files, "LCH001") == expected


@pytest.mark.parametrize(
    ("folder", "readme", "told_of"),
    [
        ("archived_arm", "", []),
        ("archived_arm", "    ros2 launch arm arm.launch.py", ["archived_arm/launch/arm.launch.py"]),
        ("arm", "", ["arm/launch/arm.launch.py"]),
    ],
)
def test_launch_files_of_a_package_that_is_put_aside(told: Told, folder: str, readme: str, told_of: list[str]):
    manifest = MANIFEST.format(build="ament_python").replace("<name>robot<", "<name>arm<")
    setup = SETUP.replace("robot", "arm")
    files = {"package.xml": manifest, "setup.py": setup, "launch/arm.launch.py": STARTS}
    files |= {"arm/__init__.py": "", "arm/driver.py": "def main():\n    pass\n"}
    below = {f"{folder}/{path}": text for path, text in files.items()}
    assert told({**below, "README.md": readme}, "PKG001") == told_of


OF_OLD = '<launch><node pkg="robot" exec="driver" colour="red"/></launch>'


@pytest.mark.parametrize(
    ("name", "readme", "told_of"),
    [
        ("robot.launch", "", []),
        ("robot.launch", "    ros2 launch robot robot.launch", ["robot/launch/robot.launch"]),
        ("other.launch", "", ["robot/launch/other.launch"]),
    ],
    ids=["ported", "still started", "forgotten, perhaps"],
)
def test_the_launch_file_that_an_installed_one_was_ported_from(told: Told, name: str, readme: str, told_of: list[str]):
    assert told({f"robot/launch/{name}": OF_OLD, "README.md": readme}, "LCH005") == told_of


CMAKE = """
cmake_minimum_required(VERSION 3.8)
project(robot)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(driver src/driver.cpp)
# add_executable(probe src/probe.cpp)
{more}
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
NODE = """
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("1probe");
  rclcpp::spin(node);
}
"""
IN_A_BRANCH = "if(WITH_PROBE)\n  add_executable(probe src/probe.cpp)\nendif()"
BY_PATTERN = "file(GLOB ALL src/*.cpp)\nadd_library(all ${ALL})"
IN_A_LOOP = "foreach(name probe)\n  add_executable(${name} src/${name}.cpp)\nendforeach()"


@pytest.mark.parametrize(
    ("more", "driver", "count"),
    [
        pytest.param("", "int main() {}\n", 0, id="its target is commented out"),
        pytest.param(IN_A_BRANCH, "int main() {}\n", 1, id="built if somebody wants it"),
        pytest.param(BY_PATTERN, "int main() {}\n", 1, id="built with all of its folder"),
        pytest.param(IN_A_LOOP, "int main() {}\n", 1, id="built in a loop"),
        pytest.param("", '#include "probe.cpp"\n', 1, id="included by another source"),
    ],
)
def test_sources_of_cpp(told: Told, more: str, driver: str, count: int):
    files = {
        "robot/package.xml": MANIFEST.replace("{build}", "ament_cmake"),
        "robot/setup.py": "",
        "robot/CMakeLists.txt": CMAKE.replace("{more}", more),
        "robot/src/driver.cpp": driver,
        "robot/src/probe.cpp": NODE,
    }
    assert told(files, "NME002") == ["robot/src/probe.cpp"] * count
