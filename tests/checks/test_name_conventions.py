"""NME001 says once what is so in a whole workspace, and alone what does not fit what is around it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.known import Baseline, Entry, Older
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from archlint.report.fingerprint import with_fingerprints
from robot_package import manifest, write_robot

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class {class_name}(Node):
    def __init__(self):
        super().__init__('{node}')
{publishers}


def main():
    rclpy.init()
    rclpy.spin({class_name}())
"""
SETUP = """\
from setuptools import setup
setup(name='robot', entry_points={{'console_scripts': [{scripts}]}})
"""


def node(class_name: str, *names: str, comment: str = "") -> str:
    """A module with one class, which publishes under these names; a comment ends the line of each."""
    lines = (f"        self.create_publisher(String, '{name}', 10){comment}" for name in names)
    return NODE.format(class_name=class_name, node=class_name.lower(), publishers="\n".join(lines))


def request(folder: Path, launch: str = "", **nodes: str) -> Request:
    """A check of the package ``robot`` that consists of these modules, all of them installed."""
    scripts = ", ".join(f"'{name} = robot.{name}:main'" for name in nodes)
    files = {f"robot/{name}.py": text for name, text in nodes.items()}
    files |= {"setup.py": SETUP.format(scripts=scripts), "archlint.toml": 'select = ["NME001"]'}
    write_robot(folder, launch, **files)
    (folder / "robot" / "talker.py").unlink()
    return Request((".",), load(folder), cached=False, jobs=1)


