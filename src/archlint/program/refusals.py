"""What Python refuses with a TypeError: a call whose arguments do not fit, a loop over a number.

What stands behind it on the same path never runs.  Only callbacks are cut short there: a program whose start fails is
noticed by whoever starts it, and what its nodes would create still says what they are meant to be.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.facts import model as facts
from archlint.program.values import BoundMethod, FunctionValue, Known, Value

if TYPE_CHECKING:
    from archlint.program.run import Run

_AT_START = frozenset({"init", "main", "module"})
"""Roles of what runs before anything spins."""
_TRANSPARENT = frozenset({"staticmethod", "classmethod"})
"""Decorators that leave a function's parameters as they are."""


class Refused(Exception):
    """Ends the path that runs: the statement raises a TypeError."""


def check_call(
    run: Run, function: Value, args: Sequence[Value], keywords: Mapping[str, Value], open_arguments: bool
) -> None:
    """Raise Refused where a call of a function of the workspace cannot bind its arguments, if the statement always
    comes to that call."""
    if not open_arguments and _is_certain(run) and _refuses(function, len(args), keywords):
        raise Refused


def refuses_to_iterate(run: Run, iterable: Value) -> bool:
    """Whether a ``for`` over a value fails: ``for i in len(items)``."""
    number = isinstance(iterable, Known) and isinstance(iterable.value, (int, float)) and not iterable.via
    return number and run.context.role not in _AT_START


def _is_certain(run: Run) -> bool:
    activation = run.activation
    if run.context.role in _AT_START or activation.scope.kind == "comprehension":
        return False
    return activation.settled == len(run.arms)


def _refuses(function: Value, given: int, keywords: Mapping[str, Value]) -> bool:
    if isinstance(function, BoundMethod):
        function, given = function.function, given + 1
    if not isinstance(function, FunctionValue):
        return False
    ir = function.ir
    if isinstance(ir, facts.Function) and (
        len(ir.decorators) != len(function.decorators) or not function.decorators <= _TRANSPARENT
    ):
        return False
    return not _binds(ir.params, given, keywords)


def _binds(params: Sequence[facts.Param], given: int, keywords: Mapping[str, Value]) -> bool:
    kinds = {param.kind for param in params}
    positional = [param for param in params if param.kind in ("positional_only", "normal")]
    if given > len(positional) and "star" not in kinds:
        return False
    left = [*positional[given:], *(param for param in params if param.kind == "keyword_only")]
    by_name = {param.name for param in left if param.kind != "positional_only"}
    taken = {param.name for param in positional[:given] if param.kind == "normal"}
    named = keywords.keys()
    if taken & named or ("double_star" not in kinds and not named <= by_name):
        return False
    return all(param.default is not None or (param.name in by_name and param.name in named) for param in left)
