"""Sleeps of a callback that are short in all and over before anything of its node is due again, or the last that it
does."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import paths_to
from archlint.analysis.reach import judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.kept_waiting import waits_besides
from archlint.execution.long_stays import long_stays, period_of
from archlint.execution.longest_way import longest_way
from archlint.execution.loop_times import in_loops
from archlint.execution.paces import pace_of
from archlint.execution.sleeps import Stay, stay_of
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import reach, without_exceptions

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, Callback, Creation, Program
    from archlint.systems.model import System

_SHORT = 0.5
"""Seconds that a callback may sleep in one run: messages wait that long in their queue, and nobody notices."""
_SHORT_OF_AN_ANSWER = 1.0
"""Seconds from which on more threads are worth it for a callback that somebody waits for the return value of."""


def is_soon_over(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a callback does nothing that takes long but sleeps, for a short time in all that is known, and whether
    no timer or regular message of the node comes more often than that."""
    if id(call.context) in _other_long_stays(system):
        return False
    seconds = _slept(system)[id(call.context)]
    of_an_answer = call.context.role == Role.EXECUTE
    if seconds >= _SHORT_OF_AN_ANSWER if of_an_answer else seconds > _SHORT:
        return False
    own = [period_of(system, call), *_paces(system, [call.context])]
    periods = [*own, *_periods_besides(system, program, call)]
    return all(period is None or period >= seconds for period in periods)


def _periods_besides(system: System, program: Program, call: ApiCall) -> Iterator[float | None]:
    for creation in waits_besides(source_code(system), call, program):
        if creation is not None:
            yield creation.period
            yield from _paces(system, _handlers(call, creation))


def _handlers(call: ApiCall, creation: Creation) -> list[Callback]:
    node = call.context.node
    return [] if node is None else [callback for callback in node.callbacks if callback.creation is creation]


def _paces(system: System, callbacks: list[Callback]) -> Iterator[float | None]:
    for callback in callbacks:
        pace = pace_of(system, callback)
        yield None if pace is None else pace.period


@once
def _other_long_stays(system: System) -> frozenset[int]:
    """The callbacks (``id``) that stay long in something else than a sleep."""
    return frozenset(id(call.context) for _, call, stay in long_stays(system) if stay.kind != "sleep")


@once
def _slept(system: System) -> dict[int, float]:
    """How many seconds each callback (``id``) sleeps in one run at most."""
    code = source_code(system)
    sleeps: dict[int, dict[tuple[Place, ...], float]] = {}
    for _, call in judged_calls(system):
        stay = stay_of(code, call)
        if stay is not None and stay.kind == "sleep":
            seconds = _seconds(code, call, stay)
            sleeps.setdefault(id(call.context), {}).update(dict.fromkeys(map(tuple, paths_to(call)), seconds))
    return {callback: longest_way(code, [*ways.items()]) for callback, ways in sleeps.items()}


def comes_last(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback does nothing after a call, whatever way led there: no timer has anything to go on with."""
    return all(_is_last(code, place) for path in paths_to(call) for place in path)


def _is_last(code: SourceCode, place: Place) -> bool:
    graph = graph_of(code.body_at(place))
    blocks = graph.evaluating(place.span)
    edges = [edge for block in blocks for edge in block.edges if without_exceptions(edge)]
    after = reach([edge.target for edge in edges], without_exceptions)
    return bool(blocks) and all(isinstance(block.fact, facts.Return) or block.fact is None for block in after)


def _seconds(code: SourceCode, call: ApiCall, stay: Stay) -> float:
    return math.inf if stay.seconds is None else in_loops(code, call, stay, with_callers=True)


__all__ = ["comes_last", "is_soon_over"]
