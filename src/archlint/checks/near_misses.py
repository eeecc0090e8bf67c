"""TOP004: a publisher and a subscription that miss each other by a slip of the pen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import (
    are_both_external,
    certain,
    coexist,
    in_source_order,
    known_to_coexist,
    named_by_library,
)
from archlint.analysis.kept import once
from archlint.analysis.left_over import is_left_over
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.sight import in_sight
from archlint.connections.only_counterparts import OnlyOnes
from archlint.connections.own_types import is_only_server
from archlint.finding import Finding, Related
from archlint.model import EntityKind
from archlint.ros.external_nodes import well_known
from archlint.suggestions import are_opposites, distance
from archlint.systems.externals import UsedNames
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Connection, Endpoint

_LONG_WORD = 7
"""From this length on, two edits are a slip; below, one is."""
_SHORT_WORD = 4
"""Shorter words that differ are different words: ``in`` and ``on``."""
_SHORT_STEM = 3
"""A word this short that lacks a letter is a slip where words around it agree: ``cmd_vell``, ``robot_pos``,
``front_scn``."""
_PARTIES = 2
_POSITIONS = frozenset({"to", "from", "in", "of", "by", "for", "with", "and", "or", "vs", "per", "2"})
"""Words that give the order of the others a meaning: ``map_to_odom`` and ``odom_to_map``."""


MOST_PAIRS = 100_000
"""How many pairs of names are compared: a system with more ends that nobody uses is a text made to stall."""


@rule("TOP004", scope=Scope.SYSTEM)
def near_miss_topic_name(system: System, options: Options) -> Iterator[Finding]:
    """Pairs of publishers and subscriptions without partners, of one type, with names that are almost equal."""
    for user, candidates in missed(system, options, system.topics):
        yield _finding(user, candidates)


def missed(
    system: System, options: Options, connections: Mapping[str, Connection]
) -> Iterator[tuple[Endpoint, list[Endpoint]]]:
    """Users of names that nobody provides, each with those who provide almost the same name to nobody."""
    unread = UsedNames(node for node in system.nodes if node.is_stranger)
    alone = [
        connection
        for connection in connections.values()
        if not (connection.users and connection.providers)
        and not options.is_external(connection.name)
        and not unread.holds(connection.name)
        and not _is_made_by_launch(system, connection.name)
        and not _is_joined_by_launch(system, connection)
    ]
    provided = _by_type(connection for connection in alone if not connection.users)
    only = OnlyOnes(alone)
    said: set[tuple[Place, ...]] = set()
    pairs = 0
    for connection in alone:
        if connection.providers:
            continue
        for user in in_source_order(_judged(connection)):
            pairs += len(provided.get(user.type or "", []))
            if pairs > MOST_PAIRS:
                return
            candidates = [end for end in provided.get(user.type or "", []) if _misses(system, only, end, user)]
            lines = user.place, *(end.place for end in candidates)
            if candidates:
                if lines not in said:  # a line that makes one user in each namespace is wrong once
                    yield user, candidates
                said.add(lines)
                break


def _is_made_by_launch(system: System, name: str) -> bool:
    """Whether a launch file, of which this system has nothing, gives a node the name that makes its private name this
    one: ``~/odom`` and ``positioning/odom``."""
    if system.name is not None or system.workspace is None:
        return False
    private = _private_names(system.workspace)
    return any(name[at + 1 :] in private for at, letter in enumerate(name) if letter == "/")


def _is_joined_by_launch(system: System, connection: Connection) -> bool:
    """Whether a launch file, of which this system has nothing, gives an end of the other side the name that has only
    this one here, by a remapping or a namespace: ``left_cmd`` becomes ``/left/cmd``."""
    if system.name is not None or system.workspace is None:
        return False
    return (connection.kind, connection.name, not connection.providers) in _sides_of_launched(system.workspace)


@once
def _sides_of_launched(workspace: WorkspaceIndex) -> frozenset[tuple[ConnectionKind, str, bool]]:
    """Kind and name of what nodes use or provide in what launch files start, and whether they provide it."""
    launched = (system for system in workspace.systems if system.launched is not None)
    connections = (
        connection
        for system in launched
        for several in (system.topics, system.services, system.actions)
        for connection in several.values()
    )
    return frozenset(
        (connection.kind, connection.name, provides)
        for connection in connections
        for provides, ends in ((True, connection.providers), (False, connection.users))
        if ends
    )


@once
def _private_names(workspace: WorkspaceIndex) -> frozenset[str]:
    """What becomes of private names where launch files give their nodes another name than the code does, without the
    namespace."""
    launched = (system for system in workspace.systems if system.launched is not None)
    return frozenset(
        f"{node.own.name.text}/{end.written[2:]}"
        for system in launched
        for node in system.nodes
        if node.own is not None and node.blueprint is not None and node.own.name.text != node.blueprint.name.text
        for end in node.endpoints
        if end.written is not None and end.written.startswith("~/")
    )


def _by_type(connections: Iterator[Connection]) -> dict[str, list[Endpoint]]:
    by_type: dict[str, list[Endpoint]] = {}
    for connection in connections:
        for end in _judged(connection):
            by_type.setdefault(end.type or "", []).append(end)
    return by_type


def _judged(connection: Connection) -> list[Endpoint]:
    ends = [*connection.providers, *connection.users]
    return [end for end in ends if certain(end) and end.type is not None and not named_by_library(end)]


def _misses(system: System, only: OnlyOnes, provider: Endpoint, user: Endpoint) -> bool:
    if provider.node is user.node:
        return False  # one node that reads and writes two like names distinguishes them on purpose
    slip = (
        nearly_equal(provider.name or "", user.name or "")
        or _namespace_slip(system, provider, user)
        or (is_private_of(provider, user) and not _is_renamed(system, provider, user))
        or _is_the_one_meant(system, provider, user)
    )
    if not slip and not only.are_meant_as_one(system, provider, user):
        return False
    return (
        _is_for_us(system, provider, user)
        and not is_left_over(system.workspace, provider)  # reads code, where names of most pairs say no
        and coexist(system, provider, user, any_package=not slip)
    )


def _is_for_us(system: System, provider: Endpoint, user: Endpoint) -> bool:
    """Whether code of the workspace makes both ends, or one of them in a system where nobody unseen may be the other's
    partner."""
    if not (provider.external or user.external):
        return True
    return not are_both_external(provider, user) and in_sight(system)


def _namespace_slip(system: System, provider: Endpoint, user: Endpoint) -> bool:
    """Whether one name has a namespace more, which its node was started in and the other end does without.

    Only nodes that are seen to start together show that, by a launch file that no other includes: that one may
    yet add the namespace.
    """
    if system.is_included:
        return False
    inner, outer = sorted((provider, user), key=lambda end: len(end.name or ""), reverse=True)
    long, short = (inner.name or "").split("/"), (outer.name or "").split("/")
    namespaces = (inner.node.name or "").split("/")[1:-1]
    return any(
        long[:at] + long[at + 1 :] == short and long[1 : at + 1] == namespaces[:at] for at in range(1, len(long) - 1)
    ) and known_to_coexist(system, provider.node, user.node)


def in_other_namespace(end: Endpoint, other: Endpoint) -> bool:
    """Whether two servers or clients have the same name in different namespaces: ``/robot/set_motor`` and
    ``/set_motor``."""
    mine, yours = (each.name or "" for each in (end, other))
    return end.kind in _SERVED and mine != yours and mine.rpartition("/")[2] == yours.rpartition("/")[2]


_SERVED = frozenset({EntityKind.SERVICE, EntityKind.ACTION_SERVER, EntityKind.CLIENT, EntityKind.ACTION_CLIENT})


def _is_the_one_meant(system: System, server: Endpoint, client: Endpoint) -> bool:
    """Whether a client asks in another namespace for what only this server offers: of a type that the workspace
    defines, nobody else can have one.  Without a launch file both are of one package, and no launch file has either."""
    if not in_other_namespace(server, client) or _is_renamed(system, server, client):
        return False
    together = (
        server.node.package == client.node.package is not None
        if system.name is None
        else known_to_coexist(system, server.node, client.node)
    )
    return together and is_only_server(system, server)


def is_private_of(server: Endpoint, client: Endpoint) -> bool:
    """Whether a node serves under its own name what is asked for beside it: ``~/set_motor`` and ``set_motor``."""
    written = server.written or ""
    if server.kind not in (EntityKind.SERVICE, EntityKind.ACTION_SERVER) or not written.startswith("~/"):
        return False
    beside = f"{(server.node.name or '').rpartition('/')[0]}/{written[2:]}"
    return (
        server.name == f"{server.node.name}/{written[2:]}" and client.name == beside and client.written == written[2:]
    )


def _is_renamed(system: System, server: Endpoint, client: Endpoint) -> bool:
    """Whether a remapping may join a private name and the one beside it: a launch file that starts one of the nodes, of
    which this system has nothing, may have it."""
    if system.name is not None:
        return system.is_included
    launched = frozenset() if system.workspace is None else system.workspace.started_by_launch
    blueprints = (server.node.blueprint, client.node.blueprint)
    return any(blueprint is None or key_of(blueprint) in launched for blueprint in blueprints)


def nearly_equal(name: str, other: str) -> bool:
    """Whether two full names differ by a slip in one of their parts, or in what stands between two."""
    if name.count("/") != other.count("/"):
        return name.replace("/", "_") == other.replace("/", "_")
    mine, yours = name.split("/"), other.split("/")
    differing = [(left, right) for left, right in zip(mine, yours, strict=True) if left != right]
    return len(differing) == 1 and _slip(*differing[0])


def _slip(part: str, other: str) -> bool:
    if part.replace("_", "").lower() == other.replace("_", "").lower():
        return True
    mine, yours = part.split("_"), other.split("_")
    if len(mine) != len(yours):
        return False
    if len(mine) > 1 and sorted(mine) == sorted(yours):
        # The same words in another order; of two, they are the two directions between two parties.
        return len(mine) > _PARTIES and not _POSITIONS.intersection(mine)
    words = [(left, right) for left, right in zip(mine, yours, strict=True) if left != right]
    return len(words) == 1 and _misspelt(*words[0], alone=len(mine) == 1)


def _misspelt(word: str, other: str, alone: bool) -> bool:
    short = min(len(word), len(other))
    if any(letter.isdigit() for letter in word + other) or are_opposites(word.lower(), other.lower()):
        return False
    if short == _SHORT_STEM and not alone:
        ends_alike = (word[0], word[-1]) == (other[0], other[-1]) and distance(word, other, 1) == 1
        return len(word) != len(other) and (word.startswith(other) or other.startswith(word) or ends_alike)
    if short < _SHORT_WORD or (short < _LONG_WORD and len(word) == len(other) and word[0] != other[0] != word[1]):
        return False  # a short word with another first letter is another word: point and joint
    limit = 2 if short >= _LONG_WORD else 1
    return distance(word, other, limit) <= limit


def _follows_node(end: Endpoint) -> bool:
    """Whether a name is the relative one that the code writes, in the namespace of its node, and no remapping's."""
    return end.name == f"{(end.node.name or '').rpartition('/')[0]}/{end.written}"


