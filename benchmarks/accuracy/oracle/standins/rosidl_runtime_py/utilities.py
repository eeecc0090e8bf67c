"""Stand-in for rosidl_runtime_py.utilities."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.interfaces import KINDS, interface
from benchmarks.accuracy.oracle.unknown import Unknown, is_tainted


def _load(identifier: Any, kind: str | None) -> Any:
    if not isinstance(identifier, str) or is_tainted(identifier):
        return Unknown("interface")
    parts = identifier.split("/")
    if len(parts) == 2 and kind:
        parts.insert(1, kind)
    if len(parts) != 3 or parts[1] not in KINDS or (kind and parts[1] != kind) or not all(parts):
        raise ValueError(f"Expected the full name of an interface, got '{identifier}'")
    return interface(*parts)


def get_interface(identifier: str) -> Any:
    """The class of an interface by its full name."""
    return _load(identifier, None)


def get_message(identifier: str) -> Any:
    """The class of a message by name."""
    return _load(identifier, "msg")


def get_service(identifier: str) -> Any:
    """The class of a service by name."""
    return _load(identifier, "srv")


def get_action(identifier: str) -> Any:
    """The class of an action by name."""
    return _load(identifier, "action")
