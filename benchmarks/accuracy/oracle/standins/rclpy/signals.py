"""Stand-in for rclpy.signals."""

from __future__ import annotations

from enum import IntEnum


class SignalHandlerOptions(IntEnum):
    """Which signals are handled."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


def install_signal_handlers(options: object = None) -> None:
    """None are."""


def uninstall_signal_handlers() -> None:
    """None were."""
