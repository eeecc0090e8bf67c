"""Which function of Python's own does what."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.builtins import aggregates, collections, conversions, reflection
from archlint.interpreter.builtins.handlers import Handler, nothing, same, unknown
from archlint.interpreter.objects.methods import call_method
from archlint.interpreter.values import Builtin, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine


def call_builtin(machine: Machine, function: Builtin, site: CallSite) -> Value:
    """Call a function of Python's own, or a method of a text or a collection."""
    target = function.self_value
    if target is not None:
        return call_method(machine, target, function.name.rpartition(".")[2], site)
    result = _call_known(machine, function.name, site)
    if function.name in _LEAVE_ALONE:
        return result
    return machine.library.lost(result, site.values, f"it is passed to {function.name}()")


def _call_known(machine: Machine, name: str, site: CallSite) -> Value:
    handler = BUILTINS.get(name)
    if handler is None:
        return Unknown(f"{name}() is not followed")
    if site.open and name not in ("print", "dict", "set", "list"):
        return Unknown(f"{name}() of arguments that are not known")
    return handler(machine, site)


_LEAVE_ALONE = frozenset(
    {"print", "str", "repr", "format", "int", "float", "bool", "abs", "round", "len", "range", "any", "all"}
    | {"isinstance", "issubclass", "callable", "hasattr", "getattr", "delattr", "id", "hash", "dir", "vars", "super"}
)
"""Functions of Python's own that keep nothing of what they are given."""


def _external_input(name: str) -> Handler:
    """What asks for something outside of the program."""

    def handler(machine: Machine, site: CallSite) -> Value:
        return machine.library.call_builtin(Builtin(name), site)

    return handler


_EXCEPTIONS = (
    *("ArithmeticError", "AssertionError", "AttributeError", "BaseException", "ConnectionError", "Exception"),
    *("FileNotFoundError", "IOError", "ImportError", "IndexError", "KeyError", "KeyboardInterrupt"),
    *("NotImplementedError", "OSError", "PermissionError", "RuntimeError", "StopIteration", "SystemExit"),
    *("TimeoutError", "TypeError", "ValueError", "ZeroDivisionError"),
)

BUILTINS: dict[str, Handler] = {
    # constants
    "str": conversions.text,
    "int": conversions.number(int),
    "float": conversions.number(float),
    "bool": conversions.boolean,
    "abs": conversions.number(abs),
    "round": conversions.number(round),
    "divmod": aggregates.quotient,
    "eval": conversions.evaluated,
    # collections
    "list": collections.collect("list"),
    "tuple": collections.collect("tuple"),
    "set": collections.collect("set"),
    "frozenset": collections.collect("set"),
    "dict": collections.dictionary,
    "range": collections.numbers,
    "enumerate": collections.enumerated,
    "zip": collections.zipped,
    "iter": same,
    "reversed": collections.in_reverse,
    "sorted": collections.in_sequence,
    "map": collections.mapped,
    "filter": collections.filtered,
    "len": aggregates.length,
    "min": aggregates.extreme(min),
    "max": aggregates.extreme(max),
    "sum": aggregates.total,
    "any": aggregates.any_or_all(True),
    "all": aggregates.any_or_all(False),
    "next": aggregates.following,
    # objects
    "object.__new__": reflection.new_object,
    "object.__setattr__": reflection.assign,
    "getattr": reflection.attribute,
    "setattr": reflection.assign,
    "hasattr": reflection.has,
    "delattr": nothing,
    "isinstance": reflection.is_of,
    "type": reflection.type_of,
    "callable": reflection.can_be_called,
    "property": same,
    "staticmethod": same,
    "classmethod": same,
    # what has no value, or one from elsewhere
    "print": nothing,
    "exec": nothing,
    "exit": nothing,
    "quit": nothing,
    "input": _external_input("input"),
    "open": _external_input("open"),
    # what is not followed
    "repr": unknown("a repr"),
    "issubclass": unknown("a class relation"),
    "id": unknown("an identity"),
    "hash": unknown("a hash"),
    "vars": unknown("the attributes of an object"),
    "dir": unknown("the attributes of an object"),
    "object": unknown("an object"),
    "super": unknown("super()"),
    "chr": unknown("a character"),
    "ord": unknown("a character"),
    "bytes": unknown("bytes"),
    "bytearray": unknown("bytes"),
    "memoryview": unknown("bytes"),
    "complex": unknown("a number"),
    "pow": unknown("a number"),
    "hex": unknown("a number"),
    "bin": unknown("a number"),
    "format": unknown("a formatted string"),
    "globals": unknown("the variables"),
    "locals": unknown("the variables"),
    "__import__": unknown("a module"),
    "slice": unknown("a slice"),
    **{name: unknown("an exception") for name in _EXCEPTIONS},
}

__all__ = ["BUILTINS", "call_builtin"]
