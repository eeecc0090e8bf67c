"""Findings in packages that others maintain: which packages those are, what a run says of them, how to see them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from archlint.cli import main

MANIFEST = """<package format="3"><name>{name}</name><version>1.0.1</version><description>d</description>
<maintainer email="{who}@example.org">{who}</maintainer><license>MIT</license>{more}<exec_depend>rclpy</exec_depend>
<export><build_type>ament_python</build_type></export></package>
"""
SETUP = """
from setuptools import setup

setup(name='{name}', packages=['{name}'], entry_points={{'console_scripts': ['node = {name}.node:main']}})
"""
NODE = """
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('{name}')
        self.get_logger().info(missing)


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""
ADDRESS = '<url type="repository">https://example.org/laser</url>'


def package(folder: str, who: str, more: str = "") -> None:
    name = folder.rpartition("/")[2]
    write(f"{folder}/package.xml", MANIFEST.format(name=name, who=who, more=more))
    write(f"{folder}/setup.py", SETUP.format(name=name))
    scripts = f"$base/lib/{name}"
    write(f"{folder}/setup.cfg", f"[develop]\nscript_dir={scripts}\n[install]\ninstall_scripts={scripts}\n")
    write(f"{folder}/{name}/__init__.py")
    write(f"{folder}/{name}/node.py", NODE.format(name=name))


