"""Stand-in for rclpy.qos_event."""

from __future__ import annotations

from typing import Any


class EventCallbacks:
    """Callbacks for the events of an entity; none happen."""

    def __init__(self, **callbacks: Any) -> None:
        vars(self).update(callbacks)


class PublisherEventCallbacks(EventCallbacks):
    """Of a publisher."""


class SubscriptionEventCallbacks(EventCallbacks):
    """Of a subscription."""


class UnsupportedEventTypeError(Exception):
    """The middleware does not know the event."""
