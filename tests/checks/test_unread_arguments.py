"""LCH011: launch arguments that are declared and never read."""

from __future__ import annotations

import pytest

from archlint.finding import Severity

FILE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
{top}

def generate_launch_description():
    {line}
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0'),
        Node(package='robot', executable='talker', {given}),
    ])
"""


def _file(line: str = "pass", given: str = "name='talker'", top: str = "") -> dict[str, str]:
    return {"launch/it.launch.py": FILE.format(line=line, given=given, top=top)}


@pytest.mark.parametrize(
    "files",
    [
        _file(),
        _file("speed = LaunchConfiguration('speed')"),
        _file(given="parameters=[{'speed': 1.0}]"),
    ],
)
def test_an_argument_that_nothing_reads(findings, files):
    (told,) = findings("LCH011", **files)
    assert told.message == "nothing reads the launch argument 'speed': setting it has no effect"
    assert (told.place.file, told.place.line, told.severity) == ("launch/it.launch.py", 10, Severity.WARNING)


@pytest.mark.parametrize(
    ("given", "default", "reading"),
    [
        ("'0001'", "0001", "ParameterValue(LaunchConfiguration('speed'), value_type=str)"),
        ("'true'", "true", "ParameterValue(LaunchConfiguration('speed'), value_type=str)"),
        ("'fast'", "fast", "LaunchConfiguration('speed')"),
        ("1", "1", "LaunchConfiguration('speed')"),
        ("'0002'", "0001", "LaunchConfiguration('speed')"),
    ],
)
def test_a_text_that_launch_would_read_as_something_else(findings, given: str, default: str, reading: str):
    file = _file(given=f"parameters=[{{'speed': {given}}}]")
    (told,) = findings("LCH011", **{name: text.replace("'1.0'", f"'{default}'") for name, text in file.items()})
    assert told.help == f"read it where it is meant, {reading}, or remove the declaration"


@pytest.mark.parametrize(
    ("comment", "told"),
    [("kept for compatibility: the path is fixed", 0), ("ignored since the driver asks the motor", 0), ("in m/s", 1)],
)
def test_a_comment_that_says_why_nothing_reads_an_argument(findings, comment: str, told: int):
    assert len(findings("LCH011", **_file(f"# {comment}\n    speed = LaunchConfiguration('speed')"))) == told
    declared = "        DeclareLaunchArgument("
    files = {name: text.replace(declared, f"        # {comment}\n{declared}") for name, text in _file().items()}
    assert len(findings("LCH011", **files)) == told


def test_a_name_with_blanks(findings):
    file = {name: text.replace("'speed', default", "'speed  ', default") for name, text in _file().items()}
    (told,) = findings("LCH011", **file)
    assert told.message == (
        "nothing reads the launch argument 'speed  ': setting it has no effect; blanks at the ends of 'speed  ' are a "
        "part of the name"
    )
    assert told.help == "declare it as 'speed', or remove the declaration"


def test_use_sim_time_is_declared_as_a_habit(findings):
    (told,) = findings(
        "LCH011", **{"launch/it.launch.py": _file()["launch/it.launch.py"].replace("speed", "use_sim_time")}
    )
    assert told.severity is Severity.INFO


def test_all_of_a_file_are_one_finding(findings):
    (told,) = findings("LCH011", '<arg name="speed" default="1"/><arg name="colour"/><node pkg="robot" exec="talker"/>')
    assert "'speed' and 'colour'" in told.message and len(told.related) == 1


def test_a_variable_that_holds_it_and_that_nothing_uses(findings):
    (told,) = findings("LCH011", **_file("slow = LaunchConfiguration('speed')"))
    assert told.help == "use slow where it is meant, or remove it and the declaration"
    assert [(row.place.line, row.message) for row in told.related] == [
        (8, "'speed' is kept here, and nothing uses that")
    ]

    (told,) = findings("LCH011", **_file())
    assert told.help == "read it where it is meant, LaunchConfiguration('speed'), or remove the declaration"


@pytest.mark.parametrize(
    "files",
    [
        _file(given="parameters=[{'speed': LaunchConfiguration('speed')}]"),
        _file("speed = LaunchConfiguration('speed')", given="parameters=[{'speed': speed}]"),
        _file("speed = LaunchConfiguration('speed')", given="parameters=[{'x': 1.0}], name=helper(speed)"),
        _file(top="NAMES = ['speed']"),  # code that the run does not come to may read it
        _file(given="parameters=[LaunchConfiguration(some())]"),
    ],
)
def test_an_argument_that_may_be_read(findings, files):
    assert findings("LCH011", **files) == []


def test_an_include_may_read_it(findings):
    """Includes are not scoped: what this file declares is known in the other one."""
    other = '<launch><node pkg="robot" exec="talker" name="$(var speed)"/></launch>'
    include = '<arg name="speed" default="1"/><include file="$(find-pkg-share robot)/launch/other.launch.xml"/>'
    assert findings("LCH011", include, **{"launch/other.launch.xml": other}) == []


def test_an_include_from_elsewhere_may_read_it(findings):
    include = '<arg name="speed" default="1"/><include file="$(find-pkg-share nav2_bringup)/launch/nav.launch.py"/>'
    assert findings("LCH011", include) == []


def test_the_launch_file_that_includes_this_one_may_read_it(findings):
    outer = (
        '<launch><include file="$(find-pkg-share robot)/launch/it.launch.xml"/>'
        '<node pkg="robot" exec="talker" name="$(var speed)"/></launch>'
    )
    declares = '<arg name="speed" default="a"/><node pkg="robot" exec="talker"/>'
    assert findings("LCH011", declares, **{"launch/outer.launch.xml": outer}) == []


OF_MOVEIT = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_move_group_launch
{top}

def generate_launch_description():
    configs = MoveItConfigsBuilder('arm', package_name='robot').to_moveit_configs()
    return LaunchDescription([generate_move_group_launch(configs){more}])
"""
HELPER = """\
from launch.actions import DeclareLaunchArgument

def colour():
    return DeclareLaunchArgument('colour', default_value='red')
"""