def everywhere(folder: Path, launch: str = "", **nodes: str) -> Request:
    """The same for who wants to hear of all absolute names."""
    asked = request(folder, launch, **nodes)
    (folder / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    return replace(asked, settings=load(folder))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


ARM = node("Arm", "/arm/state", "/arm/goal")
BASE = node("Base", "/base/state")
CAMERA = node("Camera", "/camera/image", "/camera/state")


def places(findings: list[Finding]) -> list[tuple[str, int]]:
    return [(finding.place.file, finding.place.line) for finding in findings]


def test_classes_with_nothing_else_are_one_finding(folder: Path):
    [finding] = check(request(folder, arm=ARM, base=BASE, camera=CAMERA)).findings

    assert finding.message == "3 nodes of package 'robot' fix 5 absolute names: no namespace applies to any of them"
    assert finding.severity is Severity.WARNING
    assert places([finding]) == [("robot/arm.py", 9)]
    assert [(related.place.file, related.place.line, related.message) for related in finding.related] == [
        ("robot/base.py", 9, "Base fixes the topic '/base/state'"),
        ("robot/camera.py", 9, "Camera fixes the topic '/camera/image' and 1 more"),
    ]
    assert "`archlint check --fix --unsafe-fixes`" in finding.help
    assert '`ignore = ["NME001"]`' in finding.help


def write_package(folder: Path, name: str, text: str) -> None:
    setup = f"from setuptools import setup\nsetup(name='{name}')\n"
    write_robot(folder / name, **{"package.xml": manifest(name), "setup.py": setup, "robot/talker.py": text})
    (folder / "archlint.toml").write_text('select = ["NME001"]')


def test_so_are_those_of_several_packages(folder: Path):
    write_package(folder, "arms", ARM)
    write_package(folder, "base", BASE)
    [finding] = check(Request((".",), load(folder), cached=False, jobs=1)).findings
    assert finding.message == "2 nodes in 2 packages fix 3 absolute names: no namespace applies to any of them"

    write_package(folder, "camera", CAMERA)
    assert check(Request((".",), load(folder), cached=False, jobs=1)).findings == []  # they make up a robot


def test_one_class_alone_is_told_by_its_name(folder: Path):
    [finding] = check(request(folder, arm=ARM)).findings

    assert finding.message == (
        "2 names of Arm are absolute and fixed in the code, such as the topic '/arm/state': no namespace applies to "
        "them"
    )


def test_the_message_counts_more_than_what_is_related(folder: Path):
    nodes = {f"arm{number}": node(f"Arm{number}", "/state", f"/arm{number}") for number in range(20)}
    [finding] = check(everywhere(folder, viewer=node("Viewer", "state"), **nodes)).findings

    assert finding.message.startswith("20 nodes of package 'robot' fix 21 absolute names, beside relative ones")
    assert len(finding.related) == 11


def test_it_stays_the_same_finding_when_a_name_is_added(folder: Path):
    marks = []
    for more in ({}, {"drive": node("Drive", "/wheels/drive")}):
        findings = check(request(folder, arm=ARM, base=BASE, **more)).findings
        marks += [mark for _, mark in with_fingerprints(findings)]

    assert len(marks) == 2 and len(set(marks)) == 1


def test_its_fix_is_that_of_all_classes(folder: Path):
    [finding] = check(request(folder, arm=ARM, base=BASE, camera=CAMERA)).findings

    assert finding.fix is not None
    assert {edit.place.file for edit in finding.fix.edits} == {"robot/arm.py", "robot/base.py", "robot/camera.py"}


def test_one_name_that_all_classes_use(folder: Path):
    modules = {name.lower(): node(name, "/bus/words") for name in ("Arm", "Base", "Camera")}
    [finding] = check(request(folder, **modules)).findings

    assert finding.message == (
        "3 nodes of package 'robot' fix the absolute name '/bus/words': no namespace applies to it"
    )


def test_classes_whose_nodes_have_one_name_are_several_nodes(folder: Path):
    other = node("Other", "/bus/words").replace("__init__('other')", "__init__('arm')")
    [finding] = check(request(folder, arm=node("Arm", "/bus/words"), other=other)).findings

    assert finding.message.startswith("2 nodes of package 'robot' fix the absolute name '/bus/words'")


def test_a_class_that_mixes_both_forms_is_told_with_its_package(folder: Path):
    lidar = node("Lidar", "/lidar/scan", "lidar/state")
    [alone] = check(request(folder, lidar=lidar)).findings
    assert alone.message == (
        "the topic '/lidar/scan' is absolute and fixed in the code, beside relative names of the same node such as "
        "'lidar/state': in a namespace, only those move"
    )

    [mixed] = check(request(folder, arm=ARM, base=BASE, lidar=lidar)).findings
    assert places([mixed]) == [("robot/lidar.py", 9)]
    assert mixed.message == (
        "3 nodes of package 'robot' fix 4 absolute names, beside relative ones such as 'lidar/state': in a namespace, "
        "only those move"
    )
    assert [related.place.file for related in mixed.related] == ["robot/arm.py", "robot/base.py"]


def test_packages_that_have_both_forms_are_told_with_the_others(folder: Path):
    write_package(folder, "lidars", node("Lidar", "/lidar/scan", "lidar/state"))
    write_package(folder, "arms", ARM)
    write_package(folder, "bases", BASE)

    (folder / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    [finding] = check(Request((".",), load(folder), cached=False, jobs=1)).findings
    assert finding.message.startswith("3 nodes in 3 packages fix 4 absolute names, beside relative ones such as")
    assert places([finding]) == [("lidars/robot/talker.py", 9)]
    assert [related.place.file for related in finding.related] == ["arms/robot/talker.py", "bases/robot/talker.py"]


def many(*names: str) -> dict[str, str]:
    """More nodes than a small workspace has, each with one name."""
    return {f"node{number}": node(f"Node{number}", name) for number, name in enumerate(names)}


ALL_ABSOLUTE = [f"/part{number}/state" for number in range(7)]
MOSTLY_RELATIVE = [name.removeprefix("/") for name in ALL_ABSOLUTE]


@pytest.mark.parametrize(("count", "told"), [(5, [("robot/node0.py", 9)]), (6, [])])
def test_a_large_workspace_with_nothing_else_is_built_so(folder: Path, count: int, told: list[tuple[str, int]]):
    assert places(check(request(folder, **many(*ALL_ABSOLUTE[:count]))).findings) == told


def subscriber(class_name: str, name: str) -> str:
    """A module with one class, which subscribes to this name."""
    return node(class_name, name).replace("create_publisher", "create_subscription").replace(", 10)", ", print, 10)")


def test_a_large_workspace_hears_of_the_two_ends_of_one_topic(folder: Path):
    nodes = {
        "lidar": node("Lidar", "lidar/scan"),
        "user": subscriber("User", "/lidar/scan"),
        "viewer": node("Viewer", "/user/state"),
        "recorder": subscriber("Recorder", "lidar/scan"),
    }
    [finding] = check(request(folder, **nodes, **many(*MOSTLY_RELATIVE))).findings

    assert places([finding]) == [("robot/user.py", 9)]
    assert finding.message == (
        "the topic '/lidar/scan' is absolute and fixed in the code, and the other end has 'lidar/scan' as a relative "
        "name: in a namespace, the two no longer meet"
    )
    assert [(related.place.file, related.message) for related in finding.related] == [
        ("robot/lidar.py", "'lidar/scan' is relative here"),
    ]


@pytest.mark.parametrize(
    ("launch", "told"),
    [
        ('<node pkg="robot" exec="lidar"/>', False),
        ('<node pkg="robot" exec="lidar"/><node pkg="robot" exec="node0" namespace="part"/>', True),
    ],
    ids=["nothing in a namespace", "another node in one"],
)
def test_of_two_ends_that_differ_either_may_be_meant(folder: Path, launch: str, told: bool):
    nodes = {"lidar": node("Lidar", "lidar/scan"), "user": subscriber("User", "/lidar/scan")}
    assert bool(check(request(folder, launch, **nodes, **many(*MOSTLY_RELATIVE))).findings) is told


@pytest.mark.parametrize(
    ("names", "viewer", "told"),
    [
        (("/lidar/scan", "user/state"), "viewer/state", True),
        (("/lidar/scan", "/tf_static"), "viewer/state", True),  # ROS itself makes that one absolute
        (("/lidar/scan", "/user/state"), "viewer/state", False),  # without one '/', the class stays where it is
        (("/lidar/scan",), "/viewer/state", False),  # another class that has the name stays
    ],
)
def test_a_slip_is_a_name_whose_class_follows_its_namespace_otherwise(
    folder: Path, names: tuple[str, ...], viewer: str, told: bool
):
    nodes = {
        "lidar": node("Lidar", "lidar/scan"),
        "other": subscriber("Other", "lidar/scan"),  # as many have it as a relative name
        "user": subscriber("User", names[0]).replace(
            "print, 10)", f"print, 10){''.join(map(CREATES.format, names[1:]))}"
        ),
        "viewer": subscriber("Viewer", "/lidar/scan").replace("print, 10)", f"print, 10){CREATES.format(viewer)}"),
    }
    assert bool(check(request(folder, **nodes, **many(*MOSTLY_RELATIVE))).findings) is told


@pytest.mark.parametrize(("family", "told"), [("lidar", False), ("part", True)])
def test_a_relative_name_of_a_family_of_absolute_ones_does_not_fit(folder: Path, family: str, told: bool):
    """Taking the '/' from one more name of ``/lidar/…`` would be the wrong end."""
    nodes = {"lidar": node("Lidar", "lidar/scan"), "user": subscriber("User", "/lidar/scan")}
    nodes["recorder"] = subscriber("Recorder", "lidar/scan")
    others = many(*(f"/{family}/state{number}" for number in range(7)))
    assert bool(check(request(folder, **nodes, **others)).findings) is told


CREATES = "\n        self.create_publisher(String, '{}', 10)"


@pytest.mark.parametrize(
    "others",
    [
        {"user": node("User", "/lidar/scan")},  # another version of the same node
        {"user": subscriber("User", "/lidar/scan"), "viewer": subscriber("Viewer", "/lidar/scan")},  # it is the rule
    ],
)
def test_a_relative_name_that_says_nothing_against_an_absolute_one(folder: Path, others: dict[str, str]):
    nodes = {"lidar": node("Lidar", "lidar/scan"), **others}
    assert check(request(folder, **nodes, **many(*ALL_ABSOLUTE))).findings == []


@pytest.mark.parametrize(
    ("launch", "told"),
    [
        ('<node pkg="robot" exec="robot"/><node pkg="robot" exec="node0" namespace="part"/>', True),
        ('<node pkg="robot" exec="robot" namespace="robot_1"/><node pkg="robot" exec="monitor"/>', False),
        ('<node pkg="robot" exec="robot"/><node pkg="robot" exec="monitor" namespace="fleet"/>', False),
        ('<node pkg="robot" exec="robot"><remap from="command" to="/robot_1/command"/></node>', False),
    ],
)
def test_ends_that_meet_as_they_are_started(folder: Path, launch: str, told: bool):
    """A robot in a namespace does not hear the monitor of the fleet: its relative name may be what is wrong."""
    nodes = {"robot": subscriber("Robot", "command"), "monitor": node("Monitor", "/command")}
    assert bool(check(request(folder, launch, **nodes, **many(*MOSTLY_RELATIVE))).findings) is told


def test_a_bus_of_a_fleet_is_meant_to_be_absolute(folder: Path):
    """A launch file starts the node for each robot, and all of them share the one topic."""
    starts = "".join(f'<node pkg="robot" exec="drone" namespace="drone_{number}"/>' for number in range(3))
    drone = node("Drone", "/intercom", "state").replace(
        "        self.create_publisher(String, 'state', 10)",
        "        self.create_publisher(String, 'state', 10)\n"
        "        self.create_subscription(String, '/intercom', print, 10)",
    )
    assert check(request(folder, starts, drone=drone, **many(*ALL_ABSOLUTE))).findings == []


def test_a_small_workspace_that_starts_a_driver_or_two_robots_is_no_lesson(folder: Path):
    """Somebody has this robot, and knows how its topics are called."""
    [told] = check(request(folder, '<node pkg="robot" exec="arm"/>', arm=ARM)).findings
    assert told.message.startswith("2 names of Arm are absolute")

    for other in ('pkg="v4l2_camera" exec="v4l2_camera_node"', 'pkg="robot" exec="arm" name="second"'):
        assert check(request(folder, f'<node pkg="robot" exec="arm"/><node {other}/>', arm=ARM)).findings == []
    assert check(request(folder, '<node pkg="robot" exec="arm" namespace="left"/>', arm=ARM)).findings == []


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("import cv2", False),
        ("from serial import Serial", False),
        ("from nav2_simple_commander.robot_navigator import BasicNavigator", False),
        ("import numpy as np", True),  # rclpy brings it along
        ("from geometry_msgs.msg import Twist", True),
        ("from robot.base import Base", True),
    ],
)
def test_a_small_workspace_that_works_with_more_than_ros_is_no_lesson(folder: Path, line: str, told: bool):
    """Whoever has a camera, an arm on a serial port or Nav2 has the one robot that the names are for."""
    nodes = {"arm": f"{line}\n{ARM}", "base": node("Base", "state")}
    assert bool(check(request(folder, **nodes)).findings) is told


