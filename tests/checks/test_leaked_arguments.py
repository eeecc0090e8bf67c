"""LCH009: launch arguments that an include changes for what comes after it."""

from __future__ import annotations

import pytest

from archlint.finding import Severity

DRIVER = '<launch><arg name="rviz" default="true"/><let name="shown" value="$(var rviz)"/></launch>'
PANEL = '<launch><arg name="rviz" default="maybe"/><let name="shown" value="$(var rviz)"/></launch>'
FILES = {"launch/driver.launch.xml": DRIVER, "launch/panel.launch.xml": PANEL}
OWN = '<arg name="rviz" default="true"/>\n'


def include(name: str, **arguments: str) -> str:
    given = "".join(f'<arg name="{key}" value="{value}"/>' for key, value in arguments.items())
    return f'<include file="$(find-pkg-share robot)/launch/{name}.launch.xml">{given}</include>\n'


def test_an_argument_that_the_file_reads_again(findings):
    launch = OWN + include("driver", rviz="false") + '<let name="shown" value="$(var rviz)"/>'
    (finding,) = findings("LCH009", launch, **FILES)
    assert finding.message == "'rviz' keeps 'false' behind this include, instead of 'true': includes are not scoped"
    assert finding.help == "put the include into a <group>, which gives the arguments back at its end"
    assert (finding.place.line, [row.place.line for row in finding.related]) == (2, [3])


def test_an_argument_that_the_next_include_declares(findings):
    (finding,) = findings("LCH009", include("driver", rviz="false") + include("panel"), **FILES)
    assert finding.message == (
        "'rviz' keeps 'false' behind this include: panel.launch.xml does not get its own default, 'maybe'"
    )


def test_a_default_that_the_next_include_gets(findings):
    (finding,) = findings("LCH009", include("driver") + include("panel"), **FILES)
    assert finding.message == (
        "'rviz' keeps 'true', the default of driver.launch.xml, behind this include: panel.launch.xml does not get its "
        "own, 'maybe'"
    )
    assert finding.place.file == "launch/it.launch.xml"


def test_the_first_of_several_includes_that_set_an_argument(findings):
    """A group around the last one would leave the value of the one in front of it."""
    launch = include("driver", rviz="left") + include("driver", rviz="right") + include("panel")
    (finding,) = findings("LCH009", launch, **FILES)
    assert finding.message == (
        "'rviz' keeps 'right' behind 2 includes from this one on: panel.launch.xml does not get its own default, "
        "'maybe'"
    )
    assert finding.help == "put each of these includes into a <group>, which gives the arguments back at its end"
    assert finding.place.line == 1
    assert 2 in [row.place.line for row in finding.related]


def test_a_value_that_all_includes_set_is_what_the_file_wants(findings):
    launch = include("driver", rviz="false") + include("driver", rviz="false") + include("panel")
    (finding,) = findings("LCH009", launch, **FILES)
    assert finding.severity == Severity.INFO
    assert finding.message == (
        "'rviz' keeps 'false' behind 2 includes from this one on: panel.launch.xml does not get its own default, "
        "'maybe'"
    )
    assert (
        finding.help == "pass 'rviz' to panel.launch.xml, too: 'false', or its own default, 'maybe', if that is meant"
    )
    passed = launch.replace(include("panel"), include("panel", rviz="false"))
    assert findings("LCH009", passed, **FILES) == []


@pytest.mark.parametrize(("second", "told"), [("right", "instead of 'true'"), ("true", "")])
def test_the_value_that_was_there_in_front_of_all_includes(findings, second: str, told: str):
    shown = '<let name="shown" value="$(var rviz)"/>'
    launch = OWN + include("driver", rviz="left") + include("driver", rviz=second) + shown
    assert [told in finding.message for finding in findings("LCH009", launch, **FILES)] == [True] * bool(told)


