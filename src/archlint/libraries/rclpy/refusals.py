"""What Python refuses of rclpy: calls of a node's methods whose arguments do not fit, and its modules as classes.

Also how a call that is refused is noted.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import ApiMethod, External, Instance, Value
from archlint.libraries import tables
from archlint.libraries.rclpy import names, node_classes, signatures
from archlint.libraries.rclpy.agreement import note_if_same
from archlint.libraries.values import EntityValue, ExecutorValue, FutureValue, NodeValue

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run

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
    return cls is not None and node_classes.is_node(cls) and node_classes.has_only(cls)


def place_of(run: Run, site: CallSite) -> Place | None:
    """Where a call stands; None where no code makes it, or is there for the case that it is refused."""
    if site.expression is None or not run.activations:
        return None
    expected = any(activation.expecting_refusals for activation in run.activations)
    return None if expected else run.place(site.expression.span)


def keep(run: Run, place: Place, path: str, refused: model.RefusedCall | None) -> None:
    """Note what was found of a call; one of which two things were found is not refused each time."""
    noted = run.noted.refused
    if note_if_same(noted, (place, path), refused):
        run.program.refused_calls[:] = [call for call in noted.values() if call is not None]


def is_of_rclpy(receiver: Value) -> bool:
    """Whether a value is certainly a node, or what only rclpy or tf2 makes: its methods are their own."""
    match receiver:
        case EntityValue() | ExecutorValue() | FutureValue() | Instance(cls=External(path=names.BUFFER)):
            return True
    return is_node(receiver)


__all__ = ["is_module", "is_node", "is_of_rclpy", "keep", "place_of", "refuses"]
