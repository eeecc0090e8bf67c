"""The operators of a libcst tree, as they are written, and what they make of a number."""

from __future__ import annotations

import libcst as cst

SMALLEST_INTEGER = -(2**63)
LARGEST_INTEGER = 2**64 - 1

_OPERATORS: dict[type[cst.CSTNode], str] = {
    cst.Add: "+",
    cst.AddAssign: "+",
    cst.And: "and",
    cst.BitAnd: "&",
    cst.BitAndAssign: "&",
    cst.BitInvert: "~",
    cst.BitOr: "|",
    cst.BitOrAssign: "|",
    cst.BitXor: "^",
    cst.BitXorAssign: "^",
    cst.Divide: "/",
    cst.DivideAssign: "/",
    cst.Equal: "==",
    cst.FloorDivide: "//",
    cst.FloorDivideAssign: "//",
    cst.GreaterThan: ">",
    cst.GreaterThanEqual: ">=",
    cst.In: "in",
    cst.Is: "is",
    cst.IsNot: "is not",
    cst.LeftShift: "<<",
    cst.LeftShiftAssign: "<<",
    cst.LessThan: "<",
    cst.LessThanEqual: "<=",
    cst.MatrixMultiply: "@",
    cst.MatrixMultiplyAssign: "@",
    cst.Minus: "-",
    cst.Modulo: "%",
    cst.ModuloAssign: "%",
    cst.Multiply: "*",
    cst.MultiplyAssign: "*",
    cst.Not: "not",
    cst.NotEqual: "!=",
    cst.NotIn: "not in",
    cst.Or: "or",
    cst.Plus: "+",
    cst.Power: "**",
    cst.PowerAssign: "**",
    cst.RightShift: ">>",
    cst.RightShiftAssign: ">>",
    cst.Subtract: "-",
    cst.SubtractAssign: "-",
}


def operator_text(operator: cst.CSTNode) -> str:
    """An operator as it is written, without the equals sign of an augmented assignment."""
    return _OPERATORS[operator.__class__]


def folded(op: str, value: int | float) -> int | float | None:
    """What a sign in front of a number makes of it; None where that is no number that is kept."""
    if op == "-":
        return None if value > -SMALLEST_INTEGER and isinstance(value, int) else -value
    if op == "+":
        return value
    if op == "~" and isinstance(value, int) and value < -SMALLEST_INTEGER:
        return ~value
    return None


__all__ = ["LARGEST_INTEGER", "folded", "operator_text"]
