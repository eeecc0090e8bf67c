"""What launch files start, held against the code: who publishes, and which nodes no launch file starts."""

from __future__ import annotations

import pytest

from robot_package import TALKER, node, two

NAMED_BY_PARAMETER = TALKER.replace("String", "Bool").replace(
    "'chatter'", "self.declare_parameter('topic', 'out').value"
)


OF_A_FILE = '<param from="{}"/>'


NOT_FOUND = ["$(find-pkg-share robot)/gone.yaml", "$(find-pkg-share elsewhere)/a.yaml", "$(var config)", "/etc/a.yaml"]


@pytest.mark.parametrize("file", NOT_FOUND)
def test_a_parameter_file_that_is_not_found_may_name_anything(findings, file: str):
    files = {"robot/talker.py": NAMED_BY_PARAMETER}
    assert findings("OWN001", two(OF_A_FILE.format(file)), **files) == []
    (found,) = findings("OWN001", two(OF_A_FILE.format(file) + '<param name="topic" value="both"/>'), **files)
    assert "'/both'" in found.message


STARTS_TWO = """\
import os
from launch import LaunchDescription
from launch_ros.actions import Node
import elsewhere

def generate_launch_description():
    given = GIVEN
    return LaunchDescription([
        Node(package='robot', executable='talker', name=name, PARAMETERS) for name in ('a', 'b')
    ])
"""


@pytest.mark.parametrize(
    ("given", "parameters", "topic"),
    [
        ("elsewhere.load()", "parameters=given", None),
        ("elsewhere.load()", "parameters=[given]", None),
        ("{elsewhere.NAME: 1.0}", "parameters=[given]", None),
        ("elsewhere.load()", "**given", None),
        ("elsewhere.load()", "parameters=[given, {'topic': 'both'}]", "/both"),  # what comes later holds
        ("elsewhere.load()", "parameters=[{'rate': given}]", "/out"),  # only the value is not known
        ("[{'rate': 1.0}] if os.environ.get('FAST') else [{'rate': 2.0}]", "parameters=given", "/out"),
        ("{'rate': 1.0} if os.environ.get('FAST') else {'rate': 2.0}", "parameters=[given]", "/out"),
    ],
)
def test_parameters_that_are_not_known_may_name_anything(findings, given: str, parameters: str, topic: str | None):
    launch = STARTS_TWO.replace("GIVEN", given).replace("PARAMETERS", parameters)
    files = {"robot/talker.py": NAMED_BY_PARAMETER, "launch/two.launch.py": launch}
    told = [found.message for found in findings("OWN001", **files)]
    assert [f"'{topic}'" in message for message in told] == ([] if topic is None else [True])


def test_a_parameter_file_that_is_found_leaves_the_other_defaults(findings):
    files = {"robot/talker.py": NAMED_BY_PARAMETER, "config/a.yaml": "/**: {ros__parameters: {rate: 2.0}}"}
    (found,) = findings("OWN001", two(OF_A_FILE.format("$(find-pkg-share robot)/config/a.yaml")), **files)
    assert "'/out'" in found.message
    gone = OF_A_FILE.format("$(find-pkg-share robot)/gone.yaml")
    files = {"robot/talker.py": TALKER.replace("String", "Bool")}
    assert len(findings("OWN001", two(gone), **files)) == 1  # a name that no parameter decides stays


STARTS = """
from launch import LaunchDescription
from launch_ros.actions import Node

PACKAGE = 'robot'

def generate_launch_description():
    talker = Node(package=PACKAGE, executable='talker')
    return LaunchDescription([])
"""


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("launch/more.launch.py", STARTS.replace("'talker'", "'listener'"), True),
        ("launch/more.launch.py", STARTS, False),  # under some condition it may well be returned
        ("launch/more.launch.py", STARTS.replace("'robot'", "'other'"), True),
        (
            "launch/more.launch.py",
            "import os\n\ndef generate_launch_description():\n    os.system(\"xterm -e 'ros2 run robot talker'\")\n",
            False,
        ),
        ("robot/actions.py", STARTS.replace("def generate_launch_description", "def actions"), False),
        ("robot/words.py", "NAMES = ['talker']\n", True),
    ],
)
def test_a_node_that_no_launch_file_speaks_of(findings, name: str, text: str, told: bool):
    assert bool(findings("GRF002", **{name: text})) is told


LONELY = """
import rclpy
{imports}

class Talker({base}):
    def __init__(self):
        super().__init__('talker')
        self.create_subscription(String, 'heard', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("imports", "base", "told"),
    [
        ("from rclpy.node import Node", "Node", True),
        ("from nav2_simple_commander.robot_navigator import BasicNavigator", "BasicNavigator", False),
    ],
)
def test_what_a_base_class_from_elsewhere_publishes_is_not_known(findings, imports: str, base: str, told: bool):
    text = LONELY.format(imports=f"{imports}\nfrom std_msgs.msg import String", base=base)
    closed = "select = ['TOP003']\nclosed-world = true\n"
    assert bool(findings("TOP003", node(), **{"robot/talker.py": text, "archlint.toml": closed})) is told


@pytest.mark.parametrize(
    ("owner", "launch", "clash"),
    [
        ("/left", node(name="left"), False),
        ("/talker", node(name="left"), True),
        ("/talker", node('<remap from="chatter" to="words"/>', name="left"), False),
        ("/talker", "", False),
    ],
)
def test_who_publishes_is_who_is_launched(findings, owner, launch, clash):
    config = {"archlint.toml": f'select = ["OWN003"]\n[owners]\n"/chatter" = "{owner}"\n'}
    assert [one.node for one in findings("OWN003", launch, **config)] == (["/left"] if clash else [])
