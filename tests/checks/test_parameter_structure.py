"""PRM009: which parameter files stop the nodes that they are given to.

What rcl says of each file was tried with rclpy of Jazzy.
"""

from __future__ import annotations

from textwrap import dedent

import pytest

from archlint.finding import Severity
from robot_package import SETUP, node

LOAD_IT = node('<param from="$(find-pkg-share robot)/config/p.yaml"/>', name="talker")

BAD = {
    "talker:\n  rate: 1.0": (
        2,
        "there is no 'ros__parameters' above 'rate'",
        "write 'ros__parameters:' below the name",
    ),
    "- topic_name: clock\n  lazy: true": (1, "this file is a list", "hand the path over in the parameter"),
    "rate: 1.0": (1, "there is no 'ros__parameters' above 'rate'", "write '/**:' above the parameters"),
    "talker:\n  ros_parameters:\n    rate: 1.0": (2, "'ros_parameters' is not 'ros__parameters'", "two underscores"),
    "talker:\n  ros__parameter:\n    a:\n      b: 1": (2, "'ros__parameter' is not 'ros__parameters'", "write"),
    "talker:\n  parameters:\n    rate: 1.0": (2, "'parameters' is not 'ros__parameters'", "write"),
    "ros__parameters:\n  rate: 1.0": (1, "there is no node name above 'ros__parameters'", "write '/**:' above it"),
    "talker:\nros__parameters:\n  rate: 1.0": (2, "there is no node name above", "so that it stands below 'talker'"),
    "talker:\n  ros__parameters:\n  rate: 1.0": (2, "no parameter stands below", "indent 'rate' and what follows"),
    "talker:\n  ros__parameters:\n  pid:\n    p: 1.0": (2, "no parameter stands below", "indent 'pid'"),
    "talker:\n  ros__parameters:": (2, "no parameter stands below", "write 'ros__parameters: {}'"),
    "talker:\n  ros__parameters:\n    - rate: 1.0": (2, "no parameter stands below", "write"),
    "talker:\n  ros__parameters:\n    rate: 1.0\n  gain: 2.0": (4, "'gain' stands beside", "indent 'gain'"),
    "talker:\n  ros__parameters:\n    rate: 1.0\n  pid:\n    p: 2.0": (4, "'pid' stands beside", "indent 'pid'"),
    "talker:\n  gain: 2.0\n  ros__parameters:\n    rate: 1.0": (2, "'gain' stands beside", "indent 'gain'"),
    "/**:\n  ros__parameters:\n    rate: 1.0\ntalker:\n  gain: 2.0": (5, "above 'gain'", "below the name of the node"),
    "/**:\n  ros__parameters:\n    rate: 1.0\npid:\n  p: 2.0": (5, "above 'p'", "indent 'pid'"),
    "talker:\n  ros__parameters:\n    rate: 1.0\n    other:\n      ros__parameters:\n        gain: 2.0": (
        5,
        "so the parameters below it are 'ros__parameters.gain' …: 'talker' never gets them",
        "move this section out",
    ),
}


@pytest.mark.parametrize("text", BAD)
def test_ros__parameters_is_missing_misspelt_or_in_the_wrong_place(findings, text):
    line, message, help = BAD[text]
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": text})
    assert (told.place.file, told.place.line) == ("config/p.yaml", line)
    assert message in told.message
    assert help in told.help
    assert [related.place.file for related in told.related] == ["launch/it.launch.xml"]


@pytest.mark.parametrize("text", ["agent:\n  device: /dev/tty\n", "agent:\n  ros__parameters:\n    device:\n"])
def test_a_program_that_initialises_no_ros_does_not_read_it(findings, text: str):
    agent = LOAD_IT.replace("'robot' exec='talker'", "'micro_ros_agent' exec='micro_ros_agent'")
    assert agent != LOAD_IT
    assert findings("PRM009", agent, **{"config/p.yaml": text}) == []
    assert len(findings("PRM009", LOAD_IT, **{"config/p.yaml": text})) == 1


def test_a_file_that_two_launch_files_give_is_told_once(findings):
    files = {"config/p.yaml": "talker:\n  rate: 1.0\n"}
    other = {"launch/other.launch.xml": f"<launch>\n{LOAD_IT.replace('talker', 'second')}\n</launch>"}
    (rate,) = findings("PRM009", LOAD_IT, **files, **other)
    assert rate.place.line == 2
    assert sorted(row.place.file for row in rate.related) == ["launch/it.launch.xml", "launch/other.launch.xml"]


