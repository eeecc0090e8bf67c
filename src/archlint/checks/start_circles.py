"""SRV006: nodes that wait for each other at their start, before they offer what the other one needs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words
from archlint.checks.circle_search import Key, circles
from archlint.checks.registry import finding
from archlint.execution.start_waits import StartWait, start_waits
from archlint.finding import Finding, Related
from archlint.model import SERVER_OF, EntityKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_THERE, _ANSWERS = "there", "answers"


@dataclass(frozen=True)
class _Edge:
    """A server is not there, or does not answer, before a wait is over."""

    wait: StartWait

    @property
    def server(self) -> Endpoint:
        return self.wait.server

    @property
    def target(self) -> Key:
        client = self.wait.client
        return _key(_ANSWERS if self.wait.for_response else _THERE, SERVER_OF[client.kind], client.name)


def _key(state: str, kind: EntityKind, name: str | None) -> Key:
    return f"{kind} {state}", name or ""


def start_circles(system: System) -> Iterator[Finding]:
    """What SRV006 says of waits at the start that only their own end could end."""
    edges: dict[Key, list[_Edge]] = {}
    for wait in start_waits(system):
        for state in (_THERE, _ANSWERS) if wait.comes_after else (_ANSWERS,):
            edges.setdefault(_key(state, wait.server.kind, wait.server.name), []).append(_Edge(wait))
    for circle in circles(edges, system, lambda circle: frozenset(edge.wait.call.place for edge in circle)):
        yield _circle([edge.wait for edge in circle])


def _circle(circle: list[StartWait]) -> Finding:
    ordered = sorted(circle, key=lambda wait: wait.call.place)
    last = ordered[-1]
    return finding(
        "SRV006",
        last.call.place,
        _words(last, ordered),
        help="make the servers before waiting for others"
        if all(wait.comes_after for wait in circle)
        else "wait for others in a timer, once the node is spun",
        related=[row for wait in ordered for row in _related(wait)],
        node=last.server.node.name,
        identity=tuple(sorted(wait.server.name or "" for wait in circle)),
    )


def _words(last: StartWait, ordered: list[StartWait]) -> str:
    if len(ordered) == 1:
        return (
            f"this waits for {endpoint_words(last.client.creation)}, which the program itself makes only afterwards: "
            "it never goes on"
        )
    nodes = " and ".join(dict.fromkeys(wait.client.node.shown for wait in ordered))
    waits = ", ".join(f"{wait.client.node.shown} for {wait.client.name}" for wait in ordered)
    return f"{nodes} wait for each other at their start ({waits}): none of them ever goes on"


def _related(wait: StartWait) -> Iterator[Related]:
    awaited = "the response of " if wait.for_response else ""
    yield Related(wait.call.place, f"{wait.client.node.shown} waits for {awaited}{wait.client.name} here")
    until = "is made only afterwards" if wait.comes_after else "does not answer before that"
    yield Related(wait.server.place, f"{wait.server.name} {until}")


__all__ = ["start_circles"]
