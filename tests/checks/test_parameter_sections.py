"""PRM005: which sections of a parameter file are for a node that nothing starts."""

from __future__ import annotations

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from robot_package import CMAKE, SETUP, TALKER, TALKER_OF_CPP, node, write_files, write_robot

LOAD_IT = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
RATE = "{ros__parameters: {rate: 1.0}}"
FOR_EACH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def start(context):
    return [
        Node(package='robot', executable='talker', NAMED=name.strip(),
             parameters=[[FindPackageShare('robot'), '/config/p.yaml']])
        for name in LaunchConfiguration('robots').perform(context).split(',')
    ]

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('robots', default_value='front, rear'),
        OpaqueFunction(function=start),
    ])
"""


def test_a_namespace_of_a_launch_argument_may_be_another_one(findings):
    files = {"config/p.yaml": f"side:\n  talker: {RATE}\n", "launch/each.launch.py": FOR_EACH}
    by_argument = files["launch/each.launch.py"] = FOR_EACH.replace("NAMED", "namespace")
    assert findings("PRM005", **files) == []
    files["launch/each.launch.py"] = by_argument.replace(
        "LaunchConfiguration('robots').perform(context)", "'left,right'"
    )
    (told,) = findings("PRM005", **files)
    assert told.message.endswith("starts a node '/side/talker'; did you mean '/left/talker'?")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("ros2 run robot walker --ros-args --params-file config/p.yaml", 0),
        ("ros2 run robot walker --ros-args --params-file $CONFIG", 0),
        ("ros2 run robot walker --ros-args \\\n  --params-file ~/p.yaml", 0),
        ("ros2 run robot walker --ros-args --params-file config/q.yaml", 1),
        ("ros2 run robot walker --ros-args -p rate:=2.0", 1),
    ],
)
def test_a_command_in_a_script_may_load_the_file(findings, text: str, told: int):
    files = {"config/p.yaml": f"talker: {RATE}\nwalker: {RATE}\n", "start.sh": text}
    assert len(findings("PRM005", node(LOAD_IT), **files)) == told


def test_a_command_that_a_launch_file_types_into_a_terminal_may_load_the_file(findings):
    typed = """from launch import LaunchDescription
from launch.actions import ExecuteProcess

FILE = 'p.yaml'

def generate_launch_description():
    command = f'ros2 run robot walker --ros-args --params-file {FILE}'
    return LaunchDescription([ExecuteProcess(cmd=['tmux', 'send-keys', '-t', 'robot', command, 'C-m'])])
