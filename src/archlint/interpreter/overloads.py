"""Functions of C++ that share a name: which of them a call means."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import FunctionValue, Known, Value

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

    Of several that take as many it is the one whose parameters have the types of the constants and the classes of the
    objects that are given; types that say nothing leave the one that was found by the name.
    """
    functions = all_of(overloads, function)
    if len(functions) < 2:
        return function
    given = len(site.args)
    fitting = [other for other in functions if _required(other) <= given <= _accepted(other)]
    if not fitting:
        with_defaults = [other for other in functions if given <= _accepted(other)]
        return min(with_defaults, key=_accepted) if with_defaults else min(functions, key=_required)
    fitting = _of_given_types(fitting, site)
    return next((other for other in fitting if other.ir is function.ir), fitting[-1])


def _of_given_types(functions: list[FunctionValue], site: CallSite) -> list[FunctionValue]:
    """Those of some functions whose parameters have the most types in common with the arguments of a call."""
    if len(functions) < 2:
        return functions
    shared = [_types_shared(function, site.args) for function in functions]
    return [function for function, count in zip(functions, shared, strict=True) if count == max(shared)]


def _types_shared(function: FunctionValue, given: Sequence[Value]) -> int:
    """How many arguments have the type of their parameter; -1 where one has another: a text for a number, or the
    reverse, or an object for one of another class."""
    count = 0
    # An object may be given for one of a class that it is converted to, but for no options, and for no number.
    for param, value in zip(function.ir.params, given, strict=False):
        if param.annotation is None or param.kind == "star":
            continue
        name = param.annotation.dotted
        wanted = _kind_of_type(name)
        kind = _KIND_OF_VALUE.get(value.python_type) if isinstance(value, Known) else None
        if value.class_names and name:
            last = name.rpartition(".")[2].rpartition("::")[2]
            if last not in value.class_names and (wanted is not None or last.endswith("Options")):
                return -1
            count += last in value.class_names
        if kind is None or wanted is None:
            continue
        if "text" in (kind, wanted) and kind != wanted:
            return -1
        count += kind == wanted
    return count


_KIND_OF_VALUE = {str: "text", bool: "bool", int: "integer", float: "number"}
_KIND_OF_TYPE = {"str": "text", "bool": "bool", "int": "integer", "float": "number", "double": "number"}
_INTEGER = re.compile(
    r"(?:std\W+)?(?:u?int\d+_t|size_t)|(?:unsigned |signed )*(?:long|short|unsigned)(?: long)?(?: int)?"
)


def _kind_of_type(name: str) -> str | None:
    """What constants a parameter of a type takes as they are; None for a class, or a type that is not known."""
    return _KIND_OF_TYPE.get(name) or ("integer" if _INTEGER.fullmatch(name) else None)


def _accepted(function: FunctionValue) -> int:
    if any(param.kind == "star" for param in function.ir.params):
        return MOST
    return sum(param.kind == "normal" for param in function.ir.params)


def _required(function: FunctionValue) -> int:
    defaults = {name for name, _ in function.defaults}
    return sum(param.kind == "normal" and param.name not in defaults for param in function.ir.params)


__all__ = ["Overloads", "all_of", "meant", "note"]
