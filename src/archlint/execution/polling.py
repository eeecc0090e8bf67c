"""Requests that are sent again and again: whether anything but the readiness of the service decides about each."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.model.given import Message
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of, loop_of
from archlint.syntax.flow_blocks import Block
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall

_READY = frozenset({"service_is_ready", "wait_for_service", "done", "ok"})
_PAUSES = frozenset(
    {"sleep", "sleep_for", "sleep_until", "wait", "spin", "spin_once", "input", "join", "get", "recv"}
    | {"read", "readline"}
)
"""Calls that slow a loop down, or make it wait for an event."""


def goes_on(loop: Loop | None) -> bool:
    """Whether a loop goes on for as long as the program runs."""
    if not isinstance(loop, facts.While) or loop_of(loop).is_left_early:
        return False
    asked = list(calls_in(loop.test))
    return loop.is_endless or (bool(asked) and all(called_name(call) in _READY for call in asked))


def is_unpaced(loop: Loop | None) -> bool:
    """Whether a loop goes on forever and nothing in it waits but the request."""
    return goes_on(loop) and loop is not None and all(called_name(call) not in _PAUSES for call in calls_in(loop.body))


def is_unguarded(code: SourceCode, call: ApiCall) -> bool:
    """Whether nothing but the readiness of the service decides whether the request is sent."""
    loop = code.loop(call)
    body = code.body(call) if loop is None else loop.body
    if call.chain[1:] or is_decided(body, call.place) is not False:
        return False
    function = code.definition(call.context)
    if not call.chain or function is None:
        return True
    # What runs calls the function that asks: an occasion may be needed for that, too.
    return is_decided(function.body, call.chain[0].place) is not True


def is_decided(body: Sequence[facts.Stmt], place: Place) -> bool | None:
    """Whether anything but the readiness of a service decides that a body comes to a call; None: it is not there."""
    graph = graph_of(body)
    blocks = graph.evaluating(place.span)
    if not blocks:
        return None
    if graph.without_exceptions.isdisjoint(blocks):
        return True  # only an exception leads there
    loops = {loop for block in blocks for loop in block.loops}
    sure = {loop.head for loop in loops if _runs_for_sure(loop.statement)}
    heads = {loop.head for loop in loops} - set(blocks)
    return any(block in heads or not _is_readiness(block) for block in graph.deciders(blocks) if block not in sure)


def _runs_for_sure(loop: Loop) -> bool:
    """``for name in ('left', 'right')``."""
    return isinstance(loop, facts.For) and isinstance(loop.head, facts.Sequence) and bool(loop.head.elements)


def _is_readiness(block: Block) -> bool:
    """Whether a block asks for nothing but readiness."""
    return any(edge.test is not None and _about_readiness(edge.test) for edge in block.edges)


def _about_readiness(test: facts.Expr) -> bool:
    """``if not self.client.service_is_ready()``, ``if self.future is None or self.future.done()``."""
    match test:
        case facts.Unary():
            return _about_readiness(test.operand)
        case facts.Boolean():
            return all(_about_readiness(value) for value in test.values)
        case facts.Compare():
            return _names_a_future(test.left)
        case facts.Call():
            return called_name(test) in _READY
    return _names_a_future(test)


def _names_a_future(test: facts.Expr) -> bool:
    return "future" in test.last_name.lower()


def notes_that_it_ran(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback sets a flag that outlives it: it may be asked before the next request, here or elsewhere."""
    body = code.body(call)
    shared = {name for statement in statements_of(body, facts.Global) for name in statement.names}
    return any(
        _is_flag(statement.value) and any(_outlives(target, shared) for target in statement.targets)
        for statement in statements_of(body, facts.Assign)
    )


def _outlives(target: facts.Expr, shared: Collection[str]) -> bool:
    """Whether what is assigned is there when the callback has ended; ``data`` is a message's field."""
    if target.variable:
        return target.variable in shared
    return target.attribute != "data"


def _is_flag(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and isinstance(value.value, bool)


def sends_the_same(code: SourceCode, call: ApiCall) -> bool:
    """Whether the request carries nothing but constants."""
    arguments, request = code.arguments(call), argument(call, "request")
    if isinstance(request, Message) and request.content is not None:
        return request.content == "constants"
    if not isinstance(request, Message) or not arguments:
        return False  # and where its definition is not known: whether it is made here
    given = arguments[0].value
    name, body = given.variable, code.body(call)
    if not name:
        return _is_constant_request(given)
    assigned = [
        assignment.value
        for assignment in statements_of(body, facts.Assign)
        if name in (to.variable for to in assignment.targets)
    ]
    filled = [
        *(assignment.value for assignment in statements_of(body, facts.Assign) if _fills(assignment, name)),
        *(assignment.value for assignment in statements_of(body, facts.Augmented) if _fills(assignment, name)),
    ]
    return len(assigned) == 1 and _is_constant_request(assigned[0]) and all(value.truth is not None for value in filled)


def _fills(statement: facts.Stmt, name: str) -> bool:
    """Whether a statement sets something of what a variable holds."""
    return any(target.root.variable == name and not target.variable for target in statement.assigned)


def _is_constant_request(value: facts.Expr) -> bool:
    if not isinstance(value, facts.Call) or called_name(value) != "Request":
        return False
    return all(given.value.truth is not None for given in value.args)


__all__ = ["goes_on", "is_decided", "is_unguarded", "is_unpaced", "notes_that_it_ran", "sends_the_same"]
