"""Stand-in for rclpy.action.graph."""

from __future__ import annotations

from typing import Any


def get_action_names_and_types(node: object) -> list[Any]:
    """Nothing is seen."""
    return []


def get_action_client_names_and_types_by_node(*_: object) -> list[Any]:
    """Nothing is seen."""
    return []


get_action_server_names_and_types_by_node = get_action_client_names_and_types_by_node