"""
    files = {"config/p.yaml": f"talker: {RATE}\nwalker: {RATE}\n", "launch/typed.launch.py": typed}
    assert findings("PRM005", node(LOAD_IT), **files) == []


def test_a_key_without_namespace_misses_the_node_with_the_default_of_the_argument(findings):
    launch = '<arg name="ns" default="front"/>' + node(LOAD_IT, namespace="$(var ns)")
    assert findings("PRM005", launch, **{"config/p.yaml": f"side/talker: {RATE}"}) == []
    (told,) = findings("PRM005", launch, **{"config/p.yaml": f"talker: {RATE}"})
    assert told.message.endswith("did you mean '/front/talker'?")


def test_a_name_of_a_launch_argument_may_be_another_one(findings):
    for_each = FOR_EACH.replace("NAMED", "name")
    files = {"config/p.yaml": f"side: {RATE}", "launch/each.launch.py": for_each}
    assert findings("PRM005", **files) == []
    fixed = for_each.replace("LaunchConfiguration('robots').perform(context)", "'left,right'")
    assert len(findings("PRM005", **files | {"launch/each.launch.py": fixed})) == 1


@pytest.mark.parametrize(
    ("namespace", "key", "meant"),
    [("", "camera/camera", ""), ("", "camera", "/camera/camera"), ("left", "camera/camera", "/left/camera")],
)
def test_a_node_whose_own_code_gives_it_a_namespace(findings, namespace: str, key: str, meant: str):
    """That of ``realsense2_camera`` is ``Node("camera", "/camera")``."""
    given = {"namespace": namespace} if namespace else {}
    camera = node(LOAD_IT, pkg="realsense2_camera", exec="realsense2_camera_node", name="camera", **given)
    found = findings("PRM005", camera, **{"config/p.yaml": f"/{key}: {RATE}"})
    assert [one.meant for one in found] == [meant] * bool(meant)


@pytest.mark.parametrize(
    ("given", "told"),
    [("$(var params)", 0), ("$(env PARAMS)", 0), ("$(find-pkg-share robot)/config/r.yaml", 1)],
)
def test_a_file_that_another_launch_file_may_be_given(findings, given: str, told: int):
    """The section is for the node that the other launch file starts, with whatever file it is asked for."""
    files = {
        "config/p.yaml": f"main:\n  talker: {RATE}\nsecond:\n  talker: {RATE}\n  watcher: {RATE}\n",
        "config/q.yaml": f"second:\n  watcher: {RATE}\n",
        "launch/more.launch.xml": '<launch><arg name="params" default="$(find-pkg-share robot)/config/q.yaml"/>'
        + node(f'<param from="{given}"/>', namespace="second", name="watcher")
        + "</launch>",
    }
    found = findings("PRM005", node(LOAD_IT, namespace="main"), **files)
    assert [one.identity[1] for one in found] == ["/second/watcher"] * told


@pytest.mark.parametrize("key", ["talker", "walker"])
def test_the_name_that_the_code_gives_the_node(findings, key: str):
    """It is right for who starts the node without the launch file."""
    (told,) = findings("PRM005", node(LOAD_IT, name="front_speaker"), **{"config/p.yaml": f"{key}: {RATE}\n"})
    if key == "talker":
        assert told.help.startswith("take the name off the node in the launch file, or write '/front_speaker:'")
        assert [(row.place.line, row.message) for row in told.related] == [(1, "this calls it '/front_speaker'")]
    else:
        assert told.help == "nodes that load this file: /front_speaker"
        assert told.related == ()


LIFECYCLE = '<node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="manager">{}</node>'
IN_MANAGERS_FILE = "manager: {ros__parameters: {node_names: [front_speaker]}}\n"


@pytest.mark.parametrize(
    ("parameter", "file"),
    [
        ('<param name="node_names" value="[front_speaker]"/>', ""),
        ('<param from="$(find-pkg-share robot)/config/p.yaml"/>', IN_MANAGERS_FILE),
    ],
)
def test_a_name_that_a_lifecycle_manager_knows_stays(findings, parameter: str, file: str):
    launch = node(LOAD_IT, name="front_speaker") + LIFECYCLE.format(parameter)
    (told,) = findings("PRM005", launch, **{"config/p.yaml": f"talker: {RATE}\n{file}"})
    assert told.help == "write '/front_speaker:', since the lifecycle manager knows the node by that name"


@pytest.mark.parametrize(
    ("key", "program", "told"),
    [
        ("slam_toolbox", 'pkg="slam_toolbox" exec="sync_slam_toolbox_node" name="mapper"', 1),
        ("slam_toolbox", 'pkg="slam_toolbox" exec="sync_slam_toolbox_node"', 0),
        # A key for a node that some plugin may make in the process, under a name of its own.
        ("solver", 'pkg="slam_toolbox" exec="sync_slam_toolbox_node" name="mapper"', 0),
        # Programs that archlint does not know: most call their node as the program or its package is called.
        ("driver", 'pkg="camera" exec="driver" name="front"', 1),
        ("camera", 'pkg="camera" exec="driver" name="front"', 1),
        ("camera", 'pkg="camera" exec="driver" name="$(var who)"', 0),
        ("left/driver", 'pkg="camera" exec="driver" name="front"', 0),
        # The costmap has its own name, which the launch file cannot change.
        ("local_costmap/local_costmap", 'pkg="nav2_controller" exec="controller_server" name="control"', 0),
    ],
)
def test_the_name_that_a_program_from_elsewhere_gives_its_node(findings, key: str, program: str, told: int):
    """The launch file gives the node another name, so that the section is for nobody."""
    launch = f'<arg name="who" default="rear"/><node {program}>{LOAD_IT}</node>'
    rows = findings("PRM005", launch, **{"config/p.yaml": f"{key}: {RATE}\n"})
    assert [(row.place.line, row.identity[1]) for row in rows] == [(1, f"/{key}")] * told
    assert all("take the name off the node in the launch file" in (row.help or "") for row in rows)
    # With a section for the name that the node has, the other one is for another start.
    name = program.rpartition('name="')[2].rstrip('"')
    more = f"{key}: {RATE}\n{name if name.isalpha() else 'front'}: {RATE}\n"
    assert "name=" not in program or findings("PRM005", launch, **{"config/p.yaml": more}) == []


@pytest.mark.parametrize(
    ("other", "told"),
    [
        ('<node pkg="camera" exec="driver"/>', 1),
        (f'<node pkg="camera" exec="driver">{LOAD_IT}</node>', 0),
        ('<node pkg="camera" exec="driver" args="--ros-args --params-file p.yaml"/>', 0),
        ('<node pkg="camera" exec="driver"><param from="$(env FILE)"/></node>', 0),
    ],
)
def test_a_node_of_unknown_name_beside_those_that_load_the_file(findings, other: str, told: int):
    """It matters only if it may get the file, too."""
    rows = findings("PRM005", node(LOAD_IT) + other, **{"config/p.yaml": f"tlaker: {RATE}\n"})
    assert [row.meant for row in rows] == ["/talker"] * told


def test_a_key_that_the_file_has_already_is_no_advice(findings):
    yaml = f"talker: {RATE}\ntlaker: {RATE}\n"
    (told,) = findings("PRM005", node(LOAD_IT), **{"config/p.yaml": yaml})
    assert told.message.endswith("starts a node '/tlaker'")
    (told,) = findings("PRM005", node(LOAD_IT), **{"config/p.yaml": f"tlaker: {RATE}\n"})
    assert told.message.endswith("starts a node '/tlaker'; did you mean '/talker'?")


def test_sections_that_lack_their_nodes_are_said_once_for_a_file(findings):
    two = node(LOAD_IT, namespace="left", name="a") + node(LOAD_IT, namespace="left", name="b")
    (told,) = findings("PRM005", two, **{"config/p.yaml": f"a: {RATE}\nb: {RATE}\n"})
    assert told.message.endswith("any of these 2 nodes: /a, /b; did you mean '/left/a' and '/left/b'?")
    assert told.help.startswith("the key must be the full name: write '/left/a:'")
    assert [(one.place.line, one.message) for one in told.related] == [(2, "'/b'; did you mean '/left/b'?")]
    (told,) = findings("PRM005", two, **{"config/p.yaml": f"a: {RATE}\nright:\n  b: {RATE}\n"})
    assert [(one.place.line, one.message) for one in told.related] == [(3, "'/right/b'; did you mean '/left/b'?")]
    files = {"config/p.yaml": f"a: {RATE}\n", "config/q.yaml": f"b: {RATE}\n"}
    apart = node(LOAD_IT, namespace="left", name="a") + node(
        LOAD_IT.replace("p.yaml", "q.yaml"), namespace="left", name="b"
    )
    assert [told.place.file for told in findings("PRM005", apart, **files)] == ["config/p.yaml", "config/q.yaml"]


def test_a_section_for_a_python_node_of_the_package_that_is_run_by_hand(findings):
    files = {
        "config/p.yaml": f"talker: {RATE}\nheavy: {RATE}\n",
        "robot/heavy.py": TALKER.replace("('talker')", "('heavy')"),
        "setup.py": SETUP.replace("robot.talker:main'", "robot.talker:main', 'heavy = robot.heavy:main'"),
    }
    assert findings("PRM005", node(LOAD_IT), **files) == []
    # Here it runs, and under another name than the section's.
    renamed = node(LOAD_IT) + node(LOAD_IT, exec="heavy", name="weight")
    assert len(findings("PRM005", renamed, **files)) == 1


READS_A_SECTION = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    file = os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')
    section = yaml.safe_load(open(file))['SECTION']
    return LaunchDescription([
        Node(package='robot', executable='talker', parameters=[file]),
        Node(package='robot', executable='talker', name='other', parameters=[{'rate': 2.0}]),
    ])
"""


