"""SRV004: services asked again and again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import callback_words, related_to, runs_in_executor
from archlint.analysis.reach import (
    argument,
    calls_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
)
from archlint.analysis.source_code import Loop, SourceCode, source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.model import Role
from archlint.model.given import Message
from archlint.syntax import facts
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_REQUESTS = ("rclpy.client.Client.call", "rclpy.client.Client.call_async")
_ENDS_TIMER = ("rclpy.timer.Timer.cancel", "rclpy.node.Node.destroy_timer")
_READY = frozenset({"service_is_ready", "wait_for_service", "done", "ok"})
_PAUSES = frozenset(
    {
        "sleep",
        "wait",
        "spin",
        "input",
        "join",
        "get",
        "recv",
        "read",
        "readline",
        "spin_once",
        "sleep_for",
        "sleep_until",
    }
)
"""Calls that slow a loop down, or make it wait for an event."""


# --------------------------------------------------------------------------------------------------- SRV004


@rule("SRV004", scope=Scope.AS_LAUNCHED, rate=1.0)
def service_for_continuous_data(system: System, options: Options) -> Iterator[Finding]:
    """Requests that are sent again and again without an occasion."""
    code = source_code(system)
    stopped = {call.context.place for _, call in calls_of(system, _ENDS_TIMER)}
    yield from one_for_each_place(
        _polled(system, program, call, how)
        for program, call in calls_of(system, _REQUESTS)
        if call.creation is not None and call.context.place not in stopped and _always_the_same(code, call)
        if _takes_data(program, call.creation)
        for how in [_how_often(code, call, options.number("rate"))]
        if how is not None
    )


def _takes_data(program: Program, client: Creation) -> bool:
    """Whether the program reads what a service answers; whether it worked is no data, but what a command answers."""
    return client.type is None or any(
        use.type == client.type and use.section_name == "Response" and use.access == "read" and use.name != "success"
        for use in program.field_uses
    )


def _how_often(code: SourceCode, call: ApiCall, rate: float) -> str | None:
    """How often a request is sent, in words; None where that is seldom, or has an occasion."""
    callback = call.context
    if callback.role == Role.TIMER and not call.looped:
        period = callback.creation.period if callback.creation is not None else None
        if (
            period is None
            or period <= 0
            or period * rate > 1
            or not unguarded(code, call)
            or notes_that_it_ran(code, call)
        ):
            return None
        return f"{1 / period:g} times a second" if period < 1 else "once a second"
    if callback.role in (Role.MAIN, Role.THREAD) and _unpaced(code.loop(call)) and unguarded(code, call):
        return "in every iteration of the loop"
    return None


def _unpaced(loop: Loop | None) -> bool:
    """Whether a loop goes on for ever and nothing in it waits but the request."""
    if not isinstance(loop, facts.While):
        return False
    endless = loop.test.truth is True or (
        all(called_name(c) in _READY for c in calls_in(loop.test)) and any(calls_in(loop.test))
    )
    leaves = any(
        isinstance(s, (facts.Return, facts.Raise)) or (isinstance(s, facts.Jump) and s.kind == "break")
        for s in statements_of(loop.body)
    )
    return endless and not leaves and all(called_name(call) not in _PAUSES for call in calls_in(loop.body))


def unguarded(code: SourceCode, call: ApiCall) -> bool:
    """Whether nothing but the readiness of the service decides whether the request is sent."""
    loop = code.loop(call)
    body = code.body(call) if loop is None else loop.body
    if call.chain[1:] or _reached(body, (call.place.line, call.place.column)) is not True:
        return False
    function = code.function(call.context)
    if not call.chain or not isinstance(function, facts.Function):
        return True
    # What runs calls the function that asks: an occasion may be needed for that, too.
    place = call.chain[0].place
    return _reached(function.body, (place.line, place.column)) is not False


def _reached(block: Sequence[facts.Stmt], wanted: tuple[int, int]) -> bool | None:
    """True where a block always comes to a call, False where something else decides; None: it is not there."""
    for statement in block:
        here = any(one.span[:2] == wanted for one in calls_in(statement))
        inner = statement.blocks
        if here and not inner:
            return True
        if here:
            if isinstance(statement, facts.If) and not _about_readiness(statement.test):
                return any(one.span[:2] == wanted for one in calls_in(statement.test))
            if isinstance(statement, facts.While):
                return any(one.span[:2] == wanted for one in calls_in(statement.test))  # asked once, at least
            if isinstance(statement, (facts.For, facts.Match)):
                return False
            found = [_reached(one, wanted) for one in inner]
            return next((one for one in found if one is not None), True)
        if isinstance(statement, facts.If) and not _about_readiness(statement.test) and _leaves(statement):
            return False
    return None


def _leaves(statement: facts.If) -> bool:
    inside = [*statements_of(statement.body), *statements_of(statement.orelse)]
    return any(
        isinstance(s, (facts.Return, facts.Raise, facts.Jump)) for s in inside if getattr(s, "kind", "") != "pass"
    )


def _about_readiness(test: facts.Expr) -> bool:
    """``if not self.client.service_is_ready()``, ``if self.future is None or self.future.done()``."""
    if isinstance(test, facts.Unary):
        return _about_readiness(test.operand)
    if isinstance(test, facts.Boolean):
        return all(_about_readiness(value) for value in test.values)
    if isinstance(test, facts.Compare):
        return _names_a_future(test.left)
    if isinstance(test, facts.Call):
        return called_name(test) in _READY
    return _names_a_future(test)


def _names_a_future(test: facts.Expr) -> bool:
    name = test.attr if isinstance(test, facts.Attribute) else test.id if isinstance(test, facts.Name) else ""
    return "future" in name.lower()


def notes_that_it_ran(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback sets a flag: it may be asked before the next request, here or elsewhere."""
    return any(
        isinstance(s, facts.Assign)
        and isinstance(s.value, facts.Literal)
        and isinstance(s.value.value, bool)
        and not all(isinstance(target, facts.Attribute) and target.attr == "data" for target in s.targets)
        for s in statements_of(code.body(call))
    )