def _finding(user: Endpoint, candidates: list[Endpoint]) -> Finding:
    nearest = candidates[0]
    hint = f"did you mean '{nearest.name}'?"
    help = "use the same name at both ends, or remap one in the launch file"
    if user.written == nearest.written and _follows_node(user) and _follows_node(nearest):
        hint = f"both write '{user.written}'"
        help = f"give {user.node.shown} and {nearest.node.shown} the same namespace in the launch file"
    at = nearest if user.external else user
    if hint.startswith("did") and not nearest.external and _is_the_right_one(user, nearest):
        return _of_publisher(user, nearest, help)
    return finding(
        "TOP004",
        at.place,
        f"no node publishes '{user.name}', and no node subscribes to '{nearest.name}', which {nearest.node.shown} "
        f"publishes with the same type; {hint}",
        help=help,
        related=[Related(end.place, f"{end.node.shown} publishes '{end.name}'") for end in candidates],
        node=at.node.name,
        identity=(user.name or "", nearest.name or ""),
    )


def _of_publisher(user: Endpoint, provider: Endpoint, help: str) -> Finding:
    """The finding where the publisher has the slip."""
    return finding(
        "TOP004",
        provider.place,
        f"no node subscribes to '{provider.name}', and no node publishes '{user.name}', to which {user.node.shown} "
        f"subscribes with the same type; did you mean '{user.name}'?",
        help=help,
        related=[Related(user.place, f"{user.node.shown} subscribes to '{user.name}'")],
        node=provider.node.name,
        identity=(user.name or "", provider.name or ""),
    )


def _is_the_right_one(user: Endpoint, provider: Endpoint) -> bool:
    """Whether nodes of ROS have the name that a subscription has, ``chatter``, and none has that of the publisher, as
    its code writes it."""
    right, slip = (_last_part(end.name) for end in (user, provider))
    return right in _names_of_ros() and slip not in _names_of_ros() and slip == _last_part(provider.written)


def _last_part(name: str | None) -> str:
    return (name or "").rpartition("/")[2]


@cache
def _names_of_ros() -> frozenset[str]:
    """The last parts of the names that well-known nodes give their topics."""
    nodes = (node for nodes in well_known().values() for node in nodes)
    return frozenset(end.name.rpartition("/")[2] for node in nodes for end in node.ends)
