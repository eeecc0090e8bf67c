"""archlint as a test of a package of build type ament_cmake, as docs/ci.md says, with the real ament_cmake_pytest.

For packages of Python `make adoption` does the same with colcon.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from tests_ros.environments import ROOT, Environment

CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(robot NONE)
find_package(ament_cmake REQUIRED)
install(PROGRAMS scripts/talker.py scripts/listener.py DESTINATION lib/${PROJECT_NAME})
"""
MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>robot</name>
  <version>0.1.0</version>
  <description>Two scripts.</description>
  <maintainer email="kim@example.com">Kim</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>std_msgs</exec_depend>
  <test_depend>ament_cmake_pytest</test_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
SCRIPT = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class {name}(Node):
    def __init__(self):
        super().__init__('{node}')
        self.end = self.create_{end}


rclpy.init()
rclpy.spin({name}())
"""


def example(language: str) -> str:
    """The first block of a language in the part about ROS packages."""
    text = (ROOT / "docs" / "ci.md").read_text("utf-8").partition("## In the tests of a ROS package")[2]
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)[0]


def write_package(folder: Path, received: str) -> None:
    end = f"subscription({received}, 'words', print, 10)"
    files = {
        "CMakeLists.txt": f"{CMAKE}{example('cmake')}ament_package()\n",
        "package.xml": MANIFEST,
        "test/test_archlint.py": example("python"),
        "scripts/talker.py": SCRIPT.format(
            type="String", name="Talker", node="talker", end="publisher(String, 'words', 10)"
        ),
        "scripts/listener.py": SCRIPT.format(type=received, name="Listener", node="listener", end=end),
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
        (folder / name).chmod(0o755)


def said(command: list[str | Path], folder: Path, variables: dict[str, str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command,
        cwd=folder,
        env=variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        timeout=300,
    )


@pytest.mark.parametrize(("received", "failures"), [("String", "0"), ("Int32", "1")])
def test_ctest_runs_archlint_in_the_folder_of_the_package(
    environment: Environment, tmp_path: Path, received: str, failures: str
):
    version = said([environment.python, "-c", "import sys; print(sys.version_info[:2])"], tmp_path, {}).stdout
    if version.strip() != str(sys.version_info[:2]):
        pytest.skip(f"archlint is not installed for the Python of {environment.distro}, which is another one")
    package, build = tmp_path / "src" / "robot", tmp_path / "build"
    write_package(package, received)
    variables = {
        "PATH": f"{environment.folder / 'bin'}{os.pathsep}{os.environ['PATH']}",
        "HOME": str(tmp_path),
        "AMENT_PREFIX_PATH": str(environment.folder),
        "CMAKE_PREFIX_PATH": str(environment.folder),
        "PYTHONPATH": os.pathsep.join([str(ROOT / "src"), sysconfig.get_paths()["purelib"]]),
    }
    options = [f"-DPython3_EXECUTABLE={environment.python}", "-DBUILD_TESTING=ON"]
    for command in (["cmake", "-S", package, "-B", build, *options], ["cmake", "--build", build]):
        done = said(command, tmp_path, variables)
        assert done.returncode == 0, done.stdout[-3000:]
    done = said(["ctest"], build, variables)
    [result] = (build / "test_results" / "robot").glob("*.xunit.xml")
    suite = ElementTree.parse(result).getroot()[0]
    assert (suite.get("tests"), suite.get("failures")) == ("1", failures), done.stdout[-3000:]
    message = "".join(failure.get("message", "") for failure in suite.iter("failure"))
    assert ("scripts/talker.py:10:20: TOP001 /talker publishes '/words' as std_msgs/msg/String" in message) is (
        failures == "1"
    )
