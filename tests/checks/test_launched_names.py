"""Names of nodes and topics as launch files give them: NME001, NME002, TOP004."""

from __future__ import annotations

import pytest

from archlint.finding import Finding, Severity
from robot_package import SETUP, TALKER, UNDER_CONDITIONS, node

XML = """
<push_ros_namespace namespace="a-b"/>
<node pkg="robot" exec="talker" name="my-talker" namespace="/ro bot">
  <remap from="chatter" to="1st"/>
</node>
<node pkg="elsewhere" exec="other" name="2nd"/>
<node pkg="elsewhere" exec="other" name="third"/>"""


YAML = """\
launch:
- node:
    pkg: robot
    exec: talker
    name: my-talker
    remap:
    - {from: chatter, to: good}
    - from: other
      to: not good
"""


def told(found: list[Finding]) -> list[tuple[str, int, str]]:
    """File, line and what was rejected."""
    return [(one.place.file, one.place.line, one.message.partition(":")[0]) for one in found]


def test_each_bad_name_of_a_launch_file_is_told_where_it_is_given(findings):
    found = findings("NME002", XML)
    assert told(found) == [
        ("launch/it.launch.xml", 3, "ROS rejects the name of the node 'my-talker'"),
        ("launch/it.launch.xml", 3, "ROS rejects the namespace '/ro bot'"),
        ("launch/it.launch.xml", 4, "ROS rejects the name '1st', the target of this remapping"),
        ("launch/it.launch.xml", 6, "ROS rejects the namespace '/a-b'"),
        ("launch/it.launch.xml", 6, "ROS rejects the name of the node '2nd'"),
    ]
    assert [one.place.line for one in found[3].related] == [7]  # the namespace is pushed once, for both


def test_a_namespace_that_all_nodes_are_given_is_one_finding(findings):
    nodes = "".join("\n" + node(name=name, namespace="a-b") for name in ("left", "right", "rear"))
    (found,) = findings("NME002", nodes)
    assert (found.place.line, found.message.partition(":")[0]) == (2, "ROS rejects the namespace '/a-b'")
    assert [related.place.line for related in found.related] == [3, 4]


@pytest.mark.parametrize(("default", "told"), [("-", 0), ("", 0), ("robot-1", 1)])
def test_an_argument_whose_default_says_nothing_waits_for_a_value(findings, default: str, told: int):
    launch = f'<arg name="robot" default="{default}"/>' + node(namespace="$(var robot)", name="it-is" if told else "it")
    assert len([one for one in findings("NME002", launch) if "namespace" in one.message]) == told


def test_a_default_of_a_launch_configuration_that_says_nothing_waits_too(findings):
    launch = """\
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    robot = LaunchConfiguration('robot', default={default!r})
    return LaunchDescription([Node(package='robot', executable='talker', namespace=robot)])
"""
    assert findings("NME002", **{"launch/two.launch.py": launch.format(default="-")}) == []
    assert len(findings("NME002", **{"launch/two.launch.py": launch.format(default="robot-1")})) == 1


def test_bad_names_in_yaml_and_python(findings):
    found = findings("NME002", **{"launch/two.launch.yaml": YAML})
    assert told(found) == [
        ("launch/two.launch.yaml", 5, "ROS rejects the name of the node 'my-talker'"),
        ("launch/two.launch.yaml", 8, "ROS rejects the name 'not good', the target of this remapping"),
    ]
    code = UNDER_CONDITIONS.format(first="None, name='my-talker'", second="None, name=LaunchConfiguration('real')")
    (one,) = findings("NME002", **{"launch/two.launch.yaml": "", "launch/it.launch.py": code})
    assert told([one]) == [("launch/it.launch.py", 12, "ROS rejects the name of the node 'my-talker'")]


ROUNDS = """\
from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace

def generate_launch_description():
    nodes = []
    for name in ('{one}', '{other}'):
        nodes.append(GroupAction([PushRosNamespace('{root}'), Node(
            package='robot', executable='talker', namespace=name)]))
    return LaunchDescription(nodes)
"""


