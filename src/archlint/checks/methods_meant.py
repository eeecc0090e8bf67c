"""What to do about a method that rclpy does not have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.checks.nodes_at_hand import node_around
from archlint.libraries.api_signatures import attributes_of
from archlint.model import RefusedCall

if TYPE_CHECKING:
    from archlint.systems.model import System


_NODE = "rclpy.node.Node"
_CLIENT = "rclpy.client.Client."
_ACTION_CLIENT = "rclpy.action.client.ActionClient"
_GOAL_HANDLE = "rclpy.action.client.ClientGoalHandle"


def cure_of_absent(system: System, call: RefusedCall, name: str) -> str:
    """What to do about a method that no distribution has and that has no near name."""
    if call.given.rpartition(".")[2] == "Future" and name in (attributes_of(_GOAL_HANDLE) or ()):
        return "keep the future apart from the goal handle, which is its result()"
    if not is_of_node(call) and name in (attributes_of(_NODE) or ()):
        return f"it is a method of the node: write {node_around(system, call)}.{name}(…)"
    if asks_for_action(call, name):
        return "make an ActionClient of rclpy.action, which has it, in place of the client"
    if call.given.rpartition(".")[2] == "ClientGoalHandle" and "feedback" in name:
        return "pass what takes the feedback to send_goal_async(goal, feedback_callback=…) instead"
    if is_of_node(call) and name in _OF_RCLPY:
        return f"use rclpy.{name}()"
    if getter_meant(call, name):
        return f"use {getter_meant(call, name)}()"
    return f"define {name}() in the class of the node, or remove the call" if is_of_node(call) else "remove the call"


def asks_for_action(call: RefusedCall, name: str) -> bool:
    """Whether a client for services lacks what one for actions has."""
    return call.api.startswith(_CLIENT) and name in (attributes_of(_ACTION_CLIENT) or ())


def getter_meant(call: RefusedCall, name: str) -> str:
    """The method of a node that is meant by the name of what it gets: ``get_logger`` by ``logger``."""
    getter = f"get_{name}"
    return getter if is_of_node(call) and getter in (attributes_of(_NODE) or ()) else ""


_OF_RCLPY = frozenset({"init", "ok", "shutdown", "spin", "spin_once", "spin_until_future_complete", "try_shutdown"})
"""Functions of rclpy that are taken for methods of a node.  Source: ``rclpy/__init__.py``."""


def is_of_node(call: RefusedCall) -> bool:
    """Whether it is a node that lacks what is called."""
    return call.given.rpartition(".")[2] == "Node"


__all__ = ["asks_for_action", "cure_of_absent", "getter_meant", "is_of_node"]
