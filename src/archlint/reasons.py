"""Reasons for what is not known that code asks for: texts for people, with a type that says which they are."""

from __future__ import annotations

from typing import Final


class NotPassed(str):
    """Nothing in the workspace calls a function with a value for one of its parameters."""

    __slots__ = ()

    @classmethod
    def as_parameter(cls, name: str) -> NotPassed:
        """The reason why the parameter called ``name`` is not known."""
        return cls(f"nothing in the workspace passes '{name}'")


class Uninformative(str):
    """What is so of most values; who knows what a value is for has better words."""

    __slots__ = ()


NOT_A_CONSTANT: Final = Uninformative("the value is not a constant")


__all__ = ["NOT_A_CONSTANT", "NotPassed", "Uninformative"]
