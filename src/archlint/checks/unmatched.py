"""TOP002, TOP003, SRV001 and ACT001: names with one side only, where nothing outside takes part."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain, in_source_order, named_by_library
from archlint.checks.folding import folds
from archlint.checks.near_misses import MOST_PAIRS, in_other_namespace, is_private_of, missed, nearly_equal
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.sight import in_sight, is_complete
from archlint.connections.left_out_servers import left_out_server
from archlint.connections.own_types import has_no_server_here, may_be_served_elsewhere
from archlint.finding import Finding, Related, Severity
from archlint.model import (
    SERVER_OF,
    EntityKind,
)
from archlint.ros.well_known import FOR_TOOLS, TYPES_OF_MANY_PUBLISHERS
from archlint.suggestions import meant
from archlint.systems.implicit import implicit_names

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

_PARTNER = {EntityKind.PUBLISHER: EntityKind.SUBSCRIBER, **SERVER_OF}
_PARTNER |= {partner: kind for kind, partner in _PARTNER.items()}


@rule("TOP002", scope=Scope.SYSTEM)
def topic_without_subscriber(system: System, options: Options) -> Iterator[Finding]:
    """Topics of a closed system that are published and that nobody subscribes to."""
    partners = _Partners(system)
    for end in _lonely(system, options, system.topics, EntityKind.PUBLISHER):
        if end.name not in FOR_TOOLS and end.type not in TYPES_OF_MANY_PUBLISHERS:
            yield _finding(
                "TOP002",
                partners,
                end,
                f"{end.node.shown} publishes '{end.name}', and no node subscribes to it",
                "subscribe to it, remove the publisher, or list the name under `external`",
            )


@rule("TOP003", scope=Scope.SYSTEM)
def topic_without_publisher(system: System, options: Options) -> Iterator[Finding]:
    """Subscriptions of a closed system to topics that nobody publishes."""
    partners = _Partners(system)
    for end in _lonely(system, options, system.topics, EntityKind.SUBSCRIBER):
        yield _finding(
            "TOP003",
            partners,
            end,
            f"{end.node.shown} subscribes to '{end.name}', and no node publishes it: the callback never runs",
            "publish it, or list the name under `external`",
        )


@rule("SRV001", scope=Scope.SYSTEM)
def client_without_server(system: System, options: Options) -> Iterator[Finding]:
    """Clients whose service nobody offers: of a closed system, or where a server has almost the same name."""
    partners = _Partners(system)
    for end, besides in _without_server(system, options, system.services, EntityKind.CLIENT):
        said = _finding(
            "SRV001",
            partners,
            end,
            f"{end.node.shown} calls the service '{end.name}', and no node offers it{besides}: the request never "
            "gets a response",
            "start the node that serves it, or list the name under `external`",
            group=(end.place.file, end.kind) if besides else (),
        )
        yield _if_not_elsewhere(system, end, said)


@rule("ACT001", scope=Scope.SYSTEM)
def action_client_without_server(system: System, options: Options) -> Iterator[Finding]:
    """Action clients whose action nobody offers: of a closed system, or where a server has almost the same name."""
    partners = _Partners(system)
    for end, besides in _without_server(system, options, system.actions, EntityKind.ACTION_CLIENT):
        said = _finding(
            "ACT001",
            partners,
            end,
            f"{end.node.shown} sends goals to the action '{end.name}', and no node offers it{besides}: the goals are "
            "never accepted or rejected",
            "start the node that serves it, or list the name under `external`",
            group=(end.place.file, end.kind) if besides else (),
        )
        yield _if_not_elsewhere(system, end, said)


def _if_not_elsewhere(system: System, end: Endpoint, said: Finding) -> Finding:
    """Only information where another machine, such as the robot, may serve all of the package."""
    if not said.group or not may_be_served_elsewhere(system, end):
        return said
    condition = ", unless another machine serves what is in that package"
    return replace(said, severity=Severity.INFO, message=f"{said.message}{condition}")


@folds("SRV001", across_systems=True)
def _services_of_one_file(findings: Sequence[Finding]) -> Finding:
    return _of_one_file(findings, "service", "services")


@folds("ACT001", across_systems=True)
def _actions_of_one_file(findings: Sequence[Finding]) -> Finding:
    return _of_one_file(findings, "action", "actions")


def _of_one_file(findings: Sequence[Finding], noun: str, nouns: str) -> Finding:
    """One finding for what nobody offers of all that a file asks for, such as a helper of several nodes: the package
    that serves it is not here."""
    first, by_name = findings[0], {finding.identity[1]: finding for finding in reversed(findings)}
    others = [by_name[name] for name in sorted(by_name) if name != first.identity[1]]
    related = (Related(other.place, f"nobody offers '{other.identity[1]}', either") for other in others)
    count = f"another {noun}" if len(others) == 1 else f"{len(others)} more {nouns}"
    more = f"; nor does any node offer {count} that this file asks for" if others else ""
    return replace(first, message=f"{first.message}{more}", related=(*first.related, *related))


def _without_server(
    system: System, options: Options, connections: Mapping[str, Connection], kind: EntityKind
) -> Iterator[tuple[Endpoint, str]]:
    """Clients that nobody serves, each with what the message says besides."""
    if is_complete(system):
        yield from ((end, "") for end in _lonely(system, options, connections, kind))
        return
    slips = [user for user, _ in missed(system, options, connections)]
    told = {id(user) for user in slips}
    yield from ((user, "") for user in slips)
    for connection in connections.values():
        if connection.providers or options.is_external(connection.name):
            continue
        sure = [end for end in in_source_order(connection.users) if _is_judged(end) and id(end) not in told]
        if sure and has_no_server_here(system, sure[0]):
            yield sure[0], f", nor any other of {sure[0].type}, which this workspace defines"
            continue
        left_out = left_out_server(system, sure[0]) if sure and in_sight(system) else None
        if left_out is not None:
            yield sure[0], f", since this launch file starts all nodes of their package but {left_out.node.shown}"


def _lonely(
    system: System, options: Options, connections: Mapping[str, Connection], kind: EntityKind
) -> Iterator[Endpoint]:
    """Certain endpoints without a partner, one for each name; none where somebody unknown may be one."""
    if not is_complete(system):
        return
    implicit = implicit_names(system)
    unknown = {(end.name, end.type) for end in system.all_endpoints if end.kind == _PARTNER[kind] and not end.resolved}
    left = MOST_PAIRS
    for connection in connections.values():
        ends = [end for end in connection.providers + connection.users if end.kind == kind]
        if len(ends) < len(connection.providers + connection.users):
            continue
        if connection.name in implicit or options.is_external(connection.name):
            continue
        sure = [end for end in ends if _is_judged(end) and not named_by_library(end)]
        left -= len(sure) * len(unknown)
        if left < 0:
            return  # some of them may be the partners of those that are left
        if sure and not any(_may_match(end, *other) for end in sure for other in unknown):
            yield in_source_order(sure)[0]


def _is_judged(end: Endpoint) -> bool:
    """Whether an end exists for sure, and is one that code of the workspace makes."""
    return certain(end) and not end.external


def _may_match(end: Endpoint, name: str | None, type: str | None) -> bool:
    """Whether an end may have a partner of a type that is not wholly known by its name."""
    if end.type is not None and type is not None and end.type != type:
        return False
    return name is None or fnmatchcase(end.name or "", name)


def _finding(
    code: str, partners: _Partners, end: Endpoint, message: str, help: str, group: tuple[str, ...] = ()
) -> Finding:
    other = partners.nearest(end)
    return finding(
        code,
        end.place,
        message + meant(f"'{other.name}'" if other is not None else ""),
        help=help if other is None else "use the same name at both ends, or remap one in the launch file",
        related=[Related(other.place, f"{other.node.shown} has this one")] if other is not None else (),
        node=end.node.name,
        identity=(end.kind, end.name or ""),
        group=group if other is None else (),
    )


class _Partners:
    """The ends whose names are known, by what they could be the partner of.

    :data:`~archlint.checks.near_misses.MOST_PAIRS` names are compared for one rule; nothing is suggested after that.
    """

    def __init__(self, system: System) -> None:
        self._left = MOST_PAIRS
        self._named: dict[tuple[EntityKind, str | None], list[Endpoint]] = {}
        for end in system.endpoints:
            if end.resolved:
                self._named.setdefault((end.kind, end.type), []).append(end)

    def nearest(self, end: Endpoint) -> Endpoint | None:
        """A possible partner whose name differs by a slip of the pen."""
        kind = _PARTNER[end.kind]
        partners = [other for type in {end.type: 0, None: 0} for other in self._named.get((kind, type), ())]
        self._left -= len(partners)
        if self._left < 0:
            return None
        near = [
            other for other in partners if nearly_equal(other.name or "", end.name or "") or is_private_of(other, end)
        ]
        if len(partners) == 1 and in_other_namespace(partners[0], end):
            near = partners
        return min(near, key=lambda other: (other.name or "", other.place), default=None)
