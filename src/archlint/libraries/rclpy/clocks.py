"""Clocks of nodes, and the times that they give."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import ApiMethod, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method
    from archlint.libraries.run import Run

CLOCK = "rclpy.clock.Clock"
TIME = "rclpy.time.Time"


def _clock_of_node(run: Run, node: Value, site: CallSite) -> Value:
    """``node.get_clock()``."""
    return Unknown("rclpy.node.Node.get_clock() is outside of this workspace", of_class=CLOCK)


def _now(run: Run, clock: Value, site: CallSite) -> Value:
    """``clock.now()``."""
    return Unknown(clock.why_unknown or f"{CLOCK}.now() is outside of this workspace", of_class=TIME)


def of_clock_or_time(value: Unknown, name: str) -> Value | None:
    """``clock.now`` and ``time.nanoseconds``; None for what is neither."""
    if value.of_class == CLOCK and name == "now":
        return ApiMethod(f"{CLOCK}.now", value)
    return Unknown(value.reason, of_class="int") if value.of_class == TIME and name == "nanoseconds" else None


METHODS: dict[str, Method] = {"rclpy.node.Node.get_clock": _clock_of_node, f"{CLOCK}.now": _now}

__all__ = ["CLOCK", "METHODS", "TIME", "of_clock_or_time"]
