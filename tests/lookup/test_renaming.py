"""Renaming: every end, or nothing with the reason."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.lookup.answers import Refused, Renamable
from archlint.lookup.renamable import prepare_rename
from archlint.lookup.texts import Texts
from archlint.place import Place
from lookup.asking import Editor
from robot_package import manifest, write_files

SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    packages=['robot'],
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main', 'listener = robot.listener:main']},
)
"""
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger
{before}

class It(Node):
    def __init__(self):
        super().__init__('{name}')
{body}

    def on(self, message):
        pass


def main():
    rclpy.init()
    rclpy.spin(It())
"""


def node(name: str, *body: str, before: str = "") -> str:
    return NODE.format(name=name, body="\n".join(f"        {line}" for line in body), before=before)


def publish(name: str) -> str:
    return f"self.create_publisher(String, {name}, 10)"


def subscribe(name: str) -> str:
    return f"self.create_subscription(String, {name}, self.on, 10)"


def robot_with(folder: Path, talker: str, listener: str = "", **files: str) -> Editor:
    texts = {"setup.py": SETUP, "package.xml": manifest(more="<exec_depend>std_srvs</exec_depend>")}
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    write_files(folder, {**texts, "robot/__init__.py": "", "robot/talker.py": talker, "robot/listener.py": listener})
    write_files(folder, named)
    return Editor()


# ------------------------------------------------------------------------------------------------------- topics


def test_both_ends_of_a_topic(lesson: Editor):
    edits = [
        "control_node.py:14 'readings',",
        "sensor_node.py:13 SensorReading, 'readings', 10)",
    ]
    assert lesson.rename("sensor_node.py", "'sensor^_data'", "readings") == edits
    assert lesson.rename("control_node.py", "'sensor^_data'", "readings") == edits


def test_a_service_from_the_client(lesson: Editor):
    assert lesson.rename("control_node.py", "'set^_motor'", "motor/set") == [
        "control_node.py:22 SetMotorSpeed, 'motor/set')",
        "motor_node.py:12 'motor/set',",
    ]


def test_each_end_keeps_its_form(robot: Path):
    editor = robot_with(robot, node("talker", publish("'~/chatter'")), node("listener", subscribe("'/talker/chatter'")))
    assert editor.rename("talker.py", "'~/chat^ter'", "~/speech") == [
        "listener.py:10 self.create_subscription(String, '/talker/speech', self.on, 10)",
        "talker.py:10 self.create_publisher(String, '~/speech', 10)",
    ]
    assert editor.rename("listener.py", "'/talker/chat^ter'", "/speech") == [
        "listener.py:10 self.create_subscription(String, '/speech', self.on, 10)",
        "talker.py:10 self.create_publisher(String, '/speech', 10)",
    ]


def test_a_name_in_the_code_takes_the_remapping_along(launched: Editor):
    assert launched.rename("driver.py", "'sc^an'", "laser") == [
        'robot.launch.xml:9 <remap from="laser" to="$(var scan)"/>',
        "driver.py:10 self.subscription = self.create_subscription(String, 'laser', self.drive, 10)",
    ]
    assert launched.rename("robot.launch.xml", 'from="sc^an"', "laser") == launched.rename(
        "driver.py", "'sc^an'", "laser"
    )


def test_the_target_of_a_remapping_and_the_value_of_a_parameter(launched: Editor):
    edits = [
        "patrol.yaml:4 topic: rear/scan",
        "fleet.launch.py:24 robot('north', '/north/rear/scan'),",
    ]
    assert launched.rename("fleet.launch.py", "'/north^/front/scan'", "/north/rear/scan") == edits
    assert launched.rename("patrol.yaml", "topic: fr^ont/scan", "rear/scan") == edits


def test_a_class_that_runs_in_several_namespaces(launched: Editor):
    assert launched.rename("driver.py", "'~/st^ate'", "~/mode") == [
        "driver.py:9 self.state = self.create_publisher(String, '~/mode', 10)",
        "recorder.py:9 self.north = self.create_subscription(String, 'north/base/wheels/mode', self.write, 10)",
        "recorder.py:10 self.south = self.create_subscription(String, 'south/base/wheels/mode', self.write, 10)",
    ]


def test_a_subscription_of_one_of_them_takes_the_other_along(launched: Editor):
    edits = launched.rename("recorder.py", "'north/base/wheels^/state'", "north/base/wheels/mode")
    assert edits == launched.rename("driver.py", "'~/st^ate'", "~/mode")


def test_one_of_them_cannot_go_elsewhere_alone(launched: Editor):
    reason = launched.rename("recorder.py", "'north/base/wheels^/state'", "/state")
    both = "`/north/base/wheels/state` and `/south/base/wheels/state` would become one topic, `/state`"
    assert reason == f"cannot rename `north/base/wheels/state`: {both}"


def test_a_constant_of_another_file(robot: Path):
    imported = "from robot.names import CHATTER\n"
    editor = robot_with(
        robot,
        node("talker", publish("CHATTER"), before=imported),
        node("listener", subscribe("CHATTER"), before=imported),
        robot__names_DOT_py="CHATTER = 'chatter'\n",
    )
    assert editor.rename("names.py", "'chat^ter'", "speech") == ["names.py:1 CHATTER = 'speech'"]
    assert editor.rename("talker.py", "(String, CHAT^TER", "speech") == "no name of ROS is written here"


def test_a_parameter_and_its_default(robot: Path):
    talker = node("talker", "topic = self.declare_parameter('topic', 'chatter').value", publish("topic"))
    launch = '<launch><node pkg="robot" exec="talker">\n<param name="topic" value="chatter"/>\n</node></launch>\n'
    editor = robot_with(robot, talker, node("listener", subscribe("'chatter'")), launch__it_DOT_launch_DOT_xml=launch)
    assert editor.rename("listener.py", "'chat^ter'", "speech") == [
        'it.launch.xml:2 <param name="topic" value="speech"/>',
        "listener.py:10 self.create_subscription(String, 'speech', self.on, 10)",
        "talker.py:10 topic = self.declare_parameter('topic', 'speech').value",
    ]


def test_an_edit_works(robot: Path):
    """The workspace with the edits has the same connections under the new name."""
    launch = (
        "launch:\n- node: {pkg: robot, exec: talker, namespace: front}\n"
        "- node:\n    pkg: robot\n    exec: listener\n    remap:\n    - from: chatter\n      to: /front/chatter\n"
    )
    editor = robot_with(
        robot,
        node("talker", publish("'chatter'")),
        node("listener", subscribe("'chatter'")),
        launch__it_DOT_launch_DOT_yaml=launch,
    )
    edits = editor.rename("talker.py", "'chat^ter'", "speech")
    assert edits == [
        "it.launch.yaml:8 to: /front/speech",
        "talker.py:10 self.create_publisher(String, 'speech', 10)",
    ]
    for name, at in (("robot/talker.py", "'chatter'"), ("launch/it.launch.yaml", "/front/chatter")):
        text = (robot / name).read_text()
        (robot / name).write_text(text.replace(at, at.replace("chatter", "speech")))
    [topic] = [topic for topic in Editor().systems[1].topics.values() if topic.name.startswith("/front")]
    assert (topic.name, len(topic.providers), len(topic.users)) == ("/front/speech", 1, 1)


# ----------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("talker", "why"),
    [
        ([publish("f'{chr(99)}hatter'")], "the name of the publisher at robot/talker.py:10 is not known"),
        (["base = 'chat'", publish("base + 'ter'")], "the name of the publisher at robot/talker.py:11 is computed"),
        (["import sys", publish("sys.argv[1]")], "the name of the publisher at robot/talker.py:11 is not known"),
        ([publish("'chatter'"), publish("'speech'")], "there is a topic `/speech` already, at robot/talker.py:11"),
    ],
)
def test_what_is_refused(robot: Path, talker: list[str], why: str):
    editor = robot_with(robot, node("talker", *talker), node("listener", subscribe("'chatter'")))
    reason = editor.rename("listener.py", "'chat^ter'", "speech")
    assert isinstance(reason, str) and reason.startswith("cannot rename `chatter`: ") and why in reason


def test_a_wrapper_that_adds_to_the_name(robot: Path):
    helper = "def topic(name):\n    return f'/robot/{name}'\n"
    editor = robot_with(
        robot,
        node("talker", publish("topic('chatter')"), before=helper),
        node("listener", subscribe("'/robot/chatter'")),
    )
    assert editor.rename("talker.py", "topic('chat^ter')", "speech") == (
        "cannot rename `/robot/chatter`: it is computed here, not written"
    )
    reason = editor.rename("listener.py", "'/robot/chat^ter'", "/robot/speech")
    assert "the name of the publisher at robot/talker.py:12 is computed" in reason


def test_a_name_that_is_none(lesson: Editor):
    reason = lesson.rename("sensor_node.py", "'sensor^_data'", "sensor data")
    assert "`sensor data` is no name: topic name must not contain characters other than" in reason


def test_a_topic_of_every_system(robot: Path):
    editor = robot_with(robot, node("talker", publish("'/joint_states'")), node("listener"))
    assert "`/joint_states` has this name in every ROS 2 system" in editor.rename(
        "talker.py", "'/joint^_states'", "/joints"
    )


def test_one_side_beside_a_node_from_elsewhere(robot: Path):
    launch = '<launch><node pkg="robot" exec="talker"/><node pkg="rviz2" exec="rviz2" name="rviz"/></launch>'
    editor = robot_with(robot, node("talker", publish("'chatter'")), launch__it_DOT_launch_DOT_xml=launch)
    reason = editor.rename("talker.py", "'chat^ter'", "speech")
    assert "only one side of `/chatter` is in this workspace; `/rviz`, whose source is not, may be the other" in reason


def test_a_cpp_source_with_the_name(robot: Path):
    cpp = 'auto sub = create_subscription<String>("chatter", 10, on);\n'
    editor = robot_with(robot, node("talker", publish("'chatter'")), src__heard_DOT_cpp=cpp)
    assert "`/chatter` stands at src/heard.cpp:1, too" in editor.rename("talker.py", "'chat^ter'", "speech")


def test_a_remapping_of_a_node_from_elsewhere(launched: Editor):
    reason = launched.rename("fleet.launch.py", "'spl^it'", "parts")
    assert reason == "cannot rename `split`: it is a name of a node whose source is not in this workspace"


def test_the_default_of_an_argument_that_every_launch_gives(launched: Editor):
    reason = launched.rename("robot.launch.xml", 'default="sc^an"', "laser")
    assert reason == "cannot rename `scan`: this text names nothing in what runs, as far as the workspace says"


def test_another_end_with_the_same_text_that_is_remapped(robot: Path):
    """What the listener calls chatter is not the talker's chatter."""
    launch = (
        '<launch><node pkg="robot" exec="talker"/>\n'
        '<node pkg="robot" exec="listener">\n<remap from="/chatter" to="/other"/>\n</node></launch>\n'
    )
    editor = robot_with(
        robot,
        node("talker", publish("'/chatter'")),
        node("listener", subscribe("'/chatter'")),
        launch__it_DOT_launch_DOT_xml=launch,
    )
    assert editor.rename("talker.py", "'/chat^ter'", "/speech") == [
        "talker.py:10 self.create_publisher(String, '/speech', 10)"
    ]
    assert editor.rename("listener.py", "'/chat^ter'", "/speech") == [
        'it.launch.xml:3 <remap from="/speech" to="/other"/>',
        "listener.py:10 self.create_subscription(String, '/speech', self.on, 10)",
    ]


