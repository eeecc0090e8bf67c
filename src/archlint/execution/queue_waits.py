"""Waits for a queue or an event of a node that only callbacks fill or set which cannot run meanwhile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.own_names import assigned_values
from archlint.analysis.source_code import source_code
from archlint.execution.attribute_changes import changing_callbacks, is_used_otherwise
from archlint.execution.waiting_functions import EndlessWait, Waiting, classes_of, waiting_functions, why_kept_out
from archlint.finding import Place
from archlint.python_code.annotations import imported_as
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import calls_in

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System

_QUEUES = frozenset({"queue.Queue", "queue.LifoQueue", "queue.PriorityQueue", "queue.SimpleQueue"})
_EVENTS = frozenset({"threading.Event"})
_CONDITIONS = frozenset({"threading.Condition"})
_SEMAPHORES = frozenset({"threading.Semaphore", "threading.BoundedSemaphore"})
_CLASSES = {"get": _QUEUES, "wait": _EVENTS | _CONDITIONS, "wait_for": _CONDITIONS, "acquire": _SEMAPHORES}
"""The classes whose methods wait."""
_FILLS = frozenset({"put", "put_nowait", "set", "notify", "notify_all", "release"})
_ASKS = frozenset({"empty", "qsize", "full", "is_set", "locked"})
_METHODS = _FILLS | _ASKS | {"get", "get_nowait", "task_done", "wait", "wait_for", "acquire", "clear"}


@dataclass(frozen=True, kw_only=True)
class QueueWait(EndlessWait):
    """A wait that nothing ends, as long as there is nothing in the queue, or the event is not set."""

    method: str
    """``get``, ``wait``, ``wait_for`` or ``acquire``."""
    made_by: str
    """The class that makes what is waited for: ``threading.Event``."""


@once
def queue_waits(system: System) -> list[QueueWait]:
    """The waits for queues, conditions and semaphores, and those for events at the start of a program, that nothing
    ends."""
    rows = [wait for program, waiting in waiting_functions(system) for wait in _waits_of(system, program, waiting)]
    first = {wait.place: wait for wait in reversed(rows)}
    return [first[place] for place in sorted(first)]


def _waits_of(system: System, program: Program, waiting: Waiting) -> Iterator[QueueWait]:
    code = source_code(system).facts_at(waiting.file)
    if code is None:
        return
    for call in _calls_that_wait(waiting.function):
        match call.func:
            case facts.Attribute(attr=method, value=facts.Attribute(attr=attribute, value=owner)):
                if owner.variable != waiting.variable or not _is_endless(call):
                    continue
                made_by = _maker(code, waiting, attribute, method)
                if made_by is None or _is_asked_before(waiting, call, attribute, made_by):
                    continue
                setter, why = _only_setter(system, program, waiting, attribute)
                if setter is not None:
                    yield QueueWait(
                        place=Place.of(waiting.file, call.span),
                        waiting=waiting.callback,
                        node=waiting.node,
                        attribute=f"{waiting.variable}.{attribute}",
                        method=method,
                        made_by=made_by,
                        setter=setter,
                        why=why,
                    )


@once_for
def _calls_that_wait(function: facts.Function) -> list[facts.Call]:
    """The calls of a function that look like waits for an attribute of something."""
    calls = parts_of(function.body, facts.Call)
    return [call for call in calls if call.func.attribute in _CLASSES and _is_endless(call)]


def _is_endless(call: facts.Call) -> bool:
    """``get()``, ``get(True)``, ``wait()``, ``acquire()`` and ``wait_for(…)``."""
    match call.args:
        case []:
            return call.func.attribute != "wait_for"
        case [facts.Argument(value=facts.Literal(value=True), keyword=None | "block" | "blocking")]:
            return call.func.attribute in ("get", "acquire")
        case [facts.Argument(keyword=None | "predicate", star="")]:
            return call.func.attribute == "wait_for"
    return False


def _is_asked_before(waiting: Waiting, call: facts.Call, attribute: str, made_by: str) -> bool:
    """Whether the function asks the queue what is in it, or waits only where an attribute says that something is.  Who
    waits for a condition always wants the next notice, whatever has been before."""
    for other in calls_in(waiting.function.body):
        match other.func:
            case facts.Attribute(attr=method, value=facts.Attribute(attr=name)):
                if name == attribute and method in _ASKS | _FILLS:
                    return True
    if made_by in _CONDITIONS:
        return False
    graph = graph_of(waiting.function.body)
    tests = [edge.test for edge in graph.outcomes(graph.evaluating(call.span)) if edge.test is not None]
    return any(part.value.variable == waiting.variable for part in everything_in(tests, facts.Attribute))


def _maker(code: facts.Facts, waiting: Waiting, attribute: str, method: str) -> str | None:
    """The class of all that a file assigns to an attribute, where a method of it waits; None of an event that a
    callback waits for, which EXE002 judges, and of a semaphore that is not 0 at first."""
    values = assigned_values(code, attribute)
    makers = {imported_as(code, value.func.dotted) if isinstance(value, facts.Call) else "" for value in values}
    made_by = makers.pop() if len(makers) == 1 else None
    if made_by is None or made_by not in _CLASSES[method]:
        return None
    if made_by in _SEMAPHORES and not all(map(_is_zero, values)):
        return None
    return None if made_by in _EVENTS and waiting.callback is not None else made_by


def _is_zero(call: facts.Expr) -> bool:
    match call:
        case facts.Call(args=[facts.Argument(value=facts.Literal(value=0))]):
            return True
    return False


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
