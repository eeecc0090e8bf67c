"""Python's own functions and the methods of its texts and collections, as far as names need them."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import partial
from typing import TYPE_CHECKING, Any

from archlint.interpreter import containers, decisions, formatting
from archlint.interpreter.attributes import get_attribute, set_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.constant_expressions import NotFollowed, evaluate
from archlint.interpreter.definitions import allocate
from archlint.interpreter.machine import Phase
from archlint.interpreter.type_tests import isinstance_of
from archlint.interpreter.value_methods import Arguments, Keywords, call_method, in_order, update_entries
from archlint.interpreter.values import (
    FALSE,
    NONE,
    TRUE,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    EachValue,
    External,
    ForeignValue,
    FunctionValue,
    Instance,
    Items,
    Known,
    ListKind,
    ListValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
    as_default,
    constant,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def call_builtin(machine: Machine, function: Builtin, site: CallSite) -> Value:
    """Call a function of Python's own, or a method of a text or a collection."""
    target = function.self_value
    if target is not None:
        return call_method(machine, target, function.name.rpartition(".")[2], site)
    found = _call_known(machine, function.name, site)
    if function.name in _LEAVE_ALONE:
        return found
    return machine.library.lost(found, site.values, f"it is passed to {function.name}()")


def _call_known(machine: Machine, name: str, site: CallSite) -> Value:
    handler = BUILTINS.get(name)
    if handler is None:
        return Unknown(f"{name}() is not followed")
    if site.open and name not in ("print", "dict", "set", "list"):
        return Unknown(f"{name}() of arguments that are not known")
    return handler(machine, site.args, site.keywords, site.expression)


_LEAVE_ALONE = frozenset(
    {"print", "str", "repr", "format", "int", "float", "bool", "abs", "round", "len", "range", "any", "all"}
    | {"isinstance", "issubclass", "callable", "hasattr", "getattr", "id", "hash", "dir", "vars", "super"}
)
"""Functions of Python's own that keep nothing of what they are given."""


def _first(args: Arguments, why: str = "an argument is missing") -> Value:
    return args[0] if args else Unknown(why)


