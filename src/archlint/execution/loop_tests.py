"""What a loop waits for: the attributes of an object that must change for it to end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.own_names import assigned_values
from archlint.python_code.annotations import imported_as, interface_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, is_none, statements_of

if TYPE_CHECKING:
    from archlint.syntax.expressions import Expr

_PASTIMES = frozenset({"time.sleep", "sleep", "print", "rclpy.ok"})
"""Calls that change no attribute, and end nothing."""
_PURE = frozenset({"len", "str", "int", "float", "bool", "abs", "min", "max", "round", "repr", "type"})
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal"})
_OF_CLOCKS = frozenset({"get_clock", "now", "to_msg"})
_ASKS = frozenset({"is_set", "empty", "qsize", "keys", "values", "items"})
"""Methods that say what an attribute holds."""
_PURE_MODULES = frozenset({"math", "numpy"})
_ORDERS = frozenset({"<", "<=", ">", ">="})
_CREATE_PUBLISHER = frozenset({"create_publisher", "create_lifecycle_publisher"})
_Leaving = (facts.Return, facts.Raise)


def awaited_attributes(loop: facts.While, owner: str, code: facts.Facts) -> tuple[str, ...]:
    """The attributes of ``owner`` that alone decide whether a loop goes on, by its test and those that leave it, where
    nothing in the loop changes anything or leaves it otherwise; empty where something else decides, too."""
    leaving = [s for s in statements_of(loop.body, facts.If) if s in loop.body and _leaves(s.body)]
    if loop.orelse or is_only_after_shutdown(loop) or not _only_passes_time(loop, leaving, owner, code):
        return ()
    asking = _Asking(loop, owner, code)
    asked = [asking.attributes_of(test) for test in (loop.test, *(statement.test for statement in leaving))]
    known = [attributes for attributes in asked if attributes is not None]
    return tuple(sorted(set().union(*known))) if len(known) == len(asked) else ()


def is_only_after_shutdown(loop: facts.While | facts.For) -> bool:
    """Whether a loop goes on only while ROS is shut down, as ``while not rclpy.ok()`` does: while nodes work, it is
    not entered."""
    return any(isinstance(test.negated, facts.Call) and called_name(test.negated) == "ok" for test in loop.tests)


def _leaves(body: Sequence[facts.Stmt]) -> bool:
    return any(True for _ in _exits(body))


def _exits(body: Sequence[facts.Stmt]) -> Iterator[facts.Base]:
    for part in everything_in(body):
        if isinstance(part, _Leaving) or (isinstance(part, facts.Jump) and part.kind == "break"):
            yield part


class _Asking:
    """What expressions in a loop depend on."""

    def __init__(self, loop: facts.While, owner: str, code: facts.Facts) -> None:
        self.owner = owner
        self.code = code
        self.values: dict[str, list[Expr | None]] = {}
        """What the loop assigns to variables; None where it changes one otherwise."""
        for statement in statements_of(loop.body):
            match statement:
                case facts.Assign(targets=[facts.Name(id=name)], value=value):
                    self.values.setdefault(name, []).append(value)
                case facts.Assign() | facts.Augmented():
                    for target in statement.assigned:
                        for part in everything_in(target, facts.Name):
                            self.values.setdefault(part.id, []).append(None)

    def attributes_of(self, test: Expr, through: frozenset[str] = frozenset()) -> set[str] | None:
        """The attributes that an expression depends on, also by variables that the loop sets; None where it depends on
        something else, too."""
        if not all(self._only_asks(call) for call in calls_in(test)) or self._asks_what_lives(test):
            return None
        attributes = {part.attr for part in everything_in(test, facts.Attribute) if part.value.variable == self.owner}
        for name in sorted(self._variables(test)):
            values = self.values.get(name, [])
            if name in through or None in values or (not values and not _is_limit(test, name)):
                return None
            for value in values:
                inner = None if value is None else self.attributes_of(value, through | {name})
                if inner is None:
                    return None
                attributes |= inner
        return attributes

    def _asks_what_lives(self, test: Expr) -> bool:
        """Whether an expression reads a field of an object that is no message: one with a thread of its own changes it,
        whoever holds the object."""
        methods = {id(call.func) for call in calls_in(test)}
        return any(
            isinstance(part.value, facts.Attribute)
            and part.value.value.variable == self.owner
            and any(
                isinstance(value, facts.Call) and interface_of(self.code, value.func.dotted)[0] is None
                for value in assigned_values(self.code, part.value.attr)
            )
            for part in everything_in(test, facts.Attribute)
            if id(part) not in methods
        )

    def _variables(self, test: Expr) -> set[str]:
        """The variables that an expression uses, but for functions and modules."""
        functions = {id(part) for call in calls_in(test) for part in everything_in(call.func, facts.Name)}
        names = {part.id for part in everything_in(test, facts.Name) if id(part) not in functions}
        modules = {name for name in names if imported_as(self.code, name) in _PURE_MODULES}
        return names - modules - {self.owner}

    def _only_asks(self, call: facts.Call) -> bool:
        match call.func:
            case facts.Attribute(attr=name, value=facts.Attribute(value=asked)) if asked.variable == self.owner:
                return name in _ASKS and not call.args
        if call.func.dotted == "rclpy.ok" or call.func.variable in _PURE:
            return True
        path = imported_as(self.code, call.func.dotted) if call.func.dotted else None
        return path is not None and path.partition(".")[0] in _PURE_MODULES and "random" not in path


def _is_limit(test: Expr, name: str) -> bool:
    """Whether a variable that the loop does not set is a number that is only reckoned and compared with."""
    numbers: set[int] = set()
    for part in everything_in(test):
        match part:
            case facts.Compare(left=left, ops=ops, comparators=sides) if _ORDERS.issuperset(ops):
                numbers.update(map(id, (left, *sides)))
            case facts.Binary(left=left, op="-" | "*" | "/", right=right):
                numbers.update(map(id, (left, right)))
    return all(id(part) in numbers for part in everything_in(test, facts.Name) if part.id == name)


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
    if (imported_as(code, call.func.dotted) or "").partition(".")[0] in _PURE_MODULES:
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
    values = [value for value in assigned_values(code, attribute) if not is_none(value)]
    return bool(values) and all(
        isinstance(value, facts.Call) and value.func.last_name in _CREATE_PUBLISHER for value in values
    )


__all__ = ["awaited_attributes", "is_only_after_shutdown"]
