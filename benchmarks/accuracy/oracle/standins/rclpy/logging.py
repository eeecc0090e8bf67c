"""Stand-in for rclpy.logging: silent loggers."""

from __future__ import annotations

from enum import IntEnum
from typing import Any


class LoggingSeverity(IntEnum):
    """The levels."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


class RcutilsLogger:
    """Says nothing."""

    def __init__(self, name: str = "") -> None:
        self.name = name

    def _log(self, *_: object, **__: object) -> bool:
        return True

    debug = info = warn = warning = error = fatal = critical = exception = log = _log

    def set_level(self, level: object) -> None:
        """Nothing changes."""

    def get_effective_level(self) -> LoggingSeverity:
        """Info."""
        return LoggingSeverity.INFO

    def is_enabled_for(self, severity: object) -> bool:
        """Yes."""
        return True

    def get_child(self, name: str) -> RcutilsLogger:
        """A logger below this one."""
        return RcutilsLogger(f"{self.name}.{name}")


def get_logger(name: str = "") -> RcutilsLogger:
    """A silent logger."""
    return RcutilsLogger(name)


def set_logger_level(*_: object, **__: object) -> None:
    """Nothing changes."""


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Info."""
    return LoggingSeverity.INFO


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """The level by name."""
    return LoggingSeverity[log_severity.upper()]


def initialize(*_: Any) -> None:
    """Nothing."""


shutdown = clear_config = initialize
