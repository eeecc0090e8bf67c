"""LNT002 about files that the build of their package neither compiles nor installs."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

PACKAGE = (
    "<package format='3'><name>demo</name><version>0.0.1</version><description>d</description>"
    "<maintainer email='kim@example.com'>Kim</maintainer><license>MIT</license>"
    "<export><build_type>{kind}</build_type></export></package>"
)
BROKEN_CPP = """\
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<rclcpp::Node>("old");
}
"""
BROKEN_LAUNCH = (
    "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription(]\n"
)


def unreadable(folder: Path, kind: str, asked: str = ".", **files: str) -> list[str]:
    texts = {
        "package.xml": PACKAGE.format(kind=kind),
        "archlint.toml": 'select = ["LNT002"]\n',
        **files,
    }
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return [row.place.file for row in check(Request((asked,), load(folder), cached=False, jobs=1)).findings]


@pytest.mark.parametrize(
    ("cmake", "told"),
    [
        ("add_executable(old src/old.cpp)", 1),
        ("foreach(name old new)\n  add_executable(${name} src/${name}.cpp)\nendforeach()", 1),
        ("file(GLOB files src/*.cpp)\nadd_executable(all ${files})", 1),
        ("add_executable(new src/new.cpp)", 0),
        ("add_executable(new src/new.cpp)\n# add_executable(old src/old.cpp)", 0),
        ("add_executable(new src/new.cpp)\nadd_executable(old-new src/old-new.cpp)", 0),
    ],
)
def test_a_source_that_no_target_has(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, cmake: str, told: int):
    monkeypatch.chdir(tmp_path)
    cmake = f"project(demo)\nfind_package(rclcpp REQUIRED)\n{cmake}\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "src/old.cpp": BROKEN_CPP, "src/new.cpp": "int main() {}\n"}
    assert unreadable(tmp_path, "ament_cmake", **files) == ["src/old.cpp"] * told


def test_a_source_that_another_one_includes_or_that_is_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    files = {"CMakeLists.txt": "project(demo)\nadd_executable(new src/new.cpp)\n", "src/old.cpp": BROKEN_CPP}
    assert unreadable(tmp_path, "ament_cmake", **files, **{"src/new.cpp": '#include "old.cpp"\n'}) == ["src/old.cpp"]
    assert unreadable(tmp_path, "ament_cmake", **files, **{"src/new.cpp": "int main() {}\n"}) == []
    assert unreadable(tmp_path, "ament_cmake", "src/old.cpp", **files) == ["src/old.cpp"]


BROKEN_HEADER = """\
#include <nav_msgs/msg/odometry.hpp>
#include <rclcpp/rclcpp.hpp>
class Odometry : public rclcpp::Node {
public:
  Odometry() : Node("odometry") {
"""


@pytest.mark.parametrize(
    ("cmake", "source", "told"),
    [
        ("", "int main() {}", 0),
        ("", '#include "demo/odometry.hpp"', 1),
        ("", '#include "../include/demo/odometry.hpp"', 1),
        ("", '#include "../other/odometry.hpp"', 0),
        ("", "#include <nav_msgs/msg/odometry.hpp>", 0),  # another header of that name
        ("install(DIRECTORY include/ DESTINATION include)", "int main() {}", 1),  # for other workspaces
        ("add_library(demo INTERFACE include/demo/odometry.hpp)", "int main() {}", 1),
    ],
)
def test_a_header_that_nothing_includes_or_installs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, cmake: str, source: str, told: int
):
    monkeypatch.chdir(tmp_path)
    cmake = f"project(demo)\nadd_executable(new src/new.cpp)\n{cmake}\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "include/demo/odometry.hpp": BROKEN_HEADER, "src/new.cpp": f"{source}\n"}
    assert unreadable(tmp_path, "ament_cmake", **files) == ["include/demo/odometry.hpp"] * told


SETUP = """\
from setuptools import setup
setup(name='demo', packages=['demo'], data_files=[{files}],
      entry_points={{'console_scripts': ['talker = demo.talker:main']}})
"""


@pytest.mark.parametrize(
    ("installed", "readme", "told"),
    [
        ("", "A robot.", 1),
        ("('share/demo/launch', ['launch/base.launch.py'])", "A robot.", 0),
        ("('share/demo/launch', ['launch/arm.launch.py'])", "A robot.", 1),
        ("", "    ros2 launch launch/arm.launch.py", 1),
    ],
)
def test_a_launch_file_that_nothing_installs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, installed: str, readme: str, told: int
):
    monkeypatch.chdir(tmp_path)
    files = {
        "setup.py": SETUP.format(files=installed),
        "demo/__init__.py": "",
        "demo/talker.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
        "launch/arm.launch.py": BROKEN_LAUNCH,
        "launch/base.launch.py": "",
        "README.md": readme,
    }
    assert unreadable(tmp_path, "ament_python", **files) == ["launch/arm.launch.py"] * told


MERGE = "<<<<<<< HEAD\nfind_package(nav_msgs REQUIRED)\n=======\nfind_package(std_msgs REQUIRED)\n>>>>>>> 1a2b3c4\n"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (MERGE, 1),
        ("# =======\n# a heading\n# =======\n", 0),
        ('message("<<<<<<< here")\n', 0),
        ("<<<<<<< HEAD\nfind_package(nav_msgs REQUIRED)\n", 1),  # no whole merge, and no command either
    ],
)
def test_a_merge_that_is_left_in_a_build_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, told: int):
    monkeypatch.chdir(tmp_path)
    cmake = f"project(demo)\nfind_package(ament_cmake REQUIRED)\n{text}ament_package()\n"
    assert unreadable(tmp_path, "ament_cmake", **{"CMakeLists.txt": cmake}) == ["CMakeLists.txt"] * told
