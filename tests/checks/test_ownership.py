from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.checks.ownership import multiple_publishers
from archlint.checks.registry import Options
from archlint.checks.servers import multiple_servers
from archlint.config.settings import load
from archlint.engine.merging import folded
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from archlint.ros.well_known import OF_MANY_PUBLISHERS
from archlint.rulebook import pages_folder
from archlint.systems.model import System
from archlint.testing.pages import read_page
from checks.judging import Judge
from systems.builders import (
    action_server,
    client,
    node,
    partial,
    place,
    publisher,
    service,
    subscriber,
    system,
)

NOTHING_SAID = Options(own={"texts": True, "occasions": True})
TWIST = "geometry_msgs/msg/Twist"


def owners(judged: System, options: Options = NOTHING_SAID) -> list[tuple[str, ...]]:
    """The nodes of each finding of OWN001."""
    return [_nodes(finding.identity) for finding in multiple_publishers(judged, options)]


def servers(judged: System) -> list[tuple[str, ...]]:
    return [_nodes(finding.identity) for finding in multiple_servers(judged, NOTHING_SAID)]


def _nodes(identity: tuple[str, ...]) -> tuple[str, ...]:
    return identity[2:]


class TestMultiplePublishers:
    def test_two_nodes(self):
        nodes = [node(name, publisher("cmd_vel", TWIST)) for name in ("/joystick", "/planner")]
        judged = system(*nodes, name="launch/robot.launch.py")

        [finding] = multiple_publishers(judged, NOTHING_SAID)

        assert finding.place.file.endswith("planner.py")
        assert [related.place.file for related in finding.related] == ["src/demo/demo/joystick.py"]
        assert finding.message == "/joystick and /planner both publish the topic '/cmd_vel'"
        assert finding.severity is Severity.WARNING

    def test_a_node_whose_program_was_followed_in_part(self):
        nodes = [node(name, publisher("cmd_vel", TWIST)) for name in ("/joystick", "/planner")]
        assert nodes[1].program is not None
        nodes[1].program.exhausted = True  # on which occasions it publishes is not known
        assert owners(system(*nodes, name="launch/robot.launch.py")) == []

    @pytest.mark.parametrize(
        ("topic", "found"),
        [
            ("/initialpose", []),
            ("/clicked_point", []),
            ("/goal_pose", [("/monitor", "/starter")]),
            ("/robot_1/pose", [("/monitor", "/starter")]),
        ],
    )
    def test_what_is_clicked_into_rviz_has_several_sources(self, topic: str, found: list[tuple[str, ...]]):
        nodes = [node(name, publisher(topic, "geometry_msgs/msg/PoseStamped")) for name in ("/monitor", "/starter")]

        assert owners(system(*nodes, name="launch/robot.launch.py")) == found

    def test_what_nothing_starts_together_are_alternatives(self):
        drivers = [node("/joystick", publisher("cmd_vel", TWIST)), node("/planner", publisher("cmd_vel", TWIST))]
        arms = [node("/left", service("home")), node("/right", service("home"))]

        assert owners(system(*drivers)) == []
        assert owners(system(*drivers, name="launch/robot.launch.py")) == [("/joystick", "/planner")]
        assert servers(system(*arms)) == []
        assert servers(system(*arms, name="launch/robot.launch.py")) == [("/left", "/right")]
        assert servers(system(*arms, closed=True)) == [("/left", "/right")]

    def test_many_nodes_on_one_topic_have_it_for_all_of_them(self):
        nodes = [node(f"/{name}", publisher("state")) for name in "abcd"]

        assert owners(system(*nodes[:3], name="launch/robot.launch.py")) == [("/a", "/b", "/c")]
        assert owners(system(*nodes, name="launch/robot.launch.py")) == []

    @pytest.mark.parametrize(("package", "found"), [("walking", []), ("driving", [("/base", "/legs", "/watcher")])])
    def test_what_a_helper_of_several_packages_publishes_is_for_all(self, package: str, found: list[tuple[str, ...]]):
        nodes = [
            node("/base", publisher("shapes", "robot_msgs/msg/Shapes"), package="driving"),
            node("/legs", publisher("shapes", "robot_msgs/msg/Shapes"), package=package),
            node("/watcher", publisher("shapes", "robot_msgs/msg/Shapes"), package="watching"),
        ]
        for helped in nodes[:2]:
            assert helped.blueprint is not None
            helped.blueprint.creations[0].place = place("helpers/drawing.py", 12)

        assert owners(system(*nodes, name="launch/robot.launch.py")) == found

    def test_of_commands_one_is_obeyed_however_many_give_them(self):
        nodes = [node(f"/{name}", publisher("cmd_vel", "geometry_msgs/msg/Twist")) for name in "abcd"]

        assert owners(system(*nodes, name="launch/robot.launch.py")) == [("/a", "/b", "/c", "/d")]

    def test_in_a_closed_world_everything_runs_together(self):
        nodes = [node(name, publisher("cmd_vel", TWIST)) for name in ("/joystick", "/planner")]
        judged = system(*nodes, closed=True)

        [finding] = multiple_publishers(judged, NOTHING_SAID)

        assert finding.severity is Severity.WARNING

    def test_three_nodes_are_one_finding(self):
        nodes = [node(f"/{name}", publisher("cmd_vel")) for name in "abc"]

        assert owners(system(*nodes, name="launch/robot.launch.py")) == [("/a", "/b", "/c")]

    def test_two_publishers_of_one_node_are_its_own_business(self):
        assert owners(system(node("/joystick", publisher("cmd_vel"), publisher("cmd_vel")))) == []

    def test_names_are_compared_as_they_are_at_run_time(self):
        left, right = node("/left/arm", publisher("state")), node("/right/arm_2", publisher("state"))

        assert owners(system(left, right)) == []

    @pytest.mark.parametrize("topic", sorted(OF_MANY_PUBLISHERS))
    def test_topics_that_are_shared_by_design(self, topic: str):
        assert owners(system(node("/a", publisher(topic)), node("/b", publisher(topic)))) == []

    def test_markers_of_several_nodes_add_up(self):
        def painter(name: str):
            return node(name, publisher("markers", "visualization_msgs/msg/MarkerArray"))

        assert owners(system(painter("/a"), painter("/b"))) == []

    def test_what_is_drawn_is_there_to_be_looked_at(self):
        def planner(name: str):
            return node(name, publisher("display_planned_path", "moveit_msgs/msg/DisplayTrajectory"))

        assert owners(system(planner("/a"), planner("/b"), name="launch/robot.launch.py")) == []

    def test_who_listens_to_what_he_publishes_knows_of_the_others(self):
        face, mood = publisher("face", "std_msgs/msg/Int32"), subscriber("face", "std_msgs/msg/Int32")
        yields, other = node("/behavior", face, mood), node("/web", face)
        third = node("/battery", face)

        assert owners(system(yields, other, name="launch/robot.launch.py")) == []
        assert owners(system(yields, other, third, name="launch/robot.launch.py")) != []

    @pytest.mark.parametrize(("answers", "told"), [("state", False), ("speed", True)])
    def test_who_tell_each_other_whose_turn_it_is(self, answers: str, told: bool):
        command, trigger = publisher("cmd_vel", TWIST), "std_msgs/msg/Bool"
        far = node("/far", command, publisher("trigger", trigger), subscriber("state", "std_msgs/msg/String"))
        near = node("/near", command, subscriber("trigger", trigger), publisher(answers, "std_msgs/msg/String"))

        assert bool(owners(system(far, near, name="launch/robot.launch.py"))) is told

    @pytest.mark.parametrize(
        ("one_way", "the_other", "told"),
        [("local_planner_trigger", "planner_state", False), ("oled_face", "planner_state", True)],
    )
    def test_what_is_shown_or_measured_says_nothing_of_turns(self, one_way: str, the_other: str, told: bool):
        """A web page that has a face shown, and is told the state, drives beside the navigation."""
        command, signal = publisher("cmd_vel", TWIST), "std_msgs/msg/String"
        web = node("/web", command, publisher(one_way, signal), subscriber(the_other, signal))
        slam = node("/slam", command, subscriber(one_way, signal), publisher(the_other, signal))

        assert bool(owners(system(web, slam, name="launch/robot.launch.py"))) is told

    def test_topics_that_the_team_shares(self):
        judged = system(node("/a", publisher("events/door")), node("/b", publisher("events/door")))

        assert owners(judged, Options(shared_topics=("/events/*",), own={"texts": True, "occasions": True})) == []

    def test_packages_that_have_nothing_to_do_with_each_other(self):
        one, other = node("/a", publisher("x")), node("/b", publisher("x"), package="other")

        assert owners(system(one, other)) == []
        assert owners(system(one, other, name="launch/robot.launch.py")) == [("/a", "/b")]

    def test_tests_are_left_out(self):
        assert owners(system(node("/a", publisher("x")), node("/b", publisher("x"), test=True))) == []

    def test_a_publisher_that_may_not_be_there(self):
        judged = system(node("/a", publisher("x")), node("/b", publisher("x", conditional=True)))

        assert owners(judged) == []

    def test_a_publisher_that_is_destroyed_again(self):
        judged = system(node("/a", publisher("x")), node("/b", publisher("x", destroyed=True)))

        assert owners(judged) == []

    def test_a_name_with_a_hole_is_no_proof(self):
        judged = system(node("/a", publisher(partial("*/x"))), node("/b", publisher(partial("*/x"))))

        assert owners(judged) == []