def test_a_remapping_on_the_command_line_of_a_node(robot: Path):
    launch = '<launch><node pkg="robot" exec="talker" args="--ros-args -r chatter:=speech"/></launch>'
    editor = robot_with(robot, node("talker", publish("'chatter'")), launch__it_DOT_launch_DOT_xml=launch)
    reason = editor.rename("talker.py", "'chat^ter'", "words")
    assert "the remapping of what is created at robot/talker.py:10 is not a plain text" in reason


def test_a_file_that_has_changed(lesson: Editor):
    file = lesson.path("sensor_node.py")
    lesson.buffers[file] = "\n" + (lesson.text_of(file) or "")
    try:
        reason = lesson.rename("control_node.py", "'sensor^_data'", "readings")
        assert "sensor_node.py has changed since archlint looked at it" in reason
    finally:
        lesson.buffers.clear()


def test_the_range_of_a_name(lesson: Editor):
    answer = prepare_rename(lesson.index, Texts(lesson.text_of), *lesson.position("sensor_node.py", "'sensor^_data'"))
    assert isinstance(answer, Renamable)
    assert (answer.text, Texts(lesson.text_of).at(answer.place)) == ("sensor_data", "sensor_data")
    asked = lesson.position("sensor_node.py", "msg.sensor_name = 'temper^ature'")
    assert prepare_rename(lesson.index, Texts(lesson.text_of), *asked) is None