def _nothing(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    return NONE


def _unknown(what: str) -> Callable[..., Value]:
    def handler(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
        return Unknown(reason(*args) if args else what)

    return handler


def _of_the_world(machine: Machine, args: Arguments, keywords: Keywords, e: facts.Call | None, name: str) -> Value:
    """What asks for something outside of the program."""
    return machine.library.call_builtin(Builtin(name), CallSite(args, keywords, e))


def _str(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if not args:
        return Known("")
    found = []
    for option in alternatives(args[0]):
        text = formatting.text_of(machine, option)
        found.append(_as_text(text) if isinstance(text, Known) else text)
    return one_of(found)


def _as_text(value: Known) -> Known:
    """``str(value)``: of a path, a text like any other."""
    return Known(str(value.value), value.via, value.origin, "other" if value.kind == "path" else value.kind)


def _number(convert: Callable[[Any], Any]) -> Callable[..., Value]:
    def handler(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
        if not args:
            return Known(convert()) if isinstance(convert, type) else Unknown("a call that fails")
        rest = [*args[1:], *keywords.values()]
        base = [value.value for value in rest if isinstance(value, Known)]
        if len(base) < len(rest):
            return Unknown(reason(*rest))
        found: list[Value] = []
        for option in alternatives(args[0]):
            if isinstance(option, Known):
                try:
                    found.append(constant(convert(option.value, *base), option.via | via(*rest)))
                except (TypeError, ValueError, OverflowError):
                    found.append(Unknown("a conversion that fails"))
            else:
                found.append(Unknown(reason(option), next(iter(sorted(via(option))), None)))
        return one_of(found)

    return handler


def _eval(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    """``eval('True')``: how launch files turn an argument's text into a value.  Constants only; nothing runs."""
    found: list[Value] = []
    for option in alternatives(_first(args)):
        value: object = None
        if isinstance(option, Known) and isinstance(option.value, str):
            try:
                value = evaluate(option.value)
            except NotFollowed:
                value = None
        if isinstance(value, (str, int, float)):
            found.append(Known(value, via(option)))
        else:
            found.append(Unknown("the result of eval()"))
    return one_of(found)


def _bool(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if not args:
        return FALSE
    if isinstance(args[0], Known):
        return Known(bool(args[0].value), args[0].via)
    known = decisions.truth(machine, args[0])
    return Unknown(reason(args[0])) if known is None else Known(known)


def _len(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    value = _first(args)
    if isinstance(value, Known) and isinstance(value.value, str):
        return Known(len(value.value), value.via)
    if isinstance(value, Known):
        return Unknown("the length of a number")
    items = containers.iterate(machine, value)
    if items is None or items.open or isinstance(value, OneOf):
        return Unknown("the length of a collection that is not known")
    if (
        isinstance(value, ListValue)
        and value.kind == "set"
        and not all(isinstance(item, Known) for item in items.values)
    ):
        return Unknown("how many items of this set are the same")
    return Known(len(items.values))


def _range(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    numbers = [arg.value for arg in args if isinstance(arg, Known) and isinstance(arg.value, int)]
    if not args or len(numbers) != len(args):
        return Unknown(reason(*args), next(iter(sorted(via(*args))), None))
    try:
        wanted = range(*numbers)
    except (TypeError, ValueError):
        return Unknown("a range that fails")
    if wanted[containers.ITEM_LIMIT :]:  # its length may be too large a number for len()
        return Unknown("a range too long to follow")
    return containers.new_list(machine, [Known(number, via(*args)) for number in wanted])


def _rows(row: list[Value], machine: Machine) -> Value:
    return EachValue(containers.new_list(machine, row, "tuple"))


def _element(value: Value) -> Value:
    return value.element if isinstance(value, EachValue) else Unknown("an item beside others")


def _enumerate(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    items = containers.iterate(machine, _first(args))
    start = args[1] if len(args) > 1 else keywords.get("start", Known(0))
    if isinstance(_first(args), EachValue):
        return _rows([Unknown("the number of an item"), _element(_first(args))], machine)
    if items is None:
        return Unknown(reason(*args))
    rows: list[Value] = []
    for number, item in enumerate(items.values):
        at = Known(start.value + number) if isinstance(start, Known) and isinstance(start.value, int) else start
        rows.append(containers.new_list(machine, [at, item], "tuple"))
    return containers.new_list(machine, rows, "list", items.open)


def _zip(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if any(isinstance(arg, EachValue) for arg in args):
        return _rows([_element(arg) for arg in args], machine)
    columns = [containers.iterate(machine, arg) for arg in args]
    if not columns or any(column is None for column in columns):
        return Unknown(reason(*args))
    known = [column for column in columns if column is not None]
    rows: list[Value] = [
        containers.new_list(machine, list(row), "tuple")
        for row in zip(*(column.values for column in known), strict=False)
    ]
    return containers.new_list(machine, rows, "list", any(column.open for column in known))


def _collect(kind: ListKind) -> Callable[..., Value]:
    def handler(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
        if not args:
            return containers.new_list(machine, [], kind)
        found: list[Value] = []
        for option in alternatives(args[0]):
            if isinstance(option, EachValue):
                found.append(option)
                continue
            items = containers.iterate(machine, option)
            if items is None:
                found.append(Unknown(reason(option), next(iter(sorted(via(option))), None)))
                continue
            found.append(containers.new_list(machine, items.values, kind, items.open))
        return one_of(found)

    return handler


def _reversed(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if isinstance(_first(args), EachValue):
        return _first(args)
    items = containers.iterate(machine, _first(args))
    if items is None:
        return Unknown(reason(*args))
    return containers.new_list(machine, list(reversed(items.values)), "list", items.open)


def _sorted(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if isinstance(_first(args), EachValue):
        return _first(args)
    items = containers.iterate(machine, _first(args))
    if items is None:
        return Unknown(reason(*args))
    return containers.new_list(machine, in_order(items.values, keywords), "list", items.open)


def _dict(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    entries: dict[Hashable, tuple[Value, Value]] = {}
    open_ = False
    if args:
        open_ = not update_entries(machine, entries, args[0])
    for name, value in keywords.items():
        at = containers.hashable(Known(name))
        assert at is not None
        entries[at] = (Known(name), value)
    return containers.new_dict(machine, entries, open_)


def _getattr(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if len(args) < 2:
        return Unknown("getattr() without a name")
    found = []
    for name in alternatives(args[1]):
        if isinstance(name, Known) and isinstance(name.value, str):
            value = get_attribute(machine, args[0], name.value)
            if isinstance(value, External) and name.via:
                value = External(value.path, value.via | name.via)
            missing = _is_missing(machine, value)
            found.append(as_default(args[2]) if missing and len(args) > 2 else value)
            if isinstance(value, Unknown) and not missing and len(args) > 2:
                found.append(as_default(args[2]))
        else:
            found.append(Unknown(reason(name)))
    return one_of(found)


def _is_missing(machine: Machine, value: Value) -> bool:
    """Whether an object certainly lacks an attribute: neither its class here nor a foreign base has it."""
    if isinstance(value, Unknown):
        return value.missing is not None
    return isinstance(value, ApiMethod) and machine.library.lacks(value)


def _setattr(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if len(args) == 3 and isinstance(args[1], Known) and isinstance(args[1].value, str):
        set_attribute(machine, args[0], args[1].value, args[2])
    else:
        machine.library.escaped(args[2:], "setattr() stores it under a name that is not known")
    return NONE


def _hasattr(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if len(args) != 2 or not isinstance(args[1], Known) or not isinstance(args[1].value, str):
        return Unknown("hasattr() of a name that is not known")
    known = machine.library.has_attribute(args[0], args[1].value) if isinstance(args[0], ForeignValue) else None
    if known is not None:
        return known
    if not isinstance(args[0], Instance) or not isinstance(args[0].cls, ClassValue):
        return Unknown("hasattr() of an object that is not followed")
    value = get_attribute(machine, args[0], args[1].value)
    if _is_missing(machine, value):
        return FALSE if machine.phase is Phase.START else Unknown("whether it is set by then")
    return Unknown(value.reason) if isinstance(value, Unknown) else TRUE


def _map(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if len(args) != 2:
        return Unknown("map() over several collections")
    items = containers.iterate(machine, args[1])
    if items is None:
        return Unknown(reason(args[1]))
    return containers.new_list(
        machine, [machine.call(args[0], CallSite([item])) for item in items.values], "list", items.open
    )


def _filter(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    if len(args) == 2 and isinstance(args[1], EachValue):
        return args[1]
    items = containers.iterate(machine, args[1]) if len(args) == 2 else None
    if items is None:
        return Unknown("what filter() leaves")
    kept: list[Value] = []
    open_ = items.open
    for item in items.values:
        verdict = decisions.truth(machine, item if args[0] == NONE else machine.call(args[0], CallSite([item])))
        if verdict is not False:
            kept.append(item)
        open_ = open_ or verdict is None
    return containers.new_list(machine, kept, "list", open_)


def _extreme(pick: Callable[..., Any]) -> Callable[..., Value]:
    def handler(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
        if len(args) == 1 and isinstance(args[0], EachValue):
            return args[0].element
        items = containers.iterate(machine, args[0]) if len(args) == 1 else Items(tuple(args))
        if items is None or items.open or "key" in keywords:
            return Unknown(reason(*args))
        values = [item.value for item in items.values if isinstance(item, Known)]
        if len(values) != len(items.values) or not values:
            return Unknown(reason(*items.values))
        try:
            return constant(pick(values), via(*items.values))
        except (TypeError, OverflowError):
            return Unknown("an operation that fails")

    return handler


def _sum(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    """Of numbers the sum; of lists, ``sum(lists, [])``, one list with all that they hold."""
    start = args[1] if len(args) == 2 else keywords.get("start")
    if not isinstance(start, ListValue) or start.kind != "list":
        return _extreme(sum)(machine, args, {}, e) if start is None else Unknown(reason(*args))
    lists = containers.iterate(machine, args[0])
    parts = None if lists is None else [containers.iterate(machine, one) for one in (start, *lists.values)]
    known = [part for part in parts or () if part is not None]
    if lists is None or parts is None or len(known) != len(parts):
        return Unknown(reason(*args))
    values = [value for part in known for value in part.values]
    return containers.new_list(machine, values, "list", lists.open or any(part.open for part in known))


def _any_all(wanted: bool) -> Callable[..., Value]:
    def handler(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
        items = containers.iterate(machine, _first(args))
        if items is None:
            return Unknown(reason(*args))
        verdicts = [decisions.truth(machine, item) for item in items.values]
        if wanted in verdicts:
            return Known(wanted)
        return Unknown("not all items are known") if None in verdicts or items.open else Known(not wanted)

    return handler


def _type(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    value = _first(args)
    if isinstance(value, Instance):
        return value.cls
    cls = machine.library.class_of(value) if isinstance(value, ForeignValue) else None
    return Unknown("the type of a value") if cls is None else cls


def _callable(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    value = _first(args)
    if isinstance(value, (FunctionValue, BoundMethod, ClassValue, Partial)):
        return TRUE
    return FALSE if isinstance(value, Known) else Unknown(reason(value))


def _next(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    first = _first(args)
    if isinstance(first, EachValue):
        return one_of((first.element, *args[1:]))
    items = containers.iterate(machine, first)
    if items is not None and items.values:
        return one_of(items.values)
    return args[1] if len(args) > 1 and items is not None and not items.open else Unknown("an item of an iterator")


def _same(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    return _first(args)


def _object_new(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    return allocate(machine, args[0]) if args and isinstance(args[0], ClassValue) else Unknown("an object")


def _object_setattr(machine: Machine, args: Arguments, keywords: Keywords, e: object) -> Value:
    """``object.__setattr__(self, 'x', value)``: how frozen dataclasses fill themselves."""
    return _setattr(machine, args, keywords, e)


BUILTINS: dict[str, Callable[..., Value]] = {
    "object.__new__": _object_new,
    "object.__setattr__": _object_setattr,
    "print": _nothing,
    "str": _str,
    "repr": _unknown("a repr"),
    "int": _number(int),
    "float": _number(float),
    "bool": _bool,
    "abs": _number(abs),
    "round": _unknown("a rounded number"),
    "len": _len,
    "range": _range,
    "enumerate": _enumerate,
    "zip": _zip,
    "list": _collect("list"),
    "tuple": _collect("tuple"),
    "set": _collect("set"),
    "frozenset": _collect("set"),
    "iter": _same,
    "reversed": _reversed,
    "sorted": _sorted,
    "dict": _dict,
    "getattr": _getattr,
    "setattr": _setattr,
    "hasattr": _hasattr,
    "isinstance": isinstance_of,
    "issubclass": _unknown("a class relation"),
    "map": _map,
    "filter": _filter,
    "min": _extreme(min),
    "max": _extreme(max),
    "sum": _sum,
    "any": _any_all(True),
    "all": _any_all(False),
    "type": _type,
    "callable": _callable,
    "next": _next,
    "input": partial(_of_the_world, name="input"),
    "open": partial(_of_the_world, name="open"),
    "id": _unknown("an identity"),
    "hash": _unknown("a hash"),
    "vars": _unknown("the attributes of an object"),
    "dir": _unknown("the attributes of an object"),
    "object": _unknown("an object"),
    "property": _same,
    "staticmethod": _same,
    "classmethod": _same,
    "super": _unknown("super()"),
    "chr": _unknown("a character"),
    "ord": _unknown("a character"),
    "eval": _eval,
    "exec": _nothing,
    "exit": _nothing,
    "quit": _nothing,
    "bytes": _unknown("bytes"),
    "bytearray": _unknown("bytes"),
    "memoryview": _unknown("bytes"),
    "complex": _unknown("a number"),
    "divmod": _unknown("a number"),
    "pow": _unknown("a number"),
    "format": _unknown("a formatted text"),
    "globals": _unknown("the variables"),
    "locals": _unknown("the variables"),
    "__import__": _unknown("a module"),
    "hex": _unknown("a number"),
    "bin": _unknown("a number"),
    "slice": _unknown("a slice"),
    **{
        name: _unknown("an exception")
        for name in [
            "Exception",
            "BaseException",
            "RuntimeError",
            "ValueError",
            "TypeError",
            "KeyError",
            "IndexError",
            "AttributeError",
            "OSError",
            "IOError",
            "ImportError",
            "NotImplementedError",
            "KeyboardInterrupt",
            "SystemExit",
            "TimeoutError",
            "StopIteration",
            "AssertionError",
            "ConnectionError",
            "FileNotFoundError",
            "PermissionError",
            "ZeroDivisionError",
            "ArithmeticError",
        ]
    },
}


__all__ = ["BUILTINS", "call_builtin"]