def write(path: str, text: str = "") -> None:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two packages of a team, and a driver that it has cloned beside them."""
    monkeypatch.chdir(tmp_path)
    package("src/robot", "ann")
    package("src/brain", "bob")
    package("src/laser/laser_driver", "carl", ADDRESS)
    write("src/laser/LICENSE", "MIT\n")


def checked(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[list[str], int, str]:
    """The files of the findings, how many are not shown, and what a run says beside that."""
    assert main(["check", "--no-cache", "--format", "json", "-o", "it.json", *arguments]) in (0, 1)
    document: dict[str, Any] = json.loads(Path("it.json").read_text(encoding="utf-8"))
    files = [row["file"] for row in document["diagnostics"]]
    return files, document["summary"]["vendored"], capsys.readouterr().err


OWN = ["src/brain/brain/node.py", "src/robot/robot/node.py"]
FOREIGN = "src/laser/laser_driver/laser_driver/node.py"


def test_they_are_counted_and_not_shown(capsys: pytest.CaptureFixture[str]) -> None:
    files, vendored, said = checked(capsys)
    assert (files, vendored) == (OWN, 1)
    assert "1 finding in a package that others maintain is not shown; --all-files shows it." in said


@pytest.mark.parametrize("wanted", ["--all-files", "src/laser", FOREIGN])
def test_they_are_shown_to_who_asks(capsys: pytest.CaptureFixture[str], wanted: str) -> None:
    files, vendored, said = checked(capsys, wanted)
    assert (FOREIGN in files, vendored) == (True, 0)
    assert "others maintain" not in said


def test_a_folder_with_packages_of_both_kinds_is_as_the_workspace(capsys: pytest.CaptureFixture[str]) -> None:
    assert checked(capsys, "src")[:2] == (OWN, 1)
    assert checked(capsys, "src/laser", "src/robot")[:2] == ([FOREIGN, OWN[1]], 0)


def test_the_configuration_may_ask_for_them(capsys: pytest.CaptureFixture[str]) -> None:
    write("archlint.toml", "unused-files = true\n")
    assert checked(capsys)[:2] == ([*OWN[:1], FOREIGN, *OWN[1:]], 0)


def test_a_package_that_rosdistro_has_needs_no_address(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/vision/cv_bridge", "dora")
    write("src/vision/.github/workflows/ci.yml", "on: push\n")
    assert checked(capsys)[:2] == (OWN, 2)


def test_a_copy_with_another_name_is_a_beginning_of_ones_own(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/robot_scanner", "dora", ADDRESS)
    assert checked(capsys)[1] == 1  # laser_driver alone


def test_a_copy_that_needs_a_package_of_the_team_was_changed(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/laser_driver", "carl", f"{ADDRESS}<exec_depend>brain</exec_depend>")
    assert checked(capsys)[1] == 0


@pytest.mark.parametrize(("needed", "vendored"), [("brain", False), ("rclcpp", True)])
def test_a_copy_that_is_built_with_a_package_of_the_team_was_changed(
    capsys: pytest.CaptureFixture[str], needed: str, vendored: bool
) -> None:
    manifest = MANIFEST.format(name="laser_driver", who="carl", more=ADDRESS).replace("ament_python", "ament_cmake")
    write("src/laser/laser_driver/package.xml", manifest)
    build = f"find_package(ament_cmake REQUIRED)\nfind_package({needed} REQUIRED)\n"
    write("src/laser/laser_driver/CMakeLists.txt", f"project(laser_driver)\n{build}ament_package()\n")
    files, hidden, _ = checked(capsys, "--select", "PKG001")
    assert ("src/laser/laser_driver/CMakeLists.txt" not in files, hidden > 0) == (vendored, vendored)


def test_what_releases_write_into_each_package_shows_a_clone(capsys: pytest.CaptureFixture[str]) -> None:
    Path("src/laser/LICENSE").unlink()
    assert checked(capsys)[1] == 0
    write("src/laser/laser_driver/CHANGELOG.rst", "1.0.1\n")
    assert checked(capsys)[1] == 1
    write("src/robot/CHANGELOG.rst", "1.0.1\n")  # this team releases its packages, too
    write("src/brain/CHANGELOG.rst", "1.0.1\n")
    assert checked(capsys)[1] == 0


def test_a_package_in_which_the_team_has_a_part_is_its_own(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/laser_driver", "carl", ADDRESS + "<author>Ann</author>")
    assert checked(capsys)[1] == 0


@pytest.mark.parametrize("more", ["", "<url></url>"])
def test_a_package_of_a_folder_with_a_license_alone_is_the_teams(capsys: pytest.CaptureFixture[str], more: str) -> None:
    package("src/laser/laser_driver", "carl", more)
    assert checked(capsys)[1] == 0


def test_a_license_of_the_whole_workspace_says_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    Path("src/laser/LICENSE").unlink()
    write("src/LICENSE", "MIT\n")
    write("LICENSE", "MIT\n")
    assert checked(capsys)[1] == 0


def test_where_most_packages_are_published_they_are_who_maintains_the_workspace(
    capsys: pytest.CaptureFixture[str],
) -> None:
    for name in ("laser_msgs", "laser_tools"):
        package(f"src/laser/{name}", "carl", ADDRESS)
    assert checked(capsys)[1] == 0


def test_what_such_a_package_does_to_an_own_one_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    sends = NODE.replace("self.get_logger().info(missing)", "self.create_publisher({}, '/scan', 10)").replace(
        "import rclpy\n", "import rclpy\nfrom std_msgs.msg import Int32, String\n", 1
    )
    write(FOREIGN, sends.format("Int32", name="laser_driver"))
    listens = sends.replace(
        "self.create_publisher({}, '/scan', 10)", "self.create_subscription({}, '/scan', print, 10)"
    )
    write("src/robot/robot/node.py", listens.format("String", name="robot"))
    write(
        "src/robot/launch/all.launch.xml",
        '<launch><node pkg="laser_driver" exec="node"/><node pkg="robot" exec="node"/></launch>\n',
    )
    files, _, _ = checked(capsys, "--select", "TOP001")
    assert files


def test_a_file_outside_of_the_workspace_is_in_none(
    capsys: pytest.CaptureFixture[str], tmp_path_factory: pytest.TempPathFactory
) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "node.py"
    elsewhere.write_text(NODE.format(name="other"), encoding="utf-8")
    files, _, _ = checked(capsys, "src", str(elsewhere))
    assert len(files) == 3


@pytest.mark.parametrize(
    ("said", "vendored"),
    [
        ("git clone https://github.com/carl/scanner.git", 2),
        ("    git clone -b ros2 git@github.com:carl/scanner", 2),
        ("git clone https://github.com/carl/laser_tools.git", 1),
        ("It takes the place of https://github.com/carl/scanner.", 1),
    ],
)
def test_a_readme_that_says_to_clone_what_it_lies_in(
    capsys: pytest.CaptureFixture[str], said: str, vendored: int
) -> None:
    package("src/scanner-humble/scan_driver", "dora")
    write("src/scanner-humble/README.md", f"# Scanner\n\n```\n{said}\n```\n")
    assert checked(capsys)[1] == vendored


@pytest.mark.parametrize(
    ("folder", "vendored"),
    [("scanner", 2), ("scanner-main", 2), ("scanner-main (of May)", 2), ("scanner-main-2", 1), ("robot_scanner", 1)],
)
def test_the_archive_of_a_repository_without_packages(
    capsys: pytest.CaptureFixture[str], folder: str, vendored: int
) -> None:
    write(f"ref/{folder}/README.md", "git clone https://github.com/carl/scanner.git\n")
    write(f"ref/{folder}/tools/run.py", NODE.format(name="scan") + "\n\nif __name__ == '__main__':\n    main()\n")
    assert checked(capsys)[1] == vendored
    assert f"ref/{folder}/tools/run.py" in checked(capsys, f"ref/{folder}")[0]


def test_the_readme_of_the_workspace_is_about_no_package(capsys: pytest.CaptureFixture[str]) -> None:
    write("README.md", "git clone https://github.com/team/robot.git\n")
    assert checked(capsys)[1] == 1


OLD = "teb_local_planner"
"""The name of a package that was released for ROS 1."""


@pytest.mark.parametrize(
    ("folder", "version", "who", "vendored"),
    [
        (f"src/{OLD}", "0.8.4", "dora", 2),
        (f"src/{OLD}", "0.0.0", "dora", 1),  # what `ros2 pkg create` writes
        (f"src/{OLD}", "1.0.1", "dora", 1),  # the version of the team's packages
        (f"src/{OLD}", "0.8.4", "todo", 1),
        (f"src/custom_nav/{OLD}", "0.8.4", "dora", 1),
        ("src/navigation", "0.8.4", "dora", 1),  # released once, and a word that anybody may take
    ],
)
def test_the_manifest_of_a_release(
    capsys: pytest.CaptureFixture[str], folder: str, version: str, who: str, vendored: int
) -> None:
    package(folder, who)
    manifest = Path(folder, "package.xml")
    text = manifest.read_text(encoding="utf-8").replace("@example.org", "@robots.org").replace("1.0.1", version)
    manifest.write_text(text, encoding="utf-8")
    assert checked(capsys)[1] == vendored


def test_a_package_that_goes_with_a_copy(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/laser_driver", "carl", f"{ADDRESS}<exec_depend>laser_driver_tools</exec_depend>")
    package("src/laser_driver_tools", "carl")
    assert checked(capsys)[1] == 2
    package("src/laser_driver_tools", "dora")
    assert checked(capsys)[1] == 0  # it is the team's, and the driver needs it


def test_what_lies_in_a_repository_of_published_packages(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/laser_filter", "carl", ADDRESS)
    package("src/laser/beam_helpers", "dora")
    assert checked(capsys)[1] == 0  # three copies, and two packages of the team
    write(".gitignore", "build/\n")  # the team's repository, into which one other was copied
    assert checked(capsys)[1] == 3


def test_a_copy_may_need_what_lies_in_its_repository(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/laser_driver", "carl", f"{ADDRESS}<exec_depend>beam_helpers</exec_depend>")
    package("src/laser/beam_helpers", "dora")
    assert checked(capsys)[1] == 1


def test_a_configuration_that_moveit_made_is_the_teams(capsys: pytest.CaptureFixture[str]) -> None:
    package("src/laser/arm_moveit_config", "dora", "<url>https://github.com/moveit/moveit2</url>")
    assert checked(capsys)[1] == 1
