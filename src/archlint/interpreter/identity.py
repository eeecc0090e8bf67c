"""What tells one value from another: within a run, and over several runs of the same code."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from archlint.interpreter.bindings import bound_names
from archlint.interpreter.values import (
    ApiMethod,
    AttributesValue,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    EachValue,
    EntityValue,
    External,
    FunctionValue,
    FutureValue,
    Holed,
    Instance,
    Known,
    ListValue,
    MessageValue,
    ModuleValue,
    OneOf,
    Partial,
    PythonValue,
    Scope,
    SuperValue,
    Unknown,
    Value,
)
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from archlint.interpreter.machine import Run

_NESTED = 16
"""How deep a value is looked into: a partial may hold partials."""

Key = tuple[Hashable, ...]


class _Itself:
    """A value that is like itself alone."""

    __slots__ = ("value",)

    def __init__(self, value: object) -> None:
        self.value = value

    def __hash__(self) -> int:
        return id(self.value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Itself) and other.value is self.value


def argument_key(value: Value, nested: int = 0) -> Hashable:
    """What tells one value from another: constants by value and place, objects by identity."""
    if nested > _NESTED:
        return _Itself(value)
    key = _SHAPES.get(value.__class__)
    if key is not None:
        return (value.__class__.__name__, *key(value, nested + 1))
    identity = getattr(value, "key", None)
    return (value.__class__.__name__, _Itself(value) if identity is None else identity)


def _keys(values: Iterable[Value], nested: int) -> tuple[Hashable, ...]:
    return tuple(argument_key(value, nested) for value in values)


def _of_unknown(value: Unknown, nested: int) -> Key:
    annotation = None if value.annotation is None else argument_key(value.annotation, nested)
    return (value, value.name, annotation)


def _of_function(value: FunctionValue, nested: int) -> Key:
    return (id(value.ir), value.scope.key, tuple((name, argument_key(one, nested)) for name, one in value.defaults))


def _of_partial(value: Partial, nested: int) -> Key:
    named = tuple((name, argument_key(one, nested)) for name, one in value.keywords)
    return (argument_key(value.function, nested), _keys(value.args, nested), named)


def _of_future(value: FutureValue, nested: int) -> Key:
    result = None if value.result is None else argument_key(value.result, nested)
    return (tuple(map(_Itself, value.creations)), value.api, value.place, result)


_SHAPES: dict[type[Value], Callable[..., Key]] = {
    Known: lambda value, _: (value, value.origin, value.kind),
    Unknown: _of_unknown,
    Holed: lambda value, _: (value, value.origin),
    External: lambda value, _: (value, value.via),
    ListValue: lambda value, _: (value.key, value.via),
    DictValue: lambda value, _: (value.key, value.via),
    OneOf: lambda value, nested: _keys(value.values, nested),
    Builtin: lambda value, nested: (
        value.name,
        None if value.self_value is None else argument_key(value.self_value, nested),
    ),
    ModuleValue: lambda value, _: (_Itself(value.module),),
    FunctionValue: _of_function,
    BoundMethod: lambda value, nested: _keys((value.function, value.self_value), nested),
    Partial: _of_partial,
    ApiMethod: lambda value, nested: (value.path, argument_key(value.self_value, nested)),
    FutureValue: _of_future,
    AttributesValue: lambda value, nested: _keys((value.instance,), nested),
    SuperValue: lambda value, nested: _keys((value.owner, value.self_value), nested),
    MessageValue: lambda value, _: (value,),
    EachValue: lambda value, nested: _keys((value.element,), nested),
    PythonValue: lambda value, _: (value.name, _Itself(value.function)),
}
"""What tells values apart that have no identity of their own."""


def kind_key(run: Run, value: Value, nested: int = 0, *, closely: bool = True) -> Hashable:
    """What tells one value from another whenever the code that makes it runs: objects that it makes anew each time
    are alike.  ``closely``: functions differ in what they take along, too."""
    if nested > _NESTED:
        return ()
    if isinstance(value, (Known, External, ClassValue)):
        return value
    if isinstance(value, Holed):
        return value.parts
    if isinstance(value, MessageValue):
        return (value.type, value.part)
    if isinstance(value, (EntityValue, FutureValue)):
        return (getattr(value, "api", ""), *map(_Itself, value.creations))
    if isinstance(value, Instance):
        return (kind_key(run, value.cls, nested + 1), value.place)
    if isinstance(value, FunctionValue) and not closely:
        return id(value.ir)
    parts, deeper = _kind_parts(run, value)
    inner = tuple(kind_key(run, one, nested + deeper, closely=closely) for one in parts)
    return (id(value.ir) if isinstance(value, FunctionValue) else value.__class__.__name__, *inner)


def _kind_parts(run: Run, value: Value) -> tuple[Iterable[Value], int]:
    """The values that a value is made of, and how much deeper they count: functions may close over each other."""
    if isinstance(value, OneOf):
        return value.values, 1
    if isinstance(value, BoundMethod):
        return (value.function, value.self_value), 1
    if isinstance(value, Partial):
        return (value.function, *value.args, *(one for _, one in value.keywords)), 1
    if isinstance(value, FunctionValue):
        return [*(one for _, one in value.defaults), *_closed_over(run, value)], 4
    return (), 1


def _closed_over(run: Run, function: FunctionValue) -> list[Value]:
    """The variables of the functions around it that a function uses."""
    found: list[Value] = []
    names = names_in(function.ir) - bound_names(function.ir)[0]
    scope: Scope | None = function.scope
    while scope is not None and scope.kind != "module":
        if scope.kind != "class":
            held = (run.store.get(scope.key, name) for name in sorted(names))
            found += [value for value in held if isinstance(value, Value)]
        scope = scope.parent
    return found
