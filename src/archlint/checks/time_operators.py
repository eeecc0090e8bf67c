"""What API001 says of times, durations and numbers: operators between them, and one in place of another."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.python_code.clocks_of_times import MixedClocks, mixed_clocks
from archlint.python_code.numbers_for_times import NumberForTime, numbers_for_times
from archlint.python_code.time_operators import Kind, RefusedOperator, refused_operators

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import System

OPERATOR = "operator"
"""The group of findings that are about operators."""


def time_operator_findings(system: System) -> Iterator[Finding]:
    """The findings about such operators, and about numbers in their place, in the files that use rclpy."""
    if system.workspace is not None:
        yield from map(_finding, refused_operators(system.workspace))
        yield from map(_of_number, numbers_for_times(system.workspace))
        yield from map(_of_clocks, mixed_clocks(system.workspace))


def _of_clocks(row: MixedClocks) -> Finding:
    return finding(
        "API001",
        row.place,
        f"'{row.op}' fails with a TypeError: a Time of {row.left} on its left, one of {row.right} on its right",
        help="take both of one clock: Time(…, clock_type=ClockType.ROS_TIME) is like what the node's clock gives",
        identity=(row.op, row.left, row.right),
        group=(row.place.file, OPERATOR, row.op, row.left, row.right),
        fails=True,
    )


def _of_number(row: NumberForTime) -> Finding:
    cure = "Duration(seconds=…)" if row.wanted == "Duration" else "rclpy.time.Time(), the newest there is"
    return finding(
        "API001",
        row.place,
        f"{row.call}() fails: '{row.parameter}' takes a {row.wanted} of rclpy, not a number",
        help=f"pass {cure}",
        identity=(row.call, row.parameter),
        group=(row.place.file, row.call, row.parameter),
        fails=True,
    )


def _finding(row: RefusedOperator) -> Finding:
    left, right = row.left, row.right
    return finding(
        "API001",
        row.place,
        f"'{row.op}' fails with a TypeError: {left} on its left, {right} on its right",
        help=_cure(row),
        identity=(row.op, left, right),
        group=(row.place.file, OPERATOR, row.op, left, right),
        fails=True,
    )


def _cure(row: RefusedOperator) -> str:
    kinds = {row.left, row.right}
    if Kind.STAMP in kinds and Kind.TIME in kinds and row.of_system:
        return "make a Time of the stamp first, with the clock of the other: Time.from_msg(…, clock_type=….clock_type)"
    if Kind.STAMP in kinds:
        return "make a Time of the stamp first: Time.from_msg(…)"
    if Kind.NUMBER not in kinds:
        return "compare a Time with a Time, and a Duration with a Duration"
    if row.op in ("+", "-") or (Kind.DURATION in kinds and row.op not in ("/", "//")):
        return "write Duration(seconds=…) instead of the number"
    return "use its .nanoseconds, which is a number"


__all__ = ["time_operator_findings"]
