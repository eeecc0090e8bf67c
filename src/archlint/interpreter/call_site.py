"""One call: what is given, and where it stands."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.syntax import facts


@dataclass(frozen=True)
class CallSite:
    """The arguments of one call, and the expression that makes it (None where no code of the workspace calls)."""

    args: list[Value] = field(default_factory=list)
    keywords: dict[str, Value] = field(default_factory=dict)
    expression: facts.Call | None = None
    open: bool = False
    """True where more arguments may follow than are known: ``*args``, ``**options``."""

    @property
    def values(self) -> list[Value]:
        """All that is given, by position or by name."""
        return [*self.args, *self.keywords.values()]

    @property
    def is_starred(self) -> bool:
        """Whether ``*args`` or ``**options`` is written among the arguments, be it known what is in them."""
        return self.expression is not None and any(argument.star for argument in self.expression.args)

    def after(self, *first: Value) -> CallSite:
        """The same call with other arguments in front: ``self`` of a method, those of a partial."""
        return CallSite([*first, *self.args], self.keywords, self.expression, self.open)


NOTHING_GIVEN = CallSite()
"""A call without arguments, which no code makes."""

__all__ = ["NOTHING_GIVEN", "CallSite"]