class TestConditionsOfALaunchFile:
    def judged(self, one: set[tuple[str, int]], other: set[tuple[str, int]]) -> System:
        nodes = [
            replace(node(name, publisher("x")), alternatives=frozenset(arms))
            for name, arms in (("/a", one), ("/b", other))
        ]
        return system(*nodes, name="launch/robot.launch.py")

    def test_one_condition(self):
        assert owners(self.judged({("if simulated", 0)}, {("if simulated", 0)})) == [("/a", "/b")]

    def test_opposite_conditions(self):
        assert owners(self.judged({("if simulated", 0)}, {("if simulated", 1)})) == []

    def test_conditions_that_may_never_hold_at_once(self):
        assert owners(self.judged({("if robot == 'a'", 0)}, {("if robot == 'b'", 0)})) == []

    def test_a_node_that_is_always_started_meets_one_that_sometimes_is(self):
        assert owners(self.judged(set(), {("if joystick", 0)})) == [("/a", "/b")]


class TestVariantsOfOneNode:
    """Without a launch file, what looks like two forms of one node is not taken to run together."""

    def test_one_class_name(self):
        judged = system(
            node("/talker", publisher("x"), class_name="Talker"),
            node("/talker_slow", publisher("x"), class_name="Talker"),
        )

        assert owners(judged) == []

    def test_one_node_name(self):
        judged = system(
            node("/talker", publisher("x"), class_name="A", file="a.py"),
            node("/talker", publisher("x"), class_name="B", file="b.py"),
        )

        assert owners(judged) == []

    def test_one_interface(self):
        def driver(name: str):
            return node(name, publisher("speed"), publisher("odom"), subscriber("cmd_vel"))

        assert owners(system(driver("/driver_a"), driver("/driver_b"))) == []
        together = system(driver("/driver_a"), driver("/driver_b"), name="launch/robot.launch.py")
        assert owners(together) == [("/driver_a", "/driver_b")] * 2

    def test_a_program_that_only_tries_something_out(self):
        assert owners(system(node("/a", publisher("x")), node("/test_a", publisher("x")))) == []

    def test_nodes_of_one_executable_do_run_together(self):
        judged = system(
            node("/front", publisher("x"), class_name="Camera", executables=("cameras",)),
            node("/rear", publisher("x"), class_name="Camera", executables=("cameras",)),
        )

        assert owners(judged) == [("/front", "/rear")]


