"""What sets one value apart from another: within a run, and over several runs of the same code."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from archlint.interpreter.bindings import bound_names
from archlint.interpreter.modules import Scope
from archlint.interpreter.values import (
    ApiMethod,
    AttributesValue,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    EachValue,
    External,
    ForeignValue,
    FunctionValue,
    Given,
    Holed,
    Instance,
    Known,
    ListValue,
    ModuleValue,
    OneOf,
    Partial,
    PythonValue,
    SuperValue,
    Unknown,
    Value,
)
from archlint.syntax.parts import Itself, names_in

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from archlint.interpreter.heap import Store

_NESTED = 16
"""How deep a value is looked into: a partial may hold partials."""

Key = tuple[Hashable, ...]


def argument_key(value: Value, nested: int = 0) -> Hashable:
    """What sets one value apart from another: constants by value and place, objects by identity."""
    if nested > _NESTED:
        return Itself(value)
    shape = _SHAPES.get(value.__class__)
    if shape is not None:
        return (value.__class__.__name__, *shape(value, nested + 1))
    if isinstance(value, ForeignValue):
        own = value.identity(lambda part: argument_key(part, nested + 1))
        if own is not None:
            return (value.__class__.__name__, *own)
    key = value.heap_key
    return (value.__class__.__name__, Itself(value) if key is None else key)


def _keys(values: Iterable[Value], nested: int) -> tuple[Hashable, ...]:
    return tuple(argument_key(value, nested) for value in values)


def _of_unknown(value: Unknown, nested: int) -> Key:
    annotation = None if value.annotation is None else argument_key(value.annotation, nested)
    return (value, value.name, annotation)


def _of_function(value: FunctionValue, nested: int) -> Key:
    return (
        id(value.ir),
        value.scope.key,
        tuple((name, argument_key(default, nested)) for name, default in value.defaults),
    )


def _of_partial(value: Partial, nested: int) -> Key:
    named = tuple((name, argument_key(argument, nested)) for name, argument in value.keywords)
    return (argument_key(value.function, nested), _keys(value.args, nested), named)


_SHAPES: dict[type[Value], Callable[..., Key]] = {
    Known: lambda value, _: (value, value.origin, value.kind),
    Given: lambda value, _: (Itself(value),),
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
    ModuleValue: lambda value, _: (Itself(value.module),),
    FunctionValue: _of_function,
    BoundMethod: lambda value, nested: _keys((value.function, value.self_value), nested),
    Partial: _of_partial,
    ApiMethod: lambda value, nested: (value.path, argument_key(value.self_value, nested)),
    AttributesValue: lambda value, nested: _keys((value.instance,), nested),
    SuperValue: lambda value, nested: _keys((value.owner, value.self_value), nested),
    EachValue: lambda value, nested: _keys((value.element,), nested),
    PythonValue: lambda value, _: (value.name, Itself(value.function)),
}
"""What distinguishes values that have no identity of their own."""


def kind_key(store: Store, value: Value, nested: int = 0, *, closely: bool = True) -> Hashable:
    """What sets one value apart from another whenever the code that makes it runs: objects that it makes anew each time
    are alike.  ``closely``: functions differ in what they take along, too."""
    if nested > _NESTED:
        return ()
    match value:
        case Known() | External() | ClassValue():
            return value
        case Holed():
            return value.parts
        case Instance():
            return (kind_key(store, value.cls, nested + 1), value.place)
        case FunctionValue() if not closely:
            return id(value.ir)
        case ForeignValue() if (kind := value.kind()) is not None:
            return kind
    parts, deeper = _kind_parts(store, value)
    inner = tuple(kind_key(store, part, nested + deeper, closely=closely) for part in parts)
    return (id(value.ir) if isinstance(value, FunctionValue) else value.__class__.__name__, *inner)


def _kind_parts(store: Store, value: Value) -> tuple[Iterable[Value], int]:
    """The values that a value is made of, and how much deeper they count: functions may close over each other."""
    match value:
        case OneOf() | BoundMethod() | Partial():
            return value.inner, 1
        case FunctionValue():
            return [*(default for _, default in value.defaults), *_closed_over(store, value)], 4
    return (), 1


def _closed_over(store: Store, function: FunctionValue) -> list[Value]:
    """The variables of the functions around it that a function uses."""
    values: list[Value] = []
    names = names_in(function.ir) - bound_names(function.ir)[0]
    scope: Scope | None = function.scope
    while scope is not None and scope.kind != "module":
        if scope.kind != "class":
            bound = (store.get(scope.key, name) for name in sorted(names))
            values += [value for value in bound if value is not None]
        scope = scope.parent
    return values
