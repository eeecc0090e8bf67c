"""The forms of a file that tells of a running system, and files that are none of them."""

from __future__ import annotations

import json
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.model import (
    EntityKind,
)
from archlint.observed.model import BAG, MONITOR, RECORDING
from archlint.observed.read import CannotRead, read
from archlint.ros.qos import Qos

LESSON = Path(__file__).parent / "lesson.jazzy.json"
"""What the recorder wrote while the three nodes of ``fixtures/lesson`` ran, under rclpy of jazzy with Fast DDS."""

RELIABLE = Qos(
    history=None, depth=0, reliability="reliable", durability="volatile", liveliness="automatic", lifespan=None
)


def written(folder: Path, name: str, text: str) -> str:
    path = folder / name
    path.write_text(dedent(text), encoding="utf-8")
    return str(path)


def test_a_recording_tells_of_nodes_and_all_kinds_of_ends():
    observed = read(str(LESSON))
    nodes = {node.name: node for node in observed.nodes}
    sensor = nodes["/sensor_node"]
    of_ros = ("/sensor_node/", "/rosout", "/parameter_events")
    own = {(end.kind, end.name, end.type) for end in sensor.ends if not end.name.startswith(of_ros)}

    assert (observed.form, observed.settled) == (RECORDING, True)
    assert sorted(nodes) == ["/control_node", "/motor_node", "/sensor_node"]
    assert own == {
        (EntityKind.PUBLISHER, "/sensor_data", "my_robot_interfaces/msg/SensorReading"),
        (EntityKind.SERVICE, "/query_sensor", "my_robot_interfaces/srv/GetSensorData"),
    }
    assert {end.name for end in nodes["/control_node"].ends if end.kind == EntityKind.CLIENT} == {
        "/query_sensor",
        "/set_motor",
    }


def test_a_policy_that_the_middleware_does_not_tell_is_not_known():
    """Fast DDS sends neither history nor depth: the recorder was told ``unknown`` and 0."""
    nodes = {node.name: node for node in read(str(LESSON)).nodes}
    [end] = [end for end in nodes["/sensor_node"].ends if end.name == "/sensor_data"]
    assert end.qos == RELIABLE


def test_a_node_is_found_at_its_line():
    nodes = {node.name: node.place for node in read(str(LESSON)).nodes}
    lines = LESSON.read_text("utf-8").splitlines()
    assert [lines[place.line - 1].strip() for place in nodes.values()] == [f'"name": "{name}",' for name in nodes]


OLD_BAG = r"""
rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  message_count: 144
  topics_with_message_count:
    - topic_metadata:
        name: /cmd_vel
        type: geometry_msgs/msg/Twist
        serialization_format: cdr
        offered_qos_profiles: "- history: 3\n  depth: 0\n  reliability: 1\n  durability: 2\n  deadline:\n    sec: 2\n    nsec: 500000000\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false"
      message_count: 144
"""  # noqa: E501
"""As Humble writes it: a text of YAML with the numbers of rmw."""

NEW_BAG = """
rosbag2_bagfile_information:
  version: 9
  topics_with_message_count:
    - topic_metadata:
        name: /cmd_vel
        type: geometry_msgs/msg/Twist
        serialization_format: cdr
        offered_qos_profiles:
          - history: unknown
            depth: 0
            reliability: reliable
            durability: volatile
            deadline: {sec: 2, nsec: 500000000}
            lifespan: {sec: 9223372036, nsec: 854775807}
            liveliness: automatic
            liveliness_lease_duration: {sec: 9223372036, nsec: 854775807}
            avoid_ros_namespace_conventions: false
        type_description_hash: RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a
      message_count: 144
  ros_distro: jazzy
"""


@pytest.mark.parametrize("text", [OLD_BAG, NEW_BAG], ids=["version 5", "version 9"])
def test_a_bag_tells_of_topics_and_what_their_publishers_offered(tmp_path: Path, text: str):
    observed = read(written(tmp_path, "metadata.yaml", text))
    [topic] = observed.topics
    [offered] = topic.offered

    assert (observed.form, observed.kinds) == (BAG, {EntityKind.PUBLISHER})
    assert (topic.name, topic.type) == ("/cmd_vel", "geometry_msgs/msg/Twist")
    assert (offered.reliability, offered.durability, offered.history) == ("reliable", "volatile", None)
    assert (offered.deadline, offered.lifespan, offered.liveliness_lease) == (2.5, None, None)


def test_the_folder_of_a_bag_will_do(tmp_path: Path):
    written(tmp_path, "metadata.yaml", NEW_BAG)
    assert read(str(tmp_path)).file == (tmp_path / "metadata.yaml").as_posix()


def test_profiles_may_be_left_out(tmp_path: Path):
    text = NEW_BAG.replace("version: 9", "version: 3").partition("        offered_qos_profiles")[0]
    [topic] = read(written(tmp_path, "metadata.yaml", text)).topics
    assert topic.offered == ()


QOS = {"depth": 0, "deadline": {"sec": 0, "nanosec": 0}, "lifespan": {"sec": 10, "nanosec": 0}, "history": 3,
       "reliability": 2, "durability": 1, "liveliness": 1}  # fmt: skip
