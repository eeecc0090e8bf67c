"""Stand-in for rclpy.guard_condition."""

from __future__ import annotations

from .entities import GuardCondition

__all__ = ["GuardCondition"]
