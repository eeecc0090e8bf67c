"""TOP001, SRV002 and ACT002: one name, two types."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.coexistence import (
    all_endpoints,
    conflicting_pairs,
    in_source_order,
    known_to_coexist,
    launched_separately,
)
from archlint.analysis.kept import once
from archlint.analysis.pinned import is_from_before_galactic
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.lessons import is_lesson
from archlint.finding import Finding, Related, Severity
from archlint.model import EntityKind, Role
from archlint.suggestions import listed

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

_DOES = {
    EntityKind.PUBLISHER: "publishes",
    EntityKind.SUBSCRIBER: "subscribes to",
    EntityKind.SERVICE: "serves",
    EntityKind.CLIENT: "calls",
    EntityKind.ACTION_SERVER: "serves",
    EntityKind.ACTION_CLIENT: "calls",
}


@rule("TOP001", scope=Scope.SYSTEM, separate=False)
def topic_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Topics that two endpoints use with different types; in a lesson and with ``separate`` also where nothing starts
    the two together and each has a partner, and where the same callback has another topic that works."""
    separate = options.flag("separate") or is_lesson(system)
    mismatches = _mismatches("TOP001", system, system.topics)
    yield from (mismatch for mismatch in mismatches if separate or mismatch.severity is not Severity.INFO)


@rule("SRV002", scope=Scope.SYSTEM)
def service_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Services that two endpoints use with different types."""
    yield from _mismatches("SRV002", system, system.services)


@rule("ACT002", scope=Scope.SYSTEM)
def action_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Actions that two endpoints use with different types."""
    yield from _mismatches("ACT002", system, system.actions)


def _mismatches(code: str, system: System, connections: Mapping[str, Connection]) -> Iterator[Finding]:
    missing = _missing_types(system)
    for connection in connections.values():
        if len(connection.types) < 2:
            continue
        pairs: dict[tuple[str, str], list[tuple[Endpoint, Endpoint]]] = {}
        there = [end for end in all_endpoints(connection) if end.type not in missing]
        pairs_of_types = conflicting_pairs(system, there, _one_type)
        conflicts = [
            pair
            for pair in pairs_of_types
            if not _are_of_several_programs(system, *pair)
            and not _meet_without_namespace(*pair)
            and not _is_left_out(system, *pair)
        ]
        torn = _with_several_types(conflicts)
        if not is_from_before_galactic(system.workspace):  # Foxy's Fast DDS accepts several types
            for ends in torn.values():
                yield _several_types(connection, in_source_order(ends))
        for endpoint, other in conflicts:
            if _is_told(torn, endpoint, other):
                continue
            if endpoint.kind == other.kind and not known_to_coexist(system, endpoint.node, other.node):
                continue  # of two that do the same job, one runs: nothing is lost between them
            if endpoint.kind == other.kind == EntityKind.PUBLISHER and not connection.users:
                continue  # nobody misses what either says
            first, second = sorted((endpoint.type or "", other.type or ""))
            pairs.setdefault((first, second), []).append((endpoint, other))
        for types in sorted(pairs):
            together = [
                pair
                for pair in pairs[types]
                if not _are_alternatives(system, connection, *pair) and not _are_steps(system, connection, *pair)
            ]
            diagnostic = _mismatch(code, connection, together or pairs[types])
            unsure = not together or _are_at_home(system, connection, together)
            spare = _spare(system, connection, together)
            if spare is not None:
                diagnostic = _beside_another(diagnostic, spare)
            yield _if_both_run(diagnostic) if unsure else diagnostic


