"""What tf2 creates on a node."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import (
    External,
    Instance,
    Known,
    Value,
)
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import nodes, presets, profiles
from archlint.libraries.rclpy.entities import create
from archlint.libraries.tables import Api
from archlint.libraries.tables.api import DefaultQos
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import EntityValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run


_TOPICS: list[tuple[str, str, str, DefaultQos]] = [
    ("tf_topic", "/tf", "qos", "tf"),
    ("tf_static_topic", "/tf_static", "static_qos", "tf_static_listener"),
]
"""The parameter of each topic, its name, the parameter of its profile, and the profile of a call that is given none."""


def transform_listener(run: Run, call: ApiUse) -> Value:
    """``TransformListener(buffer, node)`` subscribes to /tf and /tf_static in a reentrant group of its own."""
    return _listener(run, call, _TOPICS[-1:] if call.get("static_only") == Known(True) else _TOPICS)


def static_transform_listener(run: Run, call: ApiUse) -> Value:
    """``StaticTransformListener(buffer, node)`` subscribes to /tf_static alone."""
    return _listener(run, call, _TOPICS[-1:])


def _listener(run: Run, call: ApiUse, topics: Sequence[tuple[str, str, str, DefaultQos]]) -> Value:
    creations = []
    own_thread = call.get("spin_thread")
    for blueprint in nodes.given_nodes(run, call.get("node")):
        blueprint.runs_elsewhere |= own_thread is not None and own_thread.truth(run) is not False
        for parameter, name, qos, default in topics:
            value = call.get(parameter)
            text = model.Text(name, "exact") if value is None else text_of_value(value, "no name is given")
            part = ApiUse(
                _subscription_of(call.api.path, qos, default), None, call.arguments, call.expression, False, [], {}
            )
            profile = profiles.resolve(run, call.get(qos), default, call)
            creation = create(run, part, blueprint, text, "tf2_msgs/msg/TFMessage", None, profile, None)
            creation.group = model.Group(model.GroupKind.REENTRANT)
            creations.append(creation)
    return EntityValue(tuple(creations), call.api.path, run.store.new_key())


def _subscription_of(path: str, qos: str, default: DefaultQos) -> Api:
    return Api(path, "", "endpoint", kind=model.EntityKind.SUBSCRIBER, qos=qos, default_qos=default)


def transform_buffer(run: Run, call: ApiUse) -> Value:
    """``Buffer(cache_time, node)`` offers the service ``tf2_frames`` on the node it is given."""
    node = call.get("node")
    if node is not None and not node.is_none:
        row = Api(call.api.path, "", "endpoint", kind=model.EntityKind.SERVICE, default_qos="services_default")
        part = ApiUse(row, None, {}, call.expression, False, [], {})
        for blueprint in nodes.given_nodes(run, node):
            text = model.Text("tf2_frames", "exact")
            create(run, part, blueprint, text, "tf2_msgs/srv/FrameGraph", None, presets.DEFAULT, None)
    return Instance(External(call.api.path), run.store.new_key())
