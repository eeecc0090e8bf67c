"""SRV004: services asked again and again."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import callback_words, related_to, runs_in_executor
from archlint.analysis.own_timers import ENDS_TIMER
from archlint.analysis.polling import is_unguarded, is_unpaced, notes_that_it_ran, sends_the_same
from archlint.analysis.reach import (
    calls_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
)
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_REQUESTS = ("rclpy.client.Client.call", "rclpy.client.Client.call_async")

# --------------------------------------------------------------------------------------------------- SRV004


@rule("SRV004", scope=Scope.AS_LAUNCHED, rate=1.0)
def service_for_continuous_data(system: System, options: Options) -> Iterator[Finding]:
    """Requests that are sent again and again without an occasion."""
    code = source_code(system)
    stopped = {call.context.place for _, call in calls_of(system, ENDS_TIMER)}
    yield from one_for_each_place(
        _polled(system, program, call, how)
        for program, call in calls_of(system, _REQUESTS)
        if call.creation is not None and call.context.place not in stopped and sends_the_same(code, call)
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
            or not is_unguarded(code, call)
            or notes_that_it_ran(code, call)
        ):
            return None
        return f"{1 / period:g} times a second" if period < 1 else "once a second"
    if callback.role in (Role.MAIN, Role.THREAD) and is_unpaced(code.loop(call)) and is_unguarded(code, call):
        return "in every iteration of the loop"
    return None


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
