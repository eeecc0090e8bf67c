"""The other end of a program of the matrix: serves, publishes and asks what its cell needs, under a real rclpy."""

from __future__ import annotations

import time
from collections.abc import Callable

import rclpy
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

PERIOD_S = 0.2


def run(needs: list[str], latency: float) -> None:
    """Serves forever; ``needs`` are words of ``NEEDS``, ``latency`` what the service takes, in seconds."""
    rclpy.init()
    node = Node("other")
    group = ReentrantCallbackGroup()

    def serve(request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        time.sleep(latency)
        response.success = True
        return response

    node.create_service(Trigger, "inner", serve, callback_group=group)
    for need in needs:
        NEEDS[need](node)
    executor = MultiThreadedExecutor(num_threads=24) if latency else SingleThreadedExecutor()
    executor.add_node(node)
    executor.spin()


def publish(node: Node) -> None:
    publisher = node.create_publisher(String, "go", 10)
    node.create_timer(PERIOD_S, lambda: publisher.publish(String(data="go")))


def ask(node: Node) -> None:
    _send(node, node.create_client(Trigger, "outer"), Trigger.Request())


def set_parameter(node: Node) -> None:
    value = ParameterValue(type=ParameterType.PARAMETER_INTEGER, integer_value=1)
    request = SetParameters.Request(parameters=[Parameter(name="speed", value=value)])
    _send(node, node.create_client(SetParameters, "/asker/set_parameters"), request)


def _send(node: Node, client: Client, request: object) -> None:
    node.create_timer(PERIOD_S, lambda: client.service_is_ready() and client.call_async(request))


def send_goals(node: Node) -> None:
    client = ActionClient(node, Fibonacci, "outer_action")
    node.create_timer(PERIOD_S, lambda: client.server_is_ready() and client.send_goal_async(Fibonacci.Goal()))


def cancel_goals(node: Node) -> None:
    client = ActionClient(node, Fibonacci, "outer_action")

    def accepted(future: Future) -> None:
        future.result().cancel_goal_async()

    def send() -> None:
        if client.server_is_ready():
            client.send_goal_async(Fibonacci.Goal()).add_done_callback(accepted)

    node.create_timer(PERIOD_S, send)


def serve_goals(node: Node) -> None:
    def execute(goal: object) -> Fibonacci.Result:
        goal.publish_feedback(Fibonacci.Feedback())  # type: ignore[attr-defined]
        goal.succeed()  # type: ignore[attr-defined]
        return Fibonacci.Result()

    ActionServer(node, Fibonacci, "inner_action", execute)


def send_transforms(node: Node) -> None:
    from tf2_msgs.msg import TFMessage  # built for the programs that ask for it only

    publisher = node.create_publisher(TFMessage, "/tf", 10)

    def send() -> None:
        transform = TransformStamped(child_frame_id="base")
        transform.header.frame_id = "map"
        transform.header.stamp = node.get_clock().now().to_msg()
        publisher.publish(TFMessage(transforms=[transform]))

    node.create_timer(PERIOD_S, send)


NEEDS: dict[str, Callable[[Node], None]] = {
    "publish": publish,
    "ask": ask,
    "set_parameter": set_parameter,
    "send_goals": send_goals,
    "cancel_goals": cancel_goals,
    "send_transforms": send_transforms,
    "serve_goals": serve_goals,
}
"""What a program may need besides the service ``inner``."""
