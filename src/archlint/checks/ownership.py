"""OWN001 and OWN002: a name that more than one node publishes or serves."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import astuple, replace
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.analysis.arbitration import never_speaks, speaks_once, take_turns
from archlint.analysis.aside import is_aside
from archlint.analysis.coexistence import (
    coexisting_pairs,
    has_launch_files,
    in_source_order,
    known_to_coexist,
    launched_separately,
    named_by_library,
)
from archlint.analysis.happenings import are_requests, tell_what_happened
from archlint.analysis.left_over import is_left_over
from archlint.analysis.sharing import are_words, is_bus, is_state
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.model import EntityKind
from archlint.ros.well_known import OF_MANY_PUBLISHERS, TYPES_OF_MANY_PUBLISHERS

if TYPE_CHECKING:
    from archlint.systems.model import Connection, Endpoint, Node, System


@rule("OWN001", scope=Scope.SYSTEM)
def multiple_publishers(system: System, options: Options) -> Iterator[Finding]:
    """Topics with publishers in several nodes that run together."""
    found = [
        _of_topic(system, connection, owners)
        for connection in system.topics.values()
        if not _is_shared(connection, options)
        for owners in _several_owners(system, connection)
        if not _is_meant(system, connection, owners)
    ]
    gravest: dict[tuple[str, ...], Severity] = {}
    for one in found:
        nodes = one.identity[2:]
        gravest[nodes] = max(gravest.get(nodes, one.severity), one.severity)
    for one in found:  # what the same nodes publish beside a command is told along with it
        yield replace(one, severity=gravest[one.identity[2:]])


def _is_meant(system: System, connection: Connection, owners: list[Endpoint]) -> bool:
    """Whether several nodes are there to publish a topic, or do not do so at once."""
    if is_bus(system.workspace, connection, owners) or tell_what_happened(system, owners) or are_requests(connection):
        return True
    if not _is_proven(system, owners) and (
        has_launch_files(system) or _says_what_happens(connection.name) or _are_exercises(owners)
    ):
        return True
    return take_turns(system, owners)


_EXERCISES = 4
"""Of so many programs that nothing starts together, and that all say the same, one runs at a time."""


def _are_exercises(owners: Sequence[Endpoint]) -> bool:
    """Whether nodes that nothing starts together look like ways to do the same: many of them, in folders of their own
    in one package, or each told by a parameter of the same name where it publishes."""
    folders = {(end.node.package, posixpath.dirname(end.place.file)) for end in owners}
    parameters = {end.creation.name.parameter for end in owners}
    return (
        len({end.node.name for end in owners}) >= _EXERCISES
        or len(folders) > len({package for package, _ in folders})
        or (len(parameters) == 1 and None not in parameters)
    )


def _of_topic(system: System, connection: Connection, owners: list[Endpoint]) -> Finding:
    found = _finding(
        "OWN001",
        system,
        owners,
        f"{_nodes(owners)} publish the topic '{connection.name}'",
        f"publishes '{connection.name}' here",
        "give each its own topic and let one node arbitrate, or list the topic under shared-topics if it is meant "
        "to be shared",
    )
    return found if _is_obeyed(connection, owners) else replace(found, severity=Severity.INFO)


def _is_obeyed(connection: Connection, owners: list[Endpoint]) -> bool:
    """Whether the last message is what counts: a command or a value, and no text that stands for itself."""
    return not are_words(owners) or is_state(connection.name)


def _is_shared(connection: Connection, options: Options) -> bool:
    return (
        connection.name in OF_MANY_PUBLISHERS
        or options.is_shared(connection.name)
        or (bool(connection.types) and TYPES_OF_MANY_PUBLISHERS.issuperset(connection.types))
    )


@rule("OWN002", scope=Scope.SYSTEM)
def multiple_servers(system: System, options: Options) -> Iterator[Finding]:
    """Services and actions with servers in several nodes that run together."""
    for connection in (*system.services.values(), *system.actions.values()):
        for owners in _several_owners(system, connection):
            yield _finding(
                "OWN002",
                system,
                owners,
                f"{_nodes(owners)} serve the {connection.kind} '{connection.name}': every request reaches all of them",
                "serves it here",
                "give each server its own name, such as a private one ('~/…')",
            )


_TELLING = frozenset({"alert", "alerts", "console", "debug", "event", "events", "heartbeat", "heartbeats"}) | {
    *("log", "logs", "notification", "notifications", "say", "speech", "status", "statuses", "tts"),
}
"""Words for what many nodes have to tell on one topic."""


def _says_what_happens(topic: str) -> bool:
    """Whether a topic is for what any node may have to tell: a log, events."""
    return not _TELLING.isdisjoint(topic.rpartition("/")[2].lower().split("_"))


def _several_owners(system: System, connection: Connection) -> Iterator[list[Endpoint]]:
    """Groups of endpoints of different nodes that meet; the last one in the source comes last."""
    groups: list[list[Endpoint]] = []
    own = [end for end in connection.providers if _owns(system, end)]
    for one, other in coexisting_pairs(system, own):
        if (
            one.node is other.node
            or launched_separately(system, one.node, other.node)
            or _left_out(one.node, other.node)
        ):
            continue
        group = next((group for group in groups if one in group or other in group), None)
        if group is None:
            groups.append([one, other])
        else:
            group.extend(endpoint for endpoint in (one, other) if endpoint not in group)
    for group in groups:
        yield in_source_order(group)


def _owns(system: System, end: Endpoint) -> bool:
    """Whether a publisher or server says something of its own, in code that is in use."""
    idle = named_by_library(end) or is_left_over(system.workspace, end) or speaks_once(system, end)
    if system.name is not None and end.kind == EntityKind.PUBLISHER:
        idle = idle or never_speaks(end)  # a launch file says which program it is
    return not idle and (system.name is not None or not is_aside(system.workspace, end.place.file))


def _left_out(one: Node, other: Node) -> bool:
    """Whether a script starts the one of two nodes that it defines, and leaves the other out."""
    if one.blueprint is None or other.blueprint is None or one.program is None or other.program is None:
        return False
    one_file = one.blueprint.place.file == other.blueprint.place.file
    return one_file and one.program.executable != other.program.executable


def _finding(code: str, system: System, owners: list[Endpoint], message: str, does: str, help: str) -> Finding:
    """The finding at the last owner; for information only where nothing is seen to start any two of them."""
    last, others = owners[-1], owners[:-1]
    proven = _is_proven(system, owners)
    found = finding(
        code,
        last.place,
        message if proven else f"{message}, if they run together: no launch file here starts both",
        help=help,
        related=[Related(other.place, f"{other.node.name} {does}") for other in others],
        node=last.node.name,
        identity=(last.kind, last.name or "", *_names(owners)),
    )
    if code == "OWN001":
        found = replace(found, group=_cause(last))
    return found if proven else replace(found, severity=Severity.INFO)


def _cause(last: Endpoint) -> tuple[str, ...]:
    """What findings have in common that one change mends: the node that was added last."""
    made = last.node.blueprint
    return (last.place.file, "") if made is None else (*map(str, astuple(made.place)), made.class_name)


@folds("OWN001", across_systems=True)
def _of_one_node(findings: Sequence[Finding]) -> Finding:
    """What one node publishes beside others, on all its topics and in all launch files: the finding for the most nodes
    says which; what else is so is related."""
    most = max(findings, key=lambda one: (one.condition is None, len(one.identity)))
    same = [one for one in findings if one.identity[2:] == most.identity[2:]]
    topics = list(dict.fromkeys(one.identity[1] for one in (most, *same)))
    rest = [Related(one.place, f"{one.node} publishes '{one.identity[1]}' here") for one in findings]
    rows = [row for one in (most, *findings) for row in one.related] + rest
    return replace(
        most,
        message=most.message.replace(f"the topic '{topics[0]}'", _topics(topics)),
        related=tuple(row for row in dict.fromkeys(rows) if row.place != most.place or row not in rest),
    )


_NAMED = 4


def _topics(names: Sequence[str]) -> str:
    if len(names) == 1:
        return f"the topic '{names[0]}'"
    quoted = [f"'{name}'" for name in names]
    if len(names) > _NAMED:
        quoted = [*quoted[: _NAMED - 1], f"{len(names) - _NAMED + 1} more"]
    return f"the topics {', '.join(quoted[:-1])} and {quoted[-1]}"


def _is_proven(system: System, owners: list[Endpoint]) -> bool:
    """Whether something is seen to start two of them together."""
    return system.closed or any(known_to_coexist(system, a.node, b.node) for a, b in combinations(owners, 2))


def _nodes(owners: Iterable[Endpoint]) -> str:
    names = _names(owners)
    both = "both" if len(names) == 2 else "all"
    return f"{', '.join(names[:-1])} and {names[-1]} {both}"


def _names(owners: Iterable[Endpoint]) -> list[str]:
    return sorted({endpoint.node.name or "" for endpoint in owners})