@pytest.mark.parametrize(("section", "count"), [("map_server", 0), ("talker", 1)])
def test_a_section_that_a_launch_file_reads_itself(findings, section, count):
    files = {"launch/read.launch.py": READS_A_SECTION.replace("SECTION", section)}
    told = findings("PRM005", **files, **{"config/p.yaml": f"talker: {RATE}\nmap_server: {RATE}\n"})
    # What gets no file is not among those that load it.
    assert [one.help for one in told] == ["nodes that load this file: /talker"] * count


READS_BY_A_HELPER = READS_A_SECTION.replace(
    "def generate",
    """\
def section_of(file, key, default=None):
    with open(file) as stream:
        content = yaml.safe_load(stream) or {}
    print(default)
    return content[key]['ros__parameters']

def generate""",
)


@pytest.mark.parametrize(
    ("call", "count"),
    [
        ("section_of(file, 'map_server')", 0),
        ("section_of(file, key='map_server')", 0),
        ("section_of(file, 'talker')", 1),
        # This text is a value, and no key.
        ("section_of(file, 'talker', 'map_server')", 1),
        ("section_of(file, 'talker', default='map_server')", 1),
    ],
)
def test_a_section_that_a_launch_file_reads_through_a_helper(findings, call, count):
    launch = READS_BY_A_HELPER.replace("yaml.safe_load(open(file))['SECTION']", call)
    told = findings(
        "PRM005", **{"launch/read.launch.py": launch, "config/p.yaml": f"talker: {RATE}\nmap_server: {RATE}\n"}
    )
    assert [diagnostic.place.line for diagnostic in told] == [2] * count


