"""Stand-in for rclpy.callback_groups."""

from __future__ import annotations


class CallbackGroup:
    """Base of the groups."""

    def __init__(self) -> None:
        self.entities: set[object] = set()

    def add_entity(self, entity: object) -> None:
        """Take an entity in."""

    def has_entity(self, entity: object) -> bool:
        """Whether the entity is in the group."""
        return True

    def can_execute(self, entity: object) -> bool:
        """Yes."""
        return True

    def beginning_execution(self, entity: object) -> bool:
        """Yes."""
        return True

    def ending_execution(self, entity: object) -> None:
        """Done."""


class ReentrantCallbackGroup(CallbackGroup):
    """Callbacks run beside each other."""


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """Callbacks run one after the other."""
