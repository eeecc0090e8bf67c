"""Loops of a callback that go on until an attribute changes, which only callbacks change that it keeps out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.event_waits import kept_out
from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System

_HARMLESS = frozenset({"time.sleep", "sleep", "print", "rclpy.ok"})
"""Calls that change no attribute, and end nothing."""
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal"})
_CHANGES = frozenset(
    {"append", "appendleft", "add", "clear", "extend", "insert", "pop", "popleft", "put", "remove", "set"}
)
"""Methods that change what an attribute holds."""


@dataclass(frozen=True)
class AttributeLoop:
    """A loop that nothing ends once it is entered."""

    place: Place
    """Its test."""
    loop: Place
    callback: Callback
    attribute: str
    setter: Callback
    why: str
    """Why the setter cannot run meanwhile."""


@once
def attribute_loops(system: System) -> list[AttributeLoop]:
    """The loops of callbacks that wait for attributes of their node, and that nothing ends."""
    rows = (
        loop
        for program in system.programs
        for callback in program.callbacks
        if runs_in_executor(callback) and not system.roles.is_test(callback.file)
        for loop in _loops_of(system, program, callback)
    )
    first = {loop.place: loop for loop in sorted(rows, key=lambda loop: (loop.place, loop.callback.place))}
    return [first[place] for place in sorted(first)]


def _loops_of(system: System, program: Program, callback: Callback) -> Iterator[AttributeLoop]:
    function = source_code(system).definition(callback)
    if function is None or function.decorators or not function.params or callback.bound_arguments != 1:
        return
    self_name = function.params[0].name
    for loop in statements_of(function.body, facts.While):
        attribute = _waits_for(loop, self_name)
        setters = [] if attribute is None else _setters(system, program, callback, attribute)
        reasons = [kept_out(callback, setter, program) for setter in setters]
        if attribute is not None and reasons and all(reasons):
            test, whole = Place.of(callback.file, _span_of(loop)), Place.of(callback.file, loop.span)
            yield AttributeLoop(test, whole, callback, attribute, setters[0], reasons[0] or "")


def _span_of(loop: facts.While) -> facts.Span:
    """The test of a loop; all of it where the test has no place of its own."""
    return getattr(loop.test, "span", loop.span)


def _waits_for(loop: facts.While, self_name: str) -> str | None:
    """The one attribute of the object that the test of a loop depends on, where nothing in the loop changes it or
    leaves the loop."""
    names = {part.attr for part in everything_in(loop.test, facts.Attribute) if part.value.variable == self_name}
    variables = {part.id for part in everything_in(loop.test, facts.Name)} - {self_name, "rclpy"}
    tests_only = all(call.func.dotted == "rclpy.ok" for call in calls_in(loop.test))
    if len(names) != 1 or variables or not tests_only or loop.orelse:
        return None
    parts = list(everything_in(loop.body))
    leaves = any(isinstance(part, (facts.Return, facts.Raise, facts.Await, facts.Yield, facts.Try)) for part in parts)
    breaks = any(isinstance(part, facts.Jump) and part.kind == "break" for part in parts)
    stores = any(isinstance(part, (facts.Assign, facts.Augmented, facts.With)) for part in parts)
    if leaves or breaks or stores or not all(map(_is_harmless, calls_in(loop.body))):
        return None
    return names.pop()


def _is_harmless(call: facts.Call) -> bool:
    if call.func.dotted in _HARMLESS:
        return True
    match call.func:
        case facts.Attribute(attr=name, value=facts.Call(func=logger)) if name in _LOGS:
            return logger.last_name == "get_logger"
        case facts.Attribute(attr="get_logger"):
            return True
    return False


def _setters(system: System, program: Program, callback: Callback, attribute: str) -> list[Callback]:
    """The callbacks that change an attribute, besides the constructor; none where something else may change it."""
    workspace = system.workspace
    if workspace is None or callback.node is None or not callback.node.complete:
        return []
    own = callback.file
    if any(
        _changes(workspace.facts_at(path), attribute)
        for path in workspace.code.files_that_mention(attribute)
        if path != own
    ):
        return []
    code = workspace.facts_at(own)
    by_place = {other.place: other for other in program.callbacks if other.function is not None}
    setters: list[Callback] = []
    for function in everything_in(code.body if code is not None else [], facts.Function):
        if not _body_changes(function.body, attribute) or function.name == "__init__":
            continue
        setter = by_place.get(Place.of(own, function.name_span))
        if setter is None or setter.node is not callback.node:
            return []
        setters.append(setter)
    return setters


def _changes(code: facts.Facts | None, attribute: str) -> bool:
    return code is None or _body_changes(code.body, attribute)


def _body_changes(body: list[facts.Stmt], attribute: str) -> bool:
    """Whether code assigns an attribute of that name, changes what it holds, or names it in a text."""
    for part in everything_in(body):
        match part:
            case facts.Assign() | facts.Augmented() | facts.Annotated() | facts.With() | facts.For() | facts.Delete():
                if any(stored.attr == attribute for stored in everything_in(part.assigned, facts.Attribute)):
                    return True
            case facts.Call(func=facts.Attribute(value=facts.Attribute(attr=name), attr=method)):
                if name == attribute and method in _CHANGES:
                    return True
            case facts.Literal(text=text) if text == attribute:
                return True
    return False


__all__ = ["AttributeLoop", "attribute_loops"]