@pytest.mark.parametrize(("needed", "told"), [("moveit_ros_planning_interface", False), ("std_msgs", True)])
def test_a_small_workspace_whose_package_needs_another_system_is_no_lesson(folder: Path, needed: str, told: bool):
    asked = request(folder, arm=ARM)
    (folder / "package.xml").write_text(manifest(more=f"<depend>{needed}</depend>"))
    assert bool(check(asked).findings) is told


def test_a_large_workspace_may_mix_names_that_nobody_else_has(folder: Path):
    nodes = {"lidar": node("Lidar", "lidar/scan", "/lidar/state")}
    assert check(request(folder, **nodes, **many(*ALL_ABSOLUTE))).findings == []


@pytest.mark.parametrize(("call", "told"), [("self.get_topic_names_and_types()", False), ("print('/bus/words')", True)])
def test_a_name_that_is_held_against_those_of_the_graph(folder: Path, call: str, told: bool):
    """The names that ROS answers with are absolute, whatever namespace the node is in."""
    arm = node("Arm", "/bus/words").replace("\n\n\ndef main", f"\n        {call}\n\n\ndef main")
    assert bool(check(request(folder, arm=arm)).findings) == told


def test_a_namespace_that_does_not_apply_may_be_meant_not_to(folder: Path):
    """What is in ``left`` may well talk to somebody outside: only who asks for all absolute names hears of it."""
    launch = '<node pkg="robot" exec="arm" namespace="left"/>'
    assert check(request(folder, launch, arm=ARM, **many(*ALL_ABSOLUTE))).findings == []

    [told] = check(everywhere(folder, launch, arm=ARM)).findings
    assert told.message.endswith("launch files start the node in the namespace '/left', which does not apply to them")