def test_a_name_that_is_made_where_it_is_used(robot: Path):
    editor = robot_with(robot, node("talker", "side = 'left'", publish("f'{side}/wheel'")))
    answer = prepare_rename(editor.index, Texts(editor.text_of), *editor.position("talker.py", "f'{side}/wh^eel'"))
    assert answer == Refused(
        "cannot rename `/left/wheel`: it is computed here, not written", Place("robot/talker.py", 11, 39, 11, 54)
    )


# --------------------------------------------------------------------------------------------------- parameters

DECLARED = "self.declare_parameter('rate', 2.0)"


def test_a_parameter_everywhere(robot: Path):
    talker = node("talker", DECLARED, "self.rate = self.get_parameter('rate').value")
    launch = (
        '<launch><node pkg="robot" exec="talker">\n<param name="rate" value="4.0"/>\n'
        '<param from="$(find-pkg-share robot)/config/params.yaml"/></node></launch>\n'
    )
    params = "talker:\n  ros__parameters:\n    rate: 3.0\n"
    editor = robot_with(
        robot, talker, node("listener"), launch__it_DOT_launch_DOT_xml=launch, config__params_DOT_yaml=params
    )
    edits = [
        "params.yaml:3 period: 3.0",
        'it.launch.xml:2 <param name="period" value="4.0"/>',
        "talker.py:10 self.declare_parameter('period', 2.0)",
        "talker.py:11 self.rate = self.get_parameter('period').value",
    ]
    assert editor.rename("params.yaml", "ra^te: 3.0", "period") == edits
    assert editor.rename("talker.py", "get_parameter('ra^te')", "period") == edits


