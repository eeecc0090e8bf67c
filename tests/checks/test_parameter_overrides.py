"""PRM004: one finding for one cause, where the cause is."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.checks.registry import finding
from archlint.config.settings import load
from archlint.engine.merging import merged
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Place, Related

SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main']},
)
"""
TALKER = """\
import rclpy
from rclpy.node import Node

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('limits', '')
        self.declare_parameter('gain', 1.0)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
LAUNCH = """\
import json
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

LIMITS = {'left': {'min': 0.0, 'max': 1.0}, 'right': {'max': 2.0}}

def generate_launch_description():
    file = os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')
    return LaunchDescription([
        Node(
            package='robot',
            executable='talker',
            parameters=[
                {}
            ],
        ),
    ])
"""
FIRST = 18


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def run(
        *parameters: str, yaml: str = "", talker: str = TALKER, setup: str = SETUP, copy: str = ""
    ) -> list[Finding]:
        texts = {
            "archlint.toml": 'select = ["PRM004"]',
            "package.xml": "<package format='3'><name>robot</name><exec_depend>rclpy</exec_depend>"
            "<export><build_type>ament_python</build_type></export></package>",
            "setup.py": setup,
            "robot/talker.py": talker,
            "launch/it.launch.py": LAUNCH.replace("{}\n", "\n".join(parameters) + "\n"),
            "config/p.yaml": yaml,
        }
        if copy:
            texts["launch/it_too.launch.py"] = LAUNCH.replace("{}\n", f"{copy}\n")
        for name, text in texts.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def test_a_dict_for_a_parameter_that_the_node_declares_is_told_at_its_key(findings):
    (found,) = findings("{", "'limits': LIMITS,", "'gain': 2.0,", "}")
    assert found.message == (
        "'limits' is set to a dict, which launch splits: it sets 'limits.left.min' and 2 more, which "
        "/talker does not declare, and 'limits' keeps its default"
    )
    assert (found.place.file, found.place.line) == ("launch/it.launch.py", FIRST + 1)
    assert found.help == "pass it as a string: ParameterValue(json.dumps(…), value_type=str)"
    assert [(one.place.file, one.place.line) for one in found.related] == [("robot/talker.py", 7)]


def test_the_advice_works(findings):
    assert findings("{'limits': ParameterValue(json.dumps(LIMITS), value_type=str)}") == []


def test_a_dict_whose_parts_the_node_declares(findings):
    more = "".join(
        f"        self.declare_parameter('limits.{part}', 0.0)\n" for part in ("left.min", "left.max", "right.max")
    )
    assert findings("{'limits': LIMITS}", talker=TALKER.replace("\ndef main", f"{more}\ndef main")) == []


def test_a_number_that_is_given_a_dict(findings):
    (found,) = findings("{'gain': {'p': 1.0}}")
    assert "it sets 'gain.p', which /talker does not declare" in found.message
    assert found.help == "give it one value of type double"


@pytest.mark.parametrize("default", ["None", "{}"])
def test_code_that_wants_the_dict_has_to_declare_its_parts(findings, default: str):
    more = f"        self.filter = self.declare_parameter('filter', {default}).value or {{}}\n"
    talker = TALKER.replace("\ndef main", f"{more}\ndef main")
    (found,) = findings("{'filter': {'mean': 0.0, 'sigma': 0.1}}", talker=talker)
    assert found.help == (
        "declare each of them in the node ('filter.mean'), and read them with get_parameters_by_prefix('filter')"
    )


def test_a_dict_in_a_parameter_file(findings):
    (found,) = findings("file", yaml="talker:\n  ros__parameters:\n    limits:\n      a: 1.0\n      b: 2.0\n")
    assert (found.place.file, found.place.line) == ("config/p.yaml", 4)
    assert "which ROS splits: it sets 'limits.a' and 1 more" in found.message
    assert found.help == "pass it as a string: put it in quotes"
    quoted = """talker:\n  ros__parameters:\n    limits: '{"a": 1.0}'\n"""
    assert findings("file", yaml=quoted) == []


def test_what_one_file_sets_on_one_node_is_one_finding(findings):
    (found,) = findings("{'speed': 1.0,", "'frame': 'map',", "'device': '/dev/ttyS0'}")
    assert found.message == (
        "/talker declares none of these 3 parameters, so their values have no effect: speed, frame, device"
    )
    assert found.place.line == FIRST
    assert [(one.place.line, one.message) for one in found.related[:2]] == [
        (FIRST + 1, "'frame'"),
        (FIRST + 2, "'device'"),
    ]


def test_what_several_launch_files_set_on_one_node_is_one_finding(findings):
    (found,) = findings("{'speed': 1.0, 'frame': 'map'}", copy="{'speed': 2.0, 'device': '/dev/ttyS0'}")
    assert found.place.file == "launch/it.launch.py"
    assert "/talker declares none of these 3 parameters" in found.message
    places = [(row.place.file, row.place.line, row.message) for row in found.related]
    assert ("launch/it_too.launch.py", FIRST, "'speed'") in places
    assert ("launch/it_too.launch.py", FIRST, "'device'") in places
    (one_name,) = findings("{'speed': 1.0}", copy="{'speed': 2.0}")
    assert one_name.message.startswith("/talker declares no parameter 'speed'")
    assert [row.message for row in one_name.related][:1] == ["it is set here, too"]
    assert len(findings("{'gain': 1.0}", copy="{'speed': 2.0}")) == 1
    apart = findings("{'speed': 1.0}", copy="{'speed': 2.0}", yaml="talker: {ros__parameters: {speed: 3.0}}")
    assert [one.place.file for one in apart] == ["launch/it.launch.py"]  # no launch file gives the node that one


def test_a_misspelt_name_is_told_apart_from_others(findings):
    found = findings("{'speed': 1.0,", "'gian': 2.0,", "'device': '/dev/ttyS0'}")
    assert [(one.place.line, "did you mean 'gain'?" in one.message) for one in found] == [
        (FIRST, False),
        (FIRST + 1, True),
    ]


def test_all_misspelt_names_of_a_node_are_one_finding(findings):
    (found,) = findings("file", yaml="talker:\n  ros__parameters:\n    gian: 1.0\n    limit: a\n")
    assert (found.place.file, found.place.line) == ("config/p.yaml", 3)
    assert found.message == (
        "/talker declares none of these 2 parameters, so their values have no effect: gian (did you mean 'gain'?), "
        "limit ('limits'?)"
    )
    assert [(row.place.line, row.message) for row in found.related][:1] == [(4, "'limit'; did you mean 'limits'?")]


def test_a_text_meant_as_a_comment_that_is_joined_with_the_next_key(findings):
    lines = ["{", "'limits': 'a',", "'''", "'gain': 1.0,", "'''", "'gain': 2.0,", "}"]
    (found,) = findings(*lines)
    assert found.message.startswith("/talker gets no 'gain' here: Python joins the text in quotes with the key")
    assert (found.place.line, found.help) == (
        FIRST + 2,
        "write the text as a comment, with # in front of each of its lines",
    )
    assert findings("{", "'limits': 'a',", "# 'gain': 1.0,", "'gain': 2.0,", "}") == []


def test_a_misspelt_name_in_copies_of_a_launch_file_is_one_finding(findings):
    (found,) = findings("{'gian': 1.0}", copy="{'gian': 2.0}")
    assert "did you mean 'gain'?" in found.message
    assert [(row.place.file, row.message) for row in found.related][:1] == [
        ("launch/it_too.launch.py", "it is set here, too")
    ]


def test_a_prefix_that_no_parameter_has_is_one_finding(findings):
    lines = "    from: {gain: 1.0, limits: a, speed: 2.0}\n"
    (found,) = findings("file", yaml=f"talker:\n  ros__parameters:\n{lines}")
    assert "declares none of these 3 parameters" in found.message
    assert "from.gain, from.limits, from.speed" in found.message and "did you mean" not in found.message


def test_names_in_a_misspelt_section_are_one_finding(findings):
    talker = TALKER.replace("'limits', ''", "'speedlimits.left', 1.0").replace("'gain'", "'speedlimits.right'")
    lines = "    speed_limits:\n      left: 1.0\n      right: 2.0\n"
    (found,) = findings("file", yaml=f"talker:\n  ros__parameters:\n{lines}", talker=talker)
    assert found.message == (
        "/talker declares none of these 2 parameters, so their values have no effect: speed_limits.left, "
        "speed_limits.right; did you mean 'speedlimits' for 'speed_limits'?"
    )
    assert [row.message for row in found.related][:1] == ["'speed_limits.right'"]


def test_a_comment_hides_one_of_several(findings):
    lines = "    speed: 1.0  # archlint: ignore[PRM004]\n    frame: map\n"
    (found,) = findings("file", yaml=f"talker:\n  ros__parameters:\n{lines}")
    assert found.message.startswith("/talker declares no parameter 'frame'")


ON_BOTH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    nodes = [DeclareLaunchArgument('wide')]
    for side in ('left', 'right'):
        nodes.append(Node(package='robot', executable='talker', namespace=side, parameters=[{'gian': 2.0}]))
    MORE
    return LaunchDescription(nodes)
"""
THIRD = "Node(package='robot', executable='talker', name='c', parameters=[{'gian': 1.0}]"


