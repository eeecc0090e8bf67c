"""Includes, and where the files are that a launch file names."""

from __future__ import annotations

import pytest

from launching import names


def test_includes_across_packages_and_formats(launches):
    launches.package("arm")
    launches.file(
        "arm/launch/arm.launch.py",
        "from launch import LaunchDescription\nfrom launch.substitutions import LaunchConfiguration\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='arm', executable='talker', name=LaunchConfiguration('name'))])\n",
    )
    launches.file(
        "robot/launch/two.launch.yaml",
        "launch:\n- include:\n    file: $(find-pkg-share arm)/launch/arm.launch.py\n"
        "    arg:\n    - {name: name, value: left}\n",
    )
    launched = launches.xml('<include file="$(dirname)/two.launch.yaml"/>')
    assert names(launched) == ["left"]
    assert [include.reference.status for include in launched.included] == ["installed", "installed"]


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("$(find-pkg-share robot)/launch/gone.launch.py", "missing"),
        ("$(find-pkg-share nav2_bringup)/launch/x.launch.py", "external"),
        ("/opt/x.launch.py", "external"),
        ("$(find-pkg-share robot)/other/there.launch.xml", "not installed"),
    ],
)
def test_files_that_are_not_there(launches, path, status):
    launches.file("robot/other/there.launch.xml", "<launch/>")
    launched = launches.xml(f'<include file="{path}"/>')
    assert [include.reference.status for include in launched.included] == [status]
    assert launched.gaps == []


def test_a_circle_of_includes_ends(launches):
    launched = launches.xml('<include file="$(dirname)/it.launch.xml"/><node pkg="robot" exec="talker"/>')
    assert len(launched.started) == 1
    assert "includes itself" in launched.gaps[0].reason


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [
        ('<include file="$(dirname)/other.launch.xml"/>', '<include file="$(dirname)/it.launch.xml"/>', 1),
        ('<include file="$(dirname)/other.launch.xml"/>', "", 0),
        (
            '<arg name="n" default="1"/><include file="$(dirname)/other.launch.xml" if="$(var n)"/>',
            '<include file="$(dirname)/it.launch.xml"><arg name="n" value="0"/></include>',
            0,
        ),
        (
            '<include file="$(dirname)/other.launch.xml"/>',
            '<arg name="again"/><include file="$(dirname)/it.launch.xml" if="$(var again)"/>',
            0,
        ),
    ],
    ids=["a circle", "none", "an argument may end it", "a condition may end it"],
)
def test_a_circle_of_includes_is_told_once(launches, first, second, told):
    launches.file("robot/launch/other.launch.xml", f"<launch>{second}</launch>")
    launches.xml(first)
    loaded = launches.of_workspace()
    for file in loaded.files.all():
        loaded.run(file)
    endless = [problem for problem in loaded.files.problems() if "never end" in problem.message]
    assert [(one.file, one.line) for one in endless] == [("robot/launch/other.launch.xml", 1)] * told


def test_a_launch_that_a_command_starts_has_a_context_of_its_own(launches):
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><arg name="who" default="nobody"/><push_ros_namespace namespace="deep"/>'
        '<node pkg="robot" exec="talker" name="$(var who)"/></launch>',
    )
    launched = launches.xml(
        '<arg name="who" default="outer"/><push_ros_namespace namespace="a"/>'
        '<executable cmd="ros2 launch robot inner.launch.xml who:=$(var who)_one"/><node pkg="robot" exec="talker"/>'
    )
    assert names(launched) == ["/deep/outer_one", "/a/-"]


def test_each_entry_of_a_yaml_list_has_its_own_place(launches):
    launched = launches.yaml(
        "launch:\n"
        "- include:\n"
        "    file: $(find-pkg-share robot)/launch/other.launch.yaml\n"
        "    arg:\n"
        "    - {name: a, value: '1'}\n"
        "    - name: b\n"
        "      value: '2'\n"
        "- node:\n"
        "    pkg: robot\n"
        "    exec: talker\n"
        "    remap:\n"
        "    - from: x\n"
        "      to: y\n"
        "    - {from: v, to: w}\n"
        "    param:\n"
        "    - {name: rate, value: 1.0}\n"
        "    -\n"
        "      name: speed\n"
        "      value: 2.0\n"
    )
    (included,), (started,) = launched.included, launched.started
    assert [(name, place.line, place.column) for name, place in included.arguments] == [("a", 5, 8), ("b", 6, 7)]
    assert [remap.place.line for remap in started.remaps] == [12, 14]
    assert [parameter.place.line for parameter in started.parameters] == [16, 18]


