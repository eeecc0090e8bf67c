"""Stand-in for rclpy.duration."""

from __future__ import annotations

from functools import total_ordering
from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface

NANOSECONDS = 1_000_000_000


@total_ordering
class Duration:
    """A period."""

    def __init__(self, *, seconds: Any = 0, nanoseconds: Any = 0) -> None:
        self._nanoseconds = int(float(seconds) * NANOSECONDS) + int(nanoseconds)

    @property
    def nanoseconds(self) -> int:
        """The whole period in nanoseconds."""
        return self._nanoseconds

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Duration) and self._nanoseconds == other._nanoseconds

    def __lt__(self, other: Any) -> bool:
        return bool(self._nanoseconds < other.nanoseconds)

    def __hash__(self) -> int:
        return hash(self._nanoseconds)

    def __add__(self, other: Any) -> Any:
        return Duration(nanoseconds=self._nanoseconds + other.nanoseconds)

    def __mul__(self, factor: Any) -> Duration:
        return Duration(nanoseconds=int(self._nanoseconds * float(factor)))

    def to_msg(self) -> Any:
        """As builtin_interfaces/msg/Duration."""
        sec, nanosec = divmod(self._nanoseconds, NANOSECONDS)
        return interface("builtin_interfaces", "msg", "Duration")(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        """From builtin_interfaces/msg/Duration."""
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def get_c_duration(self) -> int:
        """In nanoseconds."""
        return self._nanoseconds


Infinite = Duration(nanoseconds=2**63 - 1)