@pytest.mark.parametrize(
    ("more", "lines"),
    [
        ("", []),  # one line, two nodes of it
        (f"nodes.append({THIRD}))", [11]),
        (f"nodes.append({THIRD}, condition=IfCondition(LaunchConfiguration('wide'))))", [11]),
    ],
)
def test_a_line_is_wrong_once_however_many_nodes_it_starts(findings, tmp_path: Path, more: str, lines: list[int]):
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch/both.launch.py").write_text(ON_BOTH.replace("MORE", more or "pass"))
    (told,) = findings("{'gain': 2.0}")
    assert (told.place.file, told.place.line) == ("launch/both.launch.py", 10)
    assert [row.place.line for row in told.related if row.message == "it is set here, too"] == lines


@pytest.mark.parametrize(
    ("conditions", "places", "told"),
    [
        ((None, "a:=true"), (5, 5), [None]),  # it holds under any arguments: no need to say it for one
        (("a:=true", "a:=false"), (5, 5), ["a:=true", "a:=false"]),
        ((None, "a:=true"), (5, 6), [None, "a:=true"]),  # another place is another mistake
    ],
)
def test_what_holds_under_any_arguments_is_not_told_for_some(
    conditions: tuple[str | None, ...], places: tuple[int, ...], told: list[str | None]
):
    node = Related(Place("robot/talker.py", 4, 1, 4, 2), "the node is defined here")
    found = [
        replace(
            finding("PRM004", Place("it.launch.py", line, 1, line, 2), f"node {number} …", help="", related=[node]),
            system="it.launch.py",
            condition=condition,
        )
        for number, (condition, line) in enumerate(zip(conditions, places, strict=True))
    ]
    assert [one.condition for one in merged(found)] == told


