"""Which endpoints of one name meet in a running system, so that a rule may hold them against each other.

Without a launch file nothing proves that two executables run together: those that look like variants of one
node are then taken for alternatives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.analysis.completeness import called_names
from archlint.branches import exclusive, runs_along
from archlint.model import (
    EntityKind,
    Role,
)
from archlint.ros.well_known import OF_MANY_PUBLISHERS
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

MOST_ENDS = 100
"""How many ends of one name are held against each other, the first in the source: with all of them the work, and what
is said, would grow with the square of their number."""
_NEVER_REACHED = frozenset({Role.METHOD})
"""Roles of code that nothing in the workspace is seen to run."""
_PLACEHOLDERS = frozenset({"placeholder", "unset", "undefined", "none", "null", "todo", "tbd", "changeme", "fixme"})


def certain(endpoint: Endpoint) -> bool:
    """Whether an endpoint exists for sure, under a known name, as long as its node runs."""
    return possible(endpoint) and not endpoint.creation.conditional


def possible(endpoint: Endpoint) -> bool:
    """The same, or that it may exist so: some branch decides."""
    return existing_at_times(endpoint) and not endpoint.creation.destroyed


def existing_at_times(endpoint: Endpoint) -> bool:
    """The same, or that it exists until the node destroys it, to make another one in its place."""
    creation = endpoint.creation
    return (
        endpoint.resolved
        and endpoint.error is None
        and endpoint.node.error is None  # the node does not come up at all
        and endpoint.node.name is not None
        and not endpoint.node.test
        and not is_placeholder(endpoint.name or "")
        and (creation.context is None or creation.context.role not in _NEVER_REACHED)
    )


@lru_cache(maxsize=10_000)  # asked of each endpoint by most rules
def is_placeholder(name: str) -> bool:
    """Whether a name only holds the place of the one that whoever starts the node gives: two nodes that both have
    ``/_`` have no topic in common."""
    last = name.rpartition("/")[2]
    return last.lower() in _PLACEHOLDERS or not any(letter.isalnum() for letter in last)


def named_by_library(endpoint: Endpoint) -> bool:
    """Whether a library, and not this code, chose the name: every ``tf2_ros.Buffer`` offers ``tf2_frames``."""
    return endpoint.creation.api.startswith("tf2_ros.")


def are_both_external(end: Endpoint, other: Endpoint) -> bool:
    """Whether neither end is made by code of the workspace: what is wrong between them is for others to mend."""
    return end.external and other.external


def in_source_order(endpoints: Iterable[Endpoint]) -> list[Endpoint]:
    """Ends in the order of the source; those of nodes whose source is not here come first, so that what is said of
    several is said at code of the workspace, where it ends."""
    ends = list(endpoints)
    if len(ends) > 1:
        ends.sort(key=lambda end: (not end.external, end.place, end.node.name or "", end.type or ""))
    return ends


def first_in_source(endpoints: Iterable[Endpoint]) -> list[Endpoint]:
    """The first :data:`MOST_ENDS` in the order of the source."""
    return in_source_order(endpoints)[:MOST_ENDS]


def coexisting_pairs(system: System, endpoints: Iterable[Endpoint]) -> Iterator[tuple[Endpoint, Endpoint]]:
    """Pairs of certain endpoints that run together; in each, the second comes later in the source."""
    for end, other in combinations(first_in_source(e for e in endpoints if certain(e)), 2):
        if not are_both_external(end, other) and coexist(system, end, other) and _under_one_name(system, end, other):
            yield end, other


def conflicting_pairs(
    system: System, endpoints: Iterable[Endpoint], agree: Callable[[Endpoint, Endpoint], bool]
) -> Iterator[tuple[Endpoint, Endpoint]]:
    """Pairs of endpoints that run together and do not agree whenever both exist.

    One of them exists for sure.  The other may depend on a branch, unless its node has another endpoint of that
    name which would agree: then the branches choose the one that fits.
    """
    at_times = first_in_source(end for end in endpoints if existing_at_times(end))
    ends = [end for end in at_times if possible(end)]
    sure = {id(end) for end in ends if certain(end)}
    of_node: dict[tuple[int, str], list[Endpoint]] = {}
    for end in at_times:
        of_node.setdefault((id(end.node), end.kind), []).append(end)
    for endpoint, other in combinations(ends, 2):
        if agree(endpoint, other) or not sure & {id(endpoint), id(other)} or are_both_external(endpoint, other):
            continue
        fixed, chosen = (endpoint, other) if id(endpoint) in sure else (other, endpoint)
        choices = [] if id(chosen) in sure else of_node[id(chosen.node), chosen.kind]
        if any(agree(fixed, end) for end in choices) or not coexist(system, endpoint, other):
            continue
        if chosen.external and choices and chosen is not choices[0]:
            continue  # one of several types that it may have is enough to be told
        if _under_one_name(system, endpoint, other):
            yield endpoint, other


def coexist(system: System, end: Endpoint, other: Endpoint, any_package: bool = False) -> bool:
    """Whether two endpoints are seen to exist at the same time; ``any_package`` as for :meth:`System.may_coexist`."""
    if end.node is other.node:
        return True
    return (
        system.may_coexist(end.node, other.node, any_package)
        # Two nodes of one name are one node written twice, or a mistake of another kind.
        and end.node.name != other.node.name
        and not exclusive(end.creation.branch_arms, other.creation.branch_arms)
        and _started_alike(end.node, other.node)
        and not (not known_to_coexist(system, end.node, other.node) and _unlikely_to_coexist(system, end, other))
    )


def _under_one_name(system: System, end: Endpoint, other: Endpoint) -> bool:
    """False where launch files start the nodes of two endpoints under other names each time: what the code calls
    them by default then proves nothing."""
    if end.node is other.node or known_to_coexist(system, end.node, other.node):
        return True
    return not _names_when_launched(system, end).isdisjoint(_names_when_launched(system, other))


def _names_when_launched(system: System, end: Endpoint) -> frozenset[str | None]:
    blueprint, workspace = end.node.blueprint, system.workspace
    if blueprint is None or workspace is None:
        return frozenset([end.name])
    given = workspace.launched_names(blueprint, end.kind, end.place)
    default = [other for other in end.node.endpoints if (other.kind, other.place) == (end.kind, end.place)] == [end]
    if default and workspace.is_renamed_by_launch(blueprint, end.kind, end.place, end.name):
        given -= {end.name}
    return given - {None} if given else frozenset([end.name])


def _started_alike(node: Node, other: Node) -> bool:
    """False where a launch file starts the two under different conditions: then perhaps never both."""
    return runs_along(node.alternatives, other.alternatives)


def known_to_coexist(system: System, first: Node, other: Node) -> bool:
    """Whether a launch file or one executable is seen to start both nodes.  A script that is not installed may have
    the name of an executable that is another file."""
    if system.name is not None:
        return True
    made_in = {node.program.file for node in (first, other) if node.program is not None}
    if system.workspace is not None and len(made_in) == 2 and len(first.executables) == len(other.executables) == 1:
        return False
    return not _starters(first).isdisjoint(_starters(other))


def launched_separately(system: System, first: Node, other: Node) -> bool:
    """Whether launch files start both nodes, but none starts both of them: then they are alternatives, or at
    least nothing proves that they are not."""
    if system.name is not None or system.workspace is None:
        return False
    mine, yours = (_launches(system.workspace.systems, node) for node in (first, other))
    return bool(mine) and bool(yours) and mine.isdisjoint(yours)


def _launches(systems: Iterable[System], node: Node) -> set[str | None]:
    """The launch files that start a node of this class."""
    if node.blueprint is None:
        return set()
    wanted = (node.blueprint.place, node.blueprint.class_name)
    return {
        system.name
        for system in systems
        if system.launched is not None
        and any(n.blueprint and (n.blueprint.place, n.blueprint.class_name) == wanted for n in system.nodes)
    }


def has_launch_files(system: System) -> bool:
    """Whether launch files say what runs together: what none of them starts together are mostly alternatives."""
    systems = system.workspace.systems if system.workspace is not None else []
    return any(other.launched is not None and bool(other.launched.started) for other in systems)


def _starters(node: Node) -> set[tuple[str | None, str]]:
    nodes = [blueprint for blueprint in (node.blueprint, *node.merged) if blueprint is not None]
    scripts = {(None, file) for blueprint in nodes for file in blueprint.scripts}
    return scripts | {(node.package, executable) for executable in node.executables}


def are_alternatives(system: System, node: Node, other: Node) -> bool:
    """Whether two nodes that nothing is seen to start together publish one topic: each does the other's work."""
    if known_to_coexist(system, node, other):
        return False
    return not _publishes(node).isdisjoint(_publishes(other) - OF_MANY_PUBLISHERS)


