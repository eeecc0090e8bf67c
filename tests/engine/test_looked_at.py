"""A run without findings says what it did not look at, and one that looked at nothing does not pass."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
PACKAGE = """\
<package format="3"><name>{0}</name><version>0.0.0</version><description>a</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><depend>rclpy</depend><depend>std_msgs</depend>
<export><build_type>{1}</build_type></export></package>
"""
LAUNCH = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def write(path: str, text: str = "") -> None:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def told(capsys: pytest.CaptureFixture[str], *arguments: str, status: int = 0) -> str:
    assert main(["check", "--no-cache", *arguments]) == status
    return capsys.readouterr().err


# ------------------------------------------------------------------------------------------- nothing was looked at


def test_a_folder_without_ros_is_nothing_to_check(capsys: pytest.CaptureFixture[str]) -> None:
    write("shop/cart.py", "total = 0\n")
    words = told(capsys, status=2)
    assert "no package.xml, no launch file, and nothing that uses rclpy or rclcpp in 1 file of Python or C++" in words


def test_a_workspace_for_ros_1_is_nothing_to_check(capsys: pytest.CaptureFixture[str]) -> None:
    manifest = "<package format='2'><name>old</name><buildtool_depend>catkin</buildtool_depend></package>"
    write("old/package.xml", manifest)
    write("old/scripts/drive.py", "import rospy\nrospy.init_node('drive')\n")
    write("old/launch/drive.launch", "<launch><node pkg='old' type='drive.py' name='drive'/></launch>")
    assert "nothing to check in .: all of it is for ROS 1" in told(capsys, status=2)
    write("new/talk.py", NODE)
    assert "1 launch file and 1 Python file are for ROS 1 and skipped" in told(capsys)


def test_a_helper_of_a_ros_package_may_be_checked_alone(capsys: pytest.CaptureFixture[str]) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("pkg/pkg/helper.py", "total = 0\n")
    assert "no node was found in 1 file" in told(capsys, "pkg/pkg/helper.py")


def test_without_a_node_it_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    write("drive/package.xml", PACKAGE.format("drive", "ament_cmake"))
    write("drive/src/drive.cpp")
    assert "no node was found in 1 file\n" in told(capsys)


def test_files_of_cpp_are_counted_like_those_of_python(capsys: pytest.CaptureFixture[str]) -> None:
    write("talk/package.xml", PACKAGE.format("talk", "ament_python"))
    write("talk/talk/__init__.py")
    write("talk/talk/node.py", NODE)
    write("drive/package.xml", PACKAGE.format("drive", "ament_cmake"))
    write("drive/src/drive.cpp")
    assert "in 3 files with 1 node." in told(capsys)


# -------------------------------------------------------------------------------------- patterns that match nothing


@pytest.mark.parametrize(
    ("configuration", "words"),
    [
        ('launch = ["**/bringpu.*"]', "archlint.toml:1: no file here matches '**/bringpu.*' under launch"),
        ('exclude = ["experimental"]', "archlint.toml:1: no file here matches 'experimental' under exclude"),
        (
            '[per-file-ignores]\n"**/tests/**" = ["TMO"]',
            "no file here matches '**/tests/**' under per-file-ignores",
        ),
        (
            '[per-package-ignores]\ntaker = ["TMO"]',
            "no package here matches 'taker' under per-package-ignores",
        ),
    ],
)
def test_a_pattern_that_matches_nothing_is_told(
    capsys: pytest.CaptureFixture[str], configuration: str, words: str
) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("pkg/pkg/node.py", NODE)
    write("archlint.toml", configuration)
    assert words in told(capsys)


@pytest.mark.parametrize(
    "configuration",
    [
        'exclude = ["build", "**/install/**"]',
        'exclude = ["old"]',
        'launch = ["pkg/launch/*.py"]',
        '[per-file-ignores]\n"pkg/**" = ["TMO"]',
        '[per-package-ignores]\n"p*" = ["TMO"]',
    ],
)
def test_a_pattern_that_matches_or_may_come_to_is_not(capsys: pytest.CaptureFixture[str], configuration: str) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("pkg/pkg/node.py", NODE)
    write("pkg/launch/a.launch.py", LAUNCH)
    write("old/x.py", NODE)
    write("archlint.toml", configuration)
    assert "matches" not in told(capsys)


def test_of_a_part_of_the_workspace_it_cannot_be_said(capsys: pytest.CaptureFixture[str]) -> None:
    write("first/pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("first/pkg/pkg/node.py", NODE)
    write("second/pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("second/pkg/pkg/node.py", NODE)
    write("archlint.toml", '[per-file-ignores]\n"second/**" = ["TMO"]')
    assert "matches" not in told(capsys, "first/pkg")


# ------------------------------------------------------------------------------ comments that look like suppressions


@pytest.mark.parametrize(
    "comment",
    ["# archlint: disable=NME001", "# archlint: noqa", "# noqa: TMO001", "# noqa: E501, TMO001", "# noqa[NME001]"],
)
def test_a_comment_that_hides_nothing_is_told(capsys: pytest.CaptureFixture[str], comment: str) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("pkg/pkg/node.py", NODE.replace("'chatter', 10)", f"'chatter', 10)  {comment}"))
    words = told(capsys)
    assert "pkg/pkg/node.py:9:" in words
    assert "has no effect; write it as `archlint: ignore[SRV003]`" in words


@pytest.mark.parametrize("comment", ["# noqa", "# noqa: E501", "# noqa: EXE001", "# about archlint", "# type: ignore"])
def test_comments_for_others_are_left_alone(capsys: pytest.CaptureFixture[str], comment: str) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write("pkg/pkg/node.py", NODE.replace("'chatter', 10)", f"'chatter', 10)  {comment}"))
    assert "has no effect" not in told(capsys)


# ---------------------------------------------------------------------------------------------- launch arguments


def test_a_misspelt_argument_is_told_where_a_part_could_not_be_read(capsys: pytest.CaptureFixture[str]) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write(
        "pkg/launch/a.launch.xml",
        '<launch><arg name="use_sim" default="false"/>'
        '<include file="$(find-pkg-share elsewhere)/launch/b.launch.py"/></launch>',
    )
    words = told(capsys, ".", "--launch", "pkg/launch/a.launch.xml", "use_smi:=true", "other:=1", "--exit-zero")
    assert "has no argument 'use_smi'; did you mean 'use_sim'?" in words
    assert "'other'" not in words, "the included file may take it"


# ------------------------------------------------------------------------------------------------- launch files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='pkg', executable='nobody')])
"""