@pytest.mark.parametrize(("other", "told"), [("/sentences", "robot/arm.py"), ("/words", "robot/base.py")])
def test_a_node_in_a_namespace_that_needs_somebody_outside(folder: Path, other: str, told: str):
    """What is in ``left`` reaches ``/words`` of the other node by its absolute name alone."""
    launch = '<node pkg="robot" exec="arm" namespace="left"/><node pkg="robot" exec="base"/>'
    [finding] = check(everywhere(folder, launch, arm=node("Arm", "/words"), base=node("Base", other))).findings

    assert finding.place.file == told


DETECTOR = NODE.format(
    class_name="Detector",
    node="detector",
    publishers="        self.create_subscription(String, '/camera/image', print, 10)",
)


@pytest.mark.parametrize(
    ("more", "other", "is_told"),
    [
        ("", "/words", False),
        ('<node pkg="camera" exec="driver" name="driver"/>', "/words", False),
        ('<node pkg="camera" exec="driver" name="driver" namespace="tags"/>', "/words", True),
        ('<node pkg="camera" exec="driver" namespace="tags/camera"/>', "/words", True),
        ('<node pkg="robot" exec="node0" namespace="tags"/>', "/words", True),
        ("", "camera/image", True),
    ],
)
def test_what_a_node_in_a_namespace_of_its_own_takes_in(folder: Path, more: str, other: str, is_told: bool):
    """The simulator that publishes the images is not in ``tags``, nor can code of this workspace be moved there."""
    launch = f'<node pkg="robot" exec="detector" namespace="tags"/>{more}'
    nodes = {"detector": DETECTOR, "base": node("Base", other)} | many(*ALL_ABSOLUTE)

    [finding] = check(everywhere(folder, launch, **nodes)).findings

    assert (
        "robot/detector.py" in {place.file for place in (finding.place, *(r.place for r in finding.related))}
    ) is is_told


