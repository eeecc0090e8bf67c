"""MSG004: annotations of callbacks that name another type than they get."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
from __future__ import annotations

from typing import Any, Optional

import geometry_msgs.msg
import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from geometry_msgs.msg import Twist as Command
from rclpy.node import Node
from std_srvs.srv import SetBool, Trigger

try:
    from nav_msgs.msg import Odometry as State
except ImportError:
    from geometry_msgs.msg import PoseStamped as State


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(TwistStamped, 'in', self.listen, 10)
        self.create_service(Trigger, 'stop', self.stop)

    def listen(self, message{message}
        print(message.header)

    def stop(self, request{request}
        return response


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("annotation", "says"),
    [
        (
            "Twist",
            "is annotated as geometry_msgs/msg/Twist, but the subscription of 'in' passes geometry_msgs",
        ),
        ("Command", "is annotated as geometry_msgs/msg/Twist"),
        ("geometry_msgs.msg.Twist", "is annotated as geometry_msgs/msg/Twist"),
    ],
)
def test_a_message_that_is_annotated_as_another(judge: Judge, annotation: str, says: str):
    [finding] = judge("MSG004", NODE.format(message=f": {annotation}):  # here", request=", response):"))
    assert says in finding.message


def test_a_request_and_a_response_of_another_service_are_one_finding(judge: Judge):
    request = ": SetBool.Request, response: SetBool.Response):  # here"
    [finding] = judge("MSG004", NODE.format(message="):", request=request))
    assert finding.message == (
        "'request' is annotated as std_srvs/srv/SetBool.Request, but the service of 'stop' passes "
        "std_srvs/srv/Trigger.Request; another parameter is of that service, too"
    )
    assert finding.help == "annotate it as Trigger.Request if the service is right, else give the service SetBool"


def test_a_request_that_is_annotated_as_the_response(judge: Judge):
    request = ": Trigger.Response, response: Trigger.Response):  # here"
    [finding] = judge("MSG004", NODE.format(message="):", request=request))
    assert "'request' is annotated as std_srvs/srv/Trigger.Response" in finding.message


@pytest.mark.parametrize(
    ("message", "request_"),
    [
        (": TwistStamped):", ": Trigger.Request, response: Trigger.Response) -> Trigger.Response:"),
        (": geometry_msgs.msg.TwistStamped):", ": Trigger, response):"),
        (": 'Twist'):", ": Any, response):"),
        (": Optional[Twist]):", ", response: SetBool):  # archlint: ignore[MSG004]"),
        (": Twist | None):", ", response):"),
        (": Robot):", ", response):"),
        (": State):", ", response):"),
        (", count: Twist = None):", ", response):"),
    ],
)
def test_an_annotation_that_fits_or_says_nothing_certain(judge: Judge, message: str, request_: str):
    assert not judge("MSG004", NODE.format(message=message, request=request_))


def test_a_callback_that_two_subscriptions_share(judge: Judge):
    source = """
from geometry_msgs.msg import Twist, TwistStamped
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(TwistStamped, 'a', self.listen, 10)
        self.create_subscription(Twist, 'b', self.listen, 10)

    def listen(self, message: Twist):
        print(message)
"""
    assert not judge("MSG004", source)


def test_a_type_that_is_nowhere_defined_is_told_at_its_import(judge: Judge):
    """MSG002 says that the node does not start: whoever takes the import out, changes the annotation, too."""
    source = NODE.format(message=": Quote):", request=", response):")
    source = source.replace("from std_srvs.srv", "from geometry_msgs.msg import Quote\nfrom std_srvs.srv")
    judge("MSG004", source)
    judge("MSG002", source.replace("import Quote", "import Quote  # here"))


PUBLISHES = """
from geometry_msgs.msg import Twist, TwistStamped
from rclpy.node import Node
from sensor_msgs.msg import Image


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_publisher({type}, 'in', 10)
"""


@pytest.mark.parametrize(
    ("type", "help"),
    [
        ("TwistStamped", "annotate it as TwistStamped"),
        ("Twist", "give the subscription Twist, which is published there"),
    ],
)
def test_what_is_published_says_which_of_the_two_is_wrong(judge: Judge, type: str, help: str):
    source = NODE.format(message=": Twist):  # here", request=", response):")
    [finding] = judge("MSG004", source, PUBLISHES.format(type=type))
    assert finding.help == help


def test_where_a_third_type_is_published_neither_is_right(judge: Judge):
    """TOP001 says what the topic lacks; nobody knows what the callback is for."""
    assert not judge("MSG004", NODE.format(message=": Twist):", request=", response):"), PUBLISHES.format(type="Image"))


@pytest.mark.parametrize(("read", "mark"), [("linear", ""), ("header", "  # here"), ("angle", "  # here")])
def test_a_field_of_the_annotation_that_the_message_has_not(judge: Judge, read: str, mark: str):
    """MSG001 tells that, at the line that fails."""
    source = NODE.format(message=f": Twist):{mark}", request=", response):")
    judge("MSG004", source.replace("message.header", f"message.{read}"))
