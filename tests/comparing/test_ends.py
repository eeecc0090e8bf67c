"""Ends of topics, services and actions: what breaks others, what may, and what does not."""

from __future__ import annotations

import pytest

from archlint.comparing.changes import Impact
from small_systems import BEST_EFFORT, RELIABLE, changes, end, node, system, told

SENSOR = node("/sensor", publishers=[end("/scan")])
PLANNER = node("/planner", subscribers=[end("/scan", callback="Planner.on_scan")])


def test_equal_systems():
    assert told(system(SENSOR, PLANNER), system(PLANNER, SENSOR)) == []


def test_a_topic_that_others_use_is_gone():
    assert told(system(SENSOR, PLANNER), system(node("/sensor"), PLANNER)) == [
        "breaking removed publisher /scan: /planner still subscribes to it, and no node here offers it"
    ]


def test_another_publisher_is_left():
    second = node("/second", publishers=[end("/scan")])
    assert told(system(SENSOR, second, PLANNER), system(node("/sensor"), second, PLANNER)) == [
        "risky removed publisher /scan: /planner subscribes to it, which here only /second still offers"
    ]


def test_a_topic_that_nobody_here_uses_is_gone():
    assert told(system(SENSOR), system(node("/sensor"))) == [
        "risky removed publisher /scan: no node here uses it; tools and nodes elsewhere may"
    ]


def test_both_ends_are_gone():
    assert told(system(SENSOR, PLANNER), system(node("/sensor"), node("/planner"))) == [
        "risky removed publisher /scan: who used it here is gone, too; tools and nodes elsewhere may use it",
        "safe removed subscriber /scan: nothing depends on it",
    ]


def test_the_last_subscriber_is_gone():
    assert told(system(SENSOR, PLANNER), system(SENSOR, node("/planner"))) == [
        "risky removed subscriber /scan: /sensor publishes it, and no node here listens any more"
    ]


def test_an_end_may_be_there_still_where_code_is_not_followed():
    assert told(system(SENSOR, PLANNER), system(node("/sensor", complete=False), PLANNER)) == [
        "risky removed publisher /scan: not all code of /sensor could be followed: it may still be there"
    ]


def test_test_code_is_no_user():
    tester = node("/tester", subscribers=[end("/scan")], test=True)
    [change] = changes(system(SENSOR, tester), system(node("/sensor"), tester))
    assert change.impact == Impact.RISKY


def test_new_ends_are_safe():
    assert told(system(node("/sensor"), node("/planner")), system(SENSOR, PLANNER)) == [
        "safe added publisher /scan: /planner subscribes to it",
        "safe added subscriber /scan: /sensor publishes it",
    ]


def test_a_second_server_is_not():
    first, second = node("/first", services=[end("/stop")]), node("/second", services=[end("/stop")])
    assert told(system(first, node("/second")), system(first, second)) == [
        "risky added service /stop: /first offers it, too: who answers is left to chance"
    ]


@pytest.mark.parametrize(
    ("planner", "impact", "reason"),
    [
        (PLANNER, "breaking", "/planner has std_msgs/msg/String there: they do not connect"),
        (
            node("/planner", subscribers=[end("/scan", "sensor_msgs/msg/LaserScan")]),
            "risky",
            "both ends here have changed; bags, tools and nodes elsewhere have the old type",
        ),
        (node("/planner"), "breaking", "no node here is at the other end: whoever is has the old type"),
    ],
)
def test_a_type_changes(planner, impact, reason):
    now = node("/sensor", publishers=[end("/scan", "sensor_msgs/msg/LaserScan")])
    [change] = [c for c in changes(system(SENSOR, PLANNER), system(now, planner)) if c.owner == "/sensor"]
    assert (change.aspect, change.before, change.after) == ("type", "std_msgs/msg/String", "sensor_msgs/msg/LaserScan")
    assert (change.impact, change.reason) == (impact, reason)


@pytest.mark.parametrize(
    ("before", "after", "impact"),
    [
        (RELIABLE, BEST_EFFORT, "breaking"),  # the planner asks for reliable
        (BEST_EFFORT, RELIABLE, "safe"),
        (RELIABLE, {**RELIABLE, "depth": 1}, "safe"),
        ({**RELIABLE, "durability": "transient_local"}, RELIABLE, "risky"),  # who joins late hears nothing any more
        (RELIABLE, {**RELIABLE, "deadline_s": 0.1}, "safe"),
        ({**RELIABLE, "deadline_s": 0.1}, {**RELIABLE, "deadline_s": 0.2}, "risky"),
    ],
)
def test_what_a_publisher_offers_changes(before, after, impact):
    old, new = (node("/sensor", publishers=[end("/scan", qos=qos)]) for qos in (before, after))
    [change] = changes(system(old, PLANNER), system(new, PLANNER))
    assert (change.aspect, change.impact) == ("qos", impact)


def test_why_quality_of_service_no_longer_fits():
    now = node("/planner", subscribers=[end("/scan", qos={**RELIABLE, "durability": "transient_local"})])
    [change] = changes(system(SENSOR, PLANNER), system(SENSOR, now))
    assert (change.before, change.after) == ("durability volatile", "durability transient_local")
    assert change.reason == (
        "it does not connect to /sensor: durability volatile is offered and transient_local requested"
    )


def test_what_a_loop_creates_is_told_one_by_one():
    """All of it is created at one place."""
    before = system(node("/sensor", publishers=[end("/left"), end("/right"), end("/rear")]))
    found = changes(before, system(node("/sensor", publishers=[end("/rear")])))
    assert [(change.status, change.name) for change in found] == [("removed", "/left"), ("removed", "/right")]


# --- other names


def test_one_end_moves():
    now = node("/planner", subscribers=[end("/points", callback="Planner.on_scan")])
    [change] = changes(system(SENSOR, PLANNER), system(SENSOR, now))
    assert (change.status, change.before, change.after) == ("renamed", "/scan", "/points")
    assert change.reason == "/sensor publishes it, and no node here listens any more"


def test_all_ends_move():
    after = system(
        node("/sensor", publishers=[end("/lidar")]),
        node("/planner", subscribers=[end("/lidar", callback="Planner.on_scan")]),
    )
    assert told(system(SENSOR, PLANNER), after) == [
        "risky renamed topic /lidar: both ends here have moved; bags, tools and nodes elsewhere use the old name"
    ]


def test_one_of_two_subscribers_stays_behind():
    logger = node("/logger", subscribers=[end("/scan")])
    after = system(
        node("/sensor", publishers=[end("/lidar")]),
        node("/planner", subscribers=[end("/lidar", callback="Planner.on_scan")]),
        logger,
    )
    assert "breaking removed publisher /scan: /logger still subscribes to it, and no node here offers it" in told(
        system(SENSOR, PLANNER, logger), after
    )


def test_a_publisher_in_place_of_another_is_no_renaming():
    after = system(node("/sensor", publishers=[end("/status")]))
    assert [change.status for change in changes(system(SENSOR), after)] == ["removed", "added"]


def test_a_parameter_names_the_end():
    before, after = (
        system(node("/sensor", publishers=[end(name, resolution="parameter", parameter="topic")]))
        for name in ("/scan", "/lidar")
    )
    [change] = changes(before, after)
    assert (change.status, change.before, change.after) == ("renamed", "/scan", "/lidar")
