"""``image_transport``: publishers and subscriptions of images, and of what describes their camera.

Of a publisher only the plain topic is known: which other transports it offers is decided by the plugins that are
installed, and each of these declares parameters.  A subscription has the topic of its one transport.
Source: ``image_transport/image_transport.hpp``, ``transport_hints.hpp``, ``publisher.cpp``,
``simple_subscriber_plugin.hpp``, and ``camera_common.hpp``: the topic of the camera is beside that of its images.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Known, Unknown, Value, join_texts, one_of
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import declarations, nodes
from archlint.libraries.rclpy.effects import EFFECTS
from archlint.libraries.rclpy.fields import PARAMETERS
from archlint.libraries.tables import NODE_ROWS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

_HINTS = "image_transport.TransportHints"
_PARAMETER = "image_transport"
_IMAGE = "sensor_msgs.msg.Image"
_CAMERA = "sensor_msgs.msg.CameraInfo"
_RAW = Known("raw")
_DECLARE = NODE_ROWS["declare_parameter"]


TRANSPORTS = {
    "raw": _IMAGE,
    "compressed": "sensor_msgs.msg.CompressedImage",
    "compressedDepth": "sensor_msgs.msg.CompressedImage",
    "zstd": "sensor_msgs.msg.CompressedImage",
    "theora": "theora_image_transport.msg.Packet",
}
"""What is sent by each transport, under its own name below the topic but for the first."""


def transported(topic: Value, transport: Value) -> tuple[Value, Value]:
    """The topic that a subscription by a transport has, and its type."""
    kind = None if transport.text is None else TRANSPORTS.get(transport.text)
    if kind is None:
        return Unknown("the transport of an image is not known"), Unknown("the transport of an image is not known")
    return (topic if kind == _IMAGE else join_texts((topic, Known("/"), transport))), External(kind)


def _hinted(run: Run, hints: Value) -> Value:
    """The transport that a ``TransportHints(node, default, parameter)`` chooses."""
    given = hints.arguments if isinstance(hints, Instance) else None
    node, default = (given or {}).get("0"), (given or {}).get("1") or Known("raw")
    return _chosen(run, node, default, (given or {}).get("2") or Known(_PARAMETER))


def _chosen(run: Run, node: Value | None, default: Value, parameter: Value) -> Value:
    """What a parameter says, where the node has declared it, and else the default."""
    if parameter.text is None:
        return Unknown("the parameter of a transport is not known")
    return run.store.get(nodes.node_key(run, node), PARAMETERS[parameter.text]) or default


def _get_transport(run: Run, receiver: Value, site: CallSite) -> Value:
    return _hinted(run, receiver)


def _publishes(run: Run, node: Value, topic: Value, qos: Value | None, site: CallSite, kinds: Sequence[str]) -> Value:
    call = ApiUse(_DECLARE, node, {}, site.expression, False, [], {})
    name = join_texts((Unknown("the name of a topic, resolved"), Known(".enable_pub_plugins")))
    declarations.declare_one(run, call, name, None, of_type="string_array")
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
    transport: Value = _RAW,
) -> Value:
    """Make an end of a topic on a node, as rclpy does."""
    end_of_topic: Value = Unknown("no image")
    row = NODE_ROWS[method]
    for kind in kinds:
        name, of_type = (_beside(topic), External(kind)) if kind != _IMAGE else transported(topic, transport)
        arguments: dict[str, Value] = {
            "msg_type": of_type,
            "topic": name,
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
            callback, transport, qos = [*rest[:3], None, None, None][:3]
            return _creates(run, method, node, topic, qos, callback, site, kinds, transport or _RAW)
        return _publishes(run, node, topic, rest[0] if rest else None, site, kinds)

    return create


def _method(method: str, kinds: Sequence[str]) -> Method:
    def create(run: Run, receiver: Value, site: CallSite) -> Value:
        if not site.args:
            return Unknown("an image transport without a topic")
        topic, *rest = site.args
        node, qos = _of_transport(receiver), rest[0] if rest else None
        if method == "create_publisher":
            return _publishes(run, node, topic, qos, site, kinds)
        callback = rest[1] if len(rest) > 1 else None
        hints = [value for value in rest[2:] if isinstance(value, Instance) and value.cls.dotted == _HINTS]
        chosen = _hinted(run, hints[0]) if hints else _chosen(run, node, _RAW, Known(_PARAMETER))
        return _creates(run, method, node, topic, qos, callback, site, kinds, chosen)

    return create


def _camera_manager(run: Run, site: CallSite) -> Value:
    """``CameraInfoManager(node, name, url, ns)`` serves what sets the calibration.

    Source: ``camera_info_manager.cpp``; Humble calls the service after the namespace of the node, Jazzy after the node,
    and later versions take a namespace, behind a node or behind three of its interfaces.
    """
    if not site.args:
        return Unknown("a camera without a node")
    node, rest = site.args[0], site.args[1:]
    interfaces = [value for value in rest[:2] if value == node]
    space = rest[5] if len(rest) > 5 and interfaces else rest[2] if len(rest) > 2 and not interfaces else None
    end = Known("/set_camera_info")
    default = one_of((Known("~/set_camera_info"), Known("set_camera_info")))
    row = NODE_ROWS["create_service"]
    arguments: dict[str, Value] = {
        "srv_type": External("sensor_msgs.srv.SetCameraInfo"),
        "srv_name": default if space is None else join_texts((space, end)),
        "callback": Unknown("the manager of a camera"),
    }
    EFFECTS[row.effect](run, ApiUse(row, node, arguments, site.expression, False, [], {}))
    return Instance(External(_MANAGER), run.store.new_key())


_MANAGER = "camera_info_manager.CameraInfoManager"
PLAIN: dict[str, Plain] = {
    _MANAGER: _camera_manager,
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
    f"{_HINTS}.getTransport": _get_transport,
}

__all__ = ["METHODS", "PLAIN"]
