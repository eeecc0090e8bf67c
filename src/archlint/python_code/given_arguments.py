"""What a handler with ``*args`` can tell of them: rclpy calls it with a request and a response, whoever else calls it
with less."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.model import Role
from archlint.python_code.class_chains import targets_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.comparisons import COMPARISONS
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.model import Callback

_GIVEN: Mapping[Role, int] = {Role.SERVICE: 2}
"""With how many arguments rclpy calls a callback."""


@dataclass(frozen=True)
class GivenArguments:
    """How many arguments rclpy leaves for the parameter ``*name``."""

    name: str
    count: int

    def rules_out(self, test: facts.Expr, truth: bool) -> bool:
        """Whether a test cannot come out so: ``if args``, ``if len(args) == 2``."""
        holds = self._holds(test)
        return holds is not None and holds is not truth

    def _holds(self, test: facts.Expr) -> bool | None:
        match test:
            case facts.Unary(op="not", operand=inner):
                holds = self._holds(inner)
                return None if holds is None else not holds
            case facts.Compare(left=left, ops=[op], comparators=[facts.Literal(value=int(number))]) if (
                op in COMPARISONS
            ):
                return COMPARISONS[op](self.count, number) if self._is_length(left) else None
        return self.count > 0 if test.variable == self.name or self._is_length(test) else None

    def _is_length(self, expression: facts.Expr) -> bool:
        match expression:
            case facts.Call(args=[facts.Argument(value=value, star="")]) as call:
                return called_name(call) == "len" and value.variable == self.name
        return False


def given_arguments(callback: Callback, function: facts.Function) -> GivenArguments | None:
    """What rclpy leaves for the ``*args`` of a callback; None where it has none, or sets the name itself."""
    star = next((param.name for param in function.params if param.kind == "star"), "")
    given = _GIVEN.get(callback.role)
    if not star or given is None or any(target.variable == star for target in targets_of(function.body)):
        return None
    named = sum(param.kind in ("positional_only", "normal") for param in function.params)
    return GivenArguments(star, max(0, callback.bound_arguments + given - named))


__all__ = ["GivenArguments", "given_arguments"]
