"""The operators of a libcst tree, as they are written, and what they make of a number."""

from __future__ import annotations

import libcst as cst

from archlint.syntax.expressions import BinaryOperator, BooleanOperator, CompareOperator, UnaryOperator

SMALLEST_INTEGER = -(2**63)
LARGEST_INTEGER = 2**64 - 1

BINARY: dict[type[cst.CSTNode], BinaryOperator] = {
    cst.Add: "+",
    cst.AddAssign: "+",
    cst.BitAnd: "&",
    cst.BitAndAssign: "&",
    cst.BitOr: "|",
    cst.BitOrAssign: "|",
    cst.BitXor: "^",
    cst.BitXorAssign: "^",
    cst.Divide: "/",
    cst.DivideAssign: "/",
    cst.FloorDivide: "//",
    cst.FloorDivideAssign: "//",
    cst.LeftShift: "<<",
    cst.LeftShiftAssign: "<<",
    cst.MatrixMultiply: "@",
    cst.MatrixMultiplyAssign: "@",
    cst.Modulo: "%",
    cst.ModuloAssign: "%",
    cst.Multiply: "*",
    cst.MultiplyAssign: "*",
    cst.Power: "**",
    cst.PowerAssign: "**",
    cst.RightShift: ">>",
    cst.RightShiftAssign: ">>",
    cst.Subtract: "-",
    cst.SubtractAssign: "-",
}
"""Those of augmented assignments, too, without the equals sign."""
UNARY: dict[type[cst.CSTNode], UnaryOperator] = {
    cst.BitInvert: "~",
    cst.Minus: "-",
    cst.Not: "not",
    cst.Plus: "+",
}
BOOLEAN: dict[type[cst.CSTNode], BooleanOperator] = {
    cst.And: "and",
    cst.Or: "or",
}
COMPARE: dict[type[cst.CSTNode], CompareOperator] = {
    cst.Equal: "==",
    cst.GreaterThan: ">",
    cst.GreaterThanEqual: ">=",
    cst.In: "in",
    cst.Is: "is",
    cst.IsNot: "is not",
    cst.LessThan: "<",
    cst.LessThanEqual: "<=",
    cst.NotEqual: "!=",
    cst.NotIn: "not in",
}


def folded(op: UnaryOperator, value: int | float) -> int | float | None:
    """What a sign in front of a number makes of it; None where that is no number that is kept."""
    if op == "-":
        return None if value > -SMALLEST_INTEGER and isinstance(value, int) else -value
    if op == "+":
        return value
    if op == "~" and isinstance(value, int) and value < -SMALLEST_INTEGER:
        return ~value
    return None


__all__ = ["BINARY", "BOOLEAN", "COMPARE", "LARGEST_INTEGER", "UNARY", "folded"]
