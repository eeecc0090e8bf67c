#!/usr/bin/env python3
"""Writes down, as JSON, what a running ROS 2 system says of itself: nodes, topics, services, actions, types and QoS.

    archlint observe --print-script -o record.py
    python3 record.py -o robot.json                  # where ROS 2 is sourced and the system runs
    archlint check --launch robot.launch.py --observed robot.json

One file that needs rclpy and nothing else, from Humble on.  It only looks: it publishes nothing and changes nothing.
Hidden nodes, such as the daemon of the ros2 command and this program itself, are left out.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections import Counter
from typing import Any

import rclpy
from rclpy.action import get_action_client_names_and_types_by_node, get_action_server_names_and_types_by_node
from rclpy.node import Node
from rclpy.utilities import get_rmw_implementation_identifier

QUIET_S = 2.0
"""How long nothing new must be discovered until the picture counts as whole."""
LATE_S = 6.0
"""The same, where of some node nothing but its name has arrived."""
STEP_S = 0.2
ANSWER_S = 2.0
"""How long a node may take to list its parameters."""
FOREVER_S = 9e9
"""From this many seconds on, a duration is one that the middleware calls infinite."""

PARAMETER_TYPES = {
    1: ("bool", "bool_value"),
    2: ("integer", "integer_value"),
    3: ("double", "double_value"),
    4: ("string", "string_value"),
    5: ("byte_array", "byte_array_value"),
    6: ("bool_array", "bool_array_value"),
    7: ("integer_array", "integer_array_value"),
    8: ("double_array", "double_array_value"),
    9: ("string_array", "string_array_value"),
}
"""``rcl_interfaces/msg/ParameterType``: its name, and the field of a ParameterValue that holds it."""

Entity = dict[str, Any]


def main() -> int:
    arguments = parser().parse_args()
    rclpy.init(args=[])
    node = rclpy.create_node(
        f"_archlint_recorder_{os.getpid()}",
        enable_rosout=False,
        start_parameter_services=False,
        use_global_arguments=False,
    )
    try:
        settled = wait(node, arguments.seconds)
        nodes = [described(node, name, count) for name, count in names(node).items()]
        if arguments.parameters:
            for entry in nodes:
                entry["parameters"] = parameters(node, entry["name"])
    except KeyboardInterrupt:
        return 130
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
    return written(nodes, settled, arguments)


def parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description="Record the graph of a running ROS 2 system as JSON.")
    parser.add_argument("-o", metavar="FILE", dest="file", help="write to FILE (default: standard output)")
    parser.add_argument(
        "--seconds",
        type=float,
        default=15.0,
        help=(
            f"record for at most this many seconds; ends earlier when nothing new appears for {QUIET_S:g} s "
            "(default: 15)"
        ),
    )
    parser.add_argument("--parameters", action="store_true", help="ask each node for its parameters, too")
    return parser


def written(nodes: list[Entity], settled: bool, arguments: argparse.Namespace) -> int:
    """Writes the result; the exit status: 1 where there is nothing to write."""
    domain = os.environ.get("ROS_DOMAIN_ID") or "0"
    if not nodes:
        print(f"no node is running in ROS_DOMAIN_ID {domain}, or none can be reached from here", file=sys.stderr)
        return 1
    if not settled:
        print(f"something new still appeared after {arguments.seconds:g} s: try a larger --seconds", file=sys.stderr)
    record = {
        "archlint_observed": 1,
        "ros_distro": os.environ.get("ROS_DISTRO"),
        "rmw_implementation": get_rmw_implementation_identifier(),
        "domain_id": int(domain) if domain.isdecimal() else None,
        "settled": settled,
        "nodes": nodes,
    }
    text = json.dumps(record, indent=1) + "\n"
    if arguments.file in (None, "-"):
        sys.stdout.write(text)
    else:
        with open(arguments.file, "w", encoding="utf-8") as stream:
            stream.write(text)
        print(f"{len(nodes)} nodes written to {arguments.file}", file=sys.stderr)
    return 0


def wait(node: Node, limit: float) -> bool:
    """Waits for the discovery; whether it came to rest within ``limit`` seconds.  Nothing at all is no rest before."""
    start = changed = time.monotonic()
    before: list[Any] = []
    while time.monotonic() - start < limit:
        graph = [(name, count, ends(node, name)) for name, count in names(node).items()]
        bare = any(not any(has.values()) for _, _, has in graph)
        if graph != before:
            before, changed = graph, time.monotonic()
        elif graph and time.monotonic() - changed >= (LATE_S if bare else QUIET_S):
            return True
        time.sleep(STEP_S)
    return not before


def names(node: Node) -> dict[str, int]:
    """The full name of each node that is not hidden, and how many nodes have it."""
    counter: Counter[str] = Counter()
    for name, namespace in node.get_node_names_and_namespaces():
        if not name.startswith("_"):
            counter[f"{namespace.rstrip('/')}/{name}"] += 1
    return dict(sorted(counter.items()))


def ends(node: Node, full: str) -> dict[str, list[tuple[str, str]]]:
    """Name and type of everything that a node has, by kind."""
    namespace, _, name = full.rpartition("/")
    of = (name, namespace or "/")
    asked = {
        "publishers": lambda: node.get_publisher_names_and_types_by_node(*of),
        "subscribers": lambda: node.get_subscriber_names_and_types_by_node(*of),
        "services": lambda: node.get_service_names_and_types_by_node(*of),
        "clients": lambda: node.get_client_names_and_types_by_node(*of),
        "action_servers": lambda: get_action_server_names_and_types_by_node(node, *of),
        "action_clients": lambda: get_action_client_names_and_types_by_node(node, *of),
    }
    return {kind: pairs(ask) for kind, ask in asked.items()}


def pairs(ask: Any) -> list[tuple[str, str]]:
    try:
        return sorted((name, type_) for name, types in ask() for type_ in types)
    except Exception:  # the node is gone, or only its name has arrived; its class differs between distributions
        return []


def described(node: Node, full: str, count: int) -> Entity:
    endpoints = ends(node, full)
    entry: Entity = {"name": full, "count": count}
    for kind, known in endpoints.items():
        entry[kind] = [{"name": name, "type": type_} for name, type_ in known]
    entry["publishers"] = with_qos(endpoints["publishers"], node.get_publishers_info_by_topic, full)
    entry["subscribers"] = with_qos(endpoints["subscribers"], node.get_subscriptions_info_by_topic, full)
    return entry


def with_qos(known: list[tuple[str, str]], ask: Any, full: str) -> list[Entity]:
    """One entry for each end of a node, with its QoS; without it where the middleware reports none."""
    entries: list[Entity] = []
    for name, type_ in known:
        infos = [info for info in ask(name) if f"{info.node_namespace.rstrip('/')}/{info.node_name}" == full]
        profiles: list[Entity | None] = [qos(info.qos_profile) for info in infos if info.topic_type == type_]
        profiles.sort(key=lambda profile: json.dumps(profile, sort_keys=True))
        entries += [{"name": name, "type": type_, "qos": profile} for profile in profiles or [None]]
    return entries


def qos(profile: Any) -> Entity:
    return {
        "history": word(profile.history),
        "depth": profile.depth,
        "reliability": word(profile.reliability),
        "durability": word(profile.durability),
        "deadline_s": seconds(profile.deadline),
        "lifespan_s": seconds(profile.lifespan),
        "liveliness": word(profile.liveliness),
        "lease_s": seconds(profile.liveliness_lease_duration),
    }


def word(policy: Any) -> str:
    """``best_effort``: the policy's name, without the prefix that older distributions put before it."""
    known = [name for name, value in type(policy).__members__.items() if value == policy and not name.startswith("RMW")]
    return known[0].lower() if known else "unknown"


