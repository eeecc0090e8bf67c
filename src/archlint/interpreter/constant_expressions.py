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
    match node:
        case ast.Constant(value=None | str() | int() | float()):
            return node.value
        case ast.BoolOp():
            return _decided(node)
        case ast.UnaryOp(op=ast.Not() | ast.USub() | ast.UAdd()):
            return _UNARY[type(node.op)](_value(node.operand))
        case ast.Compare():
            return _compared(node)
        case ast.BinOp() if type(node.op) in _BINARY:
            return _combined(node)
        case ast.IfExp():
            return _value(node.body if _value(node.test) else node.orelse)
        case ast.List() | ast.Tuple() | ast.Set():
            return [_value(item) for item in node.elts]
        case ast.Call(keywords=[]):
            return _call(node)
    raise NotFollowed("an expression that is not followed")


_UNARY: dict[type, Callable[[Any], Any]] = {ast.Not: operator.not_, ast.USub: operator.neg, ast.UAdd: operator.pos}


def _decided(node: ast.BoolOp) -> Any:
    """``and``, ``or``: the first operand that decides, or the last."""
    stop = isinstance(node.op, ast.Or)
    value: Any = None
    for part in node.values:
        value = _value(part)
        if bool(value) is stop:
            return value
    return value


def _compared(node: ast.Compare) -> bool:
    left = _value(node.left)
    for op, part in zip(node.ops, node.comparators, strict=True):
        right = _value(part)
        if type(op) not in _COMPARE:
            raise NotFollowed("a comparison that is not followed")
        if not _COMPARE[type(op)](left, right):
            return False
        left = right
    return True


def _combined(node: ast.BinOp) -> Any:
    left, right = _value(node.left), _value(node.right)
    texts = any(isinstance(side, (str, list, tuple)) for side in (left, right))
    if texts and not isinstance(node.op, ast.Add):
        raise NotFollowed("an operation on strings that is not followed")
    return _BINARY[type(node.op)](left, right)


_FUNCTIONS: dict[str, Callable[..., Any]] = {"str": str, "int": int, "float": float, "bool": bool, "len": len}
_METHODS = frozenset({"lower", "upper", "strip", "startswith", "endswith", "replace", "split"})


def _call(node: ast.Call) -> Any:
    arguments = [_value(argument) for argument in node.args]
    if any(not isinstance(argument, (str, int, float, list)) for argument in arguments):
        raise NotFollowed("a call that is not followed")
    match node.func:
        case ast.Name(id=name) if name in _FUNCTIONS and len(arguments) == 1:
            return _FUNCTIONS[name](arguments[0])
        case ast.Attribute(attr=name) if name in _METHODS:
            receiver = _value(node.func.value)
            if all(isinstance(part, str) for part in (receiver, *arguments)):
                result = getattr(receiver, name)(*arguments)
                if isinstance(result, (bool, list)) or len(result) <= LIMIT:
                    return result
    raise NotFollowed("a call that is not followed")
