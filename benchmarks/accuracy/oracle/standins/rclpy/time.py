"""Stand-in for rclpy.time."""

from __future__ import annotations

from functools import total_ordering
from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface

from .clock import ClockType
from .duration import NANOSECONDS, Duration


@total_ordering
class Time:
    """A point in time."""

    def __init__(self, *, seconds: Any = 0, nanoseconds: Any = 0, clock_type: Any = ClockType.SYSTEM_TIME) -> None:
        self._nanoseconds = int(float(seconds) * NANOSECONDS) + int(nanoseconds)
        self.clock_type = clock_type

    @property
    def nanoseconds(self) -> int:
        """Nanoseconds since the epoch."""
        return self._nanoseconds

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Seconds and the rest in nanoseconds."""
        return divmod(self._nanoseconds, NANOSECONDS)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Time) and self._nanoseconds == other._nanoseconds

    def __lt__(self, other: Any) -> bool:
        return bool(self._nanoseconds < other.nanoseconds)

    def __hash__(self) -> int:
        return hash(self._nanoseconds)

    def __add__(self, other: Any) -> Time:
        return Time(nanoseconds=self._nanoseconds + other.nanoseconds, clock_type=self.clock_type)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        nanoseconds = self._nanoseconds - other.nanoseconds
        return Time(nanoseconds=nanoseconds) if isinstance(other, Duration) else Duration(nanoseconds=nanoseconds)

    def to_msg(self) -> Any:
        """As builtin_interfaces/msg/Time."""
        sec, nanosec = divmod(self._nanoseconds, NANOSECONDS)
        return interface("builtin_interfaces", "msg", "Time")(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: Any, clock_type: Any = ClockType.ROS_TIME) -> Time:
        """From builtin_interfaces/msg/Time."""
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
