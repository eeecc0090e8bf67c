"""Stand-in for rclpy.service."""

from __future__ import annotations

from .entities import Service

__all__ = ["Service"]
