"""Subscribers that are made first and subscribe later: ``sub_.subscribe(this, "image", qos)``.

Source: ``message_filters/subscriber.hpp`` (``subscribe(node, topic, qos, options)``) and
``image_transport/subscriber_filter.hpp`` (``subscribe(node, topic, transport, qos, options)``).
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Unknown, Value
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclcpp.transports import transported
from archlint.libraries.rclpy.effects import EFFECTS
from archlint.libraries.tables import TABLE

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

SUBSCRIBER = "message_filters.cpp.Subscriber"
"""A ``message_filters::Subscriber<T>`` without a topic yet; its argument is T."""
IMAGES = "image_transport.SubscriberFilter"
_TYPE = "msg_type"
_ROW = TABLE["message_filters.Subscriber"]


def _new(run: Run, site: CallSite) -> Value:
    filter_ = Instance(External(SUBSCRIBER), run.store.new_key())
    run.store.set(filter_.key, _TYPE, site.args[0] if site.args else Unknown("no type"))
    return filter_


def _new_of_images(run: Run, site: CallSite) -> Value:
    filter_ = Instance(External(IMAGES), run.store.new_key())
    return _subscribe_to_images(run, site) if site.args else filter_


def _later(run: Run, receiver: Value, site: CallSite) -> Value:
    kind = run.store.get(receiver.key, _TYPE) if isinstance(receiver, Instance) else None
    return _subscribe(run, site, kind or Unknown("no type"), 2)


def _images_later(run: Run, receiver: Value, site: CallSite) -> Value:
    return _subscribe_to_images(run, site)


def _subscribe_to_images(run: Run, site: CallSite) -> Value:
    if len(site.args) < 3:
        return Unknown("a filter of images without a transport")
    topic, kind = transported(site.args[1], site.args[2])
    return _subscribe(run, replace(site, args=[site.args[0], topic, *site.args[2:]]), kind, 3)


def _subscribe(run: Run, site: CallSite, kind: Value, at_qos: int) -> Value:
    """The subscription to a topic; ``at_qos`` is the position of the profile."""
    if len(site.args) < 2:
        return Unknown("a filter without a topic")
    arguments = {"node": site.args[0], "topic": site.args[1], "msg_type": kind}
    if len(site.args) > at_qos:
        arguments["qos_profile"] = site.args[at_qos]
    return EFFECTS[_ROW.effect](run, ApiUse(_ROW, None, arguments, site.expression, False, [], {}))


PLAIN: dict[str, Plain] = {SUBSCRIBER: _new, IMAGES: _new_of_images}
METHODS: dict[str, Method] = {
    f"{SUBSCRIBER}.subscribe": _later,
    f"{SUBSCRIBER}.__made_with__": _later,
    f"{IMAGES}.subscribe": _images_later,
    f"{IMAGES}.__made_with__": _images_later,
}

__all__ = ["IMAGES", "METHODS", "PLAIN", "SUBSCRIBER"]