GOOD = [
    "",
    "# nothing yet\n",
    "talker:\n  ros__parameters:\n    rate: 1.0",
    "/**:\n  ros__parameters: {rate: 1.0}",
    "left:\n  talker:\n    ros__parameters:\n      rate: 1.0",
    "/left/talker:\n  ros__parameters:\n    pid:\n      p: 1.0\n      parameters:\n        i: 2",
    "talker:\n  ros__parameters: {}\nother: {}",
    "talker:\n  ros__parameters:\n    param: 3\n    ros_parameters: 2",
    "talker:\n  ros__parameters:\n    gpio:\n      - interfaces: [a, b]\n        rate: 2.0",
    "talker:\n  ros__parameters:\n    gpio:\n      - left:\n          interfaces:\n            - a",
]


NO_VALUES = {
    "talker:\n  ros__parameters:\n    rate: 1.0\n    name:": (4, "the parameter 'name' has no value: 'talker' stops"),
    "talker:\n  ros__parameters:\n    pid:\n      p:\n      i: 1.0": (4, "the parameter 'pid.p' has no value"),
    "talker:\n  ros__parameters:\n    points: [[1, 2], [3, 4]]": (3, "'points' is a list of lists, and rcl has none"),
    "talker:\n  ros__parameters:\n    points:\n      - x: 1\n        y: 2": (3, "'points' is a list of maps"),
    "talker:\n  ros__parameters:\n    pins:\n      - name: a\n        all: [b]": (3, "'pins' is a list of maps"),
    "talker:\n  ros__parameters:\n    pins:\n      - all: [a]\n      - all: [b]": (3, "'pins' is a list of maps"),
    "talker:\n  ros__parameters:\n    a: &a [1]\n    b: *a": (4, "'b' is an alias, and rcl has none"),
    "one: &one\n  ros__parameters:\n    a: 1\ntwo:\n  <<: *one": (5, "'<<' is an alias, and rcl has none"),
}


@pytest.mark.parametrize("text", NO_VALUES)
def test_a_value_that_rcl_takes_for_none(findings, text):
    line, message = NO_VALUES[text]
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": text})
    assert (told.place.file, told.place.line) == ("config/p.yaml", line)
    assert message in told.message


@pytest.mark.parametrize("value", ["''", '""', "null", "~", "[]", "{}", "[[1, 2]]", "&rate 1.0", "|\n      text"])
def test_a_value_that_rcl_reads(findings, value):
    text = f"talker:\n  ros__parameters:\n    rate: {value}\n"
    assert findings("PRM009", LOAD_IT, **{"config/p.yaml": text}) == []


@pytest.mark.parametrize("text", GOOD)
def test_a_file_that_rcl_reads(findings, text):
    assert findings("PRM009", LOAD_IT, **{"config/p.yaml": text}) == []


