"""Operators between times, durations and numbers that rclpy refuses with a TypeError.

Source: rclpy/time.py and rclpy/duration.py of humble, jazzy and rolling; ``builtin_interfaces/msg/Time``, which is
a plain message.  Equality is left out: what it says of another class differs between distributions.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.class_chains import targets_of
from archlint.analysis.kept import once_for_each_file
from archlint.place import Place
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


class Kind(StringEnum):
    """What an operand is, in words."""

    TIME = "an rclpy Time"
    DURATION = "an rclpy Duration"
    STAMP = "a stamp message"
    NUMBER = "a number"


@dataclass(frozen=True)
class RefusedOperator:
    """``left op right`` raises a TypeError."""

    op: str
    left: Kind
    right: Kind
    place: Place


def refused_operators(workspace: WorkspaceIndex) -> Iterator[RefusedOperator]:
    """Those of the files that use rclpy, outside of test code."""
    for file, _ in workspace.code.asked_for():
        if not workspace.roles.is_test(file.relative) and workspace.code.mentions(file.relative, "rclpy"):
            for op, left, right, span in _refused(workspace, file.relative) or ():
                yield RefusedOperator(op, left, right, Place(file.relative, *span))


_Row = tuple[str, Kind, Kind, facts.Span]
_ORDER = frozenset({"<", "<=", ">", ">="})
_TIMES = frozenset({Kind.TIME, Kind.DURATION, Kind.STAMP})


@once_for_each_file
def _refused(file_facts: facts.Facts) -> list[_Row]:
    code = _Code(file_facts)
    rows: list[_Row] = []
    for function in everything_in(file_facts.body, facts.Function):
        scope = code.scope(function)
        for part in parts_of(function.body):
            if Itself(part) in code.tried:
                continue
            match part:
                case facts.Binary(op=op, left=left, right=right):
                    kinds = scope.kind(left), scope.kind(right)
                case facts.Compare(ops=[op], left=left, comparators=[right]) if op in _ORDER:
                    kinds = scope.kind(left), scope.kind(right)
                case _:
                    continue
            first, second = kinds
            if first is not None and second is not None and _is_refused(op, first, second):
                rows.append((op, first, second, part.span))
    return rows


def _is_refused(op: str, left: Kind, right: Kind) -> bool:
    if _TIMES.isdisjoint((left, right)):
        return False
    if op in _ORDER:
        return left != right or left == Kind.STAMP
    if op == "-":
        return (left, right) not in {
            (Kind.TIME, Kind.TIME),
            (Kind.TIME, Kind.DURATION),
            (Kind.DURATION, Kind.DURATION),  # from lyrical on
        }
    if op == "+":
        return Kind.DURATION not in (left, right) or not {left, right} <= {Kind.TIME, Kind.DURATION}
    return op in ("/", "//") or (op == "*" and Kind.DURATION not in (left, right))


class _Code:
    """What one file calls the classes, and what it stores in attributes."""

    def __init__(self, file_facts: facts.Facts) -> None:
        self.classes: dict[str, Kind] = {}
        self.modules: set[str] = set()
        for part in everything_in(file_facts.body):
            match part:
                case facts.ImportFrom(module="rclpy.time" | "rclpy.duration" | "rclpy.clock", names=names):
                    of = {"Time": Kind.TIME, "Duration": Kind.DURATION}
                    self.classes |= {bound: of[name] for name, bound in names if name in of}
                case facts.Import(module="rclpy" | "rclpy.time" | "rclpy.duration", alias=None):
                    self.classes |= {"rclpy.time.Time": Kind.TIME, "rclpy.duration.Duration": Kind.DURATION}
                case facts.Import(module="time", alias=alias):
                    self.modules.add(alias or "time")
        self.tried = {
            Itself(part)
            for attempt in everything_in(file_facts.body, facts.Try)
            if not all(handler.caught.isdisjoint({"TypeError", "Exception"}) for handler in attempt.handlers)
            for part in everything_in(attempt.body)
        }
        self._values: dict[str, list[tuple[facts.Expr, facts.Function]]] = {}
        stored: dict[str, int] = {}
        for function in everything_in(file_facts.body, facts.Function):
            for part in parts_of(function.body):
                match part:
                    case facts.Assign(targets=[facts.Attribute(attr=name)], value=value):
                        self._values.setdefault(name, []).append((value, function))
        for target in targets_of(file_facts.body):
            if target.attribute:
                stored[target.attribute] = stored.get(target.attribute, 0) + 1
        changed = {part.target.attribute for part in everything_in(file_facts.body, facts.Augmented)}
        self._values = {
            name: values for name, values in self._values.items() if stored[name] == len(values) and name not in changed
        }
        self._asked: set[str] = set()
        self._scopes: dict[Itself[facts.Function], _Scope] = {}

    def scope(self, function: facts.Function) -> _Scope:
        """The variables of a function, worked out once."""
        key = Itself(function)
        if key not in self._scopes:
            self._scopes[key] = _Scope(self, function)
        return self._scopes[key]

    def attribute(self, name: str) -> Kind | None:
        """What an attribute of that name holds, where all that the file stores in one is of that kind, or None."""
        if name in self._asked:
            return None
        self._asked.add(name)
        values = [(value, function) for value, function in self._values.get(name, []) if not _is_none(value)]
        kinds = {self.scope(function).kind(value) for value, function in values}
        self._asked.discard(name)
        return kinds.pop() if len(kinds) == 1 else None


def _is_none(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and value.value is None


class _Scope:
    """The variables of one function."""

    def __init__(self, code: _Code, function: facts.Function) -> None:
        self._code = code
        self._values: dict[str, list[facts.Expr]] = {}
        self._asked: set[str] = set()
        targets = [target.variable for target in targets_of(function.body)]
        changed = {part.target.variable for part in everything_in(function.body, facts.Augmented)}
        changed |= {param.name for param in everything_in(function, facts.Param)}
        changed |= {name for part in everything_in(function.body, facts.Global) for name in part.names}
        for part in parts_of(function.body):
            match part:
                case facts.Assign(targets=[facts.Name(id=name)], value=value):
                    self._values.setdefault(name, []).append(value)
        self._values = {
            name: values
            for name, values in self._values.items()
            if targets.count(name) == len(values) and name not in changed
        }

    def kind(self, e: facts.Expr) -> Kind | None:
        """What an expression certainly is."""
        match e:
            case facts.Literal():
                return None if e.number is None else Kind.NUMBER
            case facts.Name(id=name):
                return self._variable(name)
            case facts.Call():
                return self._called(e)
            case facts.Attribute(value=facts.Attribute(attr="header"), attr="stamp"):
                return Kind.STAMP
            case facts.Attribute(attr="nanoseconds", value=inner):
                return Kind.NUMBER if self.kind(inner) in (Kind.TIME, Kind.DURATION) else None
            case facts.Attribute(value=facts.Name(), attr=name):
                return self._code.attribute(name)
            case facts.Binary(op=op, left=left, right=right):
                return _result(op, self.kind(left), self.kind(right))
        return None

    def _variable(self, name: str) -> Kind | None:
        if name in self._asked:
            return None
        self._asked.add(name)
        kinds = {self.kind(value) for value in self._values.get(name, [])}
        self._asked.discard(name)
        return kinds.pop() if len(kinds) == 1 else None

    def _called(self, call: facts.Call) -> Kind | None:
        match call.func:
            case facts.Attribute(value=facts.Call(func=facts.Attribute(attr="get_clock")), attr="now"):
                return Kind.TIME
            case facts.Attribute(value=facts.Name(id=module), attr="time" | "monotonic" | "perf_counter"):
                return Kind.NUMBER if module in self._code.modules else None
            case facts.Attribute(value=owner, attr="from_msg"):
                return self._code.classes.get(owner.dotted)
            case facts.Attribute(value=owner, attr="to_msg"):
                return Kind.STAMP if self.kind(owner) == Kind.TIME else None
        return self._code.classes.get(call.func.dotted)


def _result(op: str, left: Kind | None, right: Kind | None) -> Kind | None:
    match op, left, right:
        case "-", Kind.TIME, Kind.TIME:
            return Kind.DURATION
        case "+" | "-", Kind.TIME, Kind.DURATION:
            return Kind.TIME
        case "+" | "-" | "*" | "/" | "//", Kind.NUMBER, Kind.NUMBER:
            return Kind.NUMBER
    return None


__all__ = ["Kind", "RefusedOperator", "refused_operators"]
