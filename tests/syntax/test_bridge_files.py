"""The files that a bridge to a simulator reads: which topics each entry stands for."""

from __future__ import annotations

import pytest

from archlint.syntax.bridge_files import BridgedTopic, read_bridges


def read(*lines: str) -> tuple[BridgedTopic, ...] | None:
    return read_bridges("\n".join(lines))


TYPES = ("  ros_type_name: std_msgs/msg/Bool", "  gz_type_name: gz.msgs.Boolean")


@pytest.mark.parametrize(
    ("direction", "publishes", "subscribes"),
    [
        ("GZ_TO_ROS", True, False),
        ("ROS_TO_GZ", False, True),
        ("BIDIRECTIONAL", True, True),
        ("IGN_TO_ROS", True, False),
    ],
)
def test_the_direction_of_a_topic(direction: str, publishes: bool, subscribes: bool):
    rows = read("- topic_name: /lamp", *TYPES, f"  direction: {direction}")
    assert rows == (BridgedTopic("/lamp", "std_msgs/msg/Bool", publishes, subscribes),)


def test_a_topic_without_a_direction_goes_both_ways():
    assert read("- topic_name: lamp", *TYPES) == (BridgedTopic("lamp", "std_msgs/msg/Bool", True, True),)


@pytest.mark.parametrize(
    ("names", "name"),
    [
        (["- ros_topic_name: a", "  gz_topic_name: b"], "a"),
        (["- gz_topic_name: b"], "b"),
        (["- ros_topic_name: a"], "a"),
        (["- ign_topic_name: b"], "b"),
    ],
)
def test_the_name_that_a_topic_has_in_ros(names: list[str], name: str):
    rows = read(*names, *TYPES)
    assert rows is not None
    assert [row.name for row in rows] == [name]


@pytest.mark.parametrize(
    "entry",
    [
        ["- topic_name: a", "  ros_topic_name: b", *TYPES],
        ["- topic_name: a", "  gz_topic_name: b", *TYPES],
        ["- topic_name: a", "  ros_type_name: std_msgs/msg/Bool"],
        ["- topic_name: a", "  gz_type_name: gz.msgs.Boolean"],
        ["- topic_name: a", *TYPES, "  direction: SIDEWAYS"],
        ["- just a text"],
    ],
)
def test_an_entry_that_the_bridge_refuses_is_left_out(entry: list[str]):
    rows = read(*entry, "- topic_name: kept", *TYPES)
    assert rows is not None
    assert [row.name for row in rows] == ["kept"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "topic_name: a",
        "- [",
        "- service_name: /world/empty/control\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld",
    ],
)
def test_what_is_no_list_of_topics_says_nothing(text: str):
    assert read_bridges(text) is None
