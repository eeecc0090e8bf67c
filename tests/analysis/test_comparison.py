"""``check --observed``: a running system held against its source, one difference at a time."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from archlint.config.settings import Settings, load
from archlint.engine.pipeline import NothingToDo, Request, check
from archlint.finding import Severity
from archlint.observed.read import read
from archlint.report.model import Report

ROOT = Path(__file__).parents[2]
LESSON = ROOT / "fixtures" / "lesson"
RECORDED = ROOT / "tests" / "observed" / "lesson.jazzy.json"
LAUNCH = "src/my_first_package/launch/robot.launch.py"
PACKAGE = "src/my_first_package/my_first_package"
CODES = {"GRF005", "GRF006", "GRF007"}


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What the nodes of ``fixtures/lesson`` said of themselves while they ran, to be changed."""
    monkeypatch.chdir(LESSON)
    return json.loads(RECORDED.read_text("utf-8"))


def node(recorded: dict[str, Any], name: str) -> dict[str, Any]:
    [found] = [one for one in recorded["nodes"] if one["name"] == name]
    return found


def end(recorded: dict[str, Any], name: str, kind: str, of: str) -> dict[str, Any]:
    [found] = [one for one in node(recorded, name)[kind] if one["name"] == of]
    return found


def compared(recorded: dict[str, Any], folder: Path, launch: str | None = LAUNCH, **settings: Any) -> Report:
    path = folder / "robot.json"
    path.write_text(json.dumps(recorded, indent=1), encoding="utf-8")
    return check(Request((".",), Settings(**settings), cached=False, jobs=1, launch=launch, observed=read(str(path))))


def told(report: Report) -> list[tuple[str, str, int, str]]:
    return [(one.code, one.place.file, one.place.line, one.message) for one in report.findings if one.code in CODES]


@pytest.mark.parametrize("launch", [LAUNCH, None])
def test_what_runs_as_it_is_written_differs_in_nothing(recorded, tmp_path, launch):
    report = compared(recorded, tmp_path, launch)
    assert told(report) == []
    assert report.remarks[1] == "3 nodes and 6 endpoints on both sides; no difference."


def test_it_is_said_what_was_compared(recorded, tmp_path):
    file = (tmp_path / "robot.json").as_posix()
    assert compared(recorded, tmp_path).remarks[0] == f"Compared {file} with the system that {LAUNCH} starts."
    assert "without --launch it is not known which of them run" in compared(recorded, tmp_path, None).remarks[0]


def test_a_node_that_does_not_run(recorded, tmp_path):
    recorded["nodes"].remove(node(recorded, "/motor_node"))
    [found] = told(compared(recorded, tmp_path))
    assert found == ("GRF005", LAUNCH, 10, f"/motor_node does not run, and {LAUNCH} starts it")


def test_without_a_launch_file_it_may_not_be_meant_to_run(recorded, tmp_path):
    recorded["nodes"].remove(node(recorded, "/motor_node"))
    [found] = compared(recorded, tmp_path, None).findings
    assert (found.code, found.severity, found.place.line) == ("GRF005", Severity.INFO, 6)
    assert found.help == "use --launch to say which launch file started the running system"


def test_a_node_in_another_namespace(recorded, tmp_path):
    node(recorded, "/motor_node")["name"] = "/left/motor_node"
    missing, _ = sorted(told(compared(recorded, tmp_path)))
    assert missing[3].endswith("; /left/motor_node runs: is that the same node in another namespace?")


def test_a_node_that_nobody_starts(recorded, tmp_path):
    recorded["nodes"].append({"name": "/teleop"})
    report = compared(recorded, tmp_path)
    [found] = told(report)
    assert (found[0], found[3]) == ("GRF006", f"/teleop runs, and {LAUNCH} does not start it")
    line = Path(found[1]).read_text("utf-8").splitlines()[found[2] - 1]
    assert line.strip() == '"name": "/teleop"'
    assert told(compared(recorded, tmp_path, external=("/teleop",))) == []


def test_two_nodes_of_one_name(recorded, tmp_path):
    node(recorded, "/motor_node")["count"] = 2
    [found] = told(compared(recorded, tmp_path))
    assert found[0] == "GRF006"
    assert found[3] == "2 nodes with the name /motor_node run, but the source has one of that name"


@pytest.mark.parametrize(
    "name",
    [
        "/_ros2cli_daemon_0_ab12",
        "/launch_ros_4711",
        "/transform_listener_impl_55d0c8b2a3f0",
        "/ns/_hidden",
        "/rosbag2_recorder",
    ],
)
def test_nodes_of_ros_own_tools_are_no_difference(recorded, tmp_path, name):
    recorded["nodes"].append({"name": name})
    assert told(compared(recorded, tmp_path)) == []


