"""Times of two clocks that code subtracts or compares: ``self.get_clock().now() - Time()``.

Source: rclpy/time.py of humble, jazzy and kilted: a ``Time`` made without a ``clock_type`` is one of SYSTEM_TIME, what
``from_msg()`` makes or a node's clock gives is one of ROS_TIME, and operators between these raise a TypeError.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Literal

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.annotations import imported_as
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.plain_kinds import Values, values_in, values_of_self
from archlint.python_code.rclpy_objects import Kind, objects_of
from archlint.python_code.text_sums import is_its_own
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

Clock = Literal["ROS_TIME", "SYSTEM_TIME", "STEADY_TIME"]
_CLOCKS: Mapping[str, Clock] = {"ROS_TIME": "ROS_TIME", "SYSTEM_TIME": "SYSTEM_TIME", "STEADY_TIME": "STEADY_TIME"}
_OPERATORS = frozenset({"-", "<", "<=", ">", ">="})
_CLASSES: Mapping[str, Clock] = {"rclpy.clock.Clock": "SYSTEM_TIME", "rclpy.clock.ROSClock": "ROS_TIME"}
_DEPTH = 3


@dataclass(frozen=True)
class MixedClocks:
    """``left op right`` of times of these clocks."""

    op: str
    left: Clock
    right: Clock
    place: Place


@dataclass(frozen=True)
class _Row:
    op: str
    left: Clock
    right: Clock
    span: facts.Span
    cls: int | None
    attributes: tuple[str, ...]
    """The attributes of ``self`` that it is about."""


def mixed_clocks(workspace: WorkspaceIndex) -> Iterator[MixedClocks]:
    """Such operators in the files that use rclpy, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        for row in _rows(workspace, path) or ():
            own = row.attributes
            if not own or (row.cls is not None and all(is_its_own(workspace, path, row.cls, name) for name in own)):
                yield MixedClocks(row.op, row.left, row.right, Place(path, *row.span))


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    rows: list[_Row] = []
    in_methods: set[Itself[facts.Base]] = set()
    for number, cls in enumerate(classes_of(code)):
        attributes = values_of_self(cls)
        for function in methods_of(cls):
            in_methods.add(Itself(function))
            rows += _Function(code, function, attributes).rows(number)
    for function in everything_in(code.body, facts.Function):
        if Itself[facts.Base](function) not in in_methods:
            rows += _Function(code, function, {}).rows(None)
    return rows


class _Function:
    """What the times of one function are of."""

    def __init__(self, code: facts.Facts, function: facts.Function, attributes: Values) -> None:
        self._code, self._function, self._attributes = code, function, attributes
        self._objects = objects_of(code)
        self._variables: Values | None = None
        self._used: set[str] = set()

    def rows(self, number: int | None) -> Iterator[_Row]:
        """The operators between times of two clocks."""
        for part in parts_of(self._function.body):
            match part:
                case facts.Binary(op=op, left=left, right=right) if op in _OPERATORS:
                    pass
                case facts.Compare(ops=[op], left=left, comparators=[right]) if op in _OPERATORS:
                    pass
                case _:
                    continue
            if Itself(part) in self._objects.tried:
                continue
            self._used = set()
            first, second = self._clock(left, part.span), self._clock(right, part.span)
            if first is not None and second is not None and first != second:
                yield _Row(op, first, second, part.span, number, tuple(sorted(self._used)))

    def _clock(self, e: facts.Expr, at: facts.Span, depth: int = _DEPTH) -> Clock | None:
        """The clock that an expression is a time of, read at a place."""
        match e:
            case facts.Call() if depth:
                return self._called(e)
            case facts.Name(id=name) if depth:
                self._variables = self._variables or values_in(self._function)
                values = self._variables.get(name, ())
                clocks = {None if value is None else self._clock(value, at, depth - 1) for value in values}
                return clocks.pop() if len(clocks) == 1 else None
            case facts.Attribute() if depth and (own := of_self(e)) is not None:
                self._used.add(own)
                return self._of_attribute(own, at, depth)
        return None

    def _of_attribute(self, name: str, at: facts.Span, depth: int) -> Clock | None:
        """The clock of an attribute; where it is read each time that the function runs, but for what only this function
        assigns further down: the first time it has not."""
        later = {
            Itself(part.value)
            for part in everything_in(self._function.body, facts.Assign)
            if part.span[:2] > at[:2] and any(of_self(target) == name for target in part.targets)
        }
        if later and not self._always_runs(at):
            return None
        if self._function.name == "__init__":
            return None  # it is not run again
        values = self._attributes.get(name, ())
        if not values or any(value is None for value in values):
            return None
        first = [value for value in values if value is not None and Itself(value) not in later and not is_none(value)]
        clocks = {self._clock_elsewhere(value) for value in first}
        return clocks.pop() if len(clocks) == 1 and depth else None

    def _always_runs(self, at: facts.Span) -> bool:
        """Whether a place is in a plain statement of the function, in front of which nothing leaves it."""
        for statement in self._function.body:
            if covers(statement, at):
                return isinstance(statement, (facts.Assign, facts.Augmented, facts.Expression))
            if any(isinstance(part, (facts.Return, facts.Raise)) for part in everything_in([statement])):
                return False
        return False

    def _clock_elsewhere(self, value: facts.Expr) -> Clock | None:
        """The clock of what is written in any method: that of calls alone."""
        return self._called(value) if isinstance(value, facts.Call) else None

    def _called(self, call: facts.Call) -> Clock | None:
        match call.func:
            case facts.Attribute(value=facts.Call(func=facts.Attribute(attr="get_clock"), args=[]), attr="now"):
                return "ROS_TIME"
            case facts.Attribute(value=facts.Call(func=maker) as clock, attr="now"):
                default = _CLASSES.get(imported_as(self._code, maker.dotted) or "")
                return None if default is None else _given(clock, default)
            case facts.Attribute(value=owner, attr="from_msg"):
                is_time = self._objects.classes.get(owner.dotted) == Kind.TIME
                return _given(call, "ROS_TIME", at=1) if is_time else None
        return _given(call, "SYSTEM_TIME") if self._objects.classes.get(call.func.dotted) == Kind.TIME else None


def _given(call: facts.Call, default: Clock, at: int | None = None) -> Clock | None:
    """The clock that a call names, or the one that it has without."""
    if any(argument.star for argument in call.args):
        return None
    by_position = [argument.value for argument in call.args if argument.keyword is None]
    named = [argument.value for argument in call.args if argument.keyword == "clock_type"]
    named += by_position[at:] if at is not None else []
    return _CLOCKS.get(named[0].last_name) if named else default


__all__ = ["Clock", "MixedClocks", "mixed_clocks"]