@pytest.mark.parametrize(
    "folder",
    [
        "os.path.dirname(os.path.abspath(__file__))",
        "os.path.split(os.path.realpath(__file__))[0]",
        "os.path.dirname(os.path.dirname(os.path.realpath(__file__))) + '/launch'",
        "str(Path(__file__).resolve().parent)",
    ],
)
def test_a_launch_file_knows_where_it_is(launches, folder):
    launches.file("robot/launch/p.yaml", "/**:\n  ros__parameters: {rate: 1}\n")
    [node] = launches.python(
        f"[Node(package='p', executable='e', parameters=[os.path.join({folder}, 'p.yaml')])]",
        "from pathlib import Path",
    ).started
    [use] = node.parameters
    assert (use.reference.source, use.reference.status) == ("robot/launch/p.yaml", "installed")


FLAT = """\
from glob import glob
from setuptools import setup
setup(name='robot', data_files=[('share/robot', glob('launch/*.py')), ('share/robot/config', glob('config/*'))])
"""


@pytest.mark.parametrize(("file", "status"), [("config/p.yaml", "installed"), ("config/q.yaml", "missing")])
def test_the_way_from_a_launch_file_starts_where_it_is_installed(launches, file, status):
    launches.file("robot/setup.py", FLAT)
    launches.file("robot/config/p.yaml", "/**:\n  ros__parameters: {rate: 1}\n")
    [node] = launches.python(
        f"[Node(package='p', executable='e', parameters=[os.path.join(os.path.dirname(__file__), '{file}')])]"
    ).started
    [use] = node.parameters
    assert use.reference.status == status


def test_ros2_launch_is_an_include_with_a_process_of_its_own(launches):
    launches.file("robot/launch/inner.launch.xml", '<launch><node pkg="p" exec="inner"/></launch>')
    launched = launches.python("[ExecuteProcess(cmd=['ros2', 'launch', 'robot', 'inner.launch.xml'])]")
    assert [(one.reference.source, one.own_process) for one in launched.included] == [
        ("robot/launch/inner.launch.xml", True)
    ]
    plain = launches.xml('<include file="$(find-pkg-share robot)/launch/inner.launch.xml"/>')
    assert [one.own_process for one in plain.included] == [False]


PARTS = """\
from launch_ros.actions import Node


def talker(name):
    return Node(package='robot', executable='talker', name=name)
"""


@pytest.mark.parametrize("path", ["Path(__file__).with_name('parts.py')", "str(Path(__file__).parent / 'parts.py')"])
def test_a_file_that_run_path_runs_gives_its_functions(launches, path):
    launches.file("robot/launch/parts.py", PARTS)
    before = f"import runpy\nfrom pathlib import Path\nparts = runpy.run_path({path})"
    launched = launches.python("[parts['talker']('left')]", before)
    assert names(launched) == ["left"]
    assert launched.gaps == []


@pytest.mark.parametrize(
    "call", ["run_path('/opt/parts.py')", "run_path(Path(__file__).with_name('parts.py'), {'x': 1})"]
)
def test_what_run_path_makes_is_unknown_for_other_files_and_with_variables(launches, call):
    launches.file("robot/launch/parts.py", PARTS)
    before = f"import runpy\nfrom pathlib import Path\nparts = runpy.{call}"
    launched = launches.python("[parts['talker']('left')]", before)
    assert names(launched) == []
    assert launched.gaps != []


def test_a_launch_file_that_runs_itself_ends(launches):
    before = "import runpy\nparts = runpy.run_path(__file__)"
    assert launches.python("[parts['node']]", before).gaps != []
    outside = "import runpy\nME = runpy.run_path(__file__)\ndef generate_launch_description():\n    return ME['ld']\n"
    launches.file("robot/launch/round.launch.py", outside)
    assert launches.run("robot/launch/round.launch.py").gaps != []