def _always_the_same(code: SourceCode, call: ApiCall) -> bool:
    """Whether the request is made here and carries nothing but constants."""
    request = argument(call, "request")
    arguments = code.arguments(call)
    if not isinstance(request, Message) or not arguments:
        return False
    given = arguments[0].value
    if isinstance(given, facts.Name):
        name = given.id
        made = [
            s.value
            for s in statements_of(code.body(call))
            if isinstance(s, facts.Assign) and any(isinstance(t, facts.Name) and t.id == name for t in s.targets)
        ]
        filled = [
            s.value
            for s in statements_of(code.body(call))
            if isinstance(s, (facts.Assign, facts.Augmented))
            and any(_belongs_to(target, name) for target in (s.targets if isinstance(s, facts.Assign) else [s.target]))
        ]
        return len(made) == 1 and _constant_request(made[0]) and all(isinstance(v, facts.Literal) for v in filled)
    return _constant_request(given)


def _belongs_to(target: facts.Expr, name: str) -> bool:
    while isinstance(target, (facts.Attribute, facts.Subscript)):
        target = target.value
        if isinstance(target, facts.Name) and target.id == name:
            return True
    return False


def _constant_request(value: facts.Expr) -> bool:
    return (
        isinstance(value, facts.Call)
        and called_name(value) == "Request"
        and all(isinstance(given.value, facts.Literal) for given in value.args)
    )


def _polled(system: System, program: Program, call: ApiCall, how: str) -> Finding:
    callback = call.context
    who = callback_words(callback) if runs_in_executor(callback) else f"{callback.name}()"
    assert call.creation is not None
    return finding(
        "SRV004",
        call.place,
        f"{who} sends {endpoint_words(call.creation)} the same request {how}: use a topic for this data",
        help="let the server publish the data, and subscribe to it",
        related=tuple(
            related_to(call, program, call.creation)
            if runs_in_executor(callback)
            else [*related_chain(call), *related_creation(call.creation)]
        ),
        node=node_name(system, call.node),
        identity=(callback.name, call.creation.name.text or ""),
    )