READS_IT = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    with open(os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')) as file:
        settings = yaml.safe_load(file)
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[settings])])
"""


def test_a_file_that_another_launch_file_reads_as_it_is(findings):
    """Where it is indented below a node, that one gets other parameters."""
    files = {"config/p.yaml": "rate: 1.0", "launch/other.launch.py": READS_IT}
    (told,) = findings("PRM009", LOAD_IT, **files)
    assert told.help == "give the node a file of its own: other.launch.py reads this one as it is"
    files["launch/other.launch.py"] = READS_IT.replace("p.yaml", "q.yaml")
    (told,) = findings("PRM009", LOAD_IT, **files)
    assert told.help.startswith("write '/**:' above the parameters")


def test_a_file_that_no_node_is_given(findings):
    """What a launch file reads itself, and what a node gets as the value of a parameter or as an argument."""
    launch = """\
        import yaml
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch_ros.actions import Node

        def generate_launch_description():
            path = get_package_share_directory('robot') + '/config/p.yaml'
            with open(path) as file:
                content = yaml.safe_load(file)
            return LaunchDescription([
                Node(package='robot', executable='talker', parameters=[content, {'file': path}]),
                Node(package='rviz2', executable='rviz2', arguments=['-d', path]),
                Node(package='robot', executable='talker', arguments=['--params-file', path]),
            ])
    """
    files = {"config/p.yaml": "rate: 1.0", "launch/read.launch.py": dedent(launch)}
    assert findings("PRM009", **files) == []


def test_a_file_for_a_component(findings):
    """launch_ros reads it for them, and takes the whole file."""
    launch = """\
        <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
          <composable_node pkg="other" plugin="other::Talker" name="talker">
            <param from="$(find-pkg-share robot)/config/p.yaml"/>
          </composable_node>
        </node_container>
    """
    assert findings("PRM009", launch, **{"config/p.yaml": "rate: 1.0"}) == []


def test_a_file_that_the_launch_rewrites(findings):
    launch = """\
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch_ros.actions import Node
        from nav2_common.launch import RewrittenYaml

        def generate_launch_description():
            path = get_package_share_directory('robot') + '/config/p.yaml'
            made = RewrittenYaml(source_file=path, param_rewrites={}, root_key='talker', convert_types=True)
            return LaunchDescription([Node(package='robot', executable='talker', parameters=[made])])
    """
    files = {"config/p.yaml": "ros__parameters:\n  rate: 1.0", "launch/read.launch.py": dedent(launch)}
    assert findings("PRM009", **files) == []


def test_every_way_in_which_a_node_gets_a_file(findings):
    launch = """\
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch_ros.actions import Node, SetParametersFromFile

        def generate_launch_description():
            share = get_package_share_directory('robot')
            return LaunchDescription([
                SetParametersFromFile(share + '/config/all.yaml'),
                Node(package='robot', executable='talker', name='a',
                     arguments=['--ros-args', '--params-file', share + '/config/argument.yaml']),
            ])
    """
    files = {
        "config/all.yaml": "rate: 1.0",
        "config/argument.yaml": "gain: 1.0",
        "launch/it.launch.py": dedent(launch),
    }
    assert [told.place.file for told in findings("PRM009", **files)] == ["config/all.yaml", "config/argument.yaml"]


def test_a_section_below_another_one_is_not_an_unknown_parameter_too(findings):
    text = "talker:\n  ros__parameters:\n    rate: 1.0\n    other:\n      ros__parameters:\n        gain: 2.0\n"
    assert findings("PRM004", LOAD_IT, **{"config/p.yaml": text}) == []


def test_the_place_is_where_the_node_is_given_the_file(findings):
    text = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def generate_launch_description():
    default = PathJoinSubstitution([FindPackageShare('robot'), 'config', 'p.yaml'])
    config = LaunchConfiguration('config')
    return LaunchDescription([
        DeclareLaunchArgument('config', default_value=default),
        Node(package='robot', executable='talker', parameters=[config]),
    ])
"""
    bad = {"config/p.yaml": "talker:\n  rate: 1.0", "launch/it.launch.py": text}
    (told,) = findings("PRM009", **bad)
    assert [(each.place.file, each.place.line) for each in told.related] == [("launch/it.launch.py", 12)]


SECTION = "talker:\n  ros__parameters:\n    rate: 1.0\n    gains: {}\n"


@pytest.mark.parametrize(
    ("gains", "types", "help"),
    [
        ("[1.0, 2, 3.0]", "double, integer", "write a decimal point in each number of it"),
        ("[1, 2.5]", "integer, double", "write a decimal point in each number of it"),
        ("[left, 2]", "string, integer", "give all items of it one type"),
        ("[true, 1]", "bool, integer", "give all items of it one type"),
    ],
)
def test_a_list_of_several_types(findings, gains, types, help):
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": SECTION.format(gains)})
    assert (told.place.line, told.help) == (4, help)
    assert told.message == f"the list 'gains' has items of the types {types}: 'talker' stops when it reads this file"


def test_the_other_lists_of_a_file_are_related(findings):
    lists = SECTION.format("[1.0, 2]") + "    limits: [1.0, 2.0]\n    steps: [1, 2.5]\n"
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": lists})
    assert [(row.place.line, row.message) for row in told.related][1:] == [
        (6, "'steps' has items of several types, too")
    ]


@pytest.mark.parametrize("gains", ["[1.0, 2.0]", "[1, 2]", "['1', left]", "[true, false]", "[1e3, 2.0]", "[]"])
def test_a_list_of_one_type(findings, gains):
    assert findings("PRM009", LOAD_IT, **{"config/p.yaml": SECTION.format(gains)}) == []


def test_a_list_in_a_file_that_no_node_gets(findings):
    assert findings("PRM009", node("", name="talker"), **{"config/p.yaml": SECTION.format("[1.0, 2]")}) == []