def test_another_qos(recorded, tmp_path):
    end(recorded, "/sensor_node", "publishers", "/sensor_data")["qos"]["reliability"] = "best_effort"
    end(recorded, "/sensor_node", "publishers", "/sensor_data")["qos"]["deadline_s"] = 0.5
    [found] = told(compared(recorded, tmp_path))
    assert found[:3] == ("GRF007", f"{PACKAGE}/sensor_node.py", 12)
    assert found[3] == (
        "the publisher /sensor_data of /sensor_node is best effort and with a deadline of 0.5 s when it runs, but "
        "reliable and without deadline in the source"
    )


def test_history_and_depth_do_not_travel(recorded, tmp_path):
    end(recorded, "/sensor_node", "publishers", "/sensor_data")["qos"] |= {"history": "keep_last", "depth": 1}
    assert told(compared(recorded, tmp_path)) == []


def test_what_the_middleware_does_not_tell_is_no_difference(recorded, tmp_path):
    end(recorded, "/sensor_node", "publishers", "/sensor_data")["qos"] |= {"reliability": "unknown"}
    end(recorded, "/control_node", "subscribers", "/sensor_data")["qos"] = None
    assert told(compared(recorded, tmp_path)) == []


@pytest.mark.parametrize(
    ("name", "kind", "of", "line", "noun"),
    [
        ("/sensor_node", "publishers", "/sensor_data", 12, "publisher"),
        ("/control_node", "clients", "/set_motor", 21, "client"),
    ],
)
def test_another_type(recorded, tmp_path, name, kind, of, line, noun):
    was = end(recorded, name, kind, of)["type"]
    end(recorded, name, kind, of)["type"] = "other_msgs/msg/Other"
    [found] = told(compared(recorded, tmp_path))
    assert found[:3] == ("GRF007", f"{PACKAGE}{name}.py", line)
    types = f"has the type other_msgs/msg/Other when it runs, but {was} in the source"
    assert found[3] == f"the {noun} {of} of {name} {types}"


def test_another_name(recorded, tmp_path):
    end(recorded, "/sensor_node", "publishers", "/sensor_data")["name"] = "/readings"
    [found] = told(compared(recorded, tmp_path))
    assert found == (
        "GRF007",
        f"{PACKAGE}/sensor_node.py",
        12,
        "/sensor_node publishes /readings when it runs, but /sensor_data in the source",
    )


def test_an_end_that_is_not_there_and_one_that_is_too_many(recorded, tmp_path):
    motor = node(recorded, "/motor_node")
    motor["services"].remove(end(recorded, "/motor_node", "services", "/set_motor"))
    motor["publishers"].append({"name": "/cmd_vel", "type": "geometry_msgs/msg/Twist"})
    missing, unexpected = sorted(told(compared(recorded, tmp_path)))
    assert missing == ("GRF005", f"{PACKAGE}/motor_node.py", 10, "/motor_node runs without its service /set_motor")
    assert unexpected == (
        "GRF006",
        f"{PACKAGE}/motor_node.py",
        6,
        "/motor_node publishes /cmd_vel (geometry_msgs/msg/Twist) when it runs, but its source does not",
    )


def test_what_ros_makes_for_every_node_is_no_difference(recorded, tmp_path):
    motor = node(recorded, "/motor_node")
    motor["subscribers"] = [
        {"name": "/parameter_events", "type": "rcl_interfaces/msg/ParameterEvent"},
        {"name": "/clock", "type": "rosgraph_msgs/msg/Clock"},
    ]
    motor["services"] += [
        {"name": "/motor_node/set_logger_levels", "type": "rcl_interfaces/srv/SetLoggerLevels"},
        {"name": "/drive/_action/send_goal", "type": "robot_interfaces/action/Drive_SendGoal"},
    ]
    assert told(compared(recorded, tmp_path)) == []


def test_nothing_is_compared_without_a_file(recorded, tmp_path):
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    assert told(report) == []
    assert list(report.remarks) == []


# -------------------------------------------------------------------------------------- what the source leaves open

OPEN = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Watcher(Node):
    def __init__(self, robot):
        super().__init__('watcher')
        self.create_subscription(String, f'{robot}/state', self.hear, 10)
        self.declare_parameter('verbose', False)
        if self.get_parameter('verbose').value:
            self.log = self.create_publisher(String, 'log', 10)
        self.later = None

    def hear(self, message):
        if self.later is None:
            self.later = self.create_publisher(String, 'later', 10)


def main():
    rclpy.init()
    rclpy.spin(Watcher(input()))


if __name__ == '__main__':
    main()
