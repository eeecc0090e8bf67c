"""API006 and PKG004: what launch files in Python import of the workspace's own modules."""

from __future__ import annotations

import pytest

from robot_package import CMAKE

SETUP = """
from glob import glob
from setuptools import setup
setup(name='robot', packages=['robot'], data_files=[('share/robot/launch', glob('launch/*'))],
      entry_points={'console_scripts': ['talker = robot.talker:main']})
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node
{line}


def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='talker')])
"""
TOOLS = "def arms():\n    return 2\n"


def files(line: str, **more: str) -> dict[str, str]:
    """A launch file with a line, in a package with two modules of tools."""
    own = {"setup.py": SETUP, "robot/__init__.py": "", "robot/tools.py": TOOLS, "launch/beside.py": TOOLS}
    return own | more | {"launch/robot.launch.py": LAUNCH.format(line=line)}


BY_PATH = "'beside' is not found: launch loads this file by its path, and its folder is not on Python's path"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "from robot.tolls import arms",
            "there is no module robot.tolls: the import fails; did you mean robot.tools?",
        ),
        ("from robot.launch_utils import arms", "there is no module robot.launch_utils: the import fails"),
        ("from robot.tools import legs", "robot.tools has no 'legs': the import fails with an ImportError"),
        ("from beside import arms", BY_PATH),
        ("import beside", BY_PATH),
    ],
)
def test_imports_that_find_nothing(findings, line, message):
    (told,) = findings("API006", **files(line))
    assert told.message == message
    assert (told.place.file, told.place.line) == ("launch/robot.launch.py", 3)


@pytest.mark.parametrize(
    ("line", "module", "meant"),
    [
        (
            "from ament_python import get_package_share_directory",
            "module ament_python",
            "ament_index_python.packages",
        ),
        (
            "from robot_index.packages import PackageNotFoundError, get_package_prefix",
            "package robot_index",
            "ament_index_python.packages",
        ),
        (
            "from launch_actions import DeclareLaunchArgument, LogInfo",
            "module launch_actions",
            "launch.actions",
        ),
    ],
)
def test_names_of_ros_from_a_module_that_is_nowhere(findings, line: str, module: str, meant: str):
    (told,) = findings("API006", **files(line))
    assert told.message == f"there is no {module}: the import fails; the module is {meant}"
    assert told.help == f"write `from {meant} import …`"


@pytest.mark.parametrize(
    ("line", "more"),
    [
        # Some of the names are of another module.
        ("from robot_index import get_package_prefix, arms", {}),
        ("from robot_index import arms", {}),
        ("from robot_index import get_package_prefix", {"requirements.txt": "robot-index\n"}),
        ("from robot.index import get_package_prefix", {"robot/index.py": "def get_package_prefix():\n    pass\n"}),
        (
            "try:\n    from robot_index import get_package_prefix\nexcept ImportError:\n    get_package_prefix = None",
            {},
        ),
    ],
)
def test_names_of_ros_that_another_module_may_have(findings, line: str, more: dict[str, str]):
    assert findings("API006", **files(line, **more)) == []


@pytest.mark.parametrize(
    ("line", "more"),
    [
        ("from robot.tools import arms", {}),
        ("try:\n    from beside import arms\nexcept ImportError:\n    arms = None", {}),
        ("import os, sys\nsys.path.append(os.path.dirname(__file__))\nfrom beside import arms", {}),
        ("from beside import arms\nif __name__ == '__main__':\n    print(arms())", {}),
        ("from beside import arms", {"README.md": "export PYTHONPATH=launch\n"}),
        ("import yaml", {"launch/yaml.py": TOOLS}),
        ("from launch.actions import TimerAction", {"launch/launch.py": TOOLS}),
        ("from robot_bringup.tools import arms", {}),  # it may be installed from elsewhere
        ("from robot.launch_utils import arms", {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\n"}),
    ],
)
def test_imports_that_find_something_or_may(findings, line, more):
    assert findings("API006", **files(line, **more)) == []


INNER = {"robot/tools/__init__.py": "", "robot/tools/arms.py": TOOLS}


def test_a_package_that_only_a_launch_file_needs(findings):
    (told,) = findings("PKG004", **files("from robot.tools.arms import arms", **INNER))
    assert told.message.startswith("packages= leaves out 'robot.tools', which launch/robot.launch.py imports")
    listed = SETUP.replace("['robot']", "['robot', 'robot.tools']")
    assert findings("PKG004", **files("from robot.tools.arms import arms", **INNER, **{"setup.py": listed})) == []


BUILT = """\
cmake_minimum_required(VERSION 3.8)
project(robot)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""


def test_a_package_of_python_that_cmake_does_not_install(findings):
    built = {"package.xml": CMAKE, "CMakeLists.txt": BUILT + "ament_package()\n", "setup.py": ""}
    (told,) = findings("PKG004", **files("from robot.tools import arms", **built))
    assert told.message == (
        "launch/robot.launch.py imports 'robot', a folder that nothing installs where Python looks: the import fails"
    )
    installed = f"{BUILT}ament_python_install_package(robot)\nament_package()\n"
    assert findings("PKG004", **files("from robot.tools import arms", **built | {"CMakeLists.txt": installed})) == []