@pytest.mark.parametrize("folder", ["pkg", "other"])
def test_an_empty_file_that_makes_launch_a_python_package_hides_nothing(
    capsys: pytest.CaptureFixture[str], folder: str
) -> None:
    for name in ("pkg", "other"):
        write(f"{name}/package.xml", PACKAGE.format(name, "ament_python"))
        write(f"{name}/setup.py", f"from setuptools import setup\nsetup(name='{name}', packages=['{name}'])\n")
    write("pkg/launch/a.launch.py", LAUNCH)
    write(f"{folder}/launch/__init__.py")
    assert main(["check", "--no-cache", "--select", "LCH001"]) == 1
    assert "LCH001" in capsys.readouterr().out


def test_a_launch_file_that_cannot_be_followed_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    write("pkg/package.xml", PACKAGE.format("pkg", "ament_python"))
    write(
        "pkg/launch/a.launch.py",
        "from elsewhere import actions\n\n\ndef generate_launch_description():\n    return actions()\n",
    )
    words = told(capsys)
    assert "pkg/launch/a.launch.py:1: what this launch file starts is not known, so it is not checked" in words


# ------------------------------------------------------------------------------------------ packages that git ignores


def test_packages_that_git_ignores_are_told_where_nothing_else_of_src_is_read(
    capsys: pytest.CaptureFixture[str],
) -> None:
    write(".gitignore", "src/*\n")
    write("src/talk/package.xml", PACKAGE.format("talk", "ament_python"))
    write("src/talk/talk/node.py", NODE)
    words = (
        "1 package in src is not read, since a .gitignore says so (such as src/talk): "
        "`archlint check src/talk` reads it all the same"
    )
    assert "all of it is left out, such as src/talk/package.xml: git ignores it" in told(capsys, status=2)
    write("start.launch.py", LAUNCH)
    assert words in told(capsys)
    assert "is not read" not in told(capsys, "src/talk")
    write(".gitignore", "src/talk\n")
    write("src/drive/package.xml", PACKAGE.format("drive", "ament_python"))
    assert "is not read" not in told(capsys)
