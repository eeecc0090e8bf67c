"""Helpers that a launch file loads by their path."""

from __future__ import annotations

import pytest

HELPER = """\
SUFFIX = '_node'

def name_of(robot):
    return robot + SUFFIX
"""
PATH = "os.path.join(get_package_share_directory('robot'), 'launch', 'lib', 'names.py')"
IMPORTS = (
    "import importlib.util, os, runpy\n"
    "from importlib.machinery import SourceFileLoader\n"
    "from launch.launch_description_sources import load_python_launch_file_as_module\n"
)


@pytest.mark.parametrize(
    ("load", "name"),
    [
        (f"names = load_python_launch_file_as_module({PATH})\nname_of = getattr(names, 'name_of')\n", "name_of('arm')"),
        (
            f"spec = importlib.util.spec_from_file_location('names', {PATH})\n"
            "names = importlib.util.module_from_spec(spec)\nspec.loader.exec_module(names)\n",
            "names.name_of('arm')",
        ),
        (f"names = SourceFileLoader('names', {PATH}).load_module()\n", "names.name_of('arm')"),
        (f"name_of = runpy.run_path({PATH})['name_of']\n", "name_of('arm')"),
    ],
)
def test_a_function_of_a_file_beside_the_launch_file(launches, load: str, name: str):
    launches.file("robot/launch/lib/names.py", HELPER)
    launched = launches.python(f"[Node(package='robot', executable='talker', name={name})]", IMPORTS + load)
    assert [started.name.text for started in launched.started] == ["arm_node"]


def test_a_file_of_another_package(launches):
    load = "names = load_python_launch_file_as_module('/opt/names.py')\n"
    launched = launches.python("[Node(package='robot', executable='talker', name=names.NAME)]", IMPORTS + load)
    assert [(started.name.text, started.name.reason) for started in launched.started] == [
        (None, "the result of a file that is not followed")
    ]


def test_the_description_of_another_launch_file_as_a_value(launches):
    launches.file(
        "robot/launch/common.launch.py",
        "from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([DeclareLaunchArgument('name', default_value='arm')])\n",
    )
    load = "from launch.launch_description_sources import get_launch_description_from_python_launch_file as described\n"
    path = "get_package_share_directory('robot') + '/launch/common.launch.py'"
    launched = launches.python(
        f"[described({path}), Node(package='robot', executable='talker', name=LaunchConfiguration('name'))]", load
    )
    assert [started.name.text for started in launched.started] == ["arm"] and not launched.gaps


def test_the_description_of_a_launch_file_that_is_not_here(launches):
    load = "from launch.launch_description_sources import get_launch_description_from_python_launch_file as described\n"
    launched = launches.python("[described('/opt/common.launch.py'), Node(package='p', executable='e')]", load)
    assert len(launched.started) == 1 and len(launched.gaps) == 1