MONITOR_0_2 = {
    "timestamp": {"sec": 1, "nanosec": 2},
    "nodes": [
        {
            "name": "/sensor",
            "publishers": [{"name": "/scan", "type": "sensor_msgs/msg/LaserScan", "qos": QOS}],
            "subscriptions": [{"name": "/cmd_vel", "type": "geometry_msgs/msg/Twist", "qos": QOS}],
            "parameters": [{"name": "rate", "type": 0}],
            "parameter_values": [],
        }
    ],
}
ROSGRAPH_MSGS = {
    "nodes": [
        {
            "name": "/sensor",
            "parameters": [],
            "publishers": [{"name": "/scan", "type": {"name": "sensor_msgs/msg/LaserScan", "hash": {}}, "qos": QOS}],
            "subscriptions": [],
            "service_clients": [],
            "service_servers": [
                {"name": "/stop", "request_type": {"name": "std_srvs/srv/Trigger_Request"}, "response_type": {}}
            ],
            "action_clients": [],
            "action_servers": [],
        }
    ]
}


def test_a_message_of_rosgraph_monitor_tells_of_topics_only(tmp_path: Path):
    observed = read(written(tmp_path, "graph.json", json.dumps(MONITOR_0_2)))
    [node] = observed.nodes
    [scan, command] = node.ends

    assert (observed.form, observed.kinds) == (MONITOR, {EntityKind.PUBLISHER, EntityKind.SUBSCRIBER})
    assert (scan.kind, scan.name, scan.type) == (EntityKind.PUBLISHER, "/scan", "sensor_msgs/msg/LaserScan")
    assert (command.kind, command.name) == (EntityKind.SUBSCRIBER, "/cmd_vel")
    assert scan.qos is not None
    assert (scan.qos.reliability, scan.qos.durability, scan.qos.lifespan) == ("best_effort", "transient_local", 10.0)


def test_a_message_of_rosgraph_msgs_may_tell_of_services_too(tmp_path: Path):
    observed = read(written(tmp_path, "graph.json", json.dumps(ROSGRAPH_MSGS)))
    [node] = observed.nodes
    assert observed.kinds == {EntityKind.PUBLISHER, EntityKind.SUBSCRIBER, EntityKind.SERVICE}
    assert [(end.kind, end.name, end.type) for end in node.ends] == [
        (EntityKind.PUBLISHER, "/scan", "sensor_msgs/msg/LaserScan"),
        (EntityKind.SERVICE, "/stop", "std_srvs/srv/Trigger"),
    ]


def test_of_a_topic_that_was_echoed_the_last_message_counts(tmp_path: Path):
    """``ros2 topic echo --full-length`` prints YAML, and a line of three dashes after each message."""
    text = """\
        timestamp: {sec: 1, nanosec: 0}
        nodes: []
        ---
        nodes:
        - name: /sensor
          publishers: []
          subscriptions: []
        ---
        """
    assert [node.name for node in read(written(tmp_path, "graph.yaml", text)).nodes] == ["/sensor"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "expected a recording"),
        ("hello", "expected a recording"),
        ("[]", "expected a recording"),
        ('{"a": 1}', "expected a recording"),
        ('{"version": 1, "nodes": []}', "expected a recording"),  # archlint's own graph
        ("services:\n  web: {image: nginx}\n", "expected a recording"),
        ('{"archlint_observed": 1,\n "nodes": [}', ":2:12: malformed JSON"),
        ("a: [1\nb: 2", ":2:2: malformed YAML"),
        ('{"archlint_observed": 1}', "missing required field `nodes`"),
        ('{"archlint_observed": 1, "nodes": [{"name": 3}]}', "Expected `str`, got `int` - at `$.nodes[0].name`"),
        ('{"archlint_observed": 99, "nodes": []}', "it was recorded by a newer archlint"),
        ("rosbag2_bagfile_information: 3", "Expected `object`, got `int` - at `$.rosbag2_bagfile_information`"),
        (NEW_BAG.replace("type: geometry_msgs/msg/Twist", ""), "missing required field `type`"),
        (OLD_BAG.replace("- history", "- [history"), "the offered_qos_profiles of /cmd_vel"),
        ("nodes:\n- name: /a\n  publishers: []\n- '...'\n", "ros2 topic echo --full-length"),
        ("[" * 100_000, "nested too deeply"),
        ("\x00", "malformed YAML"),
    ],
)
def test_what_cannot_be_used_is_said_in_a_sentence(tmp_path: Path, text: str, said: str):
    path = tmp_path / "observed"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(CannotRead) as error:
        read(str(path))
    assert said in str(error.value)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)


def test_what_is_not_there_or_no_text(tmp_path: Path):
    (tmp_path / "bag.mcap").write_bytes(b"\x89MCAP0\r\n\xff\xfe")
    for path, said in ((tmp_path / "gone.json", "No such file"), (tmp_path / "bag.mcap", "is not text")):
        with pytest.raises(CannotRead, match=said):
            read(str(path))


def test_a_number_of_too_many_digits_is_no_fault_of_ours(tmp_path: Path) -> None:
    file = tmp_path / "graph.json"
    file.write_text('{"version": ' + "9" * 10_000 + "}")
    with pytest.raises(CannotRead, match=r"graph\.json: a number in it has too many digits"):
        read(str(file))
