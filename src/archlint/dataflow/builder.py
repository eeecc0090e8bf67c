"""What puts the graph of data together: each step and each link once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.connections.delivery import undelivered_on
from archlint.dataflow.model import NOT_KNOWN, Flow, How, Link, Step, StepKind
from archlint.dataflow.runs import Run, Runs
from archlint.model import NAMED, EntityKind
from archlint.systems.graph import interface_key

if TYPE_CHECKING:
    from archlint.model import Creation
    from archlint.place import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

IDLE = "idle"
"""The name of the unknown code of a node that does nothing with an end."""
_REQUEST = {"topic": StepKind.TOPIC, "service": StepKind.SERVICE, "action": StepKind.ACTION}
_ANSWER = {"service": StepKind.ANSWER, "action": StepKind.RESULT}


class Builder:
    """The steps and links found so far."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.runs = Runs(system)
        self.sent: set[int] = set()
        """The ends (``id``) with which a call is seen to send."""
        self._steps: dict[object, Step] = {}
        self._kept = 0
        self._links: dict[tuple[int, int, How], Link] = {}
        self._runs_on: dict[int, list[Run]] = {}
        for run in self.runs:
            self._runs_on.setdefault(id(run.node), []).append(run)
        self._ends: dict[int, list[Endpoint]] = {}
        for end in system.endpoints:
            self._ends.setdefault(id(end.creation), []).append(end)
        self._broken = {
            (id(pair.offer), id(pair.request)): pair.reason
            for topic in system.topics.values()
            for pair in undelivered_on(system, topic)
        }

    def flow(self) -> Flow:
        """All that was found."""
        return Flow(self.system, tuple(self._steps.values()), tuple(self._links.values()))

    def runs_on(self, node: Node) -> Sequence[Run]:
        """What runs on a node."""
        return self._runs_on.get(id(node), ())

    def ends(self, creation: Creation, node: Node) -> Sequence[Endpoint]:
        """What a create call is in the system: the end of a node itself, if it has one, or else of others."""
        ends = self._ends.get(id(creation), [])
        return [end for end in ends if end.node is node] or ends

    # -------------------------------------------------------------------------------------------- steps

    def step_of(self, run: Run) -> Step:
        """What runs, as a step."""
        callback = run.callback
        step = Step(StepKind.CALLBACK, callback.name, run.node, callback, run.program, callback.place, tuple(run.calls))
        return self._step(id(run), step)

    def connection(self, end: Endpoint) -> Step:
        """The topic, or the requests of the service or action, that an endpoint is an end of."""
        return self._interface(end, _REQUEST[NAMED[end.kind]])

    def answer(self, end: Endpoint) -> Step:
        """What comes back from the service or action that an endpoint is an end of."""
        return self._interface(end, _ANSWER[NAMED[end.kind]])

    def _interface(self, end: Endpoint, kind: StepKind) -> Step:
        name = end.name if end.resolved and not end.error else None
        of_kind = {"topic": self.system.topics, "service": self.system.services, "action": self.system.actions}
        known = None if name is None else of_kind[NAMED[end.kind]].get(name)
        if known is not None:
            return self._step((kind, name), Step(kind, known.name, connection=known))
        reason = end.error or end.reason or "its name is not known"
        return self._step((kind, interface_key(end)), Step(kind, end.name or NOT_KNOWN, place=end.place, reason=reason))

    def taker(self, node: Node) -> Step:
        """Code of a node that takes what arrives, and is not known: what it does with it may be anything."""
        step = self._unknown(node, "taker")
        for end in node.endpoints:
            if end.kind in (EntityKind.PUBLISHER, EntityKind.CLIENT, EntityKind.ACTION_CLIENT):
                self.link(step, self.connection(end), How.SEND, end.place, "what arrives may have to do with it")
        return step

    def sender(self, node: Node) -> Step:
        """Code of a node that sends, and is not known: it may have to do with all that arrives."""
        step = self._unknown(node, "sender")
        for run in self.runs_on(node):
            self.link(self.step_of(run), step, How.SET, None, "what it leaves may have to do with it")
        return step

    def idle(self, node: Node) -> Step:
        """A node that has an end, and does nothing with it."""
        return self._unknown(node, IDLE)

    def _unknown(self, node: Node, part: str) -> Step:
        blueprint = node.blueprint
        place = None if blueprint is None else blueprint.place
        return self._step((id(node), part), Step(StepKind.UNKNOWN, part, node, place=place))

    def stranger(self, node: Node) -> Step:
        """A node whose source is not here."""
        name = node.name or f"{node.package or '?'}/{node.executable or '?'}"
        return self._step((id(node), "stranger"), Step(StepKind.STRANGER, name, node, place=node.launch_place))

    def frame(self, topic: str, name: str) -> Step:
        """A coordinate frame, as the messages of a topic have it."""
        reason = "which frames it is about is not known" if name == NOT_KNOWN else ""
        return self._step((StepKind.FRAME, topic, name), Step(StepKind.FRAME, name, topic=topic, reason=reason))

    def has_frame(self, topic: str, name: str) -> bool:
        """Whether there is such a step."""
        return (StepKind.FRAME, topic, name) in self._steps

    def kept(self, node: Node, names: Sequence[str]) -> Step:
        """Attributes of one object, or global variables, that the same callbacks set and read."""
        self._kept += 1
        return self._step(("kept", self._kept), Step(StepKind.KEPT, ", ".join(names), node))

    def _step(self, key: object, step: Step) -> Step:
        return self._steps.setdefault(key, step)

    # -------------------------------------------------------------------------------------------- links

    @property
    def links(self) -> Sequence[Link]:
        """The links found so far."""
        return list(self._links.values())

    def link(
        self,
        tail: Step,
        head: Step,
        how: How,
        place: Place | None = None,
        doubt: str = "",
        conditional: bool = False,
        broken: str = "",
    ) -> None:
        """Note a link; of several between two steps the surest one counts."""
        key = (id(tail), id(head), how)
        link = Link(tail, head, how, place, doubt, conditional, broken)
        known = self._links.get(key)
        if known is None or _weight(link) < _weight(known):
            self._links[key] = link

    def undelivered(self, end: Endpoint) -> str:
        """Why no message of any publisher of its topic arrives at a subscription; empty where one may."""
        topic: Connection | None = self.system.topics.get(end.name or "")
        if topic is None or end.kind != EntityKind.SUBSCRIBER or not topic.providers:
            return ""
        reasons = [self._broken.get((id(offer), id(end)), "") for offer in topic.providers]
        return reasons[0] if all(reasons) else ""


def _weight(link: Link) -> tuple[bool, bool, bool]:
    return bool(link.broken), bool(link.doubt), link.conditional


__all__ = ["IDLE", "Builder"]