class TestMultipleServers:
    def test_a_service_and_an_action(self):
        judged = system(
            node("/left_arm", service("home"), action_server("grasp")),
            node("/right_arm", service("home"), action_server("grasp")),
            name="launch/robot.launch.py",
        )

        found = list(multiple_servers(judged, NOTHING_SAID))

        assert [finding.message.partition(":")[0] for finding in found] == [
            "/left_arm and /right_arm both serve the service '/home'",
            "/left_arm and /right_arm both serve the action '/grasp'",
        ]

    def test_what_the_same_nodes_serve_is_one_finding(self):
        left = node("/left_arm", service("home"), action_server("grasp"))
        right = node("/right_arm", service("home"), action_server("grasp"))
        judged = system(left, right, node("/hand", action_server("close")), name="launch/robot.launch.py")

        [told] = folded(multiple_servers(judged, NOTHING_SAID))

        assert told.message.endswith(": every request reaches all of them; another name is served by all of them, too")

    def test_private_names(self):
        assert servers(system(node("/left_arm", service("~/home")), node("/right_arm", service("~/home")))) == []

    def test_a_service_and_a_topic_of_one_name_are_two_things(self):
        assert servers(system(node("/a", service("x")), node("/b", publisher("x")))) == []


TWO_MOTIONS = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String


    class Circle(Node):
        def __init__(self):
            super().__init__('circle')
            self.create_publisher(String, 'motion', 10)


    class Square(Node):
        def __init__(self):
            super().__init__('square')
            self.create_publisher(String, 'motion', 10)  # here


    def main():
        rclpy.init()
        {body}


    if __name__ == '__main__':
        main()
"""


def test_a_node_that_its_script_leaves_out_does_not_run_beside_the_other(judge: Judge):
    judge("OWN001", TWO_MOTIONS.format(body="one, other = Circle(), Square()"))
    judge("OWN001", TWO_MOTIONS.format(body="rclpy.spin(Square())").replace("  # here", ""))


PACKAGE = """
<package format="3"><name>demo</name><exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend>
<export><build_type>ament_python</build_type></export></package>
"""
SETUP = """
from setuptools import setup
setup(name='demo', packages=['demo'], data_files=[('share/demo/launch', ['launch/all.launch.xml'])],
      entry_points={'console_scripts': ['one = demo.one:main', 'two = demo.two:main']})
"""
LAUNCH = """<launch>{}</launch>"""
NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class {name}(Node):
    def __init__(self):
        super().__init__('{name}'.lower())
        self.goal_pub = self.create_publisher(Float64, '{topic}', 10)
        self.create_timer(1.0, self.tick)
        {more}

    def tick(self):
        {tick}


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
SAYS = "self.goal_pub.publish(Float64())"


@pytest.mark.parametrize(
    ("tick", "more", "topic", "started", "severity"),
    [
        (SAYS, "pass", "goal", ("one", "two"), Severity.WARNING),
        ("pass", "pass", "goal", ("one", "two"), None),  # one of them never says anything
        ("pass", "self.say = getattr(self, 'goal_pub').publish", "goal", ("one", "two"), Severity.WARNING),
        (SAYS, "pass", "goal", ("one",), None),  # the launch file says that the other is left out
        (SAYS, "pass", "goal", (), None),
        (SAYS, "pass", "event_log", (), None),
        (SAYS, "pass", "event_log", ("one", "two"), Severity.WARNING),
    ],
    ids=[
        "both",
        "left over",
        "by its name",
        "one launched",
        "nothing launched",
        "a log",
        "a log of one system",
    ],
)
def test_publishers_in_files(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    tick: str,
    more: str,
    topic: str,
    started: tuple[str, ...],
    severity: Severity | None,
):
    monkeypatch.chdir(tmp_path)
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": SETUP,
        "demo/__init__.py": "",
        "demo/one.py": NODE.format(name="One", tick=SAYS, more="pass", topic=topic),
        "demo/two.py": NODE.format(name="Two", tick=tick, more=more, topic=topic),
    }
    if started:
        nodes = "".join(f'<node pkg="demo" exec="{one}"/>' for one in started)
        files["launch/all.launch.xml"] = LAUNCH.format(nodes)
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "archlint.toml").write_text('select = ["OWN001"]')

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))

    assert [one.severity for one in report.findings] == ([] if severity is None else [severity])


@pytest.mark.parametrize(
    ("topic", "told"), [("gui_status", 0), ("gui_state", 1), ("answer", 1)], ids=["what happens", "a state", "a text"]
)
def test_texts_that_say_what_happens_add_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, topic: str, told: int):
    monkeypatch.chdir(tmp_path)
    words = NODE.replace("Float64", "String")
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": SETUP,
        "demo/__init__.py": "",
        "demo/one.py": words.format(name="One", tick=SAYS.replace("Float64", "String"), more="pass", topic=topic),
        "demo/two.py": words.format(name="Two", tick=SAYS.replace("Float64", "String"), more="pass", topic=topic),
        "launch/all.launch.xml": LAUNCH.format('<node pkg="demo" exec="one"/><node pkg="demo" exec="two"/>'),
        "archlint.toml": 'select = ["OWN001"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


TWO = """
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import String


    class Said:
        def __init__(self, node):
            self.sayings = node.create_publisher(String, 'mode', 10)

        def say(self):
            self.sayings.publish(String())


    class One(Node):
        def __init__(self):
            super().__init__('one')
            self.words = self.create_publisher(String, 'mode', 10)
            self.create_timer(1.0, self.speak)

        def speak(self):
            self.words.publish(String())


    class Two(Node):
        def __init__(self):
            super().__init__('two')
            self.said = Said(self)
            self.create_timer(1.0, self.speak)

        def speak(self):
            {line}


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        for node in (One(), Two()):
            executor.add_node(node)
        executor.spin()


    if __name__ == '__main__':
        main()
