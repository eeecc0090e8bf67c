"""Stand-in for tf2_ros (Python)."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface
from benchmarks.accuracy.oracle.later import finished, nobody
from benchmarks.accuracy.oracle.unknown import Unknown
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
from rclpy.time import Time

_TF = interface("tf2_msgs", "msg", "TFMessage")


class TransformException(Exception):
    """No transform."""


class LookupException(TransformException):
    """No such frame."""


class ConnectivityException(TransformException):
    """The frames are not connected."""


class ExtrapolationException(TransformException):
    """Out of the time that is known."""


class InvalidArgumentException(TransformException):
    """A bad argument."""


class TimeoutException(TransformException):
    """It took too long."""


class TypeException(Exception):
    """No conversion is known."""


class NotImplementedException(Exception):
    """No conversion is known."""


class BufferInterface:
    """Transforms are there at once, and unknown."""

    def __init__(self, *_: object, **__: object) -> None:
        self.registration = Unknown("registration")

    def lookup_transform(self, *_: object, **__: object) -> Any:
        """A transform."""
        return interface("geometry_msgs", "msg", "TransformStamped")()

    lookup_transform_full = lookup_transform_core = lookup_transform

    def can_transform(self, *_: object, **__: object) -> bool:
        """Yes."""
        return True

    can_transform_full = can_transform

    def transform(self, object_stamped: Any, *_: object, **__: object) -> Any:
        """The same."""
        return object_stamped

    transform_full = transform

    def get_latest_common_time(self, *_: object) -> Any:
        """Now."""
        return Time()

    def wait_for_transform_async(self, *_: object, **__: object) -> Future:
        """It is there."""
        return finished(True)

    async def lookup_transform_async(self, *_: object, **__: object) -> Any:
        """A transform."""
        return self.lookup_transform()

    def _nothing(self, *_: object, **__: object) -> Any:
        return None

    set_transform = set_transform_static = clear = _nothing

    def all_frames_as_yaml(self, *_: object) -> str:
        """No frames."""
        return "{}"

    all_frames_as_string = all_frames_as_yaml


class Buffer(BufferInterface):
    """Record the service tf2_frames where a node is given."""

    def __init__(self, cache_time: Any = None, node: Any = None, *_: object, **__: object) -> None:
        super().__init__()
        if isinstance(node, Node):
            node.create_service(interface("tf2_msgs", "srv", "FrameGraph"), "tf2_frames", nobody)


class BufferClient(BufferInterface):
    """Record the action client to a buffer server."""

    def __init__(self, node: Any, ns: str, check_frequency: float = 10.0, timeout_padding: Any = None) -> None:
        super().__init__()
        self.action_client = ActionClient(node, interface("tf2_msgs", "action", "LookupTransform"), ns)

    def wait_for_server(self, timeout: Any = None) -> bool:
        """It is there."""
        return True


class TransformBroadcaster:
    """Record the publisher on /tf."""

    def __init__(self, node: Any, qos: Any = None) -> None:
        self.pub_tf = node.create_publisher(_TF, "/tf", qos or QoSProfile(depth=100))

    def sendTransform(self, transform: object) -> None:
        """Nobody listens."""


class StaticTransformBroadcaster:
    """Record the publisher on /tf_static."""

    def __init__(self, node: Any, qos: Any = None) -> None:
        profile = qos or QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.pub_tf = node.create_publisher(_TF, "/tf_static", profile)

    def sendTransform(self, transform: object) -> None:
        """Nobody listens."""


class TransformListener:
    """Record the subscriptions to /tf and /tf_static."""

    def __init__(
        self,
        buffer: Any,
        node: Any,
        *,
        spin_thread: bool = False,
        qos: Any = None,
        static_qos: Any = None,
        tf_topic: str = "/tf",
        tf_static_topic: str = "/tf_static",
        static_only: bool = False,
    ) -> None:
        self.buffer, self.node = buffer, node
        if not static_only:
            node.create_subscription(_TF, tf_topic, nobody, qos or QoSProfile(depth=100))
        lasting = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_subscription(_TF, tf_static_topic, nobody, static_qos or lasting)

    def unregister(self) -> None:
        """It listened."""


class StaticTransformListener(TransformListener):
    """Record the subscription to /tf_static."""

    def __init__(self, buffer: Any, node: Any, **options: Any) -> None:
        super().__init__(buffer, node, static_only=True, **options)
