"""package.xml, and which files belong to the package."""

from __future__ import annotations

import pytest

from archlint.workspace.manifest import condition_holds, condition_verdict
from workspace.trees import file_in, look, manifest, plant


def problems(tmp_path, text: str | bytes) -> list[tuple[int, str]]:
    plant(tmp_path, {"pkg/": ""})
    (tmp_path / "pkg/package.xml").write_bytes(text if isinstance(text, bytes) else text.encode())
    workspace = look(tmp_path)
    assert workspace.packages == ()
    assert {problem.file for problem in workspace.problems} == {"pkg/package.xml"}
    return [(problem.line, problem.message) for problem in workspace.problems]


def test_what_a_manifest_says(tmp_path):
    plant(
        tmp_path,
        {
            "arm/package.xml": """\
                <?xml version="1.0"?>
                <?xml-model href="http://download.ros.org/schema/package_format3.xsd"?>
                <package format="3">
                  <name>arm</name>
                  <depend>rclpy</depend>
                  <exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>
                  <test_depend>pytest</test_depend>
                  <export><build_type>ament_python</build_type></export>
                </package>
            """
        },
    )
    [package] = look(tmp_path).packages
    assert (package.name, package.relative, package.build_type) == ("arm", "arm", "ament_python")
    assert package.root == str(tmp_path / "arm")
    assert not package.is_interface_package
    assert [(entry.kind, entry.name, entry.condition, entry.line) for entry in package.dependencies] == [
        ("depend", "rclpy", None, 5),
        ("exec", "rospy", "$ROS_VERSION == 1", 6),
        ("test", "pytest", None, 7),
    ]


def test_the_working_directory_may_be_the_package(tmp_path):
    plant(tmp_path, {"package.xml": manifest("arm")})
    assert look(tmp_path).packages[0].relative == "."


def test_a_manifest_of_format_1(tmp_path):
    plant(tmp_path, {"package.xml": "<package><name>old</name><run_depend>rospy</run_depend></package>"})
    [package] = look(tmp_path).packages
    assert (package.build_type, [entry.kind for entry in package.dependencies]) == ("catkin", ["run"])


@pytest.mark.parametrize(
    ("group", "expected"),
    [
        ("<member_of_group>rosidl_interface_packages</member_of_group>", True),
        ("<member_of_group condition='$ROS_VERSION == 1'>rosidl_interface_packages</member_of_group>", False),
        ("<member_of_group>others</member_of_group>", False),
        ("", False),
    ],
)
def test_packages_of_interfaces_say_so(tmp_path, group, expected):
    plant(tmp_path, {"package.xml": manifest("robot_interfaces", "ament_cmake", group)})
    assert look(tmp_path).packages[0].is_interface_package is expected


def test_the_build_type_that_holds_in_ros_2_counts(tmp_path):
    export = """
        <export>
          <build_type condition="$ROS_VERSION == 1">catkin</build_type>
          <build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>
        </export>"""
    plant(tmp_path, {"package.xml": f"<package><name>both</name>{export}</package>"})
    assert look(tmp_path).packages[0].build_type == "ament_cmake"


# --- manifests that are none


def test_a_manifest_that_is_not_well_formed_is_told_with_its_place(tmp_path):
    text = "<package>\n  <name>pkg</name>\n  <description>x<description>\n</package>\n"
    assert problems(tmp_path, text) == [(4, "malformed package.xml: mismatched tag")]


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("", 1, "malformed package.xml: no element found"),
        ("<package>\n</package>", 1, "malformed package.xml: the package has no <name>"),
        ("<package>\n<name> </name></package>", 1, "malformed package.xml: the package has no <name>"),
        ("\n<robot/>", 2, "malformed package.xml: the root element is <robot>, not <package>"),
        ("<package>\n<name>a b</name></package>", 2, "malformed package.xml: 'a b' is not a valid package name"),
        (b"\xff\xfe\x00", 1, "malformed package.xml: unclosed token"),
        ("<?xml version='1.0' encoding='none-such'?><package/>", 1, "malformed package.xml: unknown encoding"),
    ],
)
def test_a_manifest_of_nothing_is_told(tmp_path, text, line, message):
    [(found_line, found_message)] = problems(tmp_path, text)
    assert found_line == line
    assert found_message.startswith(message)


