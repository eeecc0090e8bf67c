"""Ways of writing a name, to everything that takes one."""

from __future__ import annotations

from outcomes import tell
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from std_msgs.msg import Empty
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

LONG = "x" * 260
WRITTEN = (
    "plain", "/absolute", "a/b", "~", "~/mine", "{node}/x", "/{ns}/x", "{ns}/x", "{node", "", "/", "a/", "a//b",
    "1st", "a/1st", "with space", "a-b", "ä", "a~b", "~mine", "a.b", "_hidden", "a/_hidden", "{other}", LONG, None, 5,
    "a__b", "__a", "_", "a/~/b", "{node}{node}", "//a",
)  # fmt: skip


def publisher(node, name):
    return node.create_publisher(Empty, name, 1).topic_name


def subscription(node, name):
    return node.create_subscription(Empty, name, print, 1).topic_name


def service(node, name):
    return node.create_service(Trigger, name, print).service_name


def client(node, name):
    return node.create_client(Trigger, name).service_name


def action_client(node, name):
    return ActionClient(node, Fibonacci, name)


def action_server(node, name):
    return ActionServer(node, Fibonacci, name, print)


CREATE = (publisher, subscription, service, client, action_client, action_server)


def main():
    node = []
    calls = [lambda node, create=create, name=name: create(node, name) for create in CREATE for name in WRITTEN]
    tell("names", calls, lambda: node[0] if node else node.append(Node("named", namespace="in_space")) or node[0])


if __name__ == "__main__":
    main()
