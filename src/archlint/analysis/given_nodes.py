"""Which parameters of a function of C++ get a node."""

from __future__ import annotations

from archlint.syntax import facts

_NODES = frozenset({"rclcpp::Node", "rclcpp_lifecycle::LifecycleNode"})


def given_nodes(function: facts.Function) -> set[str]:
    """The parameters whose type is a node's, a reference or a pointer to one."""
    return {param.name for param in function.params if _is_node(param.annotation)}


def _is_node(annotation: facts.Expr | None) -> bool:
    return isinstance(annotation, facts.Name) and annotation.id in _NODES


__all__ = ["given_nodes"]