def test_a_parameter_that_the_node_sets_and_is_told_of(robot: Path):
    changed = "    def changed(self, parameters):\n        for parameter in parameters:\n"
    asked = "            if parameter.name == 'rate':\n                pass\n\n    def on("
    talker = node(
        "talker",
        DECLARED,
        "self.add_on_set_parameters_callback(self.changed)",
        "self.set_parameters([Parameter('rate', value=3.0)])",
        before="from rclpy.parameter import Parameter\n",
    ).replace("    def on(", f"{changed}{asked}")
    editor = robot_with(robot, talker)
    assert editor.rename("talker.py", "declare_parameter('ra^te'", "period") == [
        "talker.py:11 self.declare_parameter('period', 2.0)",
        "talker.py:13 self.set_parameters([Parameter('period', value=3.0)])",
        "talker.py:17 if parameter.name == 'period':",
    ]


def test_a_nested_key(robot: Path):
    talker = node("talker", "self.declare_parameter('limits.speed', 2.0)")
    loaded = '<param from="$(find-pkg-share robot)/config/params.yaml"/>'
    launch = f'<launch><node pkg="robot" exec="talker">{loaded}</node></launch>'
    params = "talker:\n  ros__parameters:\n    limits:\n      speed: 3.0\n"
    editor = robot_with(robot, talker, "", launch__it_DOT_launch_DOT_xml=launch, config__params_DOT_yaml=params)
    edits = ["params.yaml:4 top: 3.0", "talker.py:10 self.declare_parameter('limits.top', 2.0)"]
    assert editor.rename("params.yaml", "spe^ed: 3.0", "top") == edits
    assert editor.rename("talker.py", "'limits.sp^eed'", "limits.top") == edits
    assert "`speed` cannot be written at config/params.yaml:4, below `limits`" in editor.rename(
        "talker.py", "'limits.sp^eed'", "speed"
    )


@pytest.mark.parametrize(
    ("body", "why"),
    [
        (["known = 'rate' in self.seen"], "`rate` stands at robot/talker.py:11, too, and what that means is not known"),
        (["self.declare_parameter('period', 1.0)"], "`period` is declared already, at robot/talker.py:11"),
        (["self.get_parameter(self.which)"], "the name that is read at robot/talker.py:11 is not known"),
    ],
)
def test_parameters_that_are_refused(robot: Path, body: list[str], why: str):
    editor = robot_with(robot, node("talker", DECLARED, *body))
    reason = editor.rename("talker.py", "declare_parameter('ra^te'", "period")
    assert isinstance(reason, str) and why in reason


def test_a_parameter_of_rclpy(robot: Path):
    editor = robot_with(robot, node("talker", "self.get_parameter('use_sim_time')"))
    assert "rclpy itself declares `use_sim_time`" in editor.rename("talker.py", "'use_sim^_time'", "simulated")
