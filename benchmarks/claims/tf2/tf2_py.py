"""Stands for tf2's C++ library, of which there is no wheel: it knows one transform, the newest.

What waits, and who may bring it, is tf2_ros's own Python.
"""

from __future__ import annotations

import threading
from typing import Any


class TransformException(Exception):
    """As in tf2."""


class LookupException(TransformException):
    """As in tf2."""


class ConnectivityException(TransformException):
    """As in tf2."""


class ExtrapolationException(TransformException):
    """As in tf2."""


class InvalidArgumentException(TransformException):
    """As in tf2."""


class TimeoutException(TransformException):
    """As in tf2."""


class BufferCore:
    """The newest transform; there is one for a time if it is not older."""

    def __init__(self, cache_time: Any = None) -> None:
        self._lock = threading.Lock()
        self._newest: Any = None

    def set_transform(self, transform: Any, authority: str) -> None:
        with self._lock:
            self._newest = transform

    set_transform_static = set_transform

    def can_transform_core(self, target: str, source: str, time: Any) -> tuple[bool, str]:
        with self._lock:
            newest = self._newest
        if newest is None:
            return False, "nothing known"
        stamp = newest.header.stamp
        return stamp.sec * 10**9 + stamp.nanosec >= time.nanoseconds, ""

    def lookup_transform_core(self, target: str, source: str, time: Any) -> Any:
        if not self.can_transform_core(target, source, time)[0]:
            raise ExtrapolationException("the newest is too old")
        return self._newest

    def clear(self) -> None:
        self._newest = None
