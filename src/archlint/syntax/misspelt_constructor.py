"""Methods that were to be constructors (``_init_``, ``__int__``), and calls of such (``super().__init()``)."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
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


@once_for
def has_misspelt_call(cls: facts.Class) -> bool:
    """Whether a class calls what was to be the constructor of its base, with which Python does not get further."""
    return any(map(is_misspelt_call, everything_in(cls.body, facts.Call)))


def is_misspelt_call(call: facts.Call) -> bool:
    """Whether a call was to be ``super().__init__()``.  A private name has the class before it."""
    match call.func:
        case facts.Attribute(value=facts.Call(func=facts.Name(id="super")), attr=name) if name != CONSTRUCTOR:
            return name.rpartition("__")[2].strip("_") in _SLIPS or name.strip("_") in _SLIPS
    return False


def _written(cls: facts.Class, name: str) -> str:
    """A private name without the class that Python puts before it."""
    return name.removeprefix(f"_{cls.name.lstrip('_')}") if "__" in name and not name.startswith("__") else name


__all__ = ["CONSTRUCTOR", "has_misspelt_call", "is_misspelt_call", "meant_as_constructor"]
