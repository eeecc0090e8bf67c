"""Stand-in for rclpy.utilities."""

from __future__ import annotations

import sys
from typing import Any

from benchmarks.accuracy.oracle.sandbox import still_up

from .context import get_default_context


def ok(*, context: Any = None) -> bool:
    """Up, a few times at each place."""
    return still_up()


def shutdown(*, context: Any = None) -> None:
    """Down."""
    (context or get_default_context()).shutdown()


try_shutdown = shutdown


def remove_ros_args(args: Any = None) -> list[str]:
    """The arguments without those between --ros-args and --."""
    rest, inside = [], False
    for argument in sys.argv if args is None else args:
        if argument == "--ros-args":
            inside = True
        elif inside and argument == "--":
            inside = False
        elif not inside:
            rest.append(argument)
    return rest


def get_rmw_implementation_identifier() -> str:
    """The default middleware."""
    return "rmw_fastrtps_cpp"


def get_available_rmw_implementations() -> set[str]:
    """The default middleware."""
    return {"rmw_fastrtps_cpp"}


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Seconds as nanoseconds; none is forever."""
    return -1 if timeout_sec is None or timeout_sec < 0 else int(timeout_sec * 1e9)


__all__ = [
    "get_available_rmw_implementations",
    "get_default_context",
    "get_rmw_implementation_identifier",
    "ok",
]