OTHER = TALKER.replace("'gain'", "'pace'").replace("Talker", "Walker").replace("'talker'", "'walker'")
SHARED = """\
from launch import LaunchDescription
from launch_ros.actions import Node

BOTH = {'gain': 2.0, 'pace': 3.0, 'nobody': 1.0}

def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='talker', parameters=[ONE]),
        Node(package='robot', executable='walker', parameters=[TWO]),
    ])
"""


@pytest.mark.parametrize(
    ("one", "two", "told"),
    [
        ("BOTH", "BOTH", ["nobody"]),
        ("BOTH", "{'gain': 2.0}", ["gain", "nobody", "pace"]),  # a dict of its own is not shared
        ("{'gain': 2.0, 'pace': 3.0}", "{'gain': 2.0, 'pace': 3.0}", ["gain", "pace"]),
    ],
)
def test_a_dict_that_several_nodes_get_is_for_all_of_them(
    findings, tmp_path: Path, one: str, two: str, told: list[str]
):
    (tmp_path / "launch").mkdir()
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/walker.py").write_text(OTHER)
    (tmp_path / "launch/shared.launch.py").write_text(SHARED.replace("ONE", one).replace("TWO", two))
    setup = SETUP.replace("['talker = ", "['walker = robot.walker:main', 'talker = ")
    names = {name for found in findings("{'gain': 2.0}", setup=setup) for name in found.identity[1:]}
    assert sorted(names) == told


