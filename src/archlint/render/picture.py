"""The graph that is drawn: the system's, with what keeps connections from ever carrying a message."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.architecture import TOPIC
from archlint.connections.unconnected import unconnected_on
from archlint.records import dataclass
from archlint.render.observed import mark
from archlint.systems.graph import Key, node_keys, to_networkx
from archlint.systems.model import System
from archlint.systems.shape import connections

if TYPE_CHECKING:
    import networkx

    from archlint.connections.unconnected import Unconnected
    from archlint.systems.nodes import Connection, Endpoint


def graph_of(system: System) -> networkx.MultiDiGraph:
    """As :func:`~archlint.systems.graph.to_networkx`; each edge also has ``broken``: why nothing gets through, or an
    empty text, and ``held_back``: what does not, where something does.  ``graph.graph["cut"]`` says from which node
    over what to which node nothing gets.  Where the system was held against a running one,
    :mod:`archlint.render.observed` marks that."""
    graph = to_networkx(system)
    breaks = breaks_of(system)
    for _, _, attributes in graph.edges(data=True):
        end = id(attributes["endpoint"])
        attributes["broken"] = breaks.ends.get(end, "")
        attributes["held_back"] = breaks.held_back.get(end, [])
    graph.graph["broken"] = bool(breaks.ends)
    graph.graph["cut"] = breaks.cut
    if system.compared is not None:
        mark(graph, system, system.compared)
    return graph


@dataclass
class Breaks:
    """What never gets through in a system, and why."""

    ends: dict[int, str] = field(default_factory=dict)
    """The ends that connect to nobody, by ``id(endpoint)``."""
    held_back: dict[int, list[str]] = field(default_factory=dict)
    """Whom the other ends do not reach."""
    cut: dict[tuple[Key, Key, Key], str] = field(default_factory=dict)
    """From which node, over what, to which node nothing gets."""


def broken_ends(system: System) -> dict[int, str]:
    """Why QoS or a type keeps an end from connecting, by ``id(endpoint)``."""
    return breaks_of(system).ends


def breaks_of(system: System) -> Breaks:
    """Where one of several publishers fits, the one that does not is the broken end, and the other way round; where
    each of a pair has another partner, both work, and only say whom they do not reach."""
    breaks, keys = Breaks(), node_keys(system)
    for connection in connections(system):
        pairs = list(unconnected_on(system, connection))
        if pairs:
            _note_ends(breaks, connection, pairs)
            _note_cuts(breaks, connection, pairs, keys)
    return breaks


def _note_ends(breaks: Breaks, connection: Connection, pairs: list[Unconnected]) -> None:
    lost: dict[int, int] = {}
    for pair in pairs:
        for end in (pair.offer, pair.request):
            lost[id(end)] = lost.get(id(end), 0) + 1
    for pair in pairs:
        alone = [
            end
            for end, partners in ((pair.offer, connection.users), (pair.request, connection.providers))
            if lost[id(end)] == len(partners)
        ]
        for end in alone:
            breaks.ends.setdefault(id(end), pair.reason)
        if not alone:
            _hold_back(breaks, pair.offer, f"not to {pair.request.node.name}: {pair.reason}")
            _hold_back(breaks, pair.request, f"not from {pair.offer.node.name}: {pair.reason}")


def _hold_back(breaks: Breaks, end: Endpoint, words: str) -> None:
    breaks.held_back.setdefault(id(end), []).append(words)


def _note_cuts(breaks: Breaks, connection: Connection, pairs: list[Unconnected], keys: dict[int, Key]) -> None:
    """Two nodes are cut off from each other where all of their ends are."""
    reasons: dict[tuple[int, int], list[str]] = {}
    for pair in pairs:
        reasons.setdefault((id(pair.offer.node), id(pair.request.node)), []).append(pair.reason)
    for (provider, user), told in reasons.items():
        offers = sum(id(end.node) == provider for end in connection.providers)
        requests = sum(id(end.node) == user for end in connection.users)
        if len(told) == offers * requests:
            ends = (keys[provider], keys[user])
            tail, head = ends if connection.kind == TOPIC else ends[::-1]
            breaks.cut[tail, (connection.kind, connection.name), head] = told[0]