@pytest.mark.parametrize(
    ("file", "text", "told"),
    [
        ("config/bridge.yaml", "- ros_topic_name: /arm/state\n", False),
        ("config/bridge.yaml", "- ros_topic_name: /arm/states\n", True),
        ("config/bridge.yaml", "# as /arm/state\n", True),
        ("urdf/robot.xacro", "<remapping>~/out:=/arm/state</remapping>", False),
        ("urdf/robot.xacro", "<mesh>/arm/state.stl</mesh>", True),
    ],
)
def test_a_name_that_a_file_of_data_holds_to(folder: Path, file: str, text: str, told: bool):
    asked = request(folder, arm=node("Arm", "/arm/state"))
    (folder / file).parent.mkdir(exist_ok=True)
    (folder / file).write_text(text)

    assert bool(check(asked).findings) == told


DISPLAY = """\
Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/Pose
      Topic: {Depth: 5, Value: %s}
"""
INSTALLED = "setup(data_files=[('share/robot/rviz', ['rviz/arm.rviz'])], "


@pytest.mark.parametrize(
    ("file", "name", "setup", "told"),
    [
        ("rviz/arm.rviz", "/arm/state", INSTALLED, False),
        ("rviz/arm.rviz", "/arm/states", INSTALLED, True),
        ("rviz/arm.rviz", "arm/state", INSTALLED, True),
        ("rviz/mine.rviz", "/arm/state", INSTALLED, True),
        ("rviz/arm.rviz", "/arm/state", "setup(", True),
    ],
)
def test_a_name_that_an_installed_display_shows(folder: Path, file: str, name: str, setup: str, told: bool):
    """RViz knows of no namespace: where the code drops the '/', it shows nothing."""
    asked = request(folder, arm=node("Arm", "/arm/state"))
    (folder / "rviz").mkdir()
    (folder / file).write_text(DISPLAY % name)
    build = folder / "setup.py"
    build.write_text(build.read_text().replace("setup(", setup, 1))

    assert bool(check(asked).findings) == told


@pytest.mark.parametrize(
    ("installs", "told"),
    [("DIRECTORY launch", False), ("PROGRAMS scripts/arm.py", True)],
)
def test_a_script_of_a_package_whose_cmake_files_install_no_program(folder: Path, installs: str, told: bool):
    (folder / "scripts").mkdir()
    (folder / "scripts" / "arm.py").write_text(ARM)
    (folder / "package.xml").write_text(manifest("robot"))
    (folder / "CMakeLists.txt").write_text(f"install({installs} DESTINATION lib/robot)\n")
    (folder / "archlint.toml").write_text('select = ["NME001"]')

    assert bool(check(Request((".",), load(folder), cached=False, jobs=1)).findings) == told