"""


def watcher(**ends: Any) -> dict[str, Any]:
    return {"archlint_observed": 1, "nodes": [{"name": "/watcher", **ends}]}


@pytest.fixture
def open_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "watcher.py").write_text(OPEN, encoding="utf-8")
    return tmp_path


def test_a_name_that_is_known_in_part_is_never_missing(open_folder):
    assert told(compared(watcher(), open_folder, None)) == []


def test_an_end_that_may_be_the_one_of_a_name_known_in_part(open_folder):
    seen = watcher(subscribers=[{"name": "/falcon/state", "type": "std_msgs/msg/String"}])
    report = compared(seen, open_folder, None)
    assert told(report) == []
    assert any("it may be the subscription of watcher.py:9" in notice for notice in report.notices)


def test_an_end_that_cannot_be_it(open_folder):
    seen = watcher(subscribers=[{"name": "/falcon/pose", "type": "std_msgs/msg/String"}])
    assert [found[0] for found in told(compared(seen, open_folder, None))] == ["GRF006"]


def test_what_a_branch_or_a_callback_creates_may_be_there_or_not(open_folder):
    seen = watcher(publishers=[{"name": name, "type": "std_msgs/msg/String"} for name in ("/log", "/later")])
    assert told(compared(seen, open_folder, None)) == []


def test_a_node_without_a_known_name_may_be_the_one_that_runs(open_folder):
    text = OPEN.replace("'watcher'", "robot")
    (open_folder / "watcher.py").write_text(text, encoding="utf-8")
    report = compared(watcher(), open_folder, None)
    assert told(report) == []
    assert any("/watcher runs; Watcher has a name that is not known" in notice for notice in report.notices)


STARTS = {
    "a process": "<executable cmd='gz sim'/>",
    "a node of another package": "<node pkg='camera_driver' exec='camera'/>",
    "an included file": "<include file='$(find-pkg-share nav2_bringup)/launch/all.launch.py'/>",
}


@pytest.mark.parametrize("action", STARTS.values(), ids=STARTS)
def test_what_a_launch_file_starts_out_of_sight_may_be_the_node_that_runs(tmp_path, monkeypatch, action):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "all.launch.xml").write_text(f"<launch>{action}</launch>", encoding="utf-8")
    report = compared(watcher(), tmp_path, "all.launch.xml")
    assert told(report) == []
    assert any("/watcher runs; " in notice for notice in report.notices)


def test_of_a_node_whose_source_is_elsewhere_only_the_name_is_held(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = "<launch><node pkg='cpp_driver' exec='driver' name='watcher'/><node pkg='cpp' exec='x' name='y'/></launch>"
    (tmp_path / "all.launch.xml").write_text(text, encoding="utf-8")
    seen = watcher(publishers=[{"name": "/scan", "type": "sensor_msgs/msg/LaserScan"}])
    assert [found[3] for found in told(compared(seen, tmp_path, "all.launch.xml"))] == [
        "/y does not run, and all.launch.xml starts it"
    ]


def test_a_node_that_only_some_arguments_start_is_not_missing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = """<launch><arg name='sim'/>
        <node pkg='cpp' exec='x' name='y' if='$(var sim)'/><node pkg='cpp' exec='x' name='watcher'/></launch>"""
    (tmp_path / "all.launch.xml").write_text(text, encoding="utf-8")
    assert told(compared(watcher(), tmp_path, "all.launch.xml")) == []


# ---------------------------------------------------------------------------------------------------------- the rest


def test_a_comment_at_the_create_call_silences_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = OPEN.replace("f'{robot}/state', self.hear, 10)", "'state', self.hear, 10)  # archlint: ignore[GRF005]")
    (tmp_path / "watcher.py").write_text(text, encoding="utf-8")
    report = compared(watcher(), tmp_path, None)
    assert (told(report), report.summary.suppressed) == ([], 1)
    unheld = check(Request((".",), Settings(), cached=False, jobs=1))
    assert [one.code for one in unheld.findings] == []  # nothing was compared, so that it is not stale


def test_a_changed_recording_is_not_answered_from_the_cache(open_folder):
    def run(data: dict[str, Any]) -> list[str]:
        (open_folder / "robot.json").write_text(json.dumps(data), encoding="utf-8")
        request = Request((".",), load(open_folder), jobs=1, observed=read("robot.json"))
        first, again = check(request), check(request)
        assert (told(first), first.remarks) == (told(again), again.remarks)
        return [found[0] for found in told(first)]

    assert run(watcher()) == []
    assert run(watcher(publishers=[{"name": "/odd", "type": "std_msgs/msg/String"}])) == ["GRF006"]


PACKAGE_XML = "<package format='3'><name>robot</name><version>0.1.0</version><description>it</description></package>"


def test_what_was_not_asked_for_is_not_missed(recorded, tmp_path):
    path = tmp_path / "robot.json"
    recorded["nodes"].remove(node(recorded, "/motor_node"))
    path.write_text(json.dumps(recorded), encoding="utf-8")
    asked = f"{PACKAGE}/sensor_node.py"
    report = check(Request((asked,), Settings(), cached=False, jobs=1, observed=read(str(path))))
    assert told(report) == []
    assert report.remarks[1] == "2 nodes and 5 endpoints on both sides; no difference."


def test_workspaces_side_by_side_are_not_one_system(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        (tmp_path / name / "src" / "robot").mkdir(parents=True)
        (tmp_path / name / "src" / "robot" / "package.xml").write_text(PACKAGE_XML, encoding="utf-8")
        (tmp_path / name / "src" / "robot" / "watcher.py").write_text(OPEN, encoding="utf-8")
    with pytest.raises(NothingToDo, match="there are several workspaces here"):
        compared(watcher(), tmp_path, None)


# -------------------------------------------------------------------------------------------------------- parameters


@pytest.mark.parametrize(("type_", "differs"), [("bool", False), (None, False), ("string", True)])
def test_a_parameter_of_another_type(open_folder, type_, differs):
    seen = watcher(parameters=[{"name": "verbose", "type": type_, "value": None}, {"name": "use_sim_time"}])
    words = "the parameter verbose of /watcher is of type string when it runs, but bool in the source"
    assert told(compared(seen, open_folder, None)) == ([("GRF007", "watcher.py", 10, words)] if differs else [])


# -------------------------------------------------------------------------------------------------------------- bags

DRIVER = """\
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.scans = self.create_publisher(LaserScan, 'scan', qos_profile_sensor_data)
        self.speed = self.create_publisher(Twist, 'speed', 10)