def test_a_parameter_that_stands_twice(findings):
    """rcl overwrites the first value: ``rcl_yaml_param_parser/src/parse.c``."""
    held = "talker:\n  ros__parameters:\n    rate: 1.0\n    limits:\n      speed: 2.0\n    names: [a]\n    rate: 5.0\n"
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": held})
    assert (told.place.file, told.place.line) == ("config/p.yaml", 3)
    assert told.message == "'rate' stands twice in this section: 'talker' gets 5.0, and never 1.0"
    assert told.related[0].place.line == 7
    more = "other:\n  ros__parameters:\n    gain: 1.0\n    name: a\n    gain: 2.0\n    name: b\n    gain: 2.0\n"
    (told,) = findings("PRM009", LOAD_IT, **{"config/p.yaml": held + more})
    assert told.message.endswith("'talker' gets 5.0, and never 1.0; so it is with 'gain', 'name'")
    assert [row.place.line for row in told.related][-2:] == [10, 11]


@pytest.mark.parametrize(
    "held",
    [
        "talker:\n  ros__parameters:\n    rate: 1.0\n    rate: 1.0\n",
        "talker:\n  ros__parameters:\n    rate: .nan\n",
        "talker:\n  ros__parameters:\n    rate: .nan\n    rate: .NaN\n",
        "talker:\n  ros__parameters:\n    rate: 1.0\n    limits:\n      rate: 2.0\n",
        "talker:\n  ros__parameters:\n    names: [a]\n    names: [b]\n",
        "/**:\n  ros__parameters:\n    rate: 1.0\ntalker:\n  ros__parameters:\n    rate: 2.0\n",
    ],
)
def test_parameters_that_do_not_contradict_each_other(findings, held: str):
    assert findings("PRM009", LOAD_IT, **{"config/p.yaml": held}) == []


UNLOADED = {
    "talker:\n  ros_parameters:\n    rate: 1.0": (2, "'ros_parameters' is not 'ros__parameters'"),
    "talker:\n  ros__parameters:\n  rate: 1.0": (2, "no parameter stands below 'ros__parameters'"),
    "talker:\n  ros__parameters:\n    rate: 1.0\n    rate: 5.0": (
        3,
        "'rate' stands twice in this section: a node gets 5.0",
    ),
}


@pytest.mark.parametrize("text", UNLOADED)
def test_a_file_that_no_launch_file_gives_to_a_node(findings, text):
    line, message = UNLOADED[text]
    (told,) = findings("PRM009", node(name="talker"), **{"config/p.yaml": text})
    assert (told.place.file, told.place.line, told.severity, told.related[1:]) == (
        "config/p.yaml",
        line,
        Severity.WARNING,
        (),
    )
    assert told.message.startswith(message)


def test_a_section_that_is_still_empty_in_a_file_that_no_launch_file_gives_to_a_node(findings):
    text = "talker:\n  ros__parameters:\n    # rate: 1.0\n"
    (told,) = findings("PRM009", node(name="talker"), **{"config/p.yaml": text})
    assert (told.severity, told.help) == (Severity.INFO, "write 'ros__parameters: {}' for a node without parameters")


@pytest.mark.parametrize(
    ("files", "severity"),
    [
        ({}, Severity.INFO),
        ({"README.md": "Run it with `--params-file params/p.yaml`.\n"}, Severity.WARNING),
        ({"setup.py": SETUP.replace("glob('config/*')", "glob('params/*')")}, Severity.WARNING),
    ],
)
def test_a_file_that_is_neither_given_to_a_node_nor_installed(findings, files, severity):
    text = "talker:\n  ros_parameters:\n    rate: 1.0"
    (told,) = findings("PRM009", node(name="talker"), **{"params/p.yaml": text}, **files)
    assert told.severity is severity


@pytest.mark.parametrize(
    "text",
    [
        *GOOD,
        "talker:\n  rate: 1.0",
        "talker:\n  parameters:\n    rate: 1.0",
        "rates:\n  rate: 1.0\n  rate: 2.0",
        "{{ name }}:\n  ros_parameters:\n    rate: 1.0",
    ],
)
def test_a_file_that_no_launch_file_gives_to_a_node_and_that_may_be_meant(findings, text):
    assert findings("PRM009", node(name="talker"), **{"config/p.yaml": text}) == []


def test_a_file_that_code_reads_itself(findings):
    files = {
        "config/p.yaml": "talker:\n  ros_parameters:\n    rate: 1.0",
        "robot/read.py": "import yaml\nyaml.safe_load('p.yaml')",
    }
    assert findings("PRM009", node(name="talker"), **files) == []