def test_a_node_that_speaks_with_a_fixed_system_cannot_be_started_twice(folder: Path):
    commander = node("Commander", "/drone/cmd_pose", "/fmu/in/offboard_control_mode")
    assert check(request(folder, commander=commander)).findings == []
    assert check(request(folder, commander=commander, arm=ARM)).findings == []  # nor can what runs beside it

    [finding] = check(everywhere(folder, commander=commander, arm=ARM)).findings
    assert finding.message.startswith("2 names of Arm")


def test_a_name_without_a_namespace_needs_something_that_speaks_against_it(folder: Path):
    """``/scan`` is how everybody writes it; the namespace of one robot in a name, or another form of it, are not."""
    modules = {"lidar": node("Lidar", "/scan"), "map": node("Map", "/scan", "/map")}
    assert check(request(folder, **modules)).findings == []

    (folder / "archlint.toml").write_text('select = ["NME001"]\n[rules.NME001]\neverywhere = true\n')
    [every] = check(Request((".",), load(folder), cached=False, jobs=1)).findings
    assert every.message == "2 nodes of package 'robot' fix 2 absolute names: no namespace applies to any of them"

    [other_form] = check(request(folder, **modules, planner=node("Planner", "map"))).findings
    assert other_form.message.startswith(
        "2 nodes of package 'robot' fix 2 absolute names, beside relative ones such as"
    )
    [own_form] = check(request(folder, lidar=node("Lidar", "/scan", "state"))).findings
    assert "beside relative names of the same node such as 'state'" in own_form.message


def test_who_has_a_name_in_common_with_what_is_told_is_told_too(folder: Path):
    """Whoever drops the '/' in one class alone parts the ends of ``/words``."""
    arm, ear = node("Arm", "/arm/state", "/words"), node("Ear", "/words")
    [finding] = check(request(folder, arm=arm, ear=ear, map=node("Map", "/map"))).findings

    assert finding.message.startswith("2 nodes of package 'robot' fix 2 absolute names: ")
    assert places([finding]) == [("robot/arm.py", 9)]
    assert [related.message for related in finding.related] == ["Ear fixes the topic '/words'"]


def test_a_private_name_beside_an_absolute_one_is_no_mixture(folder: Path):
    [finding] = check(request(folder, arm=ARM, lidar=node("Lidar", "/lidar/scan", "~/state"))).findings

    assert finding.message.startswith("2 nodes of package 'robot' fix 3 absolute names")


def test_the_only_absolute_names_of_a_small_workspace(folder: Path):
    relative = {name.lower(): node(name, f"{name.lower()}/state") for name in ("Base", "Camera")}
    [finding] = check(request(folder, arm=ARM, **relative)).findings

    assert finding.message.startswith("2 names of Arm are absolute and fixed in the code")


def test_a_name_that_another_node_has_as_a_relative_one(folder: Path):
    [told] = check(request(folder, base=BASE, camera=node("Camera", "base/state"))).findings
    assert told.message == (
        "the topic '/base/state' is absolute and fixed in the code, and another node has 'base/state' as a relative "
        "name: in a namespace, only that one moves"
    )

    [told] = check(request(folder, base=node("Base", "/base/state", "/base/goal"))).findings
    assert told.message.startswith(
        "2 names of Base are absolute and fixed in the code, such as the topic '/base/state', and"
    )
    assert [related.message for related in told.related] == ["'base/state' is relative here", "the topic '/base/goal'"]

    camera = node("Camera", "arm/state")
    [told] = check(everywhere(folder, base=BASE, arm=ARM, drive=node("Drive", "/wheels/drive"), camera=camera)).findings

    assert places([told]) == [("robot/arm.py", 9)]
    assert told.message.startswith(
        "3 nodes of package 'robot' fix 4 absolute names, beside relative ones such as 'arm/"
    )


TWICE = '<node pkg="robot" exec="arm" name="left"/><node pkg="robot" exec="arm" name="right"/>'


def test_a_node_that_a_launch_file_starts_twice_is_told_alone(folder: Path):
    told, whole = check(everywhere(folder, TWICE, arm=ARM, base=BASE, camera=CAMERA)).findings

    assert told.message == (
        "2 names of Arm are absolute and fixed in the code, such as the topic '/arm/state', and a launch file starts "
        "the node 2 times: all of them have the same one"
    )
    assert whole.message.startswith("2 nodes of package 'robot' fix 3 absolute names")