"""


class TestLeftOver:
    """A package, since only there it is known who else may use what an object holds."""

    @pytest.fixture
    def count(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
        monkeypatch.chdir(tmp_path)

        def run(line: str, other: str = "") -> int:
            manifest = "<package format='3'><name>robot</name><version>0.0.1</version></package>"
            (tmp_path / "package.xml").write_text(manifest, encoding="utf-8")
            source = dedent(TWO).replace("{line}", line)
            (tmp_path / "two.py").write_text(source, encoding="utf-8")
            (tmp_path / "other.py").write_text(other, encoding="utf-8")
            (tmp_path / "archlint.toml").write_text('select = ["OWN001"]', encoding="utf-8")
            return len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings)

        return run

    def test_a_publisher_that_only_a_method_uses_which_nothing_calls(self, count):
        assert count("pass") == 0

    @pytest.mark.parametrize(
        "line", ["self.said.say()", "self.create_timer(1.0, self.said.say)", "getattr(self.said, 'say')()"]
    )
    def test_a_method_that_is_called_or_handed_on(self, count, line: str):
        assert count(line) == 1

    def test_a_method_that_another_file_names(self, count):
        assert count("pass", other="def use(two):\n    two.said.say()\n") == 1


WAKING = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class Sensor(Node):
    def __init__(self, name):
        super().__init__(name)
        self.waking = self.create_publisher({type}, '{topic}', 10)
        self.create_timer(1.0, self.look)

    def look(self):
        {publish}


class Ear(Sensor):
    pass


class Eye(Sensor):
    def __init__(self):
        super().__init__('eye')
        self.other = self.create_publisher({type}, '{topic}', 10)
        self.create_timer(1.0, self.wave)

    def wave(self):
        message = {type}()
        {fill}
        self.other.publish(message)


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription({type}, '{topic}', print, 10)


def main():
    rclpy.init()
    nodes = [Ear('ear'), Eye(), Listener()]
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("type_", "topic", "publish", "fill", "expected"),
    [
        ("Bool", "wake_word_detected", "Bool(data=True)", "message.data = True", 0),
        ("Empty", "button_pressed", "Empty()", "pass", 0),
        ("String", "door/alerts", "String(data='open')", "message.data = 'shut'", 0),
        ("Bool", "obstacle_detected", "Bool(data=True)", "message.data = self.sees()", 1),
        ("Bool", "obstacle_detected", "Bool(data=False)", "message.data = True", 1),
        ("Bool", "motors_enabled", "Bool(data=True)", "message.data = True", 0),
        ("Bool", "motors_enabled", "Bool(data=True)", "message.data = self.sees()", 1),
        ("Float64", "goal_reached", "Float64(data=1.0)", "message.data = 2.0", 1),
    ],
)
def test_what_has_happened_may_be_told_by_several(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, type_: str, topic: str, publish: str, fill: str, expected: int
):
    code = f"self.waking.publish({publish})"
    text = WAKING.format(type=type_, topic=topic, publish=code, fill=fill)
    (tmp_path / "node.py").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [one.code for one in found].count("OWN001") == expected


LIGHT = """\
class Light(Node):
    def __init__(self):
        super().__init__('light')
        self.create_subscription(Bool, 'cancel', print, 10)


