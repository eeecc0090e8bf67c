"""Methods that were to be constructors: ``_init_``, ``__int__``."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.walk import statements_of

_SLIPS = frozenset({"init", "int", "inti", "ini", "initt", "iniit"})
CONSTRUCTOR = "__init__"


def meant_as_constructor(classes: Sequence[facts.Class]) -> str:
    """The method of one of some classes that was to be their constructor, as it is written; empty where they have one,
    or where none looks like it."""
    names = [_written(each, method.name) for each in classes for method in statements_of(each.body, facts.Function)]
    if CONSTRUCTOR in names:
        return ""
    return next((name for name in names if name.startswith("_") and name.strip("_") in _SLIPS), "")


def _written(cls: facts.Class, name: str) -> str:
    """A private name without the class that Python puts before it."""
    return name.removeprefix(f"_{cls.name.lstrip('_')}") if "__" in name and not name.startswith("__") else name


__all__ = ["CONSTRUCTOR", "meant_as_constructor"]
