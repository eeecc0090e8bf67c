"""Transforms that code looks up in a buffer which it has just created: before anything can have arrived."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import argument, calls_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.straight_after import LOGS, follows_at_once
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import called_name, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_PASTIMES = LOGS | {
    *("Buffer", "TransformListener", "Time", "Duration", "now", "get_clock", "to_msg", "from_msg"),
    *("lookup_transform", "can_transform"),
}
"""Calls that let no time pass."""


@dataclass(frozen=True)
class EarlyLookup:
    """A lookup in a buffer that cannot hold anything yet."""

    call: ApiCall
    buffer: Place
    program: Program


@once
def early_lookups(system: System) -> list[EarlyLookup]:
    """The lookups without a timeout in a buffer that the same run of a function has just created."""
    lookups, code = [], source_code(system)
    for program, call in calls_of(system, _LOOKUPS):
        asks = argument(call, "source_frame") is not None and argument(call, "timeout") is None
        buffer = _made_just_before(code, call) if asks else None
        if buffer is not None:
            lookups.append(EarlyLookup(call, buffer, program))
    return lookups


def _made_just_before(code: SourceCode, call: ApiCall) -> Place | None:
    """Where the buffer is created that a lookup asks, if nothing can have reached it since."""
    lookup = code.expression(call)
    name = lookup.func.value.dotted if lookup is not None and isinstance(lookup.func, facts.Attribute) else ""
    if lookup is None or not name:
        return None
    body = code.body(call)
    graph = graph_of(body)
    if not follows_at_once(graph, graph.evaluating(lookup.span), name, _is_new, _PASTIMES):
        return None
    created = [
        statement.value
        for statement in statements_of(body, facts.Assign)
        if _is_new(statement.value) and any(target.dotted == name for target in statement.targets)
    ]
    return Place.of(call.place.file, getattr(created[0], "span", lookup.span)) if len(created) == 1 else None


def _is_new(value: facts.Expr) -> bool:
    return isinstance(value, facts.Call) and called_name(value) == "Buffer"


__all__ = ["EarlyLookup", "early_lookups"]