FROM_FILE = """\
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    with open(get_package_share_directory('robot') + '/config/all.yaml') as stream:
        every = yaml.safe_load(stream)['every']
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[every])])
"""


def test_a_dict_from_a_file_is_for_all_programs_of_the_package(findings, tmp_path: Path):
    for folder in ("launch", "robot", "config"):
        (tmp_path / folder).mkdir()
    (tmp_path / "robot/walker.py").write_text(OTHER)
    (tmp_path / "launch/all.launch.py").write_text(FROM_FILE)
    (tmp_path / "config/all.yaml").write_text("every: {gain: 2.0, pace: 3.0, nobody: 1.0}")
    setup = SETUP.replace("['talker = ", "['walker = robot.walker:main', 'talker = ")
    (found,) = findings("{'gain': 2.0}", setup=setup)
    assert found.identity[1:] == ("nobody",)


def test_a_whole_configuration_of_which_a_node_declares_nothing(findings, tmp_path: Path):
    """A library that the node uses takes it, or nobody: ``config.to_dict()`` is no choice of names."""
    for folder in ("launch", "config"):
        (tmp_path / folder).mkdir()
    (tmp_path / "launch/all.launch.py").write_text(FROM_FILE)
    (tmp_path / "config/all.yaml").write_text("every: {planner: 2.0, pipeline: 3.0, nobody: 1.0}")
    assert findings("{'gain': 2.0}") == []
    (tmp_path / "launch/all.launch.py").write_text(FROM_FILE.replace("[every]", "[{'planner': 2.0, 'nobody': 1.0}]"))
    assert len(findings("{'gain': 2.0}")) == 1


CHOSEN = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def start(context):
    return [Node(package='robot', executable=EXECUTABLE, parameters=[{'gain': 2.0, 'pace': 3.0}])]

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('which', default_value='talker'), OpaqueFunction(function=start)])
"""


@pytest.mark.parametrize(
    ("executable", "told"),
    [
        ("LaunchConfiguration('which').perform(context)", 0),
        ("['talker_2', 'walker'][0]", 0),
        ("{'talk': 'talker_2', 'walk': 'walker'}['talk']", 0),
        ("'talker_2' if True else 'walker'", 0),
        ("'talk' + 'er_2'", 1),
    ],
)
def test_a_value_for_the_other_executable_that_an_argument_may_choose(
    findings, tmp_path: Path, executable: str, told: int
):
    for folder in ("launch", "robot"):
        (tmp_path / folder).mkdir()
    (tmp_path / "robot/walker.py").write_text(OTHER)
    (tmp_path / "launch/chosen.launch.py").write_text(CHOSEN.replace("EXECUTABLE", executable))
    entries = "['walker = robot.walker:main', 'talker_2 = robot.talker:main', 'talker = "
    assert len(findings("{'gain': 2.0}", setup=SETUP.replace("['talker = ", entries))) == told


SWITCHED = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    file = os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')
    return LaunchDescription([
        DeclareLaunchArgument('walk', default_value='WALK'),
        Node(package='robot', executable='talker', parameters=[file]),
        Node(package='PACKAGE', executable='walker', parameters=[file],
             condition=IfCondition(LaunchConfiguration('walk'))),
    ])
"""


