"""``image_transport``: publishers and subscriptions of images, and of what describes their camera.

Only the plain topic is known: which other transports a publisher offers is decided by the plugins that are installed.
Source: ``image_transport/image_transport.hpp``, and ``camera_common.hpp``: the topic of the camera is beside that.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Known, Unknown, Value
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy.effects import EFFECTS
from archlint.libraries.tables import NODE_ROWS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

_IMAGE = "sensor_msgs.msg.Image"
_CAMERA = "sensor_msgs.msg.CameraInfo"


def _publishes(run: Run, node: Value, topic: Value, qos: Value | None, site: CallSite, kinds: Sequence[str]) -> Value:
    return _creates(run, "create_publisher", node, topic, qos, None, site, kinds)


def _creates(
    run: Run,
    method: str,
    node: Value,
    topic: Value,
    qos: Value | None,
    callback: Value | None,
    site: CallSite,
    kinds: Sequence[str],
) -> Value:
    """Make an end of a topic on a node, as rclpy does."""
    end_of_topic: Value = Unknown("no image")
    row = NODE_ROWS[method]
    for kind in kinds:
        arguments: dict[str, Value] = {
            "msg_type": External(kind),
            "topic": topic if kind == _IMAGE else _beside(topic),
            "qos_profile": qos or Unknown("the profile of the transport"),
        }
        if callback is not None:
            arguments["callback"] = callback
        end_of_topic = EFFECTS[row.effect](run, ApiUse(row, node, arguments, site.expression, False, [], {}))
    return end_of_topic


def _beside(topic: Value) -> Value:
    """``/camera/camera_info`` of ``/camera/image_raw``."""
    text = topic.text
    if text is None:
        return Unknown("the topic of an image is not known")
    folder, slash, _ = text.rpartition("/")
    return Known(f"{folder}{slash}camera_info")


def _of_transport(receiver: Value) -> Value:
    """The node that an ``ImageTransport`` was end_of_topic with."""
    given = receiver.arguments if isinstance(receiver, Instance) else None
    return (given or {}).get("0") or Unknown("the node of an image transport")


def _free(method: str, kinds: Sequence[str]) -> Plain:
    def create(run: Run, site: CallSite) -> Value:
        if len(site.args) < 2:
            return Unknown("an image transport without a topic")
        node, topic, *rest = site.args
        if method == "create_subscription":
            callback, qos = (rest[0] if rest else None), (rest[2] if len(rest) > 2 else None)
            return _creates(run, method, node, topic, qos, callback, site, kinds)
        return _publishes(run, node, topic, rest[0] if rest else None, site, kinds)

    return create


def _method(method: str, kinds: Sequence[str]) -> Method:
    def create(run: Run, receiver: Value, site: CallSite) -> Value:
        if not site.args:
            return Unknown("an image transport without a topic")
        topic, *rest = site.args
        callback = rest[1] if method == "create_subscription" and len(rest) > 1 else None
        return _creates(run, method, _of_transport(receiver), topic, rest[0] if rest else None, callback, site, kinds)

    return create


PLAIN: dict[str, Plain] = {
    "image_transport.create_publisher": _free("create_publisher", (_IMAGE,)),
    "image_transport.create_camera_publisher": _free("create_publisher", (_IMAGE, _CAMERA)),
    "image_transport.create_subscription": _free("create_subscription", (_IMAGE,)),
    "image_transport.create_camera_subscription": _free("create_subscription", (_IMAGE, _CAMERA)),
}

METHODS: dict[str, Method] = {
    "image_transport.ImageTransport.advertise": _method("create_publisher", (_IMAGE,)),
    "image_transport.ImageTransport.advertiseCamera": _method("create_publisher", (_IMAGE, _CAMERA)),
    "image_transport.ImageTransport.subscribe": _method("create_subscription", (_IMAGE,)),
    "image_transport.ImageTransport.subscribeCamera": _method("create_subscription", (_IMAGE, _CAMERA)),
}

__all__ = ["METHODS", "PLAIN"]
