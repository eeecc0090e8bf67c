"""The graph of data of a system: made once, in time that grows with its endpoints, callbacks and calls."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.transforms import LOOK_UP, TRANSFORMS
from archlint.dataflow.answers import answers_of
from archlint.dataflow.builder import Builder
from archlint.dataflow.idle_ends import is_idle
from archlint.dataflow.model import Flow, How, Step, StepKind
from archlint.dataflow.runs import PUBLISH, REQUESTS, SEND_TRANSFORMS, WAIT_FOR_MESSAGE, Run
from archlint.dataflow.transforms import is_taken_by, link_transforms
from archlint.dataflow.variables import link_variables
from archlint.execution.loop_paces import is_decided
from archlint.model import EntityKind, Role
from archlint.systems.externals import connections_of_externals, may_use

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

FRAMES = "which frames it is about is not known"
_NO_CALL = {
    EntityKind.PUBLISHER: "where it is published is not known",
    EntityKind.CLIENT: "where it is called is not known",
    EntityKind.ACTION_CLIENT: "where the goal is sent is not known",
}
_UNCALLED = "nothing here calls this method"
_NEVER = {
    EntityKind.PUBLISHER: "nothing is seen to be published",
    EntityKind.CLIENT: "no call of it is seen",
    EntityKind.ACTION_CLIENT: "no goal is seen to be sent",
}
_BUFFER_CLIENT = "tf2_ros.buffer_client.BufferClient"
"""It sends goals by itself."""
_NO_CALLBACK = "what the node does with it is not known"


@once
def flow_of(system: System) -> Flow:
    """How data goes through a system."""
    builder = Builder(system)
    for run in builder.runs:
        builder.step_of(run)
    for node in system.entries:
        for end in node.endpoints:
            if not end.creation.destroyed:
                _arrivals(builder, node, end)
        for run in builder.runs_on(node):
            _sends(builder, run)
    answers_of(builder)
    for node in system.entries:
        _senders_not_known(builder, node)
    link_variables(builder)
    _strangers(builder)
    link_transforms(builder)
    return builder.flow()


# ---------------------------------------------------------------------------------------------- what arrives


def _arrivals(builder: Builder, node: Node, end: Endpoint) -> None:
    """From a topic, a service or an action to the callbacks of one end of it."""
    if end.kind not in (EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.ACTION_SERVER):
        return
    source = builder.connection(end)
    broken = builder.undelivered(end)
    takers, doubt = _takers(builder, node, end)
    for taker in takers:
        builder.link(source, taker, How.ARRIVE, end.place, doubt, end.conditional, broken)
    if end.kind == EntityKind.SUBSCRIBER:
        return
    for taker in takers:
        if taker.callback is None or taker.callback.role in (Role.SERVICE, Role.EXECUTE):
            builder.link(taker, builder.answer(end), How.SEND, end.place, doubt)


def _takers(builder: Builder, node: Node, end: Endpoint) -> tuple[Sequence[Step], str]:
    """What gets what arrives at an end, and why that is in doubt."""
    creation = end.creation
    if creation.api.startswith(TRANSFORMS):
        readers = [run for run in builder.runs_on(node) if any(call.api.startswith(LOOK_UP) for call in run.calls)]
        steps = [builder.step_of(run) for run in readers if is_taken_by(run)]
        return (steps, FRAMES) if readers else ([builder.taker(node)], "where transforms are looked up is not known")
    if creation.api == WAIT_FOR_MESSAGE:
        waiting = builder.runs.of(node, creation.context)
        return ([builder.step_of(waiting)], "") if waiting is not None else ([builder.taker(node)], _NO_CALLBACK)
    if creation.api.startswith("message_filters."):
        filters = [run for run in builder.runs_on(node) if run.callback.role == Role.FILTER]
        doubt = "" if len(filters) == 1 else "which of the node's message filters gets it is not known"
        return ([builder.step_of(run) for run in filters], doubt) if filters else ([builder.taker(node)], _NO_CALLBACK)
    runs = [builder.runs.of(node, callback) for callback in creation.callbacks.values() if callback.function]
    steps = [builder.step_of(run) for run in runs if run is not None]
    return (steps, "") if steps else ([builder.taker(node)], _NO_CALLBACK)


# ---------------------------------------------------------------------------------------------- what is sent


def _sends(builder: Builder, run: Run) -> None:
    for call in run.calls:
        if call.api == PUBLISH or call.api in REQUESTS or call.api in SEND_TRANSFORMS:
            _send(builder, run, call)


def _send(builder: Builder, run: Run, call: ApiCall) -> None:
    """From a callback to what it publishes, calls or sends a goal to."""
    creations = () if call.receiver is None else call.receiver.creations
    doubt = "" if len(creations) == 1 else "which of several it is, is not known"
    broken = ""
    if run.callback.role == Role.METHOD:
        doubt, broken = ("", _UNCALLED) if _is_whole(run.node) else (_UNCALLED, "")
    for creation in creations:
        for end in builder.ends(creation, run.node):
            builder.sent.add(id(end))
            builder.link(
                builder.step_of(run), builder.connection(end), How.SEND, call.place, doubt, is_decided(call), broken
            )


def _is_whole(node: Node) -> bool:
    """Whether all code that may do something with a node is seen."""
    return all(blueprint.complete and not blueprint.escapes for blueprint in node.blueprints)


def _senders_not_known(builder: Builder, node: Node) -> None:
    """What a node may send although no call is seen that does it."""
    for end in node.endpoints:
        words = _NO_CALL.get(end.kind)
        if words is None or id(end) in builder.sent or end.creation.destroyed:
            continue
        if is_idle(builder.system, end) and end.creation.api != _BUFFER_CLIENT:
            idle = builder.idle(node)
            builder.link(idle, builder.connection(end), How.SEND, end.place, broken=_NEVER[end.kind])
        else:
            builder.link(builder.sender(node), builder.connection(end), How.SEND, end.place, words)


# ----------------------------------------------------------------------------------------------- strangers


def _strangers(builder: Builder) -> None:
    """Nodes whose source is not here, at the names that a launch file gives them."""
    system = builder.system
    named = dict.fromkeys((id(node), name) for node, name in connections_of_externals(system))
    externals = {id(node): node for node in system.nodes if node.is_stranger}
    for connection in (*system.topics.values(), *system.services.values(), *system.actions.values()):
        one_sided = not connection.providers or not connection.users
        for node in externals.values():
            if any(end.node is node for end in (*connection.providers, *connection.users)):
                continue  # which end of it the node is, is known
            is_named = (id(node), connection.name) in named
            if is_named or (one_sided and may_use(node, connection.name)):
                words = "a launch file gives it this name" if is_named else "the name is among its parameters"
                _stranger(builder, builder.stranger(node), connection, f"its source is not here; {words}")


def _stranger(builder: Builder, stranger: Step, connection: Connection, doubt: str) -> None:
    ends: Iterable[Endpoint] = (*connection.providers, *connection.users)
    step = builder.connection(next(iter(ends)))
    builder.link(step, stranger, How.MAY, stranger.place, doubt)
    builder.link(stranger, step, How.MAY, stranger.place, doubt)
    if step.kind in (StepKind.SERVICE, StepKind.ACTION):
        builder.link(stranger, builder.answer(next(iter(ends))), How.MAY, stranger.place, doubt)


__all__ = ["FRAMES", "flow_of"]