def test_the_rounds_of_a_loop_are_one_bad_name(findings):
    (one,) = findings("NME002", **{"launch/it.launch.py": ROUNDS.format(root="/", one="2d", other="3d")})
    assert told([one]) == [("launch/it.launch.py", 9, "ROS rejects the namespace '/2d'")]
    assert ["'/3d'" in related.message for related in one.related] == [True]
    assert findings("NME002", **{"launch/it.launch.py": ROUNDS.format(root="/", one="left", other="right")}) == []


def test_a_name_that_launch_files_replace_is_judged_as_they_give_it(findings):
    bad = {"robot/talker.py": TALKER.replace("'talker'", "'my-talker'")}
    assert findings("NME002", node(name="good"), **bad) == []
    (one,) = findings("NME002", node(), **bad)
    assert (one.place.file, one.place.line) == ("robot/talker.py", 7)


CONTAINER = """
<node_container pkg="rclcpp_components" exec="component_container" name="{}" namespace="">
  <composable_node pkg="elsewhere" plugin="elsewhere::Hearer" name="{}"/>
</node_container>
"""


def test_a_container_takes_an_empty_name_of_a_component_for_none(findings):
    assert findings("NME002", CONTAINER.format("box", "")) == []
    (one,) = findings("NME002", CONTAINER.format("box", "2nd"))
    assert "'2nd'" in one.message


def test_a_name_that_waits_for_an_argument_is_not_bad(findings):
    """Without a value for ``robot`` nothing works, and nobody starts it so."""
    text = '<arg name="robot" default="{}"/><node pkg="robot" exec="talker"><remap from="{}" to="pose"/></node>'
    assert findings("NME002", text.format("", "/model/$(var robot)/pose")) == []
    (one,) = findings("NME002", text.format("", "/model/2d/pose"))
    assert "2d" in one.message
    assert len(findings("NME002", text.format("a", "/model//pose"))) == 1


HEARER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Hearer(Node):
    def __init__(self):
        super().__init__('hearer')
        self.create_subscription(String, 'chatter', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Hearer())
"""


TWO_NODES = {
    "setup.py": SETUP.replace("robot.talker:main'", "robot.talker:main', 'hearer = robot.hearer:main'"),
    "robot/hearer.py": HEARER,
}


IN_NAMESPACE = """\
import sys
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    namespace = 'left'
    for word in WORDS:
        if word.startswith('namespace:='):
            namespace = word.split(':=')[1]
    return LaunchDescription([
        Node(package='robot', executable='talker', namespace=namespace),
        Node(package='robot', executable='hearer'),
    ])