@pytest.mark.parametrize(
    ("walk", "package", "told"),
    [
        ("true", "robot", ["nobody"]),
        ("false", "robot", ["nobody"]),  # who starts the walker has a use for the pace
        ("false", "elsewhere", []),  # and what a walker from elsewhere declares is not known
    ],
)
def test_a_node_that_is_switched_off_by_default_may_need_a_value_for_all(
    findings, tmp_path: Path, walk: str, package: str, told: list[str]
):
    (tmp_path / "launch").mkdir()
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/walker.py").write_text(OTHER)
    (tmp_path / "launch/switched.launch.py").write_text(SWITCHED.replace("WALK", walk).replace("PACKAGE", package))
    setup = SETUP.replace("['talker = ", "['walker = robot.walker:main', 'talker = ")
    values = "/**:\n  ros__parameters:\n    gain: 2.0\n    pace: 3.0\n    nobody: 1.0\n"
    names = {name for found in findings(yaml=values, setup=setup) for name in found.identity[1:]}
    assert sorted(names) == told


@pytest.mark.parametrize("walks", [True, False])
def test_what_none_of_several_nodes_declares_is_said_once_for_a_section(findings, tmp_path: Path, walks: bool):
    (tmp_path / "launch").mkdir()
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/walker.py").write_text(OTHER)
    switched = SWITCHED.replace("WALK", "true").replace("PACKAGE", "robot")
    alone = switched.replace("parameters=[file],\n", "\n")
    (tmp_path / "launch/switched.launch.py").write_text(switched if walks else alone)
    setup = SETUP.replace("['talker = ", "['walker = robot.walker:main', 'talker = ")
    values = "/**:\n  ros__parameters:\n    gain: 2.0\n    nobody: 1.0\n    nothing: 2.0\n"
    (found,) = findings(yaml=values, setup=setup)
    subject = "none of the 2 nodes that read this section declares any" if walks else "/talker declares none"
    assert found.message == (f"{subject} of these 2 parameters, so their values have no effect: nobody, nothing")
    places = {(one.place.file, one.message) for one in found.related}
    assert (("robot/walker.py", "/walker is defined here") in places) is walks
    (found,) = findings(yaml=values.replace("gain", "gian"), setup=setup)[:1]
    assert found.message.endswith("so this value has no effect; did you mean 'gain'?")


HELPERS = """\
import rclpy
from rclpy.node import Node

class Helpers(Node):
    def frame(self):
        return self.declare_parameter('frame', 'map').value

    def names(self):
        return self.declare_parameter('names', ['']).value

class Talker(Helpers):
    def __init__(self):
        super().__init__('talker')
        self.own = self.frame()

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_the_help_leaves_out_what_an_inherited_method_would_declare(findings):
    (found,) = findings("{'shape': 'round'}", talker=HELPERS)
    assert found.help == "it declares frame"


def test_a_value_for_what_an_inherited_method_may_declare_is_not_reported(findings):
    assert findings("{'names': ['a']}", talker=HELPERS) == []


ASKS_FIRST = """\
import rclpy
from rclpy.node import Node
BASE

class Talker(Base):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('gain', 1.0)

def is_simulated():
    helper = rclpy.create_node('asks_for_the_clock')
    found = helper.has_parameter('use_sim_time')
    helper.destroy_node()
    return found

def main():
    rclpy.init()
    simulated = is_simulated()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("base", "told"),
    [
        ("class Base(Node):\n    pass", ["/talker declares none of these 2 parameters"]),
        ("from drivers.base import Base", []),  # it may declare both
    ],
)
def test_a_node_that_is_gone_before_the_one_that_stays_gets_no_parameters(findings, base: str, told: list[str]):
    found = findings("{'speed': 1.0, 'frame': 'map'}", talker=ASKS_FIRST.replace("BASE", base))
    assert [one.message.partition(",")[0] for one in found] == told


