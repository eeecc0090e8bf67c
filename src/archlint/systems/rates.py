"""How often topics are published, where a timer decides it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.model import (
    EntityKind,
    Role,
)
from archlint.model.given import Entity

if TYPE_CHECKING:
    from archlint.systems.model import System

_PUBLISH = "rclpy.publisher.Publisher.publish"


def rates(system: System) -> dict[int, float]:
    """Messages a second by ``id`` of the publisher's creation: the sum over the timers whose callbacks publish
    on it unconditionally.  What has no known period is left out."""
    timers: dict[int, dict[int, float]] = {}
    for call in system.calls:
        timer = call.context.creation
        if call.api != _PUBLISH or call.context.role != Role.TIMER or timer is None or call.conditional:
            continue
        if not timer.period or not isinstance(call.receiver, Entity) or len(call.receiver.creations) != 1:
            continue
        creation = call.receiver.creations[0]
        if creation.kind == EntityKind.PUBLISHER:
            timers.setdefault(id(creation), {})[id(timer)] = 1 / timer.period
    return {key: sum(periods.values()) for key, periods in timers.items()}
