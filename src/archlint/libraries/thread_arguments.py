"""Numbers that a thread is given in place of a tuple of arguments: ``args=(speed)``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.interpreter.values import BoundMethod, FunctionValue, Unknown, alternatives
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.interpreter.values import Value

_ORDER = frozenset({"<", "<=", ">", ">="})


def number_given(bound: Mapping[str, Value], written: Mapping[str, facts.Expr]) -> str:
    """The variable that a thread is given as its arguments and that is the number which its function takes: the only
    parameter there has the same name, and is compared with numbers.  Empty for anything else."""
    name = written["args"].variable if "args" in written else ""
    target, own = bound.get("target"), 0
    if isinstance(target, BoundMethod):
        target, own = target.function, 1
    if not name or not isinstance(target, FunctionValue) or "kwargs" in bound or "args" not in bound:
        return ""
    function = target.ir
    if not isinstance(function, facts.Function) or function.decorators or not _may_be_number(bound["args"]):
        return ""
    if [(param.name, param.kind) for param in function.params[own:]] != [(name, "normal")]:
        return ""
    return name if any(_is_with_number(test, name) for test in everything_in(function.body, facts.Compare)) else ""


def _may_be_number(value: Value) -> bool:
    """Whether nothing else is known of a value."""
    return all(isinstance(option, Unknown) or type(option.constant) in (int, float) for option in alternatives(value))


def _is_with_number(test: facts.Compare, name: str) -> bool:
    """Whether a name is compared with a number written there, by its order."""
    sides = [test.left, *test.comparators]
    return (
        len(sides) == 2
        and test.ops[0] in _ORDER
        and any(side.variable == name for side in sides)
        and any(isinstance(side, facts.Literal) and type(side.value) in (int, float) for side in sides)
    )


__all__ = ["number_given"]