WITH_A_HELPER = """\
import rclpy
from rclpy.node import Node

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('gain', 1.0)
        self.helper = rclpy.create_node('talker_client')HELPER

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("helper", "told"),
    [("", ["speed"]), ("\n        self.helper.declare_parameter('speed', 2.0)", [])],
    ids=["neither declares it", "the helper does"],
)
def test_the_nodes_of_one_process_are_told_once(findings, helper: str, told: list[str]):
    rows = findings("{'gain': 1.0, 'speed': 2.0}", talker=WITH_A_HELPER.replace("HELPER", helper))
    assert [row.identity[1] for row in rows] == told
    assert all(row.help == "it declares gain" for row in rows)


TWO_NODES = """\
import rclpy
from rclpy.executors import SingleThreadedExecutor

def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    executor.add_node(rclpy.create_node('camera'))
    executor.add_node(rclpy.create_node('lamp'))
    executor.spin()
"""


def test_of_two_nodes_that_declare_nothing_neither_is_named(findings):
    (told,) = findings("{'gain': 1.0}", talker=TWO_NODES)
    assert told.message == "the program 'talker' declares no parameter 'gain', so this value has no effect"
    assert told.related == ()


CONTROLLER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        if self.declare_parameter('controls', True).value:
            self.declare_parameter('gain', 1.0)
            self.create_publisher(String, 'command', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize("controls", [False, True])
def test_a_value_for_what_the_launch_file_turns_off_waits_for_it(findings, controls: bool):
    told = findings(f"{{'controls': {controls}, 'gain': 2.0, 'speed': 2.0}},", talker=CONTROLLER)
    assert [finding.identity[1] for finding in told] == ["speed"]


@pytest.mark.parametrize(
    ("makes", "told"),
    [("MoveItPy(node_name='planner')", 0), ("rclcpp.Node('planner', rclcpp.NodeOptions())", 0), ("str('planner')", 1)],
)
def test_a_node_of_cpp_in_the_same_process_takes_parameters_too(findings, makes: str, told: int):
    talker = TALKER.replace("import rclpy\n", "import rclcpp\nimport rclpy\nfrom moveit.planning import MoveItPy\n", 1)
    talker = talker.replace("    rclpy.spin", f"    planner = {makes}\n    rclpy.spin")
    assert len(findings("{'robot_description': 'x'}", talker=talker)) == told


READS_IT = """
import os
import yaml

def gains(folder):
    with open(os.path.join(folder, 'FILE')) as file:
        return yaml.safe_load(file)['talker']['ros__parameters'].get('pose')
"""


@pytest.mark.parametrize(
    ("read", "count"), [(READS_IT.replace("FILE", "p.yaml"), 0), (READS_IT.replace("FILE", "q.yaml"), 1), ("", 1)]
)
def test_a_node_may_read_its_parameter_file_itself(findings, read: str, count: int):
    yaml = "talker:\n  ros__parameters:\n    gain: 2.0\n    pose: [0.0]\n"
    assert len(findings("file", yaml=yaml, talker=TALKER + read)) == count


READS_IT_IN_CPP = """
#include <rclcpp/rclcpp.hpp>
#include <yaml-cpp/yaml.h>

