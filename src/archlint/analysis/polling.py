"""Requests that are sent again and again: whether anything but the readiness of the service decides about each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.model.given import Message
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.model import ApiCall

_READY = frozenset({"service_is_ready", "wait_for_service", "done", "ok"})
_PAUSES = frozenset(
    {"sleep", "sleep_for", "sleep_until", "wait", "spin", "spin_once", "input", "join", "get", "recv"}
    | {"read", "readline"}
)
"""Calls that slow a loop down, or make it wait for an event."""


def is_unpaced(loop: Loop | None) -> bool:
    """Whether a loop goes on for ever and nothing in it waits but the request."""
    if not isinstance(loop, facts.While) or loop_of(loop).is_left_early:
        return False
    endless = loop.is_endless or (
        all(called_name(c) in _READY for c in calls_in(loop.test)) and any(calls_in(loop.test))
    )
    return endless and all(called_name(call) not in _PAUSES for call in calls_in(loop.body))


def is_unguarded(code: SourceCode, call: ApiCall) -> bool:
    """Whether nothing but the readiness of the service decides whether the request is sent."""
    loop = code.loop(call)
    body = code.body(call) if loop is None else loop.body
    if call.chain[1:] or _always_comes_to(body, (call.place.line, call.place.column)) is not True:
        return False
    function = code.definition(call.context)
    if not call.chain or function is None:
        return True
    # What runs calls the function that asks: an occasion may be needed for that, too.
    place = call.chain[0].place
    return _always_comes_to(function.body, (place.line, place.column)) is not False


def _always_comes_to(block: Sequence[facts.Stmt], wanted: tuple[int, int]) -> bool | None:
    """True where a block always comes to a call, False where something else decides; None: it is not there.

    An ``if`` on the way that leaves anything, be it only a loop inside it, is something that decides."""
    for statement in block:
        if _calls(statement, wanted):
            return _always_comes_inside(statement, wanted)
        if isinstance(statement, facts.If) and not _about_readiness(statement.test) and _may_jump(statement):
            return False
    return None


def _always_comes_inside(statement: facts.Stmt, wanted: tuple[int, int]) -> bool:
    match statement:
        case facts.If(test=test) if not _about_readiness(test):
            return _calls(test, wanted)
        case facts.While(test=test):
            return _calls(test, wanted)  # asked once, at least
        case facts.For() | facts.Match():
            return False
    found = [_always_comes_to(block, wanted) for block in statement.blocks]
    return next((one for one in found if one is not None), True)


def _calls(fact: facts.Base, wanted: tuple[int, int]) -> bool:
    return any(one.span[:2] == wanted for one in calls_in(fact))


def _may_jump(statement: facts.If) -> bool:
    return any(inner.jumps for inner in statements_of([statement]))


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
    """Whether a callback sets a flag: it may be asked before the next request, here or elsewhere."""
    return any(
        _is_flag(statement.value) and not all(target.attribute == "data" for target in statement.targets)
        for statement in statements_of(code.body(call), facts.Assign)
    )


def _is_flag(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and isinstance(value.value, bool)


def sends_the_same(code: SourceCode, call: ApiCall) -> bool:
    """Whether the request is made here and carries nothing but constants."""
    arguments = code.arguments(call)
    if not isinstance(argument(call, "request"), Message) or not arguments:
        return False
    given = arguments[0].value
    name, body = given.variable, code.body(call)
    if not name:
        return _is_constant_request(given)
    made = [one.value for one in statements_of(body, facts.Assign) if name in (to.variable for to in one.targets)]
    filled = [
        *(one.value for one in statements_of(body, facts.Assign) if _fills(one, name)),
        *(one.value for one in statements_of(body, facts.Augmented) if _fills(one, name)),
    ]
    return len(made) == 1 and _is_constant_request(made[0]) and all(value.truth is not None for value in filled)


def _fills(statement: facts.Stmt, name: str) -> bool:
    """Whether a statement sets something of what a variable holds."""
    return any(target.root.variable == name and not target.variable for target in statement.assigned)


def _is_constant_request(value: facts.Expr) -> bool:
    if not isinstance(value, facts.Call) or called_name(value) != "Request":
        return False
    return all(given.value.truth is not None for given in value.args)


__all__ = ["is_unguarded", "is_unpaced", "notes_that_it_ran", "sends_the_same"]