def main():
    rclpy.init()
    rclpy.spin(Driver())


if __name__ == '__main__':
    main()
"""


def bag(folder: Path, *topics: tuple[str, str, str], source: str = DRIVER) -> Report:
    (folder / "driver.py").write_text(source, encoding="utf-8")
    entries = [
        {"topic_metadata": {"name": name, "type": type_, "offered_qos_profiles": [{"reliability": reliability}]}}
        for name, type_, reliability in topics
    ]
    record = {"rosbag2_bagfile_information": {"version": 9, "topics_with_message_count": entries}}
    (folder / "metadata.yaml").write_text(json.dumps(record), encoding="utf-8")
    return check(Request((".",), Settings(), cached=False, jobs=1, observed=read("metadata.yaml")))


SCAN = ("/scan", "sensor_msgs/msg/LaserScan", "best_effort")
SPEED = ("/speed", "geometry_msgs/msg/Twist", "reliable")


@pytest.fixture
def bag_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_bag_of_what_is_published(bag_folder):
    of_ros = ("/rosout", "rcl_interfaces/msg/Log", "reliable")
    of_bags = ("/events/write_split", "rosbag2_interfaces/msg/WriteSplitEvent", "reliable")
    report = bag(bag_folder, SCAN, SPEED, of_ros, of_bags)
    assert told(report) == []
    assert report.remarks[1] == "2 topics on both sides; no difference."


def test_a_topic_that_was_not_recorded_is_not_missing(bag_folder):
    report = bag(bag_folder, SCAN)
    assert told(report) == []
    assert any("not recorded, so not compared: /speed" in notice for notice in report.notices)


def test_what_was_offered_otherwise(bag_folder):
    [found] = told(bag(bag_folder, (*SCAN[:2], "reliable"), SPEED))
    assert found == ("GRF007", "driver.py", 11, "/scan was offered with reliable, but has best effort in the source")


def test_a_topic_of_another_type(bag_folder):
    [found] = told(bag(bag_folder, SCAN, ("/speed", "geometry_msgs/msg/TwistStamped", "reliable")))
    words = "/speed has the type geometry_msgs/msg/TwistStamped, but geometry_msgs/msg/Twist in the source"
    assert found == ("GRF007", "driver.py", 12, words)


def test_a_topic_that_nobody_publishes(bag_folder):
    [found] = told(bag(bag_folder, ("/scans", *SCAN[1:])))
    assert found[:3] == ("GRF006", "metadata.yaml", 1)
    assert found[3].startswith("/scans (sensor_msgs/msg/LaserScan) was recorded, but no node here publishes it")


def test_a_topic_that_may_be_one_of_a_name_that_is_not_known(bag_folder):
    source = DRIVER.replace("'speed'", "input()")
    report = bag(bag_folder, SCAN, ("/odd", "geometry_msgs/msg/Twist", "reliable"), source=source)
    assert told(report) == []
    assert any("/odd is in the bag; it may be the publisher of driver.py:12" in notice for notice in report.notices)