def _publishes(node: Node) -> set[str]:
    return {end.name for end in node.of_kind(EntityKind.PUBLISHER) if end.resolved and end.name is not None}


def _unlikely_to_coexist(system: System, endpoint: Endpoint, other: Endpoint) -> bool:
    """Whether two nodes of different executables are probably never started together."""
    alone = any(_tries_out(end.node) or _starts_others(system, end.node) for end in (endpoint, other))
    return alone or _variants(endpoint, other)


def _starts_others(system: System, node: Node) -> bool:
    """Whether a script that no launch file starts starts processes of its own: it chooses what runs along with it."""
    if (
        system.workspace is None
        or node.blueprint is None
        or key_of(node.blueprint) in system.workspace.started_by_launch
    ):
        return False
    called = called_names(system.workspace, node.blueprint.place.file)
    return called is not None and not _STARTERS.isdisjoint(called)


_STARTERS = frozenset({"Popen", "LaunchService"})


def _tries_out(node: Node) -> bool:
    """A program called ``test_…`` is there to try something out by hand."""
    return bool(node.executables) and all(
        name.startswith("test_") or name.endswith("_test") for name in node.executables
    )


def _variants(end: Endpoint, other: Endpoint) -> bool:
    """Whether the nodes of two endpoints look like two forms of one node, of which one runs: they share their
    class, the very create call, most of what they publish, serve, call and subscribe to, or all that they serve."""
    return (
        _class_name(end.node) == _class_name(other.node)
        or end.place == other.place
        or _much_alike(end.node, other.node)
        or _serve_the_same(end.node, other.node)
    )


def _much_alike(node: Node, other: Node) -> bool:
    mine, yours = _interface(node), _interface(other)
    shared = mine & yours
    return len(shared) > 1 and 2 * len(shared) > len(mine | yours)


def _serve_the_same(node: Node, other: Node) -> bool:
    """Whether two nodes offer the same services and actions, several and no others: two drivers of one device."""
    mine, yours = (
        {(end.kind, end.name) for end in row.of_kind(EntityKind.SERVICE, EntityKind.ACTION_SERVER)}
        for row in (node, other)
    )
    return mine == yours and len(mine) > 1 and all(name is not None for _, name in mine)


def _interface(node: Node) -> set[tuple[str, str]]:
    return {(endpoint.kind, endpoint.name) for endpoint in node.endpoints if endpoint.name is not None}


def _class_name(node: Node) -> str:
    return "" if node.blueprint is None else node.blueprint.class_name.rpartition(".")[2]


def all_endpoints(connection: Connection) -> list[Endpoint]:
    return [*connection.providers, *connection.users]