@pytest.mark.parametrize(
    "making",
    [
        "    first = Arm()\n    second = Arm()\n    rclpy.spin(first)\n",
        "    first = Arm()\n    first.destroy_node()\n    rclpy.spin(Arm())\n",
    ],
)
def test_nodes_that_one_process_makes_are_started_once(folder: Path, making: str):
    arm = ARM.replace("    rclpy.spin(Arm())\n", making)
    [finding] = check(everywhere(folder, '<node pkg="robot" exec="arm"/>', arm=arm, base=BASE)).findings

    assert finding.message.startswith("2 nodes of package 'robot' fix 3 absolute names: no namespace applies")


def test_two_nodes_of_a_class_that_are_given_names_of_their_own(folder: Path):
    arm = ARM.replace("__init__(self)", "__init__(self, side)").replace("'arm'", "'arm_' + side")
    arm = arm.replace("'/arm/state'", "'/' + side + '/state'").replace("'/arm/goal'", "'/' + side + '/goal'")
    arm = arm.replace("    rclpy.spin(Arm())", "    arms = [Arm('left'), Arm('right')]\n    rclpy.spin(arms[0])")
    [finding] = check(everywhere(folder, '<node pkg="robot" exec="arm"/>', arm=arm, base=BASE)).findings

    assert "no namespace applies to any of them" in finding.message


def test_what_several_instances_only_listen_to_may_be_one_for_all(folder: Path):
    listener = ARM.replace("create_publisher", "create_subscription").replace(", 10)", ", print, 10)")
    [finding] = check(everywhere(folder, TWICE, arm=listener, base=BASE)).findings

    assert finding.message.startswith("2 nodes of package 'robot' fix 3 absolute names")


def test_a_class_whose_namespace_its_names_repeat_is_told_alone(folder: Path):
    launch = '<node pkg="robot" exec="lidar" namespace="left"/>'
    lidar = node("Lidar", "/left/scan")
    whole, launched = check(everywhere(folder, launch, arm=ARM, base=BASE, lidar=lidar)).findings

    assert whole.message.startswith("2 nodes")
    assert places([launched]) == [("robot/lidar.py", 9)]
    assert launched.message.endswith("launch files start the node in the namespace '/left', which does not apply to it")


def test_a_suppression_takes_its_class_out(folder: Path):
    quiet = node("Arm", "/arm/state", comment="  # archlint: ignore[NME001] one arm is all there is")
    report = check(everywhere(folder, arm=quiet, base=BASE, camera=CAMERA, drive=node("Drive", "/wheels/drive")))

    [finding] = report.findings
    assert "3 nodes of package 'robot' fix 4 absolute names" in finding.message
    assert places([finding]) == [("robot/base.py", 9)]
    assert report.summary.suppressed == 1


def test_a_baseline_holds_what_was_there_and_a_new_class_is_told(folder: Path):
    before = everywhere(folder, arm=ARM, base=BASE, camera=CAMERA)
    keys = [occurrence.key for occurrence in check(replace(before, occurrences=True)).occurrences]
    known = Baseline("known.txt", tuple(Entry(number, key) for number, key in enumerate(keys, 1)))
    assert len(keys) == 5
    assert check(replace(before, baseline=known)).findings == []

    after = everywhere(folder, arm=ARM, base=BASE, camera=CAMERA, drive=node("Drive", "/wheels/drive"))
    [finding] = check(replace(after, baseline=known)).findings
    assert finding.message.startswith("the topic '/wheels/drive' is absolute and fixed in the code")


def test_what_was_there_before_a_change_is_not_told_again(folder: Path):
    occurrences = check(replace(everywhere(folder, arm=ARM, base=BASE, camera=CAMERA), occurrences=True)).occurrences
    older = tuple(Older(occurrence.key, occurrence.severity) for occurrence in occurrences)
    after = everywhere(folder, arm=ARM, base=BASE, camera=CAMERA, drive=node("Drive", "/wheels/drive"))

    [finding] = check(replace(after, before=older)).findings
    assert places([finding]) == [("robot/drive.py", 9)]


def test_of_one_file_alone_only_its_class_is_told(folder: Path):
    whole = request(folder, arm=ARM, base=BASE, camera=CAMERA)
    [finding] = check(replace(whole, paths=("robot/camera.py",))).findings

    assert finding.message.startswith("2 names of Camera are absolute")