"""
CANCELLING = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, String


class Panel(Node):
    def __init__(self):
        super().__init__('panel')
        self.out = self.create_publisher(Bool, 'cancel', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.out.publish(Bool(data=load()))


class Keyboard(Node):
    def __init__(self):
        super().__init__('keyboard')
        self.keys = self.create_publisher(Bool, 'cancel', 10)  # here
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.keys.publish(Bool(data=load()))


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_subscription(Bool, 'cancel', self.on_cancel, 10)

    def on_cancel(self, message):
        {body}


{classes}def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in [Panel(), Keyboard(), {more}Driver()]:
        executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("body", "more", "told"),
    [
        pytest.param(
            "if not message.data:\n            return\n        self.goal = 0", "", False, id="returns for false"
        ),
        pytest.param("if message.data and self.busy:\n            self.goal = 0", "", False, id="acts for true"),
        pytest.param(
            "self.get_logger().info('asked')\n        if message.data:\n            self.stop()",
            "",
            False,
            id="logs either",
        ),
        pytest.param("self.cancelled = message.data", "", True, id="a state"),
        pytest.param(
            "if message.data:\n            self.stop()\n        else:\n            self.go()",
            "",
            True,
            id="acts for both",
        ),
        pytest.param("if message.data or self.busy:\n            self.stop()", "", True, id="perhaps for false"),
        pytest.param("pass", "", True, id="does nothing at all"),
        pytest.param("if message.data:\n            self.stop()", "Light(), ", True, id="somebody else listens"),
    ],
)
def test_true_may_ask_for_something_whoever_sends_it(judge: Judge, body: str, more: str, told: bool):
    text = CANCELLING.replace("{body}", body).replace("{more}", more).replace("{classes}", LIGHT if more else "")
    judge("OWN001", text if told else text.replace("  # here", ""))


@pytest.mark.parametrize(
    ("text", "before", "told"),
    [
        pytest.param("json.dumps({'robot': self.name, 'level': 1})", "pass", False, id="whose"),
        pytest.param("json.dumps(row, sort_keys=True)", "row = {'sender': self.name}", False, id="in a variable"),
        pytest.param("json.dumps({'level': 1})", "pass", True, id="nobody's"),
        pytest.param("json.dumps(load())", "pass", True, id="nobody knows"),
        pytest.param("'robot: ' + self.name", "pass", True, id="no JSON"),
    ],
)
def test_json_may_say_whose_it_is(judge: Judge, text: str, before: str, told: bool):
    code = CANCELLING.replace("{body}", "self.goal = message").replace("{more}", "").replace("{classes}", "")
    code = (
        code.replace("(Bool, ", "(String, ")
        .replace("Bool(data=load())", f"String(data={text})")
        .replace("tick(self):", f"tick(self):\n        {before}")
    )
    judge("OWN001", "import json\n" + (code if told else code.replace("  # here", "")))


@pytest.mark.parametrize(
    ("given", "told"),
    [
        pytest.param("self.ID", False, id="its own number"),
        pytest.param("int(self.robot_id)", False, id="its own number, converted"),
        pytest.param("ID", False, id="a constant"),
        pytest.param("self.goal.id", True, id="the number of something else"),
        pytest.param("identity", True, id="a variable"),
        pytest.param("self.level", True, id="a value"),
    ],
)
def test_a_message_may_say_whose_it_is(judge: Judge, given: str, told: bool):
    """Trucks that tell one excavator who of them has arrived."""
    code = CANCELLING.replace("{body}", "self.goal = message").replace("{more}", "").replace("{classes}", "")
    code = code.replace("(Bool, ", "(Int16, ").replace("import Bool", "import Int16, Bool")
    code = code.replace("self.out.publish(Bool(data=load()))", f"self.out.publish(Int16(data={given}))")
    filled = f"message = Int16()\n        message.data = {given}\n        self.keys.publish(message)"
    code = code.replace("self.keys.publish(Bool(data=load()))", filled)
    judge("OWN001", code if told else code.replace("  # here", ""))


def test_a_text_may_name_its_sender(judge: Judge):
    code = CANCELLING.replace("{body}", "self.goal = message").replace("{more}", "").replace("{classes}", "")
    code = code.replace("(Bool, ", "(String, ").replace("Bool(data=load())", "String(data=f'{self.robot_name}: full')")
    judge("OWN001", code.replace("  # here", ""))


ASKING = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class Panel(Node):
    def __init__(self):
        super().__init__('panel')
        self.out = self.create_publisher({type}, '{topic}', 10)


class Keyboard(Node):
    def __init__(self):
        super().__init__('keyboard')
        self.keys = self.create_publisher({type}, '{topic}', 10)  # here


class Worker(Node):
    def __init__(self, name):
        super().__init__(name)
        self.create_subscription({type}, '{topic}', print, 10)


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in [Panel(), Keyboard(), {workers}]:
        executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("type_", "topic", "workers", "severity"),
    [
        ("String", "robot_command", "Worker('one')", None),
        ("String", "robot_command", "Worker('one'), Worker('two')", Severity.INFO),
        ("String", "robot_mode", "Worker('one')", Severity.WARNING),
        ("Float64", "robot_command", "Worker('one')", Severity.WARNING),
        ("UInt8", "robot_state/toggle", "Worker('one')", None),
        ("Int16", "mode_request", "Worker('one')", None),
        ("UInt8", "robot_state/toggle", "Worker('one'), Worker('two')", Severity.WARNING),
        ("Float64", "speed_request", "Worker('one')", Severity.WARNING),
        ("UInt8", "robot_state", "Worker('one')", Severity.WARNING),
    ],
)
def test_one_node_may_be_asked_by_several(
    judge: Judge, type_: str, topic: str, workers: str, severity: Severity | None
):
    text = ASKING.format(type=type_, topic=topic, workers=workers)
    found = judge("OWN001", text if severity is not None else text.replace("  # here", ""))
    assert [one.severity for one in found] == ([] if severity is None else [severity])


@pytest.mark.parametrize(("module", "expected"), [("two", []), ("one", [Severity.WARNING])])
def test_a_script_that_has_the_name_of_an_executable(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, expected: list[Severity]
):
    """``one.py`` makes two nodes; nothing starts it where ``one`` is another file."""
    monkeypatch.chdir(tmp_path)
    start = "\n\nif __name__ == '__main__':\n    main()\n"
    first = NODE.format(name="One", tick=SAYS, more="pass", topic="goal")
    other = NODE.format(name="Two", tick=SAYS, more="pass", topic="goal")
    both = "    from demo.two import Two\n    rclpy.init()\n    other = Two()\n    rclpy.spin({}())\n"
    if module == "one":
        first = first.replace("    rclpy.init()\n    rclpy.spin(One())\n", both.format("One"))
    setup = "from setuptools import setup\nsetup(name='demo', packages=['demo'], entry_points={'console_scripts': "
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": f"{setup}['one = demo.{module}:main']}})\n",
        "demo/__init__.py": "",
        "demo/one.py": first + start,
        "demo/two.py": other,
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [one.severity for one in found if one.code == "OWN001"] == expected


@pytest.mark.parametrize(
    ("type_", "others", "severity"),
    [
        ("Float64", "all", None),
        ("Twist", "all", Severity.WARNING),  # a command is obeyed, whoever listens
        ("Float64", "one", None),
    ],
)
def test_publishers_that_all_listen_talk_to_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, type_: str, others: str, severity: Severity | None
):
    monkeypatch.chdir(tmp_path)
    text = ASKING.format(type=type_, topic="said", workers="Worker('one')").replace("  # here", "")
    text = text.replace("std_msgs.msg import Twist", "geometry_msgs.msg import Twist")
    listens = f"        self.create_subscription({type_}, 'said', print, 10)\n"
    for line in text.splitlines():
        if "self.out = " in line or ("self.keys = " in line and others == "all"):
            text = text.replace(f"{line}\n", f"{line}\n{listens}")
    (tmp_path / "node.py").write_text(text, encoding="utf-8")
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [one.severity for one in found if one.code == "OWN001"] == ([] if severity is None else [severity])


ENVIRONMENT = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Environment(Node):
    def __init__(self):
        super().__init__('environment')
        self.pub = self.create_publisher(Float64, 'goal', 10)

    def step(self):
        self.pub.publish(Float64())


class Goals(Node):
    def __init__(self):
        super().__init__('goals')
        self.goal_pub = self.create_publisher(Float64, 'goal', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.goal_pub.publish(Float64())


def one():
    rclpy.init()
    environment = Environment()
    {use}
    rclpy.spin(environment)


def two():
    rclpy.init()
    rclpy.spin(Goals())


def trainer():
    rclpy.init()
    environment = Environment()
    while rclpy.ok():
        environment.step()
"""


