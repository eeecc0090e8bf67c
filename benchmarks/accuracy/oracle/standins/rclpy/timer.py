"""Stand-in for rclpy.timer."""

from __future__ import annotations

from .entities import Rate, Timer

__all__ = ["Rate", "Timer"]
