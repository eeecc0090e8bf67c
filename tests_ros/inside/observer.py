"""Asks a running graph from outside, through the middleware.

``main`` runs in a fork of ``server.py``: it joins a domain and writes to the record, as JSON, what each node of the
domain has, whenever that has changed, until the process is killed.
"""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import rclpy
from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)
from rclpy.node import Node

LOOK_S = 0.4
OBSERVER = "/graph_observer"


def main(record: str) -> None:
    rclpy.init()
    node = Node(OBSERVER[1:], start_parameter_services=False, enable_rosout=False)
    written = ""
    while True:
        text = json.dumps(graph(node), sort_keys=True)
        if text != written:
            part = Path(record + ".part")
            part.write_text(text)
            part.rename(record)
            written = text
        time.sleep(LOOK_S)


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
