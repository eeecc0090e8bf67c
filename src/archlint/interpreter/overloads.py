"""Functions of C++ that share a name: which of them a call means."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import FunctionValue, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite

Overloads = dict[tuple[int, str], list[object]]
"""The functions of each class or file, by its key and their name, in the order of their definitions; the same by the
``id`` of the facts of each."""

MOST = 100
"""How many functions of one name are told apart."""


def note(overloads: Overloads, owner: int, name: str, value: Value) -> None:
    """A class or a file of C++ gets one more function."""
    if isinstance(value, FunctionValue) and value.scope.module.file.kind == "cpp":
        known = overloads.setdefault((owner, name), [])
        if len(known) < MOST and all(function.ir is not value.ir for function in _functions(known)):
            known.append(value)
            overloads[_of_function(value)] = known  # of the class, where a file defines a method outside of it


def all_of(overloads: Overloads, function: FunctionValue) -> list[FunctionValue]:
    """The functions that share the name of one, itself among them."""
    if function.scope.module.file.kind != "cpp":
        return [function]
    return _functions(overloads.get(_of_function(function), [])) or [function]


def _of_function(function: FunctionValue) -> tuple[int, str]:
    """Under which key the functions are that share the name of one."""
    return id(function.ir), ""


def _functions(row: list[object]) -> list[FunctionValue]:
    return [function for function in row if isinstance(function, FunctionValue)]


def meant(overloads: Overloads, function: FunctionValue, site: CallSite) -> FunctionValue:
    """The one that takes as many arguments as are given; where none does, the shortest that could with the defaults of
    its declaration, which a definition outside of the class does not repeat; else the one that takes the fewest.

    Types are not compared: of several that fit it is the one that was found by the name.
    """
    functions = all_of(overloads, function)
    if len(functions) < 2:
        return function
    given = len(site.args)
    fitting = [other for other in functions if _required(other) <= given <= _accepted(other)]
    if not fitting:
        with_defaults = [other for other in functions if given <= _accepted(other)]
        return min(with_defaults, key=_accepted) if with_defaults else min(functions, key=_required)
    return next((other for other in fitting if other.ir is function.ir), fitting[-1])


def _accepted(function: FunctionValue) -> int:
    if any(param.kind == "star" for param in function.ir.params):
        return MOST
    return sum(param.kind == "normal" for param in function.ir.params)


def _required(function: FunctionValue) -> int:
    defaults = {name for name, _ in function.defaults}
    return sum(param.kind == "normal" and param.name not in defaults for param in function.ir.params)


__all__ = ["Overloads", "all_of", "meant", "note"]