@pytest.mark.parametrize(
    ("use", "severity"),
    [
        ("pass", []),  # only the trainer, which nobody starts, comes to publish()
        ("environment.create_timer(1.0, environment.step)", [Severity.WARNING]),
        ("hand_on(environment)", [Severity.WARNING]),
    ],
)
def test_a_publisher_whose_program_never_publishes(tmp_path, monkeypatch, use: str, severity: list[Severity]):
    monkeypatch.chdir(tmp_path)
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": SETUP.replace("demo.one:main", "demo.both:one").replace("demo.two:main", "demo.both:two"),
        "demo/__init__.py": "",
        "demo/both.py": ENVIRONMENT.replace("{use}", use),
        "launch/all.launch.xml": LAUNCH.format('<node pkg="demo" exec="one"/><node pkg="demo" exec="two"/>'),
        "archlint.toml": 'select = ["OWN001"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))

    assert [one.severity for one in report.findings] == severity


SWITCHED = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Lidar(Node):
    def __init__(self):
        super().__init__('lidar')
        self.declare_parameter('publish_estop', {default})
        self.on = bool(self.get_parameter('publish_estop').value)
        self.pub = self.create_publisher(Bool, 'estop', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        near = self.get_clock().now().nanoseconds % 2 == 0
        {ask}
            self.pub.publish(Bool(data=near))


class App(Node):
    def __init__(self):
        super().__init__('app')
        self.button = self.create_publisher(Bool, 'estop', 10)
        self.create_timer(1.0, self.press)

    def press(self):
        self.button.publish(Bool(data=False))


def one():
    rclpy.init()
    rclpy.spin(Lidar())


def two():
    rclpy.init()
    rclpy.spin(App())
"""
SET_ESTOP = '<param name="publish_estop" value="{}"/>'


@pytest.mark.parametrize(
    ("default", "ask", "given", "severity"),
    [
        ("False", "if self.on and near:", "", None),
        ("False", "if not self.on:\n            return\n        if near:", "", None),
        ("False", "if self.on and near:", SET_ESTOP.format("false"), None),
        ("False", "if self.on and near:", SET_ESTOP.format("true"), Severity.WARNING),
        ("True", "if self.on and near:", "", Severity.WARNING),
        ("False", "if self.on or near:", "", Severity.WARNING),
        ("False", "if not self.on:", "", Severity.WARNING),
    ],
)
def test_a_publisher_that_a_parameter_turns_on(
    tmp_path, monkeypatch, default: str, ask: str, given: str, severity: Severity | None
):
    monkeypatch.chdir(tmp_path)
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": SETUP.replace("demo.one:main", "demo.both:one").replace("demo.two:main", "demo.both:two"),
        "demo/__init__.py": "",
        "demo/both.py": SWITCHED.replace("{default}", default).replace("{ask}", ask),
        "launch/all.launch.xml": LAUNCH.format(
            f'<node pkg="demo" exec="one">{given}</node><node pkg="demo" exec="two"/>'
        ),
        "archlint.toml": 'select = ["OWN001"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)

    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    assert [one.severity for one in found] == [severity] * (severity is not None)


@pytest.mark.parametrize(
    ("launch", "more", "told"),
    [
        ("all.launch.xml", "", True),
        ("all_old.launch.xml", "", False),
        ("old/all.launch.xml", "", False),
        ("all_old.launch.xml", '<include file="$(dirname)/all_old.launch.xml"/>', True),
    ],
)
def test_a_launch_file_that_is_put_aside_starts_nothing(tmp_path, monkeypatch, launch: str, more: str, told: bool):
    monkeypatch.chdir(tmp_path)
    both = '<node pkg="demo" exec="one"/><node pkg="demo" exec="two"/>'
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": SETUP.replace("demo.one:main", "demo.both:one").replace("demo.two:main", "demo.both:two"),
        "demo/__init__.py": "",
        "demo/both.py": SWITCHED.replace("{default}", "True").replace("{ask}", "if self.on or near:"),
        f"launch/{launch}": LAUNCH.format(both),
        "launch/robot.launch.xml": LAUNCH.format(more),
        "archlint.toml": 'select = ["OWN001"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    assert [one.code for one in found] == ["OWN001"] * told


@pytest.mark.parametrize(
    ("title", "cure"),
    [
        ("The drivers take turns", "        if not self.active:\n            return\n"),
        ("A topic that is meant to be shared", 'shared-topics = ["/distances"]\n'),
    ],
)
def test_what_a_good_example_of_the_page_shows_is_what_makes_it_good(
    title: str, cure: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    [page] = pages_folder().glob("OWN001-*.md")
    [example] = [each for each in read_page("OWN001", page.read_text(encoding="utf-8")) if each.title == title]
    assert any(cure in text for text in example.files.values())
    example.files = {name: text.replace(cure, "") for name, text in example.files.items()}
    example.write(tmp_path)
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [(finding.code, finding.severity) for finding in found] == [("OWN001", Severity.WARNING)]


def test_two_drivers_that_serve_the_same_services_are_alternatives():
    arm = [service("arm/move"), service("arm/pick"), service("arm/place")]
    mine = node("/arm_driver", *arm, client("vision"))
    yours = node("/other_arm", *arm, *(publisher(f"state{number}") for number in range(3)))
    assert list(multiple_servers(system(mine, yours), NOTHING_SAID)) == []
    launched = list(multiple_servers(system(mine, yours, name="launch/all.launch.py"), NOTHING_SAID))
    assert len(launched) == 3


def test_two_nodes_that_share_a_service_are_not():
    mine, yours = node("/arm", service("home"), client("vision")), node("/base", service("home"), publisher("state"))
    assert len(servers(system(mine, yours, closed=True))) == 1
    more = node("/base", service("home"), service("dock"), publisher("state"), publisher("power"))
    assert len(servers(system(mine, more, closed=True))) == 1


@pytest.mark.parametrize(
    ("package", "kind", "told"),
    [("std_msgs", "Empty", False), ("px4_msgs", "VehicleCommand", False), ("px4_msgs", "TrajectorySetpoint", True)],
)
def test_messages_of_which_none_takes_back_another(judge: Judge, package: str, kind: str, told: bool):
    node = """
        class {name}(Node):
            def __init__(self):
                super().__init__('{name}')
                self.pub = self.create_publisher({kind}, '/fmu/in/it', 10){mark}
                self.create_timer(1.0, lambda: self.pub.publish({kind}()))

"""
    head = f"""
        import rclpy
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.node import Node
        from {package}.msg import {kind}

"""
    end = """
        def main():
            rclpy.init()
            executor = SingleThreadedExecutor()
            executor.add_node(Left())
            executor.add_node(Right())
            executor.spin()


        main()
    """
    mark = "  # here" if told else ""
    nodes = node.format(name="Left", kind=kind, mark="") + node.format(name="Right", kind=kind, mark=mark)
    judge("OWN001", head + nodes + end)


SENDING = """
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from sensor_msgs.msg import Image
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    class Left(Node):
        def __init__(self):
            super().__init__('left')
            self.moving, self.image = False, None
            self.pub = self.create_publisher(Twist, '/cmd_vel', 10)
            self.create_subscription(Image, '/camera', self.keep, 10)
            {left}

        def on(self, *given):
            {body}

        def keep(self, image):
            self.moving, self.image = image.width > 0, image

        def send(self):
            command = Twist()
            command.linear.x = 1.0
            self.pub.publish(command)


    class Right(Node):
        def __init__(self):
            super().__init__('right')
            self.pub = self.create_publisher(Twist, '/cmd_vel', 10)
            self.create_service(Trigger, '/go', self.on)

        def on(self, request, response):
            command = Twist()
            command.linear.x = 2.0
            self.pub.publish(command)
            return response


    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        executor.add_node(Left())
        executor.add_node(Right())
        executor.spin()


    main()
"""
TIMER = "self.create_timer(0.1, self.on)"
IMAGES = "self.create_subscription(Image, '/image', self.on, 10)"


@pytest.mark.parametrize(
    ("left", "body", "told"),
    [
        (TIMER, "self.send()", True),
        (IMAGES, "self.send()", True),
        (TIMER, "if self.image is None:\n                return\n            self.send()", True),
        (TIMER, "if self.image is not None:\n                self.send()", True),
        (TIMER, "if self.image is None:\n                self.send()", False),
        (TIMER, "if self.moving:\n                self.send()\n            else:\n                self.send()", True),
        (TIMER, "if self.moving:\n                self.send()", False),
        ("self.create_subscription(String, '/word', self.on, 10)", "self.send()", False),
        ("self.create_service(Trigger, '/halt', self.on)", "self.send()", False),
    ],
)
def test_two_that_each_speak_on_an_occasion_share_a_topic(judge: Judge, left: str, body: str, told: bool):
    """Right sends when it is asked to: the two disagree only where Left sends again and again."""
    source = SENDING.replace("{left}", left).replace("{body}", body)
    # The last publisher in the source is where the finding is.
    last = source.rindex("'/cmd_vel', 10)") + len("'/cmd_vel', 10)")
    judge("OWN001", source[:last] + ("  # here" if told else "") + source[last:])


FLEET = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import {type}


    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            self.out = self.create_publisher({type}, '{topic}', 10)
            self.create_timer(1.0, self.tick)

        def tick(self):
            self.out.publish({type}())


    class Ear(Node):
        def __init__(self):
            super().__init__('ear')
            self.create_subscription({type}, '{topic}', print, 10)


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    def listen():
        rclpy.init()
        rclpy.spin(Ear())
"""


@pytest.mark.parametrize(
    ("type_", "topic", "ears", "told"),
    [
        ("Float64", "/level", 1, 1),
        ("Float64", "/level", 2, 0),  # each robot tells all the others
        ("String", "/report", 1, 0),  # a text of one takes back no text of another
        ("String", "/state", 1, 1),
    ],
)
def test_what_instances_of_one_node_tell(tmp_path, monkeypatch, type_: str, topic: str, ears: int, told: int):
    monkeypatch.chdir(tmp_path)
    starts = "".join(f'<node pkg="demo" exec="robot" name="robot_{number}"/>' for number in range(2))
    starts += "".join(f'<node pkg="demo" exec="ear" name="ear_{number}"/>' for number in range(ears))
    entries = "'console_scripts': ['robot = demo.robot:main', 'ear = demo.robot:listen']"
    files = {
        "package.xml": PACKAGE.strip(),
        "setup.py": f"from setuptools import setup\nsetup(name='demo', entry_points={{{entries}}})\n",
        "demo/__init__.py": "",
        "demo/robot.py": dedent(FLEET).format(type=type_, topic=topic),
        "launch/all.launch.xml": LAUNCH.format(starts),
        "archlint.toml": 'select = ["OWN001"]',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


DRIVES = """
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from std_msgs.msg import Float32


class Page(Node):
    def __init__(self):
        super().__init__('page')
        self.laser = self.create_publisher(Float32, 'a_speed', 10)
        self.drive = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.laser.publish(Float32(data=load()))
        self.drive.publish(load())


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.laser = self.create_publisher(Float32, 'a_speed', 10)
        self.drive = self.create_publisher(Twist, 'cmd_vel', 10)  # here
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.laser.publish(Float32(data=load()))
        self.drive.publish(load())


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in [Page(), Planner()]:
        executor.add_node(node)
    executor.spin()


if __name__ == '__main__':
    main()
"""


def test_of_several_topics_the_command_says_where(judge: Judge):
    """Nobody minds who turns a laser; two that drive are what is wrong."""
    [found] = judge("OWN001", DRIVES)
    assert found.message == "/page and /planner both publish the topics '/cmd_vel' and '/a_speed'"


REPLACED = """
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.out = self.create_publisher(Twist, 'cmd_vel', 10)
        {line}
        self.create_timer(0.1, lambda: self.out.publish(Twist()))


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        self.out = self.create_publisher(Twist, 'cmd_vel', 10){mark}
        self.create_timer(0.1, lambda: self.out.publish(Twist()))


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in (Planner(), Pilot()):
        executor.add_node(node)
    executor.spin()


main()
"""


@pytest.mark.parametrize(
    ("line", "mark"),
    [
        ("self.out = self.create_publisher(Twist, 'plan', 10)", ""),
        ("self.out = wrapped(self.out)", "  # here"),
        ("self.other = self.create_publisher(Twist, 'plan', 10)", "  # here"),
    ],
)
def test_a_publisher_that_the_next_line_replaces(judge: Judge, line: str, mark: str):
    judge("OWN001", REPLACED.format(line=line, mark=mark))


@pytest.mark.parametrize(
    ("made", "mark"),
    [
        ("Planner(), Pilot()", "  # here"),
        ("Planner(),", ""),
        ("Planner(), *[make() for make in (Pilot,)]", "  # here"),
    ],
)
def test_a_node_that_nothing_makes(judge: Judge, made: str, mark: str):
    source = REPLACED.format(line="", mark=mark).replace("Planner(), Pilot()", made)
    judge("OWN001", source)