"""


def test_one_name_in_two_namespaces(findings):
    (found,) = findings("TOP004", node(namespace="left") + node(exec="hearer"), **TWO_NODES)
    assert found.message.endswith("; both write 'chatter'")
    assert found.help == "give /hearer and /left/talker the same namespace in the launch file"
    assert findings("TOP004", node(namespace="left") + node(exec="hearer", namespace="left"), **TWO_NODES) == []


def test_one_name_that_the_launch_file_remaps_at_one_end(findings):
    remapped = node('<remap from="chatter" to="chater"/>')
    (found,) = findings("TOP004", remapped + node(exec="hearer"), **TWO_NODES)
    assert found.help == "use the same name at both ends, or remap one in the launch file"


@pytest.mark.parametrize(
    ("inside", "arguments", "told"),
    [
        ('<param name="in" value="chater"/>', "", 0),
        ('<param from="$(find-pkg-share robot)/config/p.yaml"/>', "", 0),
        ('<remap from="out" to="chatter"/>', "", 0),
        ("", "/chatter@std_msgs/msg/String[gz.msgs.StringMsg", 0),
        ('<param name="in" value="words"/>', "/chatterbox", 1),
    ],
)
def test_a_node_that_was_not_read_may_be_the_partner(findings, inside: str, arguments: str, told: int):
    """A driver in C++ is told the name by its parameters, a remapping or its command line."""
    yaml = "/**: {ros__parameters: {topics: [odom, chater]}}"
    driver = node(inside, pkg="driver", exec="driver", name="driver", args=arguments)
    remapped = node('<remap from="chatter" to="chater"/>')
    found = findings("TOP004", remapped + node(exec="hearer") + driver, **TWO_NODES, **{"config/p.yaml": yaml})
    assert len(found) == told


def test_a_line_that_misses_its_partner_in_each_namespace_is_said_once(findings):
    pairs = [
        node('<remap from="chatter" to="chater"/>', namespace=side) + node(exec="hearer", namespace=side)
        for side in ("left", "right")
    ]
    (found,) = findings("TOP004", "".join(pairs), **TWO_NODES)
    assert found.message.startswith("no node publishes '/left/chatter'")


def test_a_publisher_that_never_publishes_is_not_the_one_that_was_meant(findings):
    remapped = node('<remap from="chatter" to="chater"/>') + node(exec="hearer")
    kept = TALKER.replace("self.create_publisher", "self.unused = self.create_publisher")
    assert findings("TOP004", remapped, **TWO_NODES, **{"robot/talker.py": kept}) == []
    used = kept + "\ndef say(talker):\n    talker.unused.publish(String())\n"
    assert len(findings("TOP004", remapped, **TWO_NODES, **{"robot/talker.py": used})) == 1


@pytest.mark.parametrize(
    ("named", "told"),
    [
        ({}, 1),
        ({"name": "talker"}, 1),
        ({"name": "driver"}, 1),
        ({"name": "Talker"}, 0),
        ({"name": "Talker", "namespace": "left"}, 0),
    ],
)
def test_a_private_name_as_a_launch_file_makes_it(findings, named: dict[str, str], told: int):
    """``ros2 run robot hearer`` beside the launch file meets the talker, if that has the name that it writes."""
    code = {
        **TWO_NODES,
        "robot/talker.py": TALKER.replace("'chatter'", "'~/chatter'"),
        "robot/hearer.py": HEARER.replace("'chatter'", "'Talker/chatter'"),
    }
    assert len(findings("TOP004", node(**named), **code)) == told


@pytest.mark.parametrize(("words", "told"), [("sys.argv", 0), ("['verbose:=true']", 1)])
def test_a_namespace_from_the_command_line_is_not_known(findings, words, told):
    launch = {"launch/it.launch.xml": "<launch/>", "launch/two.launch.py": IN_NAMESPACE.replace("WORDS", words)}
    assert len(findings("TOP004", **TWO_NODES, **launch)) == told


def absolute(*names: str) -> dict[str, str]:
    """The talker with a publisher for each name."""
    lines = "".join(f"        self.create_publisher(String, '{name}', 10)\n" for name in names)
    return {"robot/talker.py": TALKER.replace("        self.create_publisher(String, 'chatter', 10)\n", lines)}


@pytest.mark.parametrize(
    ("names", "namespaces", "help"),
    [
        (["/left/words"], ["left"], "write 'words': the launch file starts the node in '/left'"),
        (
            ["/words"],
            ["left"],
            "write 'words', so that the node's namespace applies, or take the name from a parameter",
        ),
        (
            ["/left/words"],
            [""],
            "write 'left/words', so that the node's namespace applies, or take the name from a parameter",
        ),
        (["/lefty/words"], ["left"], "write 'lefty/words', so that"),
        (["/left/words"], ["left", ""], "take the name from a parameter: self.declare_parameter('words_name'"),
        (
            ["/left/words", "/left/more"],
            ["left"],
            "remove '/left/', the namespace in which the launch file starts the node",
        ),
        (
            ["/left/words", "/arm/state"],
            ["left"],
            "remove '/left/', the namespace in which the launch file starts the node, "
            "and take the other names from parameters",
        ),
        (["/left/words", "/arm/state"], ["left", "right"], "take the names from parameters"),
        (["/words", "/state"], ["left", "right"], "remove the leading '/'"),
    ],
)
def test_the_name_to_write_in_the_namespace_that_the_launch_file_gives(findings, names, namespaces, help):
    launch = "".join(node(**({"namespace": one} if one else {})) for one in namespaces)
    (found,) = findings("NME001", launch, **absolute(*names))
    assert found.help is not None and found.help.startswith(help)


@pytest.mark.parametrize(
    ("names", "namespace", "severity"),
    [
        (
            ["/words", "said"],
            {"namespace": "left"},
            None,
        ),  # the relative name is this node's, the other is not
        (["/words", "said"], {}, Severity.WARNING),
        (["/words"], {"namespace": "left"}, Severity.WARNING),
    ],
)
def test_an_absolute_name_beside_relative_ones_in_a_namespace(findings, names, namespace, severity: Severity | None):
    found = findings("NME001", node(**namespace), **absolute(*names))
    assert [one.severity for one in found] == ([] if severity is None else [severity])


@pytest.mark.parametrize(
    ("launch", "severity"),
    [
        (node('<remap from="/words" to="said"/>'), None),
        (node('<remap from="/words" to="said"/>') + node(name="other"), Severity.WARNING),  # here it stays
        (node('<remap from="words" to="said"/>', namespace="left"), Severity.WARNING),  # which is /left/words
    ],
)
def test_a_name_that_every_launch_file_remaps(findings, launch: str, severity: Severity | None):
    found = findings("NME001", launch, **absolute("/words"))
    assert [one.severity for one in found] == ([] if severity is None else [severity])


def test_the_namespace_that_an_including_file_gives(findings):
    include = '<include file="$(find-pkg-share robot)/launch/it.launch.xml"/>'
    outer = f'<launch><group><push-ros-namespace namespace="left"/>{include}</group></launch>'
    files = {"launch/all.launch.xml": outer, **absolute("/left/words")}
    (found,) = findings("NME001", node(), **files)
    assert found.help == "write 'words': the launch file starts the node in '/left'"


@pytest.mark.parametrize(
    ("parameter", "place"),
    [
        ('<param name="robot" value="p2, p3"/>', ("launch/it.launch.xml", 1)),
        ('<param from="$(find-pkg-share robot)/config/p.yaml"/>', ("config/p.yaml", 3)),
    ],
)
def test_the_value_that_makes_bad_names_is_told_where_it_is_set(findings, parameter: str, place: tuple[str, int]):
    lines = "robot = self.declare_parameter('robot', 'p1').value\n        "
    lines += "".join(f"self.create_publisher(String, f'/{{robot}}/{name}', 10)\n        " for name in ("pose", "goal"))
    files = {
        "robot/talker.py": TALKER.replace("self.declare_parameter('rate', 1.0)", lines),
        "config/p.yaml": "talker:\n  ros__parameters:\n    robot: 'p2, p3'\n",
    }
    (found,) = findings("NME002", node(parameter), **files)
    assert (found.place.file, found.place.line) == place
    assert "'/p2, p3/goal', which is built from this value of the parameter 'robot'" in found.message
    assert len(found.related) == 2
    assert findings("NME002", node(parameter.replace("p2, p3", "p2")), **files | {"config/p.yaml": ""}) == []


@pytest.mark.parametrize(
    "test",
    [
        "not prefix.startswith('/')",
        "prefix[0] != '/'",
        "prefix[:1] != '/'",
    ],
)
def test_a_prefix_that_the_code_completes(findings, test: str):
    """Of a callback, that might see another value: what the test proves of the prefix is known all the same."""
    told = node('<param name="prefix" value="/perception"/>')
    lines = f"""prefix = self.get_parameter('prefix').value.rstrip('/')
        if {test}:
            prefix = '/' + prefix
        self.create_publisher(String, f'{{prefix}}/mask', 10)
