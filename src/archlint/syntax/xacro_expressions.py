"""What a text of xacro comes to: ``${…}`` is worked out as far as it is plain, and ``$(arg name)`` stays as it is.

Source: ``eval_text`` of xacro, branches ros2.  What is not known here is None.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from typing import Protocol, TypeAlias

Value: TypeAlias = "str | int | float | bool | None"

_PART = re.compile(r"\$(\$+[{(])|\$\{([^}]*)\}|\$\(([^)]*)\)|[^$]+|\$")
_ARGUMENT = re.compile("\ue000([^\ue001]*)\ue001")
_LONGEST = 300
_LONGEST_RESULT = 2_000
_MOST_HOLES = 3
"""In how many places of a text arguments are looked for in another: each multiplies what a comparison takes."""
_LARGEST = 1e9
_OPERATORS: Mapping[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}
_COMPARISONS: Mapping[type[ast.cmpop], Callable[[str | float, str | float], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
_ORDERS: Mapping[type[ast.cmpop], Callable[[float, float], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}


class Scope(Protocol):
    """What the names of properties and of the parameters of macros stand for."""

    def value_of(self, name: str) -> Value: ...


def evaluated(text: str, scope: Scope) -> Value:
    """What an attribute is set to; the arguments of a description stand in it as ``argument`` writes them."""
    values: list[Value] = []
    for match in _PART.finditer(text):
        escaped, expression, command = match.groups()
        if escaped is not None:
            values.append(escaped)
        elif expression is not None:
            values.append(_of_expression(expression, scope))
        elif command is not None:
            values.append(_of_command(command, scope))
        else:
            values.append(match[0])
    if len(values) == 1:
        return values[0]
    return None if None in values else _short("".join(str(value) for value in values))


def _short(text: str) -> str | None:
    return text if len(text) <= _LONGEST_RESULT else None


def argument(name: str) -> str:
    """What stands for an argument of a description, of which nobody knows the value."""
    return f"\ue000{name}\ue001"


def has_argument(text: str) -> bool:
    return _ARGUMENT.search(text) is not None


def shown(text: str) -> str:
    """A text as xacro has it, with the arguments in it."""
    return _ARGUMENT.sub(lambda match: f"$(arg {match[1]})", text)


def may_be_same(name: str, other: str) -> bool:
    """Whether two texts are the same for some values of the arguments in them."""
    if name == other or (has_argument(name) and has_argument(other)):
        return True
    with_holes, plain = (name, other) if has_argument(name) else (other, name)
    if not has_argument(with_holes):
        return False
    is_long = len(_ARGUMENT.findall(with_holes)) > _MOST_HOLES
    return is_long or _pattern(with_holes).fullmatch(plain) is not None


def _pattern(with_holes: str) -> re.Pattern[str]:
    return re.compile(".*".join(re.escape(part) for part in _ARGUMENT.split(with_holes)[::2]))


def truth(value: Value) -> bool | None:
    """Whether a condition of xacro holds."""
    if isinstance(value, str):
        text = value.strip()
        if text in ("true", "True"):
            return True
        if text in ("false", "False"):
            return False
        return bool(int(text)) if re.fullmatch(r"-?\d{1,9}", text) else None
    return None if value is None else bool(value)


def _of_command(command: str, scope: Scope) -> Value:
    words = command.split()
    if len(words) == 2 and words[0] == "arg":
        return argument(words[1])
    return f"$({' '.join(words)})" if len(words) == 2 and words[0] == "find" else None


def _of_expression(text: str, scope: Scope) -> Value:
    if len(text) > _LONGEST:
        return None
    try:
        tree = ast.parse(text.strip(), mode="eval")
        return _of_tree(tree.body, scope)
    except (ArithmeticError, MemoryError, RecursionError, SyntaxError, ValueError):
        return None


def _of_tree(tree: ast.expr, scope: Scope) -> Value:
    match tree:
        case ast.Constant(value=str() | int() | float() as value):
            return value
        case ast.Name(id=name):
            return scope.value_of(name)
        case ast.BinOp(left=left, op=op, right=right):
            return _joined(type(op), _of_tree(left, scope), _of_tree(right, scope))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            number = _of_tree(operand, scope)
            return None if number is None or isinstance(number, str) else -number
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            holds = _python_truth(_of_tree(operand, scope))
            return None if holds is None else not holds
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return _compared(type(op), _of_tree(left, scope), _of_tree(right, scope))
        case ast.BoolOp(op=op, values=values):
            return _of_several([_python_truth(_of_tree(value, scope)) for value in values], isinstance(op, ast.And))
        case ast.IfExp(test=test, body=body, orelse=orelse):
            holds = _python_truth(_of_tree(test, scope))
            return None if holds is None else _of_tree(body if holds else orelse, scope)
    return None


def _joined(op: type[ast.operator], left: Value, right: Value) -> Value:
    if left is None or right is None:
        return None
    if isinstance(left, str) or isinstance(right, str):
        both = isinstance(left, str) and isinstance(right, str)
        return _short(f"{left}{right}") if both and op is ast.Add else None
    work = _OPERATORS.get(op)
    result = None if work is None else work(left, right)
    return result if result is not None and abs(result) < _LARGEST else None


def _compared(op: type[ast.cmpop], left: Value, right: Value) -> Value:
    if left is None or right is None or any(isinstance(side, str) and has_argument(side) for side in (left, right)):
        return None
    if op in _COMPARISONS:
        return _COMPARISONS[op](left, right)
    if isinstance(left, str) or isinstance(right, str) or op not in _ORDERS:
        return None
    return _ORDERS[op](left, right)


def _of_several(values: list[bool | None], is_all: bool) -> bool | None:
    if (not is_all) in values:
        return not is_all
    return None if None in values else is_all


def _python_truth(value: Value) -> bool | None:
    if value is None or (isinstance(value, str) and has_argument(value)):
        return None
    return bool(value)


__all__ = ["Scope", "Value", "argument", "evaluated", "has_argument", "may_be_same", "shown", "truth"]
