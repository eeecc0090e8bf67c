"""Stand-in for rclpy.publisher."""

from __future__ import annotations

from .entities import Publisher

__all__ = ["Publisher"]