"""
    code = TALKER.replace(
        "self.declare_parameter('rate', 1.0)",
        "self.declare_parameter('prefix', '/perception')\n        self.create_timer(1.0, self.start)",
    ).replace("def main", f"    def start(self):\n        {lines}\n\ndef main")
    assert findings("NME002", told, **{"robot/talker.py": code}) == []
    assert len(findings("NME002", told, **{"robot/talker.py": code.replace("!=", "==").replace("not ", "")})) == 1


@pytest.mark.parametrize(
    ("default", "launch", "told"),
    [
        ("''", "", False),  # whoever starts it by hand sees that it is missing
        ("''", node('<param name="topic" value="words"/>'), False),
        ("''", node(), True),
        ("'my words'", "", True),
    ],
)
def test_an_empty_default_is_for_a_parameter_that_has_to_be_set(findings, default: str, launch: str, told: bool):
    lines = f"self.create_publisher(String, self.declare_parameter('topic', {default}).value, 10)"
    files = {"robot/talker.py": TALKER.replace("self.declare_parameter('rate', 1.0)", lines)}
    assert len(findings("NME002", launch, **files)) == told


TOPIC = """\
import rclpy
from std_msgs.msg import String

def main():
    rclpy.init()
    node = rclpy.create_node('talker')
    topic = node.declare_parameter('topic', '').value
    node.create_publisher(String, topic, 10)
    rclpy.spin(node)
