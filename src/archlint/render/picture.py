"""The graph that is drawn: the system's, with what keeps connections from ever carrying a message."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.delivery import undelivered
from archlint.render.observed import mark
from archlint.systems.graph import to_networkx
from archlint.systems.model import System

if TYPE_CHECKING:
    from collections.abc import Sequence

    import networkx

    from archlint.systems.nodes import Endpoint


def graph_of(system: System) -> networkx.MultiDiGraph:
    """As :func:`~archlint.systems.graph.to_networkx`; each edge also has ``broken``: why no message gets through, or
    an empty text.  Where the system was held against a running one, :mod:`archlint.render.observed` marks that."""
    graph = to_networkx(system)
    reasons = broken_ends(system)
    for _, _, attributes in graph.edges(data=True):
        attributes["broken"] = reasons.get(id(attributes["endpoint"]), "")
    graph.graph["broken"] = any(reasons.values())
    if system.compared is not None:
        mark(graph, system, system.compared)
    return graph


def broken_ends(system: System) -> dict[int, str]:
    """Why quality of service keeps an end from connecting, by ``id(endpoint)``.

    Where one of several publishers fits, the one that does not is the broken end, and the other way round; where
    each of a pair has another partner, both are.
    """
    pairs = list(undelivered(system))
    lost: dict[int, set[int]] = {}
    for pair in pairs:
        lost.setdefault(id(pair.request), set()).add(id(pair.offer))
        lost.setdefault(id(pair.offer), set()).add(id(pair.request))
    partners = {id(end): len(_partners(system, end)) for pair in pairs for end in (pair.offer, pair.request)}
    reasons: dict[int, str] = {}
    for pair in pairs:
        ends = (pair.offer, pair.request)
        alone = [end for end in ends if len(lost[id(end)]) == partners[id(end)]]
        for end in alone or ends:
            reasons.setdefault(id(end), pair.reason)
    return reasons


def _partners(system: System, end: Endpoint) -> Sequence[Endpoint]:
    """The other side of an end's topic."""
    topic = system.topics[end.name or ""]
    return topic.users if any(end is provider for provider in topic.providers) else topic.providers
