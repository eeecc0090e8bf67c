"""What Python refuses of rclpy: calls of a node's methods whose arguments do not fit, and its modules as classes."""

from __future__ import annotations

from collections.abc import Collection

from archlint.interpreter.values import ApiMethod, Value
from archlint.libraries import tables
from archlint.libraries.rclpy import names, node_classes, signatures
from archlint.libraries.values import NodeValue

_MODULES = frozenset(
    ".".join(parts[:length])
    for row in tables.ROWS
    if row.path.startswith("rclpy.")
    for parts in [row.path.split(".")]
    for length in range(1, len(parts))
    if parts[length - 1].islower()
)
"""The modules of rclpy."""


def is_module(path: str) -> bool:
    """Whether a dotted name is that of a module of rclpy."""
    return path in _MODULES


def refuses(method: ApiMethod, given: int, keywords: Collection[str]) -> bool:
    """Whether a method of a node refuses so many positional arguments and these keywords."""
    owner, _, name = method.path.rpartition(".")
    of_node = owner in names.NODE_CLASSES and is_node(method.self_value)
    return of_node and signatures.refuses(name, given, keywords)


def is_node(value: Value) -> bool:
    """Whether a value is a node for certain, whose methods are rclpy's own where the workspace defines none."""
    if isinstance(value, NodeValue):
        return not value.blueprint.caller_unknown
    cls = value.own_class
    return cls is not None and node_classes.has_only(cls)


__all__ = ["is_module", "is_node", "refuses"]