def test_no_entity_ever_expands(tmp_path):
    bomb = '<!DOCTYPE package [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>\n<package><name>&b;</name></package>'
    assert problems(tmp_path, bomb) == [(1, "malformed package.xml: a document type is not allowed here")]


def test_deeply_nested_elements_are_survived(tmp_path):
    depth = 20_000
    plant(tmp_path, {"package.xml": "<package><name>deep</name>" + "<a>" * depth + "</a>" * depth + "</package>"})
    assert look(tmp_path).packages[0].name == "deep"


def test_files_of_a_package_without_a_readable_manifest_still_have_their_modules(tmp_path):
    plant(tmp_path, {"pkg/package.xml": "<package", "pkg/pkg/__init__.py": "", "pkg/pkg/node.py": ""})
    file = file_in(look(tmp_path), "pkg/pkg/node.py")
    assert (file.package, file.module) == (None, "pkg.node")


def test_the_manifest_of_the_package_around_a_path_is_not_what_was_asked_about(tmp_path):
    plant(tmp_path, {"pkg/package.xml": "<package", "pkg/pkg/node.py": ""})
    assert look(tmp_path, "pkg/pkg").problems == ()


# --- which files belong


def test_each_file_belongs_to_the_package_around_it(tmp_path):
    plant(
        tmp_path,
        {
            "src/arm/package.xml": manifest("arm"),
            "src/arm/arm/node.py": "",
            "src/group/leg/package.xml": manifest("leg"),
            "src/group/leg/leg/node.py": "",
            "src/tool.py": "",
        },
    )
    workspace = look(tmp_path)
    assert [package.name for package in workspace.packages] == ["arm", "leg"]
    owners = {file.relative: file.package for file in workspace.files if file.kind == "python"}
    assert owners == {"src/arm/arm/node.py": "arm", "src/group/leg/leg/node.py": "leg", "src/tool.py": None}


def test_a_package_inside_a_package_is_none_for_colcon_does_not_look_there(tmp_path):
    plant(
        tmp_path,
        {
            "outer/package.xml": manifest("outer"),
            "outer/test/data/package.xml": "<package><broken",
            "outer/template/package.xml": manifest("inner"),
            "outer/template/node.py": "",
        },
    )
    workspace = look(tmp_path)
    assert [package.name for package in workspace.packages] == ["outer"]
    assert workspace.problems == ()
    assert file_in(workspace, "outer/template/node.py").package == "outer"


# --- conditions


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        (None, True),
        ("$ROS_VERSION == 2", True),
        ("$ROS_VERSION == 1", False),
        ("$ROS_VERSION != '1'", True),
        ("2 == $ROS_VERSION", True),
        ("$ROS_VERSION >= 2", True),
        ("$ROS_VERSION < 2", False),
        ("$ROS_DISTRO == humble", True),
        ("$ROS_DISTRO == jazzy", False),
        ('$ROS_DISTRO == jazzy or $ROS_VERSION == "2"', True),
        ("$ROS_DISTRO == jazzy and $ROS_VERSION == 2", False),
        ("$ROS_VERSION == 2 or $ROS_VERSION == 1 and $ROS_DISTRO == jazzy", True),
        ("($ROS_VERSION == 2 or $ROS_VERSION == 1) and $ROS_DISTRO == jazzy", False),
        ("$NOT_SET == ''", True),
    ],
)
def test_conditions(condition, holds):
    assert condition_holds(condition, {"ROS_DISTRO": "humble"}) is holds


@pytest.mark.parametrize(
    ("condition", "verdict"),
    [
        ("$BUILD == hardware", None),
        ("$BUILD == hardware or $ROS_VERSION == 2", True),
        ("$BUILD == hardware and $ROS_VERSION == 2", None),
        ("$BUILD == hardware and $ROS_VERSION == 1", False),
        ("$ROS_DISTRO == humble", None),
    ],
)
def test_conditions_on_what_only_the_building_machine_knows(condition, verdict):
    assert condition_verdict(condition) is verdict
    assert condition_holds(condition) is (verdict is not False)


@pytest.mark.parametrize("condition", ["==", "$ROS_VERSION", "(" * 900, "(" * 100_000, "a == b == c", "; rm", "a ="])
def test_what_is_no_condition_takes_nothing_away(condition):
    assert condition_holds(condition)