def _are_of_several_programs(system: System, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether two ends of one node are never in one process: several programs start its class, each with a type of its
    own, say."""
    if endpoint.node is not other.node:
        return False
    programs = _programs_with(system)
    own = programs.get((endpoint.place, endpoint.type), set())
    others = programs.get((other.place, other.type), set())
    return bool(own and others) and own.isdisjoint(others)


def _meet_without_namespace(endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether two ends of one node, an absolute and a relative one, have the same name only where nothing gives the
    node a namespace, for which it has the relative one."""
    if endpoint.node is not other.node or endpoint.node.launched_by is not None:
        return False
    written = [end.written for end in (endpoint, other)]
    return None not in written and len({(name or "").startswith("/") for name in written}) > 1


def _is_left_out(system: System, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether one of two nodes is of a module that its package installs no executable of, though it does of others:
    nothing starts it beside them."""
    if endpoint.node is other.node or system.closed or known_to_coexist(system, endpoint.node, other.node):
        return False
    nodes = [end.node for end in (endpoint, other) if not end.node.executables]
    files = [node.blueprint.place.file for node in nodes if node.blueprint is not None]
    return len(nodes) == 1 and any(is_not_installed(system.workspace, file) for file in files)


@once
def _programs_with(system: System) -> dict[tuple[Place, str | None], set[int]]:
    """The programs that make an end of a type at a place, by their numbers."""
    programs: dict[tuple[Place, str | None], set[int]] = {}
    for number, program in enumerate(system.programs):
        for creation in (creation for node in program.nodes for creation in node.creations):
            programs.setdefault((creation.place, creation.type), set()).add(number)
    return programs


_OwnEnds = dict[tuple[int, EntityKind], list["Endpoint"]]


def _with_several_types(conflicts: Iterable[tuple[Endpoint, Endpoint]]) -> _OwnEnds:
    """The ends of nodes that publish or subscribe to one topic with several types, by node and kind."""
    torn: _OwnEnds = {}
    for pair in conflicts:
        if pair[0].node is pair[1].node and pair[0].kind == pair[1].kind and pair[0].kind in _OF_TOPICS:
            ends = torn.setdefault((id(pair[0].node), pair[0].kind), [])
            ends.extend(end for end in pair if end not in ends)
    return torn


_OF_TOPICS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)


def _is_told(torn: _OwnEnds, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether it is said already that a node has several types, one of which is that of the other end."""
    for end, far in ((endpoint, other), (other, endpoint)):
        own = torn.get((id(end.node), end.kind), [])
        if any(_one_type(row, far) for row in own):
            return True
    return False


def _several_types(connection: Connection, ends: Sequence[Endpoint]) -> Finding:
    """One finding for a node that means to take, or say, several types on one topic."""
    last = ends[-1]
    types = list(dict.fromkeys(end.type or "" for end in ends))
    diagnostic = finding(
        "TOP001",
        last.place,
        f"{last.node.shown} {_DOES[last.kind]} '{connection.name}' as {', '.join(types[:-1])} and {types[-1]}: within "
        "one process Fast DDS, the default of ROS 2, refuses the second type, and the node stops there",
        help=f"choose one type, by a parameter say, and create one {_ONE[last.kind]}",
        related=[Related(end.place, f"{end.node.shown} {_DOES[end.kind]} it as {end.type}") for end in ends[:-1]],
        node=last.node.name,
        identity=(connection.kind, connection.name, *sorted(types)),
    )
    return replace(diagnostic, severity=Severity.WARNING)


_ONE = {EntityKind.PUBLISHER: "publisher", EntityKind.SUBSCRIBER: "subscription"}


def _are_alternatives(system: System, connection: Connection, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether launch files start two nodes and none starts both, while one of them starts both ends of the name with
    other nodes: each has its own partner."""
    if endpoint.node is other.node or not launched_separately(system, endpoint.node, other.node):
        return False
    systems = system.workspace.systems if system.workspace is not None else []
    launches = [launch for launch in systems if launch.launched is not None]
    names = [names for launch in launches for names in (launch.topics, launch.services, launch.actions)]
    alike = [connections[connection.name] for connections in names if connection.name in connections]
    return any(there.kind == connection.kind and there.providers and there.users for there in alike)


def _are_steps(system: System, connection: Connection, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether nothing starts two nodes together, and one of them has the partner that it wants in a namesake of the
    other: of two nodes with one name, such as the steps of a lesson, one runs."""
    if endpoint.node is other.node or system.closed or known_to_coexist(system, endpoint.node, other.node):
        return False
    return any(
        there.type == end.type and there.node.name == far.node.name and there.node not in (end.node, far.node)
        for end, far in ((endpoint, other), (other, endpoint))
        for there in (connection.providers if far in connection.providers else connection.users)
    )


def _are_at_home(system: System, connection: Connection, pairs: list[tuple[Endpoint, Endpoint]]) -> bool:
    """Whether nothing is seen to start any two of these together, while whoever listens or asks has a partner of its
    own type: in its package, as lessons of a course that all say ``topic``; or anywhere, where one server answers."""
    if system.closed or any(known_to_coexist(system, endpoint.node, other.node) for endpoint, other in pairs):
        return False
    users = [end for pair in pairs for end in pair if end in connection.users]
    anywhere = connection.kind != "topic"
    return bool(users) and all(
        any(
            end.type == user.type and (anywhere or end.node.package == user.node.package)
            for end in connection.providers
        )
        for user in users
    )


def _spare(system: System, connection: Connection, pairs: Sequence[tuple[Endpoint, Endpoint]]) -> Endpoint | None:
    """The subscription that works of those which a node makes of one type with one callback, where it tries several
    names, ``costmap`` and ``costmap_raw``: the one that disagrees is there in case that the other has no publisher."""
    users = list(dict.fromkeys(end for pair in pairs for end in pair if end in connection.users))
    if len(users) != 1 or connection.kind != "topic":
        return None
    callback = users[0].creation.callbacks.get(Role.SUBSCRIPTION)
    for other in users[0].node.endpoints:
        if other is users[0] or other.kind != users[0].kind or other.type != users[0].type:
            continue
        own = other.creation.callbacks.get(Role.SUBSCRIPTION)
        there = system.topics.get(other.name or "")
        if callback is None or own is None or own.place != callback.place or there is None or there is connection:
            continue
        if any(end.type == other.type for end in there.providers):
            return other
    return None


def _beside_another(diagnostic: Finding, spare: Endpoint) -> Finding:
    return replace(
        diagnostic,
        help=f"remove this subscription: the one to '{spare.name}' has the same callback, and a publisher of its type",
        related=(*diagnostic.related, Related(spare.place, f"this subscription to '{spare.name}' gets messages")),
        severity=Severity.INFO,
    )


def _if_both_run(diagnostic: Finding) -> Finding:
    message = f"{diagnostic.message}, if they run together: no launch file here starts both by default"
    return replace(diagnostic, message=message, severity=Severity.INFO)


def _missing_types(system: System) -> set[str]:
    """Types that no package defines, of which MSG002 speaks: what imports one does not even start."""
    return {
        f"{unknown_interface.package}/{unknown_interface.kind}/{unknown_interface.name}"
        for program in system.programs
        for unknown_interface in program.unknown_interfaces
    }


def _one_type(end: Endpoint, other: Endpoint) -> bool:
    return end.type is None or other.type is None or end.type == other.type


def _mismatch(code: str, connection: Connection, pairs: list[tuple[Endpoint, Endpoint]]) -> Finding:
    """One finding for two types of one name: at the endpoint that comes last in the source, of those that disagree with
    the other side, if any do; what has a partner of its own type is not what is wrong."""
    ends = in_source_order({id(end): end for pair in pairs for end in pair}.values())
    across = [pair for pair in pairs if pair[0].kind != pair[1].kind] or pairs
    disagreeing = in_source_order({id(end): end for pair in across for end in pair}.values())
    last = ([end for end in disagreeing if not _has_partner(connection, end)] or disagreeing)[-1]
    against = [far for pair in across for end, far in (pair, pair[::-1]) if end is last]
    rest = [end for end in ends if end is not last and end not in against]
    return finding(
        code,
        last.place,
        f"{last.node.shown} {_DOES[last.kind]} '{connection.name}' as {last.type}, but "
        f"{against[0].node.shown} {_DOES[against[0].kind]} it as {against[0].type}: they are never connected",
        help=f"use the same type at both ends of the {connection.kind}, or different names",
        related=[
            Related(end.place, f"{end.node.shown} {_DOES[end.kind]} it as {end.type}") for end in (*against, *rest)
        ],
        node=last.node.name,
        identity=(connection.kind, connection.name, *sorted({end.type or "" for end in ends})),
        group=(str(last.place), last.type or "", "1" if against[0].kind == last.kind else "0"),
    )


def _has_partner(connection: Connection, end: Endpoint) -> bool:
    """Whether another node has the other end of a connection for an end, with its type."""
    others = connection.users if end in connection.providers else connection.providers
    return any(other.type == end.type and other.node is not end.node for other in others)


@folds("TOP001", across_systems=True, common=2)
def _of_one_line(findings: Sequence[Finding]) -> Finding:
    """One finding for what one line creates, whatever other nodes and launch files it disagrees with, the other side
    first; a line of a loop creates an end of several topics."""
    first, *rest = sorted(findings, key=lambda diagnostic: diagnostic.group[2])
    related = dict.fromkeys(row for other in (first, *rest) for row in other.related)
    first = replace(first, related=tuple(related))
    others = {other.identity[1]: other for other in rest if other.identity[1] != first.identity[1]}.values()
    if not others:
        return first
    more = "another topic" if len(others) == 1 else f"{len(others)} more topics"
    names = listed([f"'{other.identity[1]}'" for other in others])
    return replace(first, message=f"{first.message}; so it is with {more} of that line: {names}")
