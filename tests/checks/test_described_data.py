"""PKG004: files that a description of a robot names by the package that they are in, and that its build leaves out."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import CMAKE, SETUP, write_files

ROBOT = '<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  {}\n</robot>\n'
INCLUDE = '<xacro:include filename="$(find robot)/parts/arm.xacro"/>'
MESH = '<mesh filename="package://robot/parts/arm.stl"/>'
PARTS = {"parts/arm.xacro": ROBOT.format(""), "parts/arm.stl": "", "setup.py": "", "launch/it.launch.xml": "<launch/>"}


def described(line: str, installed: str, **more: str) -> dict[str, str]:
    """A package that CMake builds, with a description in the folder ``urdf``."""
    build = f"project(robot)\nfind_package(ament_cmake REQUIRED)\n{installed}\nament_package()\n"
    robot = {"package.xml": CMAKE, "CMakeLists.txt": build, "urdf/robot.urdf.xacro": ROBOT.format(line)}
    return {**robot, **PARTS, **more}


URDF = "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})"


@pytest.mark.parametrize(
    ("line", "column"),
    [(INCLUDE, 18), (MESH, 9), (f"<xacro:if value='$(arg arm)'>{INCLUDE}</xacro:if>", 47)],
)
def test_a_folder_that_a_description_names_by_its_package(findings, line: str, column: int):
    """No launch file reads the description here: whoever does needs that folder."""
    (told,) = findings("PKG004", **described(line, URDF))
    assert told.message == (
        "package 'robot' does not install the folder 'parts', which urdf/robot.urdf.xacro looks for in its share folder"
    )
    assert (told.place.file, told.place.line) == ("CMakeLists.txt", 4)
    assert told.help == "write install(DIRECTORY parts DESTINATION share/${PROJECT_NAME})"
    (row,) = told.related
    assert (row.place.file, row.place.line, row.place.column) == ("urdf/robot.urdf.xacro", 2, column)
    assert findings("PKG004", **described(line, URDF.replace("urdf", "urdf parts"))) == []


def test_a_file_whose_neighbours_are_installed(findings):
    installed = f"{URDF}\ninstall(FILES parts/leg.stl DESTINATION share/${{PROJECT_NAME}}/parts)"
    (told,) = findings("PKG004", **described(MESH, installed, **{"parts/leg.stl": ""}))
    assert told.message.startswith("package 'robot' does not install the file 'parts/arm.stl', which urdf/robot.urdf")
    assert told.help == "write install(FILES parts/arm.stl DESTINATION share/${PROJECT_NAME}/parts)"


def test_a_file_beside_the_description(findings):
    """A path without a package goes from the folder of the description on, where that is installed."""
    line = '<xacro:include filename="wheel.xacro"/>'
    alone = "install(FILES urdf/robot.urdf.xacro DESTINATION share/${PROJECT_NAME}/urdf)\n" + URDF.replace(" urdf", "")
    (told,) = findings("PKG004", **described(line, alone, **{"urdf/wheel.xacro": ROBOT.format("")}))
    assert "does not install the file 'urdf/wheel.xacro', which urdf/robot.urdf.xacro looks for" in told.message
    assert findings("PKG004", **described(line, URDF, **{"urdf/wheel.xacro": ROBOT.format("")})) == []
    assert findings("PKG004", **described(line, URDF)) == []  # nobody knows where that file is


@pytest.mark.parametrize(
    ("build", "more", "told"),
    [
        ("", {}, 1),
        ("", {"scripts/move.py": "print(1)\n"}, 0),
        ("add_executable(move src/move.cpp)\n", {"src/move.cpp": "int main() {}\n"}, 0),
    ],
)
def test_a_package_that_is_nothing_but_descriptions(tmp_path, monkeypatch, build: str, more: dict[str, str], told: int):
    """It installs none of them, which a package with code may do on purpose."""
    files = described(INCLUDE, build + URDF.replace(" urdf", ""), **more)
    write_files(tmp_path, {"archlint.toml": 'select = ["PKG004"]', **files})
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert ["does not install the folder 'parts'" in row.message for row in found] == [True] * told


def test_a_package_that_setup_py_builds(findings):
    listed = "data_files=[('share/robot/urdf', ['urdf/robot.urdf.xacro']), "
    files = {"setup.py": SETUP.replace("data_files=[", listed), "urdf/robot.urdf.xacro": ROBOT.format(MESH)}
    (told,) = findings("PKG004", **files, **{"parts/arm.stl": ""})
    assert told.help == "add ('share/robot/parts', glob('parts/*')) to data_files="


@pytest.mark.parametrize(
    "line",
    [
        f"<!-- {MESH} -->",
        MESH.replace("arm.stl", "gone.stl"),
        MESH.replace("robot", "other_robot"),
        MESH.replace("package://robot", "file://$(find robot)"),
        MESH.replace("arm.stl", "${side}.stl"),
        MESH.replace("mesh", "texture"),
        f"<xacro:macro name='m'>{INCLUDE}</xacro:macro>",
        f"<xacro:if value='false'>{INCLUDE}</xacro:if>",
        INCLUDE.replace("/>", " optional='true'/>"),
    ],
)
def test_what_a_description_may_do_without(findings, line: str):
    assert findings("PKG004", **described(line, URDF)) == []


@pytest.mark.parametrize(
    "installed",
    [
        URDF + "\ninstall(DIRECTORY parts/ DESTINATION share/${PROJECT_NAME}/parts)",
        URDF + "\ninstall(DIRECTORY ${PARTS} DESTINATION share/${PROJECT_NAME})",
        URDF + "\ninstall_parts(parts)",
        URDF + "\nament_auto_package(INSTALL_TO_SHARE parts)",
    ],
)
def test_a_build_that_installs_it_or_may(findings, installed: str):
    assert findings("PKG004", **described(MESH, installed)) == []


def test_what_a_launch_file_reads_is_told_there(findings):
    launch = '<launch><node pkg="robot_state_publisher" exec="robot_state_publisher"><param name="robot_description" '
    launch += "value=\"$(command 'xacro $(find-pkg-share robot)/urdf/robot.urdf.xacro')\"/></node></launch>"
    files = described(INCLUDE, URDF, **{"launch/it.launch.xml": launch})
    assert findings("PKG004", **files) == []
    assert len(findings("LCH004", **files)) == 1
