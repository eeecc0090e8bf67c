"""Stand-in for rclpy.subscription."""

from __future__ import annotations

from .entities import Subscription

__all__ = ["Subscription"]
