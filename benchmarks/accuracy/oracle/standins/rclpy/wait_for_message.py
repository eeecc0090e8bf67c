"""Stand-in for rclpy.wait_for_message."""

from __future__ import annotations

from typing import Any

from .node import Node, record
from .qos import normal_form


def wait_for_message(
    msg_type: Any, node: Node, topic: str, *, qos_profile: Any = 1, time_to_wait: Any = -1
) -> tuple[bool, Any]:
    """Record the subscription; a message is there at once."""
    record(node, "subscriber", msg_type, topic, normal_form(qos_profile))
    return True, msg_type()
