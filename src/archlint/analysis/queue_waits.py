"""Waits for a queue or an event of a node that only callbacks fill or set which cannot run meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.annotations import imported_as
from archlint.analysis.attribute_changes import changing_callbacks, is_used_otherwise
from archlint.analysis.kept import once
from archlint.analysis.own_names import assigned_values
from archlint.analysis.source_code import source_code
from archlint.analysis.waiting_functions import EndlessWait, Waiting, classes_of, waiting_functions, why_kept_out
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System

_QUEUES = frozenset({"queue.Queue", "queue.LifoQueue", "queue.PriorityQueue", "queue.SimpleQueue"})
_EVENTS = frozenset({"threading.Event"})
_FILLS = frozenset({"put", "put_nowait", "set"})
_ASKS = frozenset({"empty", "qsize", "full", "is_set"})
_METHODS = _FILLS | _ASKS | {"get", "get_nowait", "task_done", "wait", "clear"}


@dataclass(frozen=True, kw_only=True)
class QueueWait(EndlessWait):
    """A wait that nothing ends, as long as there is nothing in the queue, or the event is not set."""

    method: str
    """``get`` or ``wait``."""


@once
def queue_waits(system: System) -> list[QueueWait]:
    """The waits for queues, and those for events at the start of a program, that nothing ends."""
    rows = [wait for program, waiting in waiting_functions(system) for wait in _waits_of(system, program, waiting)]
    first = {wait.place: wait for wait in reversed(rows)}
    return [first[place] for place in sorted(first)]


def _waits_of(system: System, program: Program, waiting: Waiting) -> Iterator[QueueWait]:
    code = source_code(system).facts_at(waiting.file)
    if code is None:
        return
    for call in _calls_that_wait(waiting.function):
        match call.func:
            case facts.Attribute(attr="get" | "wait" as method, value=facts.Attribute(attr=attribute, value=owner)):
                if owner.variable != waiting.variable or not _is_endless(call):
                    continue
                if _is_asked_before(waiting, call, attribute) or not _is_made(code, waiting, attribute, method):
                    continue
                setter, why = _only_setter(system, program, waiting, attribute)
                if setter is not None:
                    yield QueueWait(
                        place=Place.of(waiting.file, call.span),
                        waiting=waiting.callback,
                        node=waiting.node,
                        attribute=f"{waiting.variable}.{attribute}",
                        method=method,
                        setter=setter,
                        why=why,
                    )


@once_for
def _calls_that_wait(function: facts.Function) -> list[facts.Call]:
    """The calls of a function that look like waits for an attribute of something."""
    calls = parts_of(function.body, facts.Call)
    return [call for call in calls if call.func.attribute in ("get", "wait") and _is_endless(call)]


def _is_endless(call: facts.Call) -> bool:
    """``get()``, ``get(True)`` and ``wait()``."""
    match call.args:
        case []:
            return True
        case [facts.Argument(value=facts.Literal(value=True), keyword=None | "block")]:
            return call.func.attribute == "get"
    return False


def _is_asked_before(waiting: Waiting, call: facts.Call, attribute: str) -> bool:
    """Whether the function asks the queue what is in it, or waits only where an attribute says that something is."""
    for other in calls_in(waiting.function.body):
        match other.func:
            case facts.Attribute(attr=method, value=facts.Attribute(attr=name)):
                if name == attribute and method in _ASKS | _FILLS:
                    return True
    graph = graph_of(waiting.function.body)
    tests = [edge.test for edge in graph.outcomes(graph.evaluating(call.span)) if edge.test is not None]
    return any(part.value.variable == waiting.variable for part in everything_in(tests, facts.Attribute))


def _is_made(code: facts.Facts, waiting: Waiting, attribute: str, method: str) -> bool:
    """Whether all that a file assigns to an attribute is queues, or events at the start of a program: for callbacks
    it is EXE002 that judges those."""
    if method == "wait" and waiting.callback is not None:
        return False
    values = assigned_values(code, attribute)
    classes = _QUEUES if method == "get" else _EVENTS
    return bool(values) and all(
        isinstance(value, facts.Call) and imported_as(code, value.func.dotted) in classes for value in values
    )


def _only_setter(system: System, program: Program, waiting: Waiting, attribute: str) -> tuple[Callback | None, str]:
    """The callback that fills the queue, the first of several, and why it cannot run; None where something may."""
    classes = classes_of(system, waiting)
    if is_used_otherwise(system, waiting.file, attribute, _METHODS, classes) or _is_filled_at_first(system, waiting):
        return None, ""
    setters = changing_callbacks(system, program, waiting.node, waiting.file, attribute, classes) or []
    called = {call.func.last_name for call in calls_in(waiting.function.body)}
    if any(setter.name.rpartition(".")[2] in called for setter in setters):
        return None, ""
    reasons = [why_kept_out(system, waiting, setter, program) for setter in setters]
    return (setters[0], reasons[0] or "") if reasons and all(reasons) else (None, "")


def _is_filled_at_first(system: System, waiting: Waiting) -> bool:
    """Whether a constructor puts something into what it makes."""
    for path in dict.fromkeys((waiting.file, *(cls.place.file for cls in waiting.node.classes))):
        code = source_code(system).facts_at(path)
        for function in everything_in([] if code is None else code.body, facts.Function):
            if function.name == "__init__" and any(call.func.attribute in _FILLS for call in calls_in(function.body)):
                return True
    return False


__all__ = ["QueueWait", "queue_waits"]
