"""Stand-in for rclpy.lifecycle."""

from __future__ import annotations

from enum import Enum
from typing import Any, NamedTuple

from rclpy.entities import Publisher as _PlainPublisher
from rclpy.node import Node as _PlainNode


class TransitionCallbackReturn(Enum):
    """What a transition callback says."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99


class LifecycleState(NamedTuple):
    """A state."""

    label: str
    state_id: int


State = LifecycleState


class ManagedEntity:
    """Follows the transitions of its node."""

    def _succeed(self, state: object = None) -> TransitionCallbackReturn:
        return TransitionCallbackReturn.SUCCESS

    on_configure = on_cleanup = on_shutdown = on_activate = on_deactivate = on_error = _succeed


class SimpleManagedEntity(ManagedEntity):
    """Knows whether it is active."""

    is_activated = True

    @staticmethod
    def when_enabled(wrapped: Any = None, *, when_not_enabled: Any = None) -> Any:
        """The function as it is."""
        return wrapped if wrapped is not None else lambda function: function


class LifecyclePublisher(_PlainPublisher):
    """A publisher that is managed."""

    is_activated = True


class LifecycleNodeMixin(ManagedEntity):
    """What makes a node a lifecycle node."""

    _lifecycle = True

    def create_lifecycle_publisher(self, *args: Any, publisher_class: Any = None, **kwargs: Any) -> Any:
        """Record a publisher."""
        return self.create_publisher(*args, **kwargs)  # type: ignore[attr-defined]

    def destroy_lifecycle_publisher(self, publisher: object) -> bool:
        """It was there."""
        return True

    def add_managed_entity(self, entity: object) -> None:
        """Nothing."""

    def _trigger(self) -> TransitionCallbackReturn:
        return TransitionCallbackReturn.SUCCESS

    trigger_configure = trigger_cleanup = trigger_shutdown = trigger_activate = trigger_deactivate = _trigger

    def register_callback(self, *_: object) -> bool:
        """Nothing."""
        return True

    def _oracle_transitions(self) -> list[Any]:
        """The transition callbacks in the order of a first start."""
        return [self.on_configure, self.on_activate]


class LifecycleNode(LifecycleNodeMixin, _PlainNode):
    """A managed node."""

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **options: Any) -> None:
        _PlainNode.__init__(self, node_name, **options)


Node = LifecycleNode
Publisher = LifecyclePublisher


__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "Node",
    "Publisher",
    "SimpleManagedEntity",
    "State",
    "TransitionCallbackReturn",
]
