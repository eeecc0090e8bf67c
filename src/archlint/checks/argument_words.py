"""What is said of the arguments of a call that do not fit its parameters."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.model import Misuse


def what_does_not_fit(misuse: Misuse, parameters: Sequence[str], takes: int) -> str:
    """What is missing or too much; ``takes`` is how many arguments go by position."""
    names = quoted(parameters)
    match misuse:
        case Misuse.MISSING:
            return f"{names} {'is' if len(parameters) == 1 else 'are'} missing"
        case Misuse.TOO_MANY if not takes:
            return "it takes no argument"
        case Misuse.TOO_MANY:
            return f"it takes at most {takes} {'argument' if takes == 1 else 'arguments'} by position"
        case Misuse.UNKNOWN_KEYWORD:
            return f"it has no parameter {names}"
    return f"{names} is given by position and by name"


def quoted(names: Sequence[str]) -> str:
    """Names in quotes: ``'a', 'b' and 'c'``."""
    return " and ".join(filter(None, (", ".join(map(repr, names[:-1])), *map(repr, names[-1:]))))


__all__ = ["quoted", "what_does_not_fit"]