def test_a_launch_file_of_tests_may_start_the_node(findings):
    files = {"config/p.yaml": f"tester: {RATE}\ntalker: {RATE}\n"}
    assert len(findings("PRM005", node(LOAD_IT), **files)) == 1
    test = "<launch>" + node(LOAD_IT, name="tester") + "</launch>"
    assert findings("PRM005", node(LOAD_IT), **files, **{"launch/test_it.launch.xml": test}) == []


BY_ARGUMENT = '<arg name="show" default="false"/>'


@pytest.mark.parametrize(
    ("other", "count"),
    [
        ("", 1),
        ('<node pkg="rviz2" exec="rviz2" name="rviz2" if="$(var show)"/>', 1),
        # It may be the node that the section is for.
        ('<node pkg="rviz2" exec="rviz2" name="listener" if="$(var show)"/>', 0),
        ('<node pkg="rviz2" exec="rviz2" if="$(var show)"/>', 0),
        # It may have more nodes than this one, and one of them may be it.
        (f'<node pkg="rviz2" exec="rviz2" name="rviz2" if="$(var show)">{LOAD_IT}</node>', 0),
    ],
)
def test_a_process_that_only_other_arguments_start(findings, other, count):
    files = {"config/p.yaml": f"talker: {RATE}\nlistener: {RATE}\n"}
    told = findings("PRM005", BY_ARGUMENT + node(LOAD_IT) + other, **files)
    assert [finding.place.line for finding in told] == [2] * count


REWRITES = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from nav2_common.launch import RewrittenYaml

def generate_launch_description():
    made = RewrittenYaml(source_file=[FindPackageShare('robot'), '/config/p.yaml'], {more}, convert_types=True)
    return LaunchDescription([Node(package='robot', executable='talker', name='talker', parameters=[made])])