"""


@pytest.mark.parametrize(
    ("launch", "lines"),
    [
        ('<node pkg="robot" exec="talker"><param name="topic" value="words"/></node>', []),
        ('<node pkg="robot" exec="talker"><param name="topic" value="$(env TOPIC)"/></node>', []),
        ('<node pkg="robot" exec="talker"/>', [8]),
        ('<node pkg="robot" exec="viewer"/>', []),  # nothing starts it but who sees that it is missing
    ],
)
def test_the_default_of_a_parameter_that_launch_files_set(findings, launch: str, lines: list[int]):
    found = findings("NME002", launch, **{"robot/talker.py": TOPIC})
    assert [one.place.line for one in found] == lines


@pytest.mark.parametrize(
    ("default", "told"),
    [
        ("['/scan']", []),  # substitutions, which launch joins to one text: no list with a topic '/'
        ("'/scan'", []),
        ("""'["/scan"]'""", []),
        ("""["['/sc", "an/']"]""", ["/scan/"]),
        ("""'["/"]'""", ["/"]),
    ],
)
@pytest.mark.parametrize("declared", ["['/odom', '/imu']", "Parameter.Type.STRING_ARRAY"])
def test_a_list_of_names_that_a_launch_argument_sets(findings, declared, default, told):
    launch = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    topics = {{'topics': LaunchConfiguration('topics')}}
    return LaunchDescription([
        DeclareLaunchArgument('topics', default_value={default}),
        Node(package='robot', executable='talker', parameters=[topics]),
    ])
"""
    lines = f"topics = self.declare_parameter('topics', {declared}).value\n        "
    lines += "self.create_publisher(String, topics[0], 10)"
    talker = TALKER.replace("self.declare_parameter('rate', 1.0)", lines)
    files = {"robot/talker.py": "from rclpy.parameter import Parameter\n" + talker, "launch/all.launch.py": launch}
    messages = [finding.message for finding in findings("NME002", **files)]
    assert [message.split("'")[1] for message in messages] == told


@pytest.mark.parametrize(("default", "told"), [("", 0), (", ''", 1), (", 'camera/image'", 0)])
def test_a_name_of_a_file_that_is_not_here_is_not_empty_where_the_file_has_none(findings, default: str, told: int):
    """launch refuses the None that stands for it, and ROS never sees it."""
    launch = f"""\
import os
import yaml
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node

def load(path):
    with open(path) as file:
        return yaml.safe_load(file) or {{}}

def start(context):
    topic = load(os.environ['CONFIG']).get('camera', {{}}).get('topic'{default})
    return [Node(package='robot', executable='talker', remappings=[(topic, '/camera')])]

def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=start)])
"""
    assert len(findings("NME002", **{"launch/py.launch.py": launch})) == told
