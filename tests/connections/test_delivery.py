"""Which ends of one name get something through to each other."""

from __future__ import annotations

from archlint.connections.delivery import fitting, mistyped_on, undelivered
from archlint.ros.qos import Qos
from systems.builders import node, publisher, subscriber, system

BEST_EFFORT = Qos(reliability="best_effort")


def test_best_effort_data_never_gets_to_a_reliable_subscription():
    sensor = system(
        node("/camera", publisher("/image", qos=BEST_EFFORT)),
        node("/viewer", subscriber("/image")),
        node("/recorder", subscriber("/image", qos=BEST_EFFORT)),
    )
    assert [(pair.request.node.name, pair.reason) for pair in undelivered(sensor)] == [
        ("/viewer", "best effort offered, reliable requested")
    ]


def test_reliable_data_gets_to_everybody():
    sensor = system(
        node("/camera", publisher("/image")),
        node("/viewer", subscriber("/image")),
        node("/recorder", subscriber("/image", qos=BEST_EFFORT)),
    )
    assert list(undelivered(sensor)) == []


def test_a_profile_that_is_not_known_may_be_any():
    sensor = system(
        node("/camera", publisher("/image", qos=BEST_EFFORT)),
        node("/viewer", subscriber("/image", qos=None)),
    )
    assert list(undelivered(sensor)) == []


def test_the_publishers_that_suit_a_subscription():
    sensor = system(
        node("/camera", publisher("/image", qos=BEST_EFFORT)),
        node("/replay", publisher("/image")),
        node("/viewer", subscriber("/image")),
    )
    [request] = sensor.topics["/image"].users
    assert [offer.node.name for offer in fitting(sensor, request)] == ["/replay"]


def test_other_types_never_connect():
    counter = system(
        node("/counter", publisher("/count", "std_msgs/msg/Int32")),
        node("/display", subscriber("/count", "std_msgs/msg/String")),
        node("/log", subscriber("/count", "std_msgs/msg/Int32")),
    )
    assert [pair.reason for pair in mistyped_on(counter, counter.topics["/count"])] == [
        "Int32 published, String subscribed"
    ]
