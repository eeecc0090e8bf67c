"""``PythonExpression`` and ``$(eval …)``: what Python makes of a text, and the texts that it refuses.

Source: ``PythonExpression.perform`` of launch evaluates the text with the names of ``math``, and with those of the
modules that it is given.
"""

from __future__ import annotations

import ast
import builtins
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter import constant_expressions
from archlint.interpreter.values import Known, Unknown, Value
from archlint.launch.mistakes import RefusedExpression
from archlint.launch.objects import LaunchObject
from archlint.launch.substitutions.texts import each_text

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def python_expression(run: LaunchRun, value: LaunchObject) -> Value:
    """What an expression comes to."""
    text = run.perform(value.argument("expression"))
    if isinstance(text, Known) and not run.is_conditional and not run.result.arguments and not value.rest:
        _note_refused(run, value, str(text.value))
    return each_text(text, _evaluated)


def _evaluated(expression: str) -> Value:
    try:
        return Known(str(constant_expressions.evaluate(expression)))
    except constant_expressions.NotFollowed as error:
        return Unknown(str(error))


_KNOWN = frozenset(dir(builtins)) | frozenset(dir(math)) | {"math"}


def _note_refused(run: LaunchRun, value: LaunchObject, text: str) -> None:
    """Note an expression at which a launch with the defaults of its arguments stops."""
    name = refused_name(text)
    if name is None or value.open or value.argument("python_modules") is not None:
        return
    refused = RefusedExpression(text.strip(), name, value.place or run.place_now)
    if refused not in run.result.expressions:
        run.result.expressions.append(refused)


def refused_name(text: str) -> str | None:
    """The name that an expression surely reads and that Python does not know; None where there is none."""
    if len(text) > constant_expressions.LIMIT or "$(" in text:
        return None
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return next((name for name in _read(tree) if name not in _KNOWN), None)


def _read(node: ast.expr) -> Iterator[str]:
    """The names that an expression reads whatever its parts come to."""
    match node:
        case ast.Name(id=name):
            yield name
        case ast.BoolOp(values=[first, *_]) | ast.IfExp(test=first):
            yield from _read(first)
        case ast.Compare(left=left, comparators=[right, *_]):
            yield from _read(left)
            yield from _read(right)
        case ast.UnaryOp(operand=operand):
            yield from _read(operand)
        case ast.BinOp(left=left, right=right):
            yield from _read(left)
            yield from _read(right)


__all__ = ["python_expression", "refused_name"]
