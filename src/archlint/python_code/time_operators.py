"""Operators between times, durations and numbers that rclpy refuses with a TypeError.

Source: rclpy/time.py and rclpy/duration.py of humble, jazzy and rolling; ``builtin_interfaces/msg/Time``, which is
a plain message.  Equality is left out: what it says of another class differs between distributions.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.rclpy_objects import Kind, Objects, objects_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class RefusedOperator:
    """``left op right`` raises a TypeError."""

    op: str
    left: Kind
    right: Kind
    place: Place
    of_system: bool = False
    """Whether the file makes times of the system's clock, such as ``Time()``: ``from_msg()`` makes those of ROS's."""


def refused_operators(workspace: WorkspaceIndex) -> Iterator[RefusedOperator]:
    """Those of the files that use rclpy, outside of test code."""
    for file, _ in workspace.code.judged():
        if not workspace.roles.is_test(file.relative) and workspace.code.mentions(file.relative, "rclpy"):
            for op, left, right, span, of_system in _refused(workspace, file.relative) or ():
                yield RefusedOperator(op, left, right, Place(file.relative, *span), of_system)


_Row = tuple[str, Kind, Kind, facts.Span, bool]
_ORDER = frozenset({"<", "<=", ">", ">="})
_TIMES = frozenset({Kind.TIME, Kind.DURATION, Kind.STAMP})


@kept_for_each_file
def _refused(file_facts: facts.Facts) -> list[_Row]:
    code = objects_of(file_facts)
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
                rows.append((op, first, second, part.span, _makes_times_of_system(file_facts, code)))
    return rows


def _makes_times_of_system(file_facts: facts.Facts, code: Objects) -> bool:
    return any(
        (code.classes.get(call.func.dotted) == Kind.TIME or call.func.last_name == "Clock")
        and all(argument.keyword != "clock_type" for argument in call.args)
        for call in everything_in(file_facts.body, facts.Call)
    )


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


__all__ = ["Kind", "RefusedOperator", "refused_operators"]