"""


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ("param_rewrites={}", 1),
        ("param_rewrites={'rate': '2.0'}, root_key=''", 1),
        ("param_rewrites={}, root_key='left'", 0),  # the keys are others then
        ("param_rewrites={}, key_rewrites={'Talker': 'talker'}", 0),
        ("param_rewrites=anything()", 0),
    ],
)
def test_a_file_of_which_the_launch_makes_another_one(findings, more: str, told: int):
    files = {"config/p.yaml": f"Talker: {RATE}\n", "launch/new.launch.py": REWRITES.replace("{more}", more)}
    messages = [row.message for row in findings("PRM005", **files)]
    assert len(messages) == told
    assert all(message.endswith("starts a node '/Talker'; did you mean '/talker'?") for message in messages)


@pytest.mark.parametrize(
    ("key", "launch", "meant"),
    [
        ("talker_node", node(LOAD_IT, name="talker"), ["/talker"]),
        ("talker", node(LOAD_IT, name="talker_node"), ["/talker_node"]),
        # Only the one that gets the file is meant, and one alone.
        ("talker_node", node(LOAD_IT, name="listener") + node(name="talker"), [""]),
        ("front/talker_node", node(LOAD_IT, name="talker"), [""]),
    ],
)
def test_a_key_that_says_node_at_its_end(findings, key: str, launch: str, meant: list[str]):
    told = findings("PRM005", launch, **{"config/p.yaml": f"{key}: {RATE}\n"})
    assert [row.meant for row in told] == meant


def test_a_program_from_elsewhere_that_gets_the_file_under_almost_the_name(findings):
    camera = f'<node pkg="camera" exec="driver" name="left_camera">{LOAD_IT}</node>'
    (told,) = findings("PRM005", camera, **{"config/p.yaml": f"left_camera_node: {RATE}\n"})
    assert told.message == (
        "no launch file that loads this file starts a node '/left_camera_node'; did you mean '/left_camera'?"
    )
    assert findings("PRM005", camera, **{"config/p.yaml": f"right: {RATE}\n"}) == []


@pytest.mark.parametrize(
    ("key", "meant"), [("map_saver", []), ("map_servr", ["/map_server"]), ("map_server_node", ["/map_server"])]
)
def test_the_name_of_another_well_known_program_is_no_slip(findings, key: str, meant: list[str]):
    """Nav2's own file has sections for more nodes than most robots start."""
    server = f'<node pkg="nav2_map_server" exec="map_server" name="map_server">{LOAD_IT}</node>'
    rows = findings("PRM005", server, **{"config/p.yaml": f"{key}: {RATE}\n"})
    assert [row.meant for row in rows] == meant


CONTROLLERS = f"""\
left:
  controller_manager:
    ros__parameters:
      update_rate: 100
      arm_controller: {{type: joint_trajectory_controller/JointTrajectoryController}}
  arm_controller: {RATE}
"""
MANAGER = f"""
  <node pkg="controller_manager" exec="ros2_control_node" namespace="left" name="controller_manager">{LOAD_IT}</node>
  <node pkg="controller_manager" exec="spawner" namespace="left" name="arm_controller_spawner" args="arm_controller"/>
"""


def test_the_controllers_that_a_manager_makes_are_no_spawners(findings):
    assert findings("PRM005", MANAGER, **{"config/p.yaml": CONTROLLERS}) == []


PLANNER = """\
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "rclcpp/rclcpp.hpp"

class Planner : public rclcpp::Node
{
public:
  Planner() : Node("planner")
  {
    MADE;
  }
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Planner>());
}
"""


@pytest.mark.parametrize(
    ("made", "key", "told"),
    [
        ('costmap_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>(\n  "hall", "/", "hall")', "hall/hall", 0),
        ('costmap_.reset(new nav2_costmap_2d::Costmap2DROS{"hall"})', "hall/hall", 0),
        ('costmap_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>("hall")', "yard/yard", 1),
        ('// costmap_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>("hall")', "hall/hall", 1),
        ('costmap_ = nullptr; RCLCPP_INFO(get_logger(), "hall")', "hall/hall", 1),
    ],
)
def test_the_costmap_that_a_node_of_the_workspace_makes(tmp_path, monkeypatch, made: str, key: str, told: int):
    """It is a node of its own in the process that gets the file, whatever name the launch file gives."""
    monkeypatch.chdir(tmp_path)
    launch = f'<node pkg="planner" exec="talker" name="planner">{LOAD_IT}</node>'
    write_robot(tmp_path / "robot", launch, **{"config/p.yaml": f"planner: {RATE}\n{key}: {RATE}\n"})
    files = {
        "CMakeLists.txt": TALKER_OF_CPP.replace("robot", "planner"),
        "src/talker.cpp": PLANNER.replace("MADE", made),
    }
    manifest = CMAKE.replace("robot", "planner").replace("rclpy", "rclcpp")
    write_files(tmp_path / "planner", {"package.xml": manifest} | files)
    rows = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [row.identity[1] for row in rows if row.code == "PRM005"] == [f"/{key}"] * told
