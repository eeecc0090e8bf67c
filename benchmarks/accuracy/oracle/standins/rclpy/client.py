"""Stand-in for rclpy.client."""

from __future__ import annotations

from .entities import Client

__all__ = ["Client"]
