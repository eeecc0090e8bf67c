"""Stand-in for rclpy.clock: a clock that moves on with each look at it, and never waits."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from benchmarks.accuracy.oracle.sandbox import waited
from benchmarks.accuracy.oracle.unknown import Unknown


class ClockType(IntEnum):
    """The kinds of clock."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class ClockChange(IntEnum):
    """What happened to a clock."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class Clock:
    """A clock."""

    _seconds = 1_700_000_000

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self.clock_type = clock_type
        self.handle = Unknown("clock.handle")

    def now(self) -> Any:
        """One second later than the last time it was asked."""
        from rclpy.time import Time

        Clock._seconds += 1
        return Time(seconds=Clock._seconds, clock_type=self.clock_type)

    def sleep_for(self, duration: object, context: object = None) -> bool:
        """Do not wait."""
        waited(2)
        return True

    def sleep_until(self, until: object, context: object = None) -> bool:
        """Do not wait."""
        waited(2)
        return True

    def create_jump_callback(self, *_: object, **__: object) -> Any:
        """Nothing jumps."""
        return Unknown("jump_handle")


class ROSClock(Clock):
    """The clock that follows /clock when told to."""

    def __init__(self) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self.ros_time_is_active = False


class JumpThreshold:
    """When to be told of a jump."""

    def __init__(self, **_: object) -> None:
        return None
