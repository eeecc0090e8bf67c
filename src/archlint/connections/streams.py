"""Publishers that send again and again, whatever happens, beside those that send on an occasion."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.arbitration import WORDS, publishes_of
from archlint.model import EntityKind, Role
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.walk import called_name, calls_in, is_none

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, Frame
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_WITH_DATA = frozenset({Role.SUBSCRIPTION, Role.FILTER, Role.FEEDBACK})


def sends_again_and_again(system: System, owner: Endpoint) -> bool:
    """Whether a publisher is not only used on an occasion, such as a request, a key or a condition: a timer, each
    message or a loop publishes.  So it is where nothing says how it publishes."""
    calls = publishes_of(system, owner)
    places = frozenset(call.place for call in calls)
    if not calls:
        return _is_handed_on(system, owner)
    return any(_is_again_and_again(system, call, places) for call in calls)


def is_at_it_all_the_time(system: System, owner: Endpoint) -> bool:
    """Whether a timer, each message of data or a loop may publish, on a condition or not: no request or word makes it
    do so.  So it is where nothing says how it publishes."""
    calls = publishes_of(system, owner)
    if not calls:
        return _is_handed_on(system, owner)
    return any(
        call.looped
        or call.context.role in (Role.TIMER, Role.METHOD)
        or (call.context.role in _WITH_DATA and not _gets_words(system, call))
        for call in calls
    )


def _is_handed_on(system: System, owner: Endpoint) -> bool:
    """Whether the file that makes a publisher does not publish, but others do.  Where it does, and the run of the node
    does not come to that, it happens on an occasion such as a request of a web server."""
    return system.workspace is None or not system.workspace.code.mentions(owner.place.file, "publish")


def waits_for_nobody(system: System, owner: Endpoint) -> bool:
    """Whether a publisher is used only where a message arrives that nobody in a launched system sends: as started
    there, it says nothing."""
    if system.launched is None or system.launched.gaps or any(node.is_stranger for node in system.nodes):
        return False
    calls = publishes_of(system, owner)
    return bool(calls) and all(_waits_in_vain(system, owner, call) for call in calls)


def _waits_in_vain(system: System, owner: Endpoint, call: ApiCall) -> bool:
    topics = [end.name for end in _heard(system, call) if end.node is owner.node]
    connections = [system.topics.get(name) for name in topics if name is not None]
    return bool(topics) and None not in topics and not any(row is None or row.providers for row in connections)


def _gets_words(system: System, call: ApiCall) -> bool:
    """Whether the callback that publishes is that of a text, a switch, a number or a goal: each has an occasion."""
    return any(end.type in WORDS or _is_goal(end.name) for end in _heard(system, call))


_GOALS = frozenset({"goal", "goals", "request", "requests"})


def _is_goal(topic: str | None) -> bool:
    """Whether a topic's name says that each message asks for something new."""
    return topic is not None and not _GOALS.isdisjoint(topic.rpartition("/")[2].lower().split("_"))


def _heard(system: System, call: ApiCall) -> list[Endpoint]:
    """The subscriptions whose callback makes a call."""
    return _subscriptions(system).get(call.context.place, []) if call.context.role is Role.SUBSCRIPTION else []


@once
def _subscriptions(system: System) -> dict[Place, list[Endpoint]]:
    """The subscriptions of a system, by the place of their callback."""
    by_callback: dict[Place, list[Endpoint]] = {}
    for node in system.nodes:
        for end in node.of_kind(EntityKind.SUBSCRIBER):
            for callback in end.creation.callbacks.values():
                by_callback.setdefault(callback.place, []).append(end)
    return by_callback


def _is_again_and_again(system: System, call: ApiCall, places: Collection[Place]) -> bool:
    code = source_code(system)
    role = call.context.role
    if role is Role.METHOD:
        return False  # who calls it, and when, is not seen
    if role is not Role.TIMER and (role not in _WITH_DATA or _gets_words(system, call)):
        return call.looped and not call.conditional
    # A lambda has no statements, and of C++ only what the call itself says is known.
    body, here = code.body(call), [place.span for place in places if place.file == call.place.file]
    return (_comes_to(body, here) if body else not call.conditional) and all(
        _goes_on(code, frame) for frame in call.chain
    )


def _goes_on(code: SourceCode, frame: Frame) -> bool:
    """Whether a caller comes to a call of the function that a frame leads to, here or elsewhere in it."""
    body, name = code.body_at(frame.place), frame.callee.rpartition(".")[2]
    return not body or _comes_to(body, [call.span for call in calls_in(body) if called_name(call) == name])


def _comes_to(body: Sequence[facts.Stmt], spans: Collection[facts.Span]) -> bool:
    """Whether a body comes to one of some calls, unless it has nothing to go on with and is left before: no branch
    without such a call is taken instead."""
    return any(
        bool(inside := [span for span in spans if covers(statement, span)]) and _leads_to(statement, inside)
        for statement in body
    )


def _leads_to(statement: facts.Stmt, spans: Collection[facts.Span]) -> bool:
    """Whether a statement that holds some calls comes to one of them, whatever it asks."""
    if isinstance(statement, facts.If):
        other = _comes_to(statement.orelse, spans) if statement.orelse else _asks_for_data(statement.test)
        return other and _comes_to(statement.body, spans)
    if isinstance(statement, facts.Match):
        return all(_comes_to(block, spans) for block in statement.blocks)
    blocks: Sequence[Sequence[facts.Stmt]] = getattr(statement, "blocks", ())
    return not blocks or any(_comes_to(block, spans) for block in blocks)


def _asks_for_data(test: facts.Expr) -> bool:
    """``self.scan is not None``."""
    match test:
        case facts.Compare(ops=["is not"] | ["!="], comparators=[other]):
            return is_none(other)
    return False


__all__ = ["is_at_it_all_the_time", "sends_again_and_again", "waits_for_nobody"]