class Arm : public rclcpp::Node {
public:
  explicit Arm(const std::string & share) : Node("arm"), config_(YAML::LoadFile(share + "/config/FILE")) {}
  YAML::Node config_;
};
"""


@pytest.mark.parametrize(("file", "count"), [("p.yaml", 0), ("q.yaml", 1)])
def test_a_node_in_cpp_may_read_the_parameter_file_itself(findings, tmp_path: Path, file: str, count: int):
    (tmp_path / "src").mkdir()
    (tmp_path / "src/arm.cpp").write_text(READS_IT_IN_CPP.replace("FILE", file))
    assert len(findings("file", yaml="talker:\n  ros__parameters:\n    pose: [0.0]\n")) == count


@pytest.mark.parametrize(("key", "count"), [("pose", 0), ("gain", 1)])
def test_a_launch_file_reads_the_keys_that_it_asks_for(findings, key: str, count: int):
    taken = f"yaml.safe_load(open(file))['talker']['ros__parameters']['{key}']"
    yaml = "talker:\n  ros__parameters:\n    gain: 2.0\n    pose: [0.0]\n"
    assert len(findings("file", f", {{'gain': {taken}}}", yaml=yaml)) == count


IN_A_LOOP = """\
self.declare_parameter('servos_used', DEFAULT)
        used = self.get_parameter('servos_used').value
        if used < 0:
            raise ValueError('how many?')
        for number in range(used):
            self.declare_parameter(f'servo{number}.min', 0.0)
"""


@pytest.mark.parametrize("default", [0, 1, 2])
@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("'servos_used': 2, 'servo0.min': 1.0, 'servo1.min': 1.0", []),
        ("'servos_used': 2, 'servo1.min': 1.0, 'servo2.min': 1.0", ["servo2.min"]),
        ("'servos_used': 2, 'speed': 1.0", ["speed"]),
    ],
)
def test_parameters_that_a_loop_declares_as_often_as_another_one_says(
    findings, default: int, given: str, told: list[str]
):
    """The value of the launch file counts, and the default does not."""
    loop = IN_A_LOOP.replace("DEFAULT", str(default))
    talker = TALKER.replace("self.declare_parameter('gain', 1.0)", loop)
    found = findings(f"{{{given}}},", talker=talker)
    assert [name for name in told if any(name in one.message for one in found)] == told
    assert len(found) == len(told)


# ------------------------------------------------------------------------------ a program that is too large to follow

LOOP = """        for a in range(400):
            for b in range(400):
                self.get_logger().info('x')
"""
LARGE = LOOP * 20 + "        {read}\n"
"""One loop leaves something for what follows it."""


@pytest.mark.parametrize(
    ("read", "told"),
    [
        ("self.get_parameter('gain')", ["maximum_gain"]),
        ("self.declare_parameter('maximum_gain', 1.0)", []),
        ("self.declare_parameter(f'{self.get_name()}.maximum_gain', 1.0)", []),
        ("self.helper('maximum_gain')", []),
    ],
)
def test_a_name_that_no_code_has_is_no_parameter_of_a_program_that_is_cut_short(findings, read: str, told: list[str]):
    talker = TALKER.replace("\ndef main", f"{LARGE.format(read=read)}\ndef main")
    assert [row.identity[1] for row in findings("{'maximum_gain': 0.1}", talker=talker)] == told


@pytest.mark.parametrize(("read", "told"), [("'speed'", ["volume"]), ("'other'", ["speed", "volume"])])
def test_a_value_that_the_node_reads_undeclared_is_told_at_the_read(findings, read: str, told: list[str]):
    talker = TALKER.replace("\ndef main", f"        self.get_parameter({read})\n\ndef main")
    [found] = findings("{'speed': 1.0, 'volume': 2.0}", talker=talker)
    assert [name for name in ("speed", "volume") if name in found.message] == told


def test_a_name_is_no_slip_for_what_another_one_is_nearer_to(findings):
    talker = TALKER.replace("'gain'", "'heat_management_enable'")
    lines = ["talker:", "  ros__parameters:", "    heat_management:", "      derating_enable: true"]
    (alone,) = findings("file", talker=talker, yaml="\n".join(lines))
    assert alone.message.endswith("did you mean 'heat_management_enable'?")
    both = findings("file", talker=talker, yaml="\n".join([*lines, "      enable: true"]))
    assert [(told.place.line, "did you mean" in told.message) for told in both] == [(4, False), (5, True)]
