"""GRF001, GRF003 and GRF004: what the shape of the graph says about its nodes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.sight import in_sight, is_complete
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
)
from archlint.systems.rates import rates
from archlint.systems.shape import connected, splits

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node


@rule("GRF001", scope=Scope.SYSTEM)
def isolated_node(system: System, options: Options) -> Iterator[Finding]:
    """Nodes of a closed system that share no name with another node."""
    if not is_complete(system) or any(not end.resolved for end in system.all_endpoints):
        return
    tied = connected(system)
    judged = [node for node in system.nodes if _judged(node)]
    for node in judged:
        external = any(end.name is not None and options.is_external(end.name) for end in node.endpoints)
        if len(judged) > 1 and id(node) not in tied and not external:
            yield _finding(
                "GRF001",
                node,
                f"{node.shown} shares no topic, service or action with any other node",
                "connect it or remove it, or list names under `external` if it talks to something outside",
            )


def _runs(system: System) -> bool:
    """Whether the nodes run as one system: where there are launch files, what one of them starts."""
    others = [] if system.workspace is None else system.workspace.systems
    return system.launched is not None or all(other.launched is None for other in others)


def _judged(node: Node) -> bool:
    if node.blueprint is None:
        return False
    return node.name is not None and not node.test and node.blueprint.complete


@rule("GRF003", scope=Scope.SYSTEM, messages=1000.0, topics=10, rate=50.0)
def hub_bottleneck(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that more periodic messages reach than the limits allow."""
    known = rates(system)
    for node in system.nodes if _runs(system) else ():
        if not _judged(node):
            continue
        incoming = {
            end.name: rate
            for end in node.of_kind(EntityKind.SUBSCRIBER)
            if end.resolved and end.name is not None and (rate := _rate_of(system, end, known)) > 0
        }
        total = sum(incoming.values())
        high = [name for name, rate in incoming.items() if rate >= options.number("rate")]
        if total >= options.number("messages") or len(high) >= options.number("topics"):
            topics = "1 periodic topic" if len(incoming) == 1 else f"{len(incoming)} periodic topics"
            yield _finding(
                "GRF003",
                node,
                f"{node.shown} receives at least {total:g} messages a second on {topics}"
                + (f", {len(high)} of them at {options.number('rate'):g} Hz and more" if high else ""),
                "split the node by task, so that each node subscribes only to what it needs",
                [end for end in node.of_kind(EntityKind.SUBSCRIBER) if end.name in incoming],
            )


def _rate_of(system: System, end: Endpoint, known: dict[int, float]) -> float:
    """Messages a second that are known to come in on a subscription."""
    topic = system.topics.get(end.name or "")
    providers = [] if topic is None else topic.providers
    return sum(known.get(id(other.creation), 0.0) for other in providers if other.node is not end.node)


@rule("GRF004", scope=Scope.SYSTEM)
def single_point_of_failure(system: System, options: Options) -> Iterator[Finding]:
    """Nodes without which the rest falls into parts."""
    # Somebody unseen, or under a name that is not known, may tie the parts.
    known = in_sight(system) and all(end.resolved for end in system.all_endpoints)
    for node, parts in splits(system) if known and _runs(system) else ():
        if not _judged(node):
            continue
        names = ["{" + ", ".join(sorted(member.name or "?" for member in part)[:4]) + "}" for part in parts]
        yield _finding(
            "GRF004",
            node,
            f"without {node.shown} the system splits into {len(parts)} unconnected parts: "
            f"{', '.join(sorted(names)[:3])}",
            "start it with respawn=True, so that it restarts when it fails",
        )


def _finding(code: str, node: Node, message: str, help: str, ends: list[Endpoint] | None = None) -> Finding:
    assert node.blueprint is not None
    return finding(
        code,
        node.blueprint.name.origin or node.blueprint.place,
        message,
        help=help,
        related=[Related(end.place, f"it subscribes to '{end.name}'") for end in ends or ()],
        node=node.name,
        identity=(node.name or "",),
    )
