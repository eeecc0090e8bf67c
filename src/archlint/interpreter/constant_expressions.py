"""Texts that hold a Python expression over constants: comparisons, boolean and arithmetic operators; nothing runs."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from typing import Any

LIMIT = 2_000
NESTING = 40


class NotFollowed(Exception):
    """An expression with more in it than is followed."""


_COMPARE: dict[type, Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda a, b: a in b,
    ast.NotIn: lambda a, b: a not in b,
    ast.Is: lambda a, b: a is b,
    ast.IsNot: lambda a, b: a is not b,
}
_BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}


def evaluate(text: str) -> object:
    """The value of a Python expression over constants.  Raises :class:`NotFollowed` for anything else."""
    text = text.strip()
    depth = deepest = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        deepest = max(deepest, depth)
    if len(text) > LIMIT or deepest > NESTING:
        raise NotFollowed("an expression too long to follow")
    try:
        return _value(ast.parse(text, mode="eval").body)
    except NotFollowed:
        raise
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise NotFollowed("an expression that is not Python") from None
    except (TypeError, ArithmeticError, LookupError):
        raise NotFollowed("an expression that fails") from None


def _value(node: ast.expr) -> Any:
    if isinstance(node, ast.Constant) and isinstance(node.value, (str, int, float, bool, type(None))):
        return node.value
    if isinstance(node, ast.BoolOp):
        stop = isinstance(node.op, ast.Or)
        value: Any = None
        for part in node.values:
            value = _value(part)
            if bool(value) is stop:
                return value
        return value
    if isinstance(node, ast.UnaryOp):
        operand = _value(node.operand)
        if isinstance(node.op, ast.Not):
            return not operand
        if isinstance(node.op, ast.USub):
            return -operand
        if isinstance(node.op, ast.UAdd):
            return +operand
    if isinstance(node, ast.Compare):
        left = _value(node.left)
        for op, part in zip(node.ops, node.comparators, strict=True):
            right = _value(part)
            if type(op) not in _COMPARE:
                raise NotFollowed("a comparison that is not followed")
            if not _COMPARE[type(op)](left, right):
                return False
            left = right
        return True
    if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        left, right = _value(node.left), _value(node.right)
        texts = isinstance(left, (str, list, tuple)) or isinstance(right, (str, list, tuple))
        if texts and not isinstance(node.op, ast.Add):
            raise NotFollowed("an operation on texts that is not followed")
        return _BINARY[type(node.op)](left, right)
    if isinstance(node, ast.IfExp):
        return _value(node.body if _value(node.test) else node.orelse)
    if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
        return [_value(item) for item in node.elts]
    if isinstance(node, ast.Call) and not node.keywords:
        return _call(node)
    raise NotFollowed("an expression that is not followed")


_FUNCTIONS: dict[str, Callable[..., Any]] = {"str": str, "int": int, "float": float, "bool": bool, "len": len}
_METHODS = frozenset({"lower", "upper", "strip", "startswith", "endswith", "replace", "split"})


def _call(node: ast.Call) -> Any:
    arguments = [_value(argument) for argument in node.args]
    if any(not isinstance(argument, (str, int, float, bool, list)) for argument in arguments):
        raise NotFollowed("a call that is not followed")
    if isinstance(node.func, ast.Name) and node.func.id in _FUNCTIONS and len(arguments) == 1:
        return _FUNCTIONS[node.func.id](arguments[0])
    if isinstance(node.func, ast.Attribute) and node.func.attr in _METHODS:
        receiver = _value(node.func.value)
        if isinstance(receiver, str) and all(isinstance(argument, str) for argument in arguments):
            found = getattr(receiver, node.func.attr)(*arguments)
            if isinstance(found, (bool, list)) or len(found) <= LIMIT:
                return found
    raise NotFollowed("a call that is not followed")
