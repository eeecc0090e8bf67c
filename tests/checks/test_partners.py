"""TOP002 to TOP004, SRV001, ACT001 and the QoS rules, over systems written by hand."""

from __future__ import annotations

import pytest

from archlint.checks.near_misses import nearly_equal
from archlint.checks.registry import judge, options_for
from archlint.config import Settings
from archlint.finding import Finding
from archlint.program.model import Qos
from archlint.system.model import System
from system.builders import (
    action_client,
    action_server,
    client,
    node,
    partial,
    publisher,
    service,
    subscriber,
    system,
    unknown,
)


def findings(found_in: System, *codes: str, **settings: object) -> list[Finding]:
    return list(judge(found_in, options_for(Settings(**settings), codes)))  # type: ignore[arg-type]


def subjects(found: list[Finding]) -> list[str]:
    return [f"{one.code} {one.identity[1]}" for one in found]


LONELY = ("TOP002", "TOP003", "SRV001", "ACT001")


def test_a_name_with_one_side_only():
    closed = system(
        node("/a", publisher("said"), subscriber("heard"), client("asked"), action_client("sent")),
        node("/b", service("offered"), action_server("done")),
        closed=True,
    )
    assert subjects(findings(closed, *LONELY)) == ["ACT001 /sent", "SRV001 /asked", "TOP002 /said", "TOP003 /heard"]


def test_an_open_system_has_partners_elsewhere():
    assert findings(system(node("/a", publisher("said"), subscriber("heard"))), *LONELY) == []


@pytest.mark.parametrize(
    "other",
    [
        node("/b", subscriber("said")),
        node("/b", subscriber("said", conditional=True)),
        node("/b", subscriber(unknown())),
        node("/b", subscriber(partial("sa*"))),
        node("/b", subscriber(unknown(), type=None)),
    ],
)
def test_whoever_may_be_the_partner_counts(other):
    assert findings(system(node("/a", publisher("said")), other, closed=True), "TOP002") == []


def test_a_node_of_unknown_name_with_another_type_is_no_partner():
    other = node("/b", subscriber(unknown(), type="std_msgs/msg/Bool"))
    assert subjects(findings(system(node("/a", publisher("said")), other, closed=True), "TOP002")) == ["TOP002 /said"]


def test_names_of_tools_and_of_others_are_left_out():
    closed = system(node("/a", publisher("/tf"), publisher("/x/said"), subscriber("/clock")), closed=True)
    assert findings(closed, *LONELY, external=("/x/*",)) == []


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("/camera/image", "/camera/images"),
        ("/cmdVel", "/cmd_vel"),
        ("/robot/comand_velocity", "/robot/command_velocity"),
        ("/odometry/filterd", "/odometry/filtered"),
    ],
)
def test_names_that_are_nearly_equal(one: str, other: str):
    assert nearly_equal(one, other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("/camera_1/image", "/camera_2/image"),
        ("/left/image", "/right/image"),
        ("/in", "/on"),
        ("/goal_x", "/goal_y"),
        ("/input", "/output"),
        ("/scan", "/robot/scan"),
        ("/camera/image_raw", "/camera/image"),
    ],
)
def test_names_that_differ_on_purpose(one: str, other: str):
    assert not nearly_equal(one, other)


def test_a_near_miss_is_shown_with_both_ends():
    [found] = findings(
        system(node("/a", publisher("images")), node("/b", subscriber("image")), node("/c", subscriber("other"))),
        "TOP004",
    )
    assert (found.node, found.related[0].message) == ("/b", "/a publishes '/images'")


@pytest.mark.parametrize(
    "nodes",
    [
        [node("/a", publisher("images"), subscriber("image"))],  # one node tells them apart
        [node("/a", publisher("images")), node("/b", subscriber("image", type="std_msgs/msg/Bool"))],
        [node("/a", publisher("images")), node("/b", subscriber("image")), node("/c", publisher("image"))],
        [node("/a", publisher("images")), node("/b", subscriber("image"), package="elsewhere")],
    ],
)
def test_no_near_miss(nodes):
    assert findings(system(*nodes), "TOP004") == []


BEST_EFFORT = Qos(reliability="best_effort")
LATCHED = Qos(durability="transient_local")


@pytest.mark.parametrize(
    ("offered", "requested", "codes"),
    [
        (BEST_EFFORT, Qos(), ["QOS001"]),
        (Qos(), BEST_EFFORT, []),
        (Qos(), LATCHED, ["QOS002"]),
        (LATCHED, Qos(), []),
        (BEST_EFFORT, LATCHED, ["QOS001", "QOS002"]),
        (Qos(), Qos(deadline=0.1), ["QOS003"]),
        (Qos(deadline=0.1), Qos(deadline=0.5), []),
        (Qos(liveliness="automatic"), Qos(liveliness="manual_by_topic"), ["QOS003"]),
        (Qos(), Qos(liveliness="manual_by_topic"), []),  # the middleware decides the default
        (Qos(reliability="system_default"), Qos(), []),
        (Qos(reliability="best_available"), Qos(), []),
        (Qos(reliability=None), Qos(), []),
        (Qos(reliability="best_effort", overridable=True), Qos(), []),
    ],
)
def test_an_offer_and_a_request(offered: Qos, requested: Qos, codes: list[str]):
    pair = system(node("/a", publisher("said", qos=offered)), node("/b", subscriber("said", qos=requested)))
    assert [one.code for one in findings(pair, "QOS001", "QOS002", "QOS003")] == codes


def test_the_one_bad_publisher_of_three_is_named():
    [found] = findings(
        system(
            node("/good", publisher("said")),
            node("/bad", publisher("said", qos=BEST_EFFORT)),
            node("/fine", publisher("said")),
            node("/b", subscriber("said")),
        ),
        "QOS001",
    )
    assert [one.message for one in found.related] == ["/bad offers best effort"]


@pytest.mark.parametrize(
    ("qos", "wrong"),
    [
        (Qos(history="keep_all", depth=5, explicit=frozenset({"depth", "history"})), True),
        (Qos(history="keep_all"), False),
        (Qos(depth=0), True),
        (Qos(depth=1), False),
        (Qos(depth=None), False),
    ],
)
def test_a_profile_against_itself(qos: Qos, wrong: bool):
    assert bool(findings(system(node("/a", publisher("said", qos=qos))), "QOS004")) is wrong
