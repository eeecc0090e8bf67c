"""PKG002: classes of a description of plugins that C++ registers under another name."""

from __future__ import annotations

import pytest

from robot_package import CMAKE

BUILD = """\
project(robot)
find_package(ament_cmake REQUIRED)
find_package(pluginlib REQUIRED)
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
ament_package()
"""
BASE = "nav2_core::Controller"
CPP = f"PLUGINLIB_EXPORT_CLASS(\n  robot::{{}}, {BASE})\n"
OTHER = "PLUGINLIB_EXPORT_CLASS(robot::Arm, tools::Arm)\n"


def xml(*types: str, base: str = BASE) -> str:
    """A description of these classes."""
    classes = "".join(f'  <class type="{name}"\n    base_class_type="{base}"/>\n' for name in types)
    return f'<library path="robot">\n  <!-- <class type="a::B" base_class_type="{base}"/> -->\n{classes}</library>\n'


@pytest.fixture
def told(findings):
    """What is found for a description and a C++ source."""

    def run(description: str, code: str):
        files = {"CMakeLists.txt": BUILD, "plugins.xml": description, "src/controller.cpp": code}
        return findings("PKG002", **{"package.xml": CMAKE, **files})

    return run


@pytest.mark.parametrize(
    ("types", "code"),
    [
        (["robots::Follow"], CPP.format("Follow")),
        (["robot::FollowPath"], CPP.format("Follow")),
        (["robot::Folow"], CPP.format("Follow") + CPP.format("Turn")),
        (["robot::Turn", "robots::Follow"], CPP.format("Follow") + CPP.format("Turn")),
        (["robots::Follow"], OTHER + CPP.format("Follow")),
    ],
)
def test_a_class_that_is_registered_under_another_name(told, types, code):
    (finding,) = told(xml(*types), code)
    assert finding.message == (
        f"the plugin '{types[-1]}' cannot be loaded: the package registers no class of that name for '{BASE}', but "
        "'robot::Follow', which no description names"
    )
    line = 3 + 2 * (len(types) - 1)
    assert (finding.place.file, finding.place.line, finding.place.column) == ("plugins.xml", line, 16)
    assert [row.place.file for row in finding.related] == ["src/controller.cpp"]


@pytest.mark.parametrize(
    ("description", "code"),
    [
        (xml("robot::Follow"), CPP.format("Follow")),
        (xml("robot::Follow&lt;&gt;"), CPP.format("Follow<>")),
        (xml("robots::Follow"), ""),  # perhaps registered by a macro of the team
        (xml("robots::Follow"), f"// {OTHER}" + OTHER),
        (xml("robots::Follow"), "// PLUGINLIB_EXPORT_CLASS(robot::Follow, nav2_core::Controller)\n"),
        (xml("robot::Follow", "robots::Follow"), CPP.format("Follow")),
        (xml("robot.Panel", base="rqt_gui_py::Plugin"), CPP.format("Follow")),
        ("<class type='robots::Follow'/>", CPP.format("Follow")),
    ],
)
def test_classes_that_are_registered_or_may_be(told, description, code):
    assert told(description, code) == []


COMPONENTS = """\
project(robot)
find_package(ament_cmake REQUIRED)
find_package(rclcpp_components REQUIRED)
add_library(parts SHARED src/parts.cpp)
rclcpp_components_register_node(parts PLUGIN "robot::{}" EXECUTABLE arm)
install(TARGETS parts DESTINATION lib)
ament_package()
"""


@pytest.mark.parametrize(
    ("asked", "registered", "told"),
    [
        ("Arm", "robot::Hand", ["robot::Hand"]),
        ("Arm", "arm::Arm", ["arm::Arm"]),
        ("Arm", "robot::Arm", []),
        ("Arm", "", []),
        ("${NAME}", "robot::Hand", []),
    ],
)
def test_a_component_that_is_registered_under_another_name(findings, asked, registered, told):
    code = f"RCLCPP_COMPONENTS_REGISTER_NODE({registered})\n" if registered else "int arm() {}\n"
    files = {"package.xml": CMAKE, "CMakeLists.txt": COMPONENTS.format(asked), "src/parts.cpp": code}
    found = findings("PKG002", **files)
    assert [row.meant for row in found] == told
    assert [row.place.line for row in found] == [5] * len(told)


def test_a_description_that_is_not_there(findings):
    (found,) = findings("PKG004", **{"package.xml": CMAKE, "CMakeLists.txt": BUILD})
    assert "lists a file that is not there: the build stops at 'plugins.xml'" in found.message