@pytest.mark.parametrize(
    ("top", "more", "names"),
    [
        ("", "", []),  # MoveIt declares what it does not read
        ("", ", DeclareLaunchArgument('speed', default_value='1.0')", ["speed"]),
        ("from robot.helper import colour", ", colour()", ["colour"]),
    ],
)
def test_what_a_library_declares_is_not_for_the_launch_file_to_read(findings, top, more, names):
    files = {"launch/it.launch.py": OF_MOVEIT.format(top=top, more=more), "robot/helper.py": HELPER}
    files |= {"config/arm.urdf.xacro": "<robot/>", "config/arm.srdf": "<robot name='arm'/>"}
    assert [told.message.split("'")[1] for told in findings("LCH011", **files)] == names


def test_the_same_argument_of_copied_launch_files_is_one_finding(findings):
    files = {f"launch/{name}.launch.py": text for name in ("a", "b", "c") for text in _file().values()}
    (told,) = findings("LCH011", **files)
    assert told.message.endswith("setting it has no effect; 2 more launch files of the package have it, too")
    assert [row.place.file for row in (told, *told.related)] == list(files)

    other = _file()["launch/it.launch.py"].replace("speed", "colour")
    assert len(findings("LCH011", **files, **{"launch/d.launch.py": other})) == 2


@pytest.mark.parametrize(
    ("name", "told"),
    [("navsat_example.launch.py", 0), ("example.launch.py", 0), ("template.launch.py", 0), ("exemplary.launch.py", 1)],
)
def test_a_launch_file_that_is_there_to_be_copied(findings, name, told):
    assert len(findings("LCH011", **{f"launch/{name}": _file()["launch/it.launch.py"]})) == told


def test_an_example_that_another_launch_file_starts(findings):
    outer = '<include file="$(find-pkg-share robot)/launch/example.launch.py"/>'
    (told,) = findings("LCH011", outer, **{"launch/example.launch.py": _file()["launch/it.launch.py"]})
    assert told.place.file == "launch/example.launch.py"


RECORDING = """\
from launch.actions import ExecuteProcess
from launch.substitutions import LaunchConfiguration


def recording(context, switch='record', argument='{argument}'):
    if LaunchConfiguration(switch).perform(context) != 'true':
        return []
    return [ExecuteProcess(cmd=['perf', LaunchConfiguration(argument)])]
"""
WITH_HELPER = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch_ros.actions import Node

from robot.recording import recording


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('record', default_value='false'),
        DeclareLaunchArgument('speed', default_value='1.0'),
        Node(package='robot', executable='talker'),
        OpaqueFunction(function=recording),
    ])
"""


@pytest.mark.parametrize(("argument", "lines"), [("speed", []), ("events", [11])])
def test_a_name_in_a_default_of_a_function_of_another_module(findings, argument: str, lines: list[int]):
    files = {"launch/it.launch.py": WITH_HELPER, "robot/recording.py": RECORDING.format(argument=argument)}
    assert [told.place.line for told in findings("LCH011", **files)] == lines
