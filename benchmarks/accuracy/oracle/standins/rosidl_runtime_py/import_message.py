"""Stand-in for rosidl_runtime_py.import_message."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface


def import_message_from_namespaced_type(message_type: Any) -> Any:
    """The class of a message by its namespaced type."""
    return interface(message_type.namespaces[0], message_type.namespaces[1], message_type.name)
