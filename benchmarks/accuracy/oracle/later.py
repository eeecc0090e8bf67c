"""What code gets from a world that does not answer: futures that are done, messages whose fields nobody knows."""

from __future__ import annotations

import sys
from typing import Any

from .unknown import Unknown


def finished(result: Any) -> Any:
    """A future of rclpy, the one that is loaded, that already has its answer."""
    future = sys.modules["rclpy.task"].Future()
    future.set_result(result)
    return future


def nobody(*_: object) -> None:
    """The callback of a library's own subscription: rclpy wants one, and no callback is recorded."""


def received(type_: Any) -> Any:
    """A message that came in: one of its class, each field unknown."""
    try:
        message = type_()
    except Exception:
        return Unknown("message")
    for name in getattr(type_, "__slots__", ()):
        if name.startswith("_") and name != "_check_fields":
            object.__setattr__(message, name, Unknown(f"{type_.__name__}.{name[1:]}"))
    return message
