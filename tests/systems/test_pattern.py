"""Which pattern a system resembles: small robots of each kind."""

from __future__ import annotations

import sys
from collections.abc import Callable
from itertools import pairwise

from archlint.systems.model import System
from archlint.systems.pattern import HUB, MANY, REQUESTS, Hub, figures, words
from systems.builders import client, node, publisher, service, subscriber, system


def star(spokes: int) -> System:
    names = [f"arm_{number}" for number in range(spokes)]
    center = [*(subscriber(f"{name}/state") for name in names), *(publisher(f"{name}/goal") for name in names)]
    modules = [node(f"/{name}", publisher(f"{name}/state"), subscriber(f"{name}/goal")) for name in names]
    return system(node("/coordinator", *center), *modules)


def test_a_coordinator_and_its_modules():
    found = figures(star(4))
    assert (found.pattern, found.hubs) == (HUB, (Hub("/coordinator", 4, 4),))
    assert found.components == 1 and found.isolated == 0


def test_topics_without_a_centre():
    found = figures(
        system(
            node("/camera", publisher("image")),
            node("/lidar", publisher("scan")),
            node("/detector", subscriber("image"), publisher("objects")),
            node("/mapper", subscriber("scan"), subscriber("image"), publisher("map")),
            node("/planner", subscriber("objects"), subscriber("map"), publisher("path")),
            node("/control", subscriber("path"), subscriber("scan")),
        )
    )
    assert found.pattern == MANY


def test_a_chain_of_three_has_no_hub():
    found = figures(
        system(
            node("/sensors", publisher("camera"), publisher("lidar"), publisher("imu")),
            node("/planning", subscriber("camera"), subscriber("lidar"), subscriber("imu"), publisher("motion")),
            node("/actuators", subscriber("motion"), publisher("motor_state")),
        )
    )
    assert found.pattern == MANY


def test_a_coordinator_that_commands_by_service():
    names = ("motor", "arm", "head", "legs")
    modules = [node(f"/{name}", publisher(f"{name}/status"), service(f"{name}/command")) for name in names]
    states = [subscriber(f"{name}/status") for name in names]
    commands = [client(f"{name}/command") for name in names]
    assert figures(system(node("/main", *states, *commands), *modules)).pattern == HUB
    assert figures(system(node("/main", *states[:1], *commands), *modules)).pattern == REQUESTS


def test_callers_and_what_they_ask():
    found = figures(
        system(
            node("/mission", client("plan"), client("grip")),
            node("/planner", service("plan"), client("map")),
            node("/map", service("map")),
            node("/gripper", service("grip"), publisher("state")),
        )
    )
    assert found.pattern == REQUESTS
    assert found.chain == ("/mission", "/planner", "/map")


def test_nodes_that_ask_each_other_count_as_one():
    found = figures(
        system(
            node("/a", client("b"), service("a")),
            node("/b", client("a"), service("b"), client("c")),
            node("/c", service("c")),
        )
    )
    assert found.chain == ("/a and /b", "/c")


def test_what_everybody_shares_ties_nobody():
    found = figures(system(*(node(f"/n{number}", publisher("/tf"), subscriber("/tf")) for number in range(5))))
    assert found.pairs == {"topic": 0, "service": 0, "action": 0}


def test_a_node_that_holds_two_parts_together():
    chain = ["a", "b", "bridge", "c", "d"]
    links = [*pairwise(chain)]
    nodes = [
        node(
            f"/{name}",
            *(publisher(f"{one}_{other}") for one, other in links if one == name),
            *(subscriber(f"{one}_{other}") for one, other in links if other == name),
        )
        for name in chain
    ]
    assert figures(system(*nodes)).bridges == ("/bridge",)


def test_two_nodes_are_no_pattern():
    found = figures(system(node("/a", publisher("x")), node("/b", subscriber("x")), node("/c")))
    assert found.pattern is None
    assert words(found)[1:] == [
        "connected: 2 of 3 nodes; pairs 1 by topics",
        "parts: 1 group of connected nodes, 1 node alone",
    ]


def calls(action: Callable[[], object]) -> int:
    """How many functions an action calls."""
    counted = 0

    def count(frame: object, event: str, argument: object) -> None:
        nonlocal counted
        counted += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        action()
    finally:
        sys.setprofile(None)
    return counted


def test_twice_the_nodes_are_twice_the_work():
    small, large = star(200), star(400)
    assert figures(large).pattern == HUB
    assert calls(lambda: figures(large)) < 3 * calls(lambda: figures(small))