@pytest.mark.parametrize(("name", "told"), [("show_rviz", False), ("speed", True)])
def test_an_include_that_is_given_its_value_by_another_name(findings, name: str, told: bool):
    """LCH003 says that panel.launch.xml does not take it: with the right name nothing leaks."""
    launch = include("driver", rviz="false") + include("panel", **{name: "true"})
    assert bool(findings("LCH009", launch, **FILES)) is told
    assert len(findings("LCH003", launch, **FILES)) == 1


@pytest.mark.parametrize("period", [None, 8.0])
def test_an_argument_that_a_timer_of_the_include_reads_needs_another_name(findings, period: float | None):
    """A group has given the argument back by the time that the timer fires: what it starts would read the old one."""
    shown = '<let name="seen" value="$(var rviz)"/>'
    late = shown if period is None else f'<timer period="{period}">{shown}</timer>'
    driver = f'<launch><arg name="rviz" default="true"/>{late}</launch>'
    launch = OWN + include("driver", rviz="false") + '<let name="shown" value="$(var rviz)"/>'
    (finding,) = findings("LCH009", launch, **FILES | {"launch/driver.launch.xml": driver})
    words = "put the include into a <group>" if period is None else "rename the argument 'rviz' in one of the two files"
    assert (finding.help or "").startswith(words)


def test_the_launch_files_of_a_package_with_the_same_leak_are_one_finding(findings):
    """They are copies of each other, such as those of a driver for two and for three cameras."""
    launch = include("driver", rviz="false") + include("panel")
    (told,) = findings("LCH009", launch, **FILES, **{"launch/more.launch.xml": f"<launch>{launch}</launch>"})
    assert told.place.file == "launch/it.launch.xml"
    assert (told.related[-1].place.file, told.related[-1].message) == ("launch/more.launch.xml", "it is set here, too")


def test_an_argument_that_each_include_sets_anew_is_told_once(findings):
    launch = OWN + include("driver", rviz="false") + include("driver", rviz="$(var rviz)x") + include("panel")
    (finding,) = findings("LCH009", launch, **FILES)
    assert finding.place.line == 2
    assert 3 in [row.place.line for row in finding.related]


@pytest.mark.parametrize(
    "launch",
    [
        OWN + f"<group>{include('driver', rviz='false')}</group>" + '<let name="shown" value="$(var rviz)"/>',
        OWN + include("driver", rviz="True") + '<let name="shown" value="$(var rviz)"/>',
        OWN + include("driver", rviz="$(var rviz)") + include("panel", rviz="$(var rviz)"),
        OWN + include("driver") + include("panel"),  # both have the file's own
        include("driver", rviz="false") + include("panel", rviz="true"),
        include("driver", rviz="false") + include("driver", rviz="false"),
        include("driver") + f"<group>{include('panel', rviz='maybe')}</group>",
        f"<group>{include('driver')}</group>" + include("panel"),
        '<arg name="real" default="false"/>'
        + include("driver").replace("<include", '<include if="$(var real)"')
        + include("panel"),
    ],
)
def test_arguments_that_stay_what_they_were(findings, launch):
    assert findings("LCH009", launch, **FILES) == []


TIMED = """
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def include(name, **arguments):
    path = [FindPackageShare('robot'), f'/launch/{{name}}.launch.xml']
    return IncludeLaunchDescription(path, launch_arguments=arguments.items())

def generate_launch_description():
    first = Node(package='robot', executable='talker')
    return LaunchDescription([first, {actions}])
"""
DRIVER_FIRST = "include('driver', rviz='false')"


@pytest.mark.parametrize(
    ("actions", "told"),
    [
        (f"{DRIVER_FIRST}, include('panel')", True),
        (f"TimerAction(period=5.0, actions=[{DRIVER_FIRST}, include('panel')])", True),
        (f"{DRIVER_FIRST}, TimerAction(period=5.0, actions=[include('panel')])", True),
        (f"TimerAction(period=5.0, actions=[{DRIVER_FIRST}]), include('panel')", False),
        ("TimerAction(period=5.0, actions=[include('driver')]), include('panel')", False),
        (
            f"RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[{DRIVER_FIRST}])), include('panel')",
            False,
        ),
    ],
)
def test_what_a_timer_or_an_event_sets_comes_after_the_description(findings, actions: str, told: bool):
    files = FILES | {"launch/timed.launch.py": TIMED.format(actions=actions)}
    assert bool(findings("LCH009", **files)) is told