def seconds(duration: Any) -> float | None:
    """None where nothing is set, or where the duration is infinite."""
    length = duration.nanoseconds / 1e9
    return length if 0 < length < FOREVER_S else None


def parameters(node: Node, full: str) -> list[Entity] | None:
    """The parameters that a node declares; None where it does not answer."""
    from rcl_interfaces.srv import GetParameters, ListParameters

    listed = answer(node, ListParameters, f"{full}/list_parameters", ListParameters.Request())
    if listed is None:
        return None
    known = sorted(listed.result.names)
    got = answer(node, GetParameters, f"{full}/get_parameters", GetParameters.Request(names=known))
    if got is None or len(got.values) != len(known):
        return None
    return [parameter(name, value) for name, value in zip(known, got.values)]  # noqa: B905


def answer(node: Node, type_: Any, name: str, request: Any) -> Any:
    """What a service answers; None where it does not in time."""
    client = node.create_client(type_, name)
    try:
        if not client.wait_for_service(timeout_sec=ANSWER_S):
            return None
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future, timeout_sec=ANSWER_S)
        return future.result() if future.done() else None
    finally:
        node.destroy_client(client)


def parameter(name: str, value: Any) -> Entity:
    if value.type not in PARAMETER_TYPES:
        return {"name": name, "type": None, "value": None}
    type_, attribute = PARAMETER_TYPES[value.type]
    known = getattr(value, attribute)
    if type_ == "byte_array":
        known = [byte[0] if isinstance(byte, bytes) else int(byte) for byte in known]
    return {"name": name, "type": type_, "value": list(known) if type_.endswith("_array") else known}


if __name__ == "__main__":
    sys.exit(main())
