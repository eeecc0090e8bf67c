"""LCH010 and LCH014: paths into the home folder of one person."""

from __future__ import annotations

import pytest

PYTHON = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        {action},
        Node(package='robot', executable='talker'),
    ])
"""


def node(arguments: str) -> str:
    return f'<node pkg="robot" exec="talker" args="{arguments}"/>'


@pytest.mark.parametrize(
    "path",
    [
        "/home/maria/maps/hall.yaml",
        "file:///home/maria/hall.world",
        "/Users/maria/maps/hall.yaml",
        "C:/Users/maria/hall.yaml",
    ],
)
def test_a_path_in_an_argument(findings, path):
    (finding,) = findings("LCH010", node(f"--map {path}"))
    assert "is in the home folder of 'maria'" in finding.message


HALL = {"maps/hall.yaml": "image: hall.png\n"}
"""A map in the source folder of the package."""


def test_a_file_of_the_workspace_is_found_through_its_package(findings):
    (finding,) = findings("LCH014", node("--map /home/maria/ros2_ws/src/robot/maps/hall.yaml"), **HALL)
    assert finding.help == "install it, and write $(find-pkg-share robot)/maps/hall.yaml"


@pytest.mark.parametrize(
    ("folder", "written"), [("share/robot/maps", "maps/hall.yaml"), ("share/robot", "hall.yaml"), ("etc", None)]
)
def test_a_file_that_its_package_installs(findings, folder, written):
    """It is named where it comes to: below the share folder, it need not lie as it does in the source folder."""
    setup = f"from setuptools import setup\nsetup(name='robot', data_files=[('{folder}', ['maps/hall.yaml'])])\n"
    (finding,) = findings("LCH014", node("/home/maria/ws/src/robot/maps/hall.yaml"), **HALL, **{"setup.py": setup})
    if written is None:
        assert finding.help == "install it, and write $(find-pkg-share robot)/maps/hall.yaml"
    else:
        assert finding.help == f"write $(find-pkg-share robot)/{written}"


def test_a_file_of_the_workspace_that_a_launch_file_in_python_names(findings):
    action = (
        "DeclareLaunchArgument('map', default_value='/home/maria/ros2_ws/install/robot/share/robot/maps/hall.yaml')"
    )
    (finding,) = findings("LCH014", node(""), **{"launch/python.launch.py": PYTHON.format(action=action)}, **HALL)
    assert finding.help == (
        "install it, and write os.path.join(get_package_share_directory('robot'), 'maps/hall.yaml')"
    )


def test_a_file_of_the_workspace_that_a_parameter_file_names(findings):
    """Substitutions in it are evaluated by launch files in XML and YAML, and on demand alone in Python."""
    launch = '<node pkg="robot" exec="talker"><param from="$(find-pkg-share robot)/config/robot.yaml"/></node>'
    yaml = "talker:\n  ros__parameters:\n    map: /home/maria/ros2_ws/src/robot/maps/hall.yaml\n"
    (finding,) = findings("LCH014", launch, **{"config/robot.yaml": yaml}, **HALL)
    assert (finding.place.file, finding.place.line) == ("config/robot.yaml", 3)
    assert "let the launch file give the parameter" in (finding.help or "")


def test_own_files_of_one_launch_file_are_one_finding(findings):
    path = "/home/maria/ros2_ws/src/robot/maps/hall"
    (finding,) = findings("LCH014", node(f"{path}.yaml") + node(f"{path}.png"), **HALL, **{"maps/hall.png": ""})
    assert finding.message.endswith("; another path of this file is in it, too")


@pytest.mark.parametrize(
    "path",
    [
        "/home/maria/ros2_ws/src/robot/maps/yard.yaml",
        "/home/maria/ros2_ws/src/arm/maps/hall.yaml",
        "/home/maria/maps/hall.yaml",
        "/home/ubuntu/ros2_ws/src/robot/maps/hall.yaml",
        "/opt/robot/maps/hall.yaml",
    ],
    ids=["no such file", "no such package", "not in the package", "an account of every machine", "no home folder"],
)
def test_paths_that_lead_to_no_file_of_the_workspace(findings, path):
    assert findings("LCH014", node(path), **HALL) == []


def test_each_path_is_told_by_one_rule(findings):
    path = "/home/maria/ros2_ws/src/robot/maps/hall.yaml"
    assert findings("LCH010", node(path), **HALL) == []


def test_paths_of_one_file_are_one_finding(findings):
    (finding,) = findings("LCH010", node("/home/maria/a.yaml") + node("/home/maria/b.yaml"))
    assert finding.message.endswith("; another path of this file is in it, too")


def test_a_parameter_file_that_is_loaded(findings):
    launch = '<node pkg="robot" exec="talker"><param from="$(find-pkg-share robot)/config/robot.yaml"/></node>'
    yaml = "talker:\n  ros__parameters:\n    map: /home/maria/hall.yaml\n"
    (finding,) = findings("LCH010", launch, **{"config/robot.yaml": yaml})
    assert (finding.place.file, finding.place.line) == ("config/robot.yaml", 3)


def test_a_launch_file_in_python(findings):
    action = "DeclareLaunchArgument('map', default_value='/home/maria/hall.yaml')"
    files = {"launch/python.launch.py": PYTHON.format(action=action)}
    (finding,) = findings("LCH010", node(""), **files)
    assert (finding.place.file, finding.place.line) == ("launch/python.launch.py", 8)


@pytest.mark.parametrize(
    "action",
    [
        "DeclareLaunchArgument('map', description='such as /home/maria/hall.yaml')",
        "LogInfo(msg='looked in /home/maria/maps')",
        "DeclareLaunchArgument('map', default_value='/home/user/hall.yaml')",
        "DeclareLaunchArgument('map', default_value='/homes/maria/hall.yaml')",
        "DeclareLaunchArgument('map', default_value='/opt/home/maria/hall.yaml')",
    ],
)
def test_texts_that_are_no_path_of_one_person(findings, action):
    assert findings("LCH010", node(""), **{"launch/python.launch.py": PYTHON.format(action=action)}) == []


@pytest.mark.parametrize(
    "path", ["/home/ubuntu/hall.yaml", "$(env HOME)/hall.yaml", "/opt/robot/hall.yaml", "~/hall.yaml", "/home/maria"]
)
def test_paths_that_others_have_too(findings, path):
    assert findings("LCH010", node(path)) == []


def test_an_account_of_the_image_that_the_workspace_builds(findings):
    dockerfile = "FROM ros:jazzy\nRUN useradd -m maria\nCOPY . /home/maria/ws\n"
    assert findings("LCH010", node("/home/maria/hall.yaml"), Dockerfile=dockerfile) == []


MAP = "image: {image}\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"


@pytest.mark.parametrize("image", ["/home/maria/maps/hall.pgm", "'/home/maria/maps/hall.pgm'"])
def test_the_image_of_a_map(findings, image):
    files = {"maps/hall.yaml": MAP.format(image=image), "maps/hall.pgm": "P5"}
    (finding,) = findings("LCH014", node(""), **files)
    assert (finding.place.file, finding.place.line) == ("maps/hall.yaml", 1)
    assert finding.message.startswith("'/home/maria/maps/hall.pgm' is in the home folder of 'maria'")
    assert finding.help == "write image: hall.pgm, which is looked for beside the map"


@pytest.mark.parametrize(
    ("text", "beside"),
    [
        (MAP.format(image="hall.pgm"), "hall.pgm"),
        (MAP.format(image="/home/maria/maps/hall.pgm"), "yard.pgm"),  # it is somewhere else
        (MAP.format(image="/home/ubuntu/maps/hall.pgm"), "hall.pgm"),
        ("image: /home/maria/maps/hall.pgm\n", "hall.pgm"),  # no map
        (MAP.format(image="hall.pgm") + "# image: /home/maria/hall.pgm\n", "hall.pgm"),
    ],
)
def test_the_image_of_a_map_that_others_find(findings, text, beside):
    assert findings("LCH014", node(""), **{"maps/hall.yaml": text, f"maps/{beside}": "P5"}) == []


UNREAD = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    {lines}
    return LaunchDescription([Node(package='robot', executable='talker', arguments=[{argument}])])
"""


@pytest.mark.parametrize(
    ("value", "argument", "told"),
    [
        ("'/home/maria/ros2_ws/src/robot/maps/hall.yaml'", "", False),
        ("os.path.join('/home/maria/ros2_ws/src/robot/maps/hall.yaml')", "", False),
        ("'/home/maria/ros2_ws/src/robot/maps/hall.yaml'", "map_path", True),
        ("'/home/maria/ros2_ws/src/robot/maps/hall.yaml'", "f'--map={map_path}'", True),
        ("open('/home/maria/ros2_ws/src/robot/maps/hall.yaml')", "", True),
    ],
    ids=["a text", "a joined path", "it is given", "it is in a text", "a file is opened"],
)
def test_a_variable_that_nothing_reads(findings, value, argument, told):
    """What it holds is a leftover: no machine misses the file."""
    text = UNREAD.format(lines=f"map_path = {value}", argument=argument)
    assert bool(findings("LCH014", node(""), **{"launch/python.launch.py": text}, **HALL)) is told
