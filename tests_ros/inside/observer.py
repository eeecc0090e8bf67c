"""Asks a running graph from outside, through the middleware: a server that ``tests_ros/running.py`` starts.

``{"domain": 7}`` on a line of the standard input joins a domain; ``{"nodes": {name: {kind: [[name, type], …]}},
"limit": 10}`` on the next asks: the answer, a line too, has what each node of the domain has, as soon as all that is
expected is there, or after ``limit`` seconds.
"""

from __future__ import annotations

import ctypes
import json
import signal
import sys
import time
from typing import Any

import rclpy
from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)
from rclpy.node import Node

QUIET_S = 0.3
"""How long nothing new must arrive once all that is expected is there."""
LATE_S = 3.0
"""The same, where a node has no /rosout: it may have been told to have none."""
OBSERVER = "/graph_observer"
KINDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")


def main() -> None:
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: not to outlive the tests
    for line in sys.stdin:
        context = rclpy.Context()
        rclpy.init(context=context, domain_id=json.loads(line)["domain"])
        node = Node(OBSERVER[1:], context=context, start_parameter_services=False, enable_rosout=False)
        print("here", flush=True)
        question = json.loads(sys.stdin.readline())
        print(json.dumps(answer(node, **question)), flush=True)
        node.destroy_node()
        rclpy.shutdown(context=context)


def answer(node: Node, nodes: dict[str, Any], limit: float) -> dict[str, Any]:
    start = covered = time.monotonic()
    before: dict[str, Any] = {}
    while True:
        found, now = graph(node), time.monotonic()
        if found != before or not covers(found, nodes):
            covered = now
        before = found
        quiet = QUIET_S if all(logs(found[name]) for name in nodes if name in found) else LATE_S
        if now - covered > quiet or now - start > limit:
            return found
        time.sleep(0.1)


def logs(kinds: dict[str, Any]) -> bool:
    """Whether what rcl makes for almost every node, without the node's knowing, has arrived."""
    return any(end[0] == "/rosout" for end in kinds["publishers"])


def covers(seen: dict[str, Any], expected: dict[str, Any]) -> bool:
    return all(
        name in seen
        and {tuple(one[:2]) for one in expected[name][kind]} <= {tuple(one[:2]) for one in seen[name][kind]}
        for name in expected
        for kind in KINDS
    )


def graph(node: Node) -> dict[str, Any]:
    found = {}
    for name, namespace in node.get_node_names_and_namespaces():
        full = f"{namespace.rstrip('/')}/{name}"
        if full == OBSERVER or name.startswith("_"):
            continue
        try:
            found[full] = ends(node, name, namespace)
        except rclpy.node.NodeNameNonExistentError:
            continue  # known by name, and nothing else of it has arrived
    return found


def ends(node: Node, name: str, namespace: str) -> dict[str, Any]:
    asked = {
        "publishers": node.get_publisher_names_and_types_by_node(name, namespace),
        "subscribers": node.get_subscriber_names_and_types_by_node(name, namespace),
        "services": node.get_service_names_and_types_by_node(name, namespace),
        "clients": node.get_client_names_and_types_by_node(name, namespace),
        "action_servers": get_action_server_names_and_types_by_node(node, name, namespace),
        "action_clients": get_action_client_names_and_types_by_node(node, name, namespace),
    }
    found = {kind: sorted([one, type_] for one, types in pairs for type_ in types) for kind, pairs in asked.items()}
    questions = {"publishers": node.get_publishers_info_by_topic, "subscribers": node.get_subscriptions_info_by_topic}
    for kind, ask in questions.items():
        for end in found[kind]:
            mine = [one for one in ask(end[0]) if (one.node_name, one.node_namespace) == (name, namespace)]
            end.append([policies(one.qos_profile) for one in mine if one.topic_type == end[1]])
    return found


def policies(profile: Any) -> dict[str, str]:
    """What the middleware passes on of a profile; history and depth are not."""
    return {"reliability": profile.reliability.name.lower(), "durability": profile.durability.name.lower()}


if __name__ == "__main__":
    main()
