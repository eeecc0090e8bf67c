"""Which endpoints of one name meet in a running system, so that a rule may hold them against each other.

Without a launch file nothing proves that two executables run together: those that look like variants of one
node are then taken for alternatives.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.system.model import exclusive

if TYPE_CHECKING:
    from archlint.system.model import Connection, Endpoint, Node, System

_NEVER_REACHED = frozenset({"method"})
"""Roles of code that nothing in the workspace is seen to run."""


def certain(endpoint: Endpoint) -> bool:
    """Whether an endpoint exists for sure, under a known name, as long as its node runs."""
    creation = endpoint.creation
    return (
        endpoint.resolved
        and endpoint.error is None
        and endpoint.node.name is not None
        and not endpoint.node.test
        and not creation.conditional
        and not creation.destroyed
        and (creation.context is None or creation.context.role not in _NEVER_REACHED)
    )


def in_source_order(endpoints: Iterable[Endpoint]) -> list[Endpoint]:
    return sorted(endpoints, key=lambda e: (e.place, e.node.name or "", e.type or ""))


def meeting(system: System, endpoints: Iterable[Endpoint]) -> Iterator[tuple[Endpoint, Endpoint]]:
    """Pairs of certain endpoints that run together; in each, the second comes later in the source."""
    for one, other in combinations(in_source_order(e for e in endpoints if certain(e)), 2):
        if meet(system, one, other):
            yield one, other


def meet(system: System, one: Endpoint, other: Endpoint) -> bool:
    """Whether two endpoints are seen to exist at the same time."""
    if one.node is other.node:
        return True
    return (
        system.together(one.node, other.node)
        and not exclusive(one.creation.arms, other.creation.arms)
        and not (_nobody_starts_both(system, one.node, other.node) and _variants(one, other))
    )


def _nobody_starts_both(system: System, one: Node, other: Node) -> bool:
    """True where neither a launch file nor one executable is seen to start both nodes."""
    return system.name is None and set(one.executables).isdisjoint(other.executables)


def _variants(one: Endpoint, other: Endpoint) -> bool:
    """Whether the nodes of two endpoints look like two forms of one node, of which one runs: they share their
    name, their class or the very create call, or one class derives from the other."""
    return (
        one.node.name == other.node.name
        or _class_name(one.node) == _class_name(other.node)
        or one.place == other.place
    )


def _class_name(node: Node) -> str:
    return "" if node.blueprint is None else node.blueprint.class_name.rpartition(".")[2]


def all_endpoints(connection: Connection) -> list[Endpoint]:
    return [*connection.providers, *connection.users]
