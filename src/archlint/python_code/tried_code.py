"""Code that is told of an error which it expects."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

OF_A_WRONG_KIND = frozenset({"TypeError", "AttributeError"})
"""What Python raises where a value is of another kind than the code takes it for."""


def tried_for(body: Sequence[facts.Stmt], errors: Iterable[str]) -> set[Itself[facts.Base]]:
    """What is tried in a body, where a handler catches one of these errors by name or by a base of it."""
    names = frozenset(errors)
    return {
        Itself(part)
        for attempt in everything_in(body, facts.Try)
        if any(not handler.caught.isdisjoint(names) for handler in attempt.handlers)
        for part in everything_in(attempt.body)
    }


__all__ = ["OF_A_WRONG_KIND", "tried_for"]
