"""The API tables: one row a call that creates something, waits, sleeps or spins; each module is one theme.

Signatures are those of rclpy, humble to rolling: positional order is the same in every supported distro unless a
row says otherwise.  A new API is a new row: the words of the screen, the methods of nodes, the arguments that Python
refuses and what fixes and rules know of it follow.
"""

from __future__ import annotations

from archlint.libraries.tables import (
    callbacks,
    companions,
    endpoints,
    nodes,
    parameters,
    profiles,
    python,
    spinning,
    waiting,
)
from archlint.libraries.tables.api import Api

_MODULES = (nodes, endpoints, companions, callbacks, waiting, spinning, parameters, profiles, python)

ROWS = tuple(row for module in _MODULES for row in module.ROWS)

TABLE: dict[str, Api] = {row.path: row for row in ROWS}

NODE_ROWS: dict[str, Api] = {
    name: row
    for row in ROWS
    for cls, _, name in [row.path.rpartition(".")]
    if cls in ("rclpy.node.Node", "rclpy.lifecycle.node.LifecycleNode") and name != "__init__"
}
"""The methods of a node, by name."""

EXECUTORS = (
    "rclpy.executors.SingleThreadedExecutor",
    "rclpy.executors.MultiThreadedExecutor",
    "rclpy.experimental.events_executor.EventsExecutor",
    "rclpy.experimental.EventsExecutor",
)


def find(path: str) -> Api | None:
    """The row of a call by its canonical name; executors share the rows of their base class."""
    row = TABLE.get(path)
    if row is not None:
        return row
    cls, _, name = path.rpartition(".")
    if cls in EXECUTORS:
        return TABLE.get(f"rclpy.executors.Executor.{name}")
    if cls in ("threading.Condition", "multiprocessing.Event", "multiprocessing.synchronize.Event"):
        return TABLE.get(f"threading.Event.{name}")
    if cls.startswith("rclpy.lifecycle.") and not name.startswith("__"):
        return TABLE.get(f"rclpy.node.Node.{name}")
    return None


__all__ = ["EXECUTORS", "NODE_ROWS", "ROWS", "TABLE", "Api", "find"]
