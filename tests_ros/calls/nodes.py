"""Nodes, types, callbacks, timers and command lines, as they should be and as they should not."""

from __future__ import annotations

import rclpy
from names import LONG, client, publisher
from outcomes import fresh, tell
from rclpy.action import ActionClient, ActionServer
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import Empty
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci


def publisher_of(node, type_):
    return node.create_publisher(type_, "x", 1)


def answer(request, response):
    return response


def node_called(*arguments, **options):
    return lambda _: Node(*arguments, **options).get_fully_qualified_name()


def on_command_line(*words, then=lambda node: publisher(node, "topic")):
    """What becomes of a node that is given words of a command line."""

    def call(_):
        return then(fresh(cli_args=["--ros-args", *words]))

    return call


CALLS = [
    # Nodes
    node_called("a"),
    node_called("a", namespace="b"),
    node_called("a", namespace="/b"),
    node_called("a", namespace="/b/"),
    node_called("a", namespace=""),
    node_called("a", namespace="/"),
    node_called("a", namespace="b c"),
    node_called("a", namespace="1b"),
    node_called("a", namespace="b//c"),
    node_called("a/b"),
    node_called(""),
    node_called("1a"),
    node_called("a b"),
    node_called("/a"),
    node_called("a-b"),
    node_called(None),
    node_called(7),
    node_called(LONG),
    node_called(),
    node_called("a", "b"),
    node_called("a", unheard_of=1),
    lambda _: LifecycleNode("managed").get_name(),
    lambda _: LifecycleNode("managed", namespace="x").get_fully_qualified_name(),
    lambda _: rclpy.create_node("made", namespace="x").get_fully_qualified_name(),
    # Types and callbacks
    lambda node: publisher_of(node, Trigger),
    lambda node: publisher_of(node, "std_msgs/msg/Empty"),
    lambda node: publisher_of(node, None),
    lambda node: node.create_client(Empty, "x"),
    lambda node: node.create_subscription(Empty, "x", None, 1),
    lambda node: node.create_subscription(Empty, "x", lambda: None, 1),
    lambda node: bool(node.create_subscription(Empty, "x", lambda a, b: None, 1)),
    lambda node: node.create_subscription(Empty, "x", lambda a, b, c: None, 1),
    lambda node: bool(node.create_service(Trigger, "x", None)),
    lambda node: node.create_publisher(Empty, "x"),
    lambda node: node.create_subscription(Empty, "x", 1),
    lambda node: bool(ActionServer(node, Fibonacci, "x", None)),
    lambda node: ActionClient("node", Fibonacci, "x"),
    # QoS that is none
    lambda node: node.create_publisher(Empty, "x", None),
    lambda node: node.create_publisher(Empty, "x", "10"),
    lambda node: node.create_publisher(Empty, "x", 1.0),
    lambda node: node.create_publisher(Empty, "x", -1),
    lambda node: bool(node.create_publisher(Empty, "x", True)),
    lambda node: bool(node.create_client(Trigger, "x", qos_profile=10)),
    lambda node: bool(node.create_service(Trigger, "x", answer, qos_profile=10)),
    # Timers
    lambda node: node.create_timer(0.1, None).timer_period_ns,
    lambda node: node.create_timer(1 / 30, print).timer_period_ns,
    lambda node: node.create_timer(0, print).timer_period_ns,
    lambda node: node.create_timer(-1, print).timer_period_ns,
    lambda node: node.create_timer("0.5", print).timer_period_ns,
    lambda node: node.create_timer(None, print).timer_period_ns,
    lambda node: node.create_rate(0),
    lambda node: bool(node.create_rate(10)),
    # Command lines
    on_command_line("-r", "topic:=other"),
    on_command_line("-r", "/topic:=/other"),
    on_command_line("-r", "topic:=~/other", then=lambda node: publisher(node, "topic").count("/")),
    on_command_line("-r", "nothing:=other"),
    on_command_line("-r", "topic:=a", "-r", "topic:=b"),
    on_command_line("-r", "someone:topic:=other"),
    on_command_line("-r", "__node:=renamed", then=lambda node: node.get_name()),
    on_command_line("-r", "__name:=renamed", then=lambda node: node.get_name()),
    on_command_line("-r", "__ns:=/moved", then=lambda node: node.get_namespace()),
    on_command_line("-r", "__ns:=moved", then=lambda node: node.get_namespace()),
    on_command_line("-r", "__ns:=/moved"),
    on_command_line("-r", "rostopic://topic:=other"),
    on_command_line("-r", "rosservice://topic:=other"),
    on_command_line("-r", "topic:=other", then=lambda node: client(node, "topic")),
    on_command_line("-r", "topic:=a//b"),
    on_command_line("-r", "topic"),
    on_command_line("-p", "p:=5", then=lambda node: node.declare_parameter("p", 1).value),
    on_command_line("-p", "p:=text", then=lambda node: node.declare_parameter("p", "default").value),
    on_command_line("-p", "p:=[1, 2]", then=lambda node: list(node.declare_parameter("p", [3]).value)),
    on_command_line("-p", "p:=text", then=lambda node: node.declare_parameter("p", 1).value),
    on_command_line("-p", "use_sim_time:=true", then=lambda node: node.get_parameter("use_sim_time").value),
    on_command_line("-r", "topic:=other", then=lambda node: node.resolve_topic_name("topic")),
    on_command_line("-r", "topic:=other", then=lambda node: node.resolve_topic_name("topic", only_expand=True)),
    on_command_line("-r", "topic:=other", then=lambda node: node.resolve_service_name("topic")),
    # Running
    lambda _: rclpy.init(),
    lambda _: rclpy.ok(),
]  # fmt: skip


def main():
    node = []
    tell("nodes", CALLS, lambda: node[0] if node else node.append(Node("used")) or node[0])


if __name__ == "__main__":
    main()
