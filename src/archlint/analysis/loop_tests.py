"""What a loop waits for: the attribute of an object that must change for it to end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.annotations import interface_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.syntax.expressions import Expr

_PASTIMES = frozenset({"time.sleep", "sleep", "print", "rclpy.ok"})
"""Calls that change no attribute, and end nothing."""
_PURE = frozenset({"len", "str", "int", "float", "bool", "abs", "min", "max", "round", "repr", "type"})
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal"})
_OF_CLOCKS = frozenset({"get_clock", "now", "to_msg"})
_ASKS = frozenset({"is_set", "empty", "qsize", "keys", "values", "items"})
"""Methods that say what an attribute holds."""
_CREATE_PUBLISHER = frozenset({"create_publisher", "create_lifecycle_publisher"})
_Leaving = (facts.Return, facts.Raise)


def awaited_attribute(loop: facts.While, owner: str, code: facts.Facts) -> str | None:
    """The one attribute of ``owner`` that the tests of a loop ask for, those that leave it among them, where nothing in
    the loop changes anything or leaves it otherwise."""
    leaving = [s for s in statements_of(loop.body, facts.If) if s in loop.body and _leaves(s.body)]
    if loop.orelse or not _only_passes_time(loop, leaving, owner, code):
        return None
    asked = [_asked(test, owner) for test in (loop.test, *(statement.test for statement in leaving))]
    names = {name for attributes in asked if attributes is not None for name in attributes}
    return names.pop() if None not in asked and len(names) == 1 else None


def _leaves(body: Sequence[facts.Stmt]) -> bool:
    return any(True for _ in _exits(body))


def _exits(body: Sequence[facts.Stmt]) -> Iterator[facts.Base]:
    for part in everything_in(body):
        if isinstance(part, _Leaving) or (isinstance(part, facts.Jump) and part.kind == "break"):
            yield part


def _asked(test: Expr, owner: str) -> set[str] | None:
    """The attributes that a test depends on; None where it depends on something else, too."""
    attributes = {part.attr for part in everything_in(test, facts.Attribute) if part.value.variable == owner}
    variables = {part.id for part in everything_in(test, facts.Name)} - {owner, "rclpy"} - _PURE
    return None if variables or not all(_only_asks(call, owner) for call in calls_in(test)) else attributes


def _only_asks(call: facts.Call, owner: str) -> bool:
    match call.func:
        case facts.Attribute(attr=name, value=facts.Attribute(value=asked)) if asked.variable == owner:
            return name in _ASKS and not call.args
    return call.func.dotted == "rclpy.ok" or call.func.variable in _PURE


def _only_passes_time(loop: facts.While, leaving: Sequence[facts.If], owner: str, code: facts.Facts) -> bool:
    """Whether a loop does nothing that another part of the program could see, but for what it publishes."""
    guarded = {id(exit_) for statement in leaving for exit_ in _exits(statement.body)}
    ends = {id(statement) for statement in leaving}
    body = [part for statement in loop.body if id(statement) not in ends for part in everything_in(statement)]
    orelse = [part for statement in leaving for part in everything_in(statement.orelse)]
    if any(id(exit_) not in guarded for exit_ in _exits(loop.body)):
        return False
    if any(isinstance(part, (facts.Await, facts.Yield)) for part in everything_in(loop.body)):
        return False
    return all(_is_harmless(part, owner, code) for part in (*body, *orelse))


def _is_harmless(part: facts.Base, owner: str, code: facts.Facts) -> bool:
    match part:
        case facts.Call():
            return _passes_time(part, owner, code)
        case facts.Try() | facts.With() | facts.For() | facts.Delete() | facts.Annotated() | facts.Global():
            return False
        case facts.Assign() | facts.Augmented():
            return all(_is_local(target, owner) for target in part.assigned)
    return True


def _is_local(target: Expr, owner: str) -> bool:
    """Whether an assignment is to a variable, or to a field of what a variable holds."""
    while isinstance(target, facts.Attribute):
        target = target.value
    return bool(target.variable) and target.variable != owner


def _passes_time(call: facts.Call, owner: str, code: facts.Facts) -> bool:
    if call.func.dotted in _PASTIMES or call.func.variable in _PURE:
        return True
    match call.func:
        case facts.Attribute(attr=name, value=facts.Call(func=logger)) if name in _LOGS:
            return logger.last_name == "get_logger"
        case facts.Attribute(attr="get_logger"):
            return True
        case facts.Attribute(attr=name) if name in _OF_CLOCKS:
            return True
        case facts.Attribute(attr="publish", value=facts.Attribute(attr=name, value=value)):
            return value.variable == owner and _is_publisher(name, code)
    return bool(call.func.dotted) and interface_of(code, call.func.dotted)[0] is not None


def _is_publisher(attribute: str, code: facts.Facts) -> bool:
    """Whether all that a file assigns to an attribute is publishers."""
    values = [
        assignment.value
        for assignment in everything_in(code.body, facts.Assign)
        for target in assignment.targets
        if isinstance(target, facts.Attribute) and target.attr == attribute
    ]
    values = [value for value in values if not (isinstance(value, facts.Literal) and value.value is None)]
    return bool(values) and all(
        isinstance(value, facts.Call) and value.func.last_name in _CREATE_PUBLISHER for value in values
    )


__all__ = ["awaited_attribute"]
