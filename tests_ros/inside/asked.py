"""Asks a real rclpy what it makes of names, remap rules, QoS pairs and parameter files: JSON in, JSON out.

A question is ``{"names": […], "nodes": […], "namespaces": […], "remaps": [[rule, …], …], "qos": [[offer, request],
…], "parameters": FILE, "declared": {name: default}}``; a profile is a dictionary of policies, durations in seconds.
What is refused is answered with the name of the exception in angle brackets.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Empty
from std_srvs.srv import Trigger

MATCHED_S = 10.0


def main() -> None:
    question = json.load(sys.stdin)
    answer: dict[str, Any] = {}
    rclpy.init()
    node = Node("asker", namespace="/left")
    ends = question["names"]
    answer["names"] = [tried(lambda one: node.create_publisher(Empty, one, 1).topic_name, one) for one in ends]
    answer["services"] = [tried(lambda one: node.create_client(Trigger, one).service_name, one) for one in ends]
    answer["nodes"] = [tried(lambda one: Node(one).get_name(), one) for one in question["nodes"]]
    answer["namespaces"] = [
        tried(lambda one: Node("one", namespace=one).get_namespace(), one) for one in question["namespaces"]
    ]
    answer["remaps"] = [tried(remapped, rules) for rules in question["remaps"]]
    answer["qos"] = matched(node, question["qos"])
    setting = Node("holder", cli_args=["--ros-args", "--params-file", question["parameters"]])
    answer["parameters"] = {
        name: tried(lambda given: shown(setting.declare_parameter(*given).value), (name, default))
        for name, default in question["declared"].items()
    }
    json.dump(answer, sys.stdout)


def tried(ask: Callable[[Any], str], given: Any) -> str:
    try:
        return ask(given)
    except Exception as error:
        return f"<{type(error).__name__}>"


def shown(value: object) -> str:
    return repr(value if isinstance(value, (bool, int, float, str)) else list(value))  # type: ignore[call-overload]


def remapped(rules: list[str]) -> str:
    """What a process with these rules makes of a node, its topic ``scan``, and its service ``scan``."""
    context = Context()
    rclpy.init(context=context, args=["--ros-args", *(word for rule in rules for word in ("-r", rule))])
    try:
        node = Node("asker", context=context)
        topic = node.create_publisher(Empty, "scan", 1).topic_name
        return f"{node.get_fully_qualified_name()} {topic} {node.create_client(Trigger, 'scan').service_name}"
    finally:
        context.shutdown()


def profile(given: dict[str, Any]) -> QoSProfile:
    made = QoSProfile(
        depth=1,
        reliability=ReliabilityPolicy[given["reliability"].upper()],
        durability=DurabilityPolicy[given["durability"].upper()],
        liveliness=LivelinessPolicy[given["liveliness"].upper()],
    )
    if given["deadline"] is not None:
        made.deadline = Duration(seconds=given["deadline"])
    if given["liveliness_lease"] is not None:
        made.liveliness_lease_duration = Duration(seconds=given["liveliness_lease"])
    return made


def matched(node: Node, pairs: list[list[dict[str, Any]]]) -> list[bool]:
    """Whether a publisher with the one profile and a subscription with the other find each other."""
    publishers = []
    for number, (offer, request) in enumerate(pairs):
        publishers.append(node.create_publisher(Empty, f"pair_{number}", profile(offer)))
        node.create_subscription(Empty, f"pair_{number}", lambda message: None, profile(request))
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    # The pairs are matched in the order in which they were made: once the last one, which is good, has met, all have.
    end = time.monotonic() + MATCHED_S
    while not publishers[-1].get_subscription_count() and time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    time.sleep(0.5)
    return [publisher.get_subscription_count() > 0 for publisher in publishers]


if __name__ == "__main__":
    main()