REWRITTEN = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare
from nav2_common.launch import RewrittenYaml

def generate_launch_description():
    rviz = LaunchConfiguration('rviz')
    given = {given}
    path = [FindPackageShare('robot'), '/launch/driver.launch.xml']
    return LaunchDescription([
        DeclareLaunchArgument('rviz', default_value='/etc/robot.yaml'),
        IncludeLaunchDescription(path, launch_arguments={{'rviz': given}}.items()),
        IncludeLaunchDescription(path, launch_arguments={{'rviz': rviz}}.items()),
    ])
"""


@pytest.mark.parametrize(
    ("given", "told"),
    [("RewrittenYaml(source_file=rviz, param_rewrites={}, convert_types=True)", 0), ("'/etc/other.yaml'", 1)],
)
def test_a_file_that_a_launch_makes_of_the_other_is_no_leak(findings, given: str, told: int):
    files = FILES | {"launch/rewritten.launch.py": REWRITTEN.format(given=given)}
    assert len(findings("LCH009", **files)) == told


def test_an_argument_that_nobody_takes_is_told_otherwise(findings):
    launch = OWN + include("driver", rviz="false") + '<let name="shown" value="$(var rviz)"/>'
    files = {"launch/driver.launch.xml": "<launch/>"}
    assert findings("LCH009", launch, **files) == []
    assert len(findings("LCH003", launch, **files)) == 1


@pytest.mark.parametrize(
    ("shown", "told"),
    [
        ('<let name="seen" value="$(var rviz)" if="false"/>', False),
        ('<let name="seen" value="$(var rviz)" if="true"/>', True),
        ('<let name="seen" value="$(var rviz)" if="false"/><let name="shown" value="$(var rviz)"/>', True),
        ('<let name="shown" value="$(var rviz)"/><let name="seen" value="$(var rviz)" if="false"/>', True),
        ("", False),
        ('<include file="$(find-pkg-share robot)/launch/inner.launch.xml"/>', True),
    ],
)
def test_an_argument_that_only_what_nothing_runs_reads(findings, shown: str, told: bool):
    panel = f'<launch><arg name="rviz" default="maybe"/>{shown}</launch>'
    launch = include("driver", rviz="false") + include("panel")
    inner = '<launch><let name="seen" value="$(var rviz)"/></launch>'
    files = FILES | {"launch/panel.launch.xml": panel, "launch/inner.launch.xml": inner}
    assert bool(findings("LCH009", launch, **files)) is told


@pytest.mark.parametrize(
    ("actions", "told"),
    [
        ("LogInfo(msg=['with RViz: ', LaunchConfiguration('rviz')])", False),
        (
            "LogInfo(msg=['with RViz: ', LaunchConfiguration('rviz')]),\n"
            "        SetLaunchConfiguration('seen', LaunchConfiguration('rviz'))",
            True,
        ),
        ("LogInfo(msg='no word of it')", False),
    ],
)
def test_an_argument_that_only_a_log_message_shows(findings, actions: str, told: bool):
    panel = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('rviz', default_value='maybe'),
        {actions},
    ])
"""
    launch = include("driver", rviz="false") + include("panel").replace(".xml", ".py")
    assert bool(findings("LCH009", launch, **FILES | {"launch/panel.launch.py": panel})) is told


def test_an_argument_that_is_declared_again_after_the_include_and_read_by_nothing(findings):
    launch = OWN + include("driver", rviz="false") + OWN
    assert findings("LCH009", launch, **FILES) == []
    assert len(findings("LCH009", f'{launch}<let name="shown" value="$(var rviz)"/>', **FILES)) == 1
