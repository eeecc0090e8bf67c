"""Functions and classes: how they are defined."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import declared, overloads, refusals, registries
from archlint.interpreter.activation import Activation
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.classes import SETTERS, called
from archlint.interpreter.limits import CLASSES
from archlint.interpreter.modules import Scope
from archlint.interpreter.objects import enums
from archlint.interpreter.python_classes import ENUM_BASES
from archlint.interpreter.values import (
    Builtin,
    ClassValue,
    External,
    FunctionValue,
    Known,
    Partial,
    Unknown,
    Value,
    alternatives,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def define_function(machine: Machine, s: facts.Function) -> Value:
    """What ``def`` binds."""
    activation = machine.activation
    activation.closed_over = True
    defaults = []
    for param in s.params:
        if param.default is not None:
            defaults.append((param.name, machine.evaluate(param.default).as_default()))
    owner_scope = activation.scope
    if owner_scope.module.file.kind == "cpp":
        defaults += declared.defaults_of(machine.index, machine.store, owner_scope, s)
    prefix = "" if owner_scope.kind == "module" else owner_scope.qualified + "."
    names: set[str] = set()
    foreign: list[Value] = []
    for decorator in s.decorators:
        _read_decorator(machine, decorator, names, foreign)
    function = FunctionValue(s, owner_scope, prefix + s.name, tuple(defaults), None, frozenset(names))
    overloads.note(machine.index.overloads, owner_scope.key, s.name, function)
    if "setter" in names:
        machine.store.set(owner_scope.key, SETTERS[s.name], function)
        return machine.store.get(owner_scope.key, s.name) or function
    return _decorated(machine, function, foreign)


def _decorated(machine: Machine, function: FunctionValue, decorators: Sequence[Value]) -> Value:
    """What decorators make of a function: the function itself where they give nothing that is known."""
    value: Value = function
    for decorator in reversed(decorators):
        result = machine.call(decorator, CallSite([value]))
        if not isinstance(result, Unknown) and not result.is_none:
            value = result
    return value


_KNOWN_DECORATORS = {
    "property": "property",
    "staticmethod": "staticmethod",
    "classmethod": "classmethod",
    "functools.cached_property": "property",
    "cached_property": "property",
    "abc.abstractmethod": "abstract",
    "abc.abstractproperty": "property",
    "contextlib.contextmanager": "contextmanager",
}


def _read_decorator(machine: Machine, decorator: facts.Expr, names: set[str], foreign: list[Value]) -> None:
    if decorator.attribute in ("setter", "getter", "deleter"):
        names.add(decorator.attribute)
        return
    match machine.evaluate(decorator):
        case External(path=path) | Builtin(name=path):
            if path in _KNOWN_DECORATORS:
                names.add(_KNOWN_DECORATORS[path])
        case FunctionValue() | Partial() | ClassValue() as value:
            foreign.append(value)


def define_lambda(machine: Machine, e: facts.Lambda) -> Value:
    """What a lambda is."""
    machine.activation.closed_over = True
    defaults = []
    for param in e.params:
        if param.default is not None:
            defaults.append((param.name, machine.evaluate(param.default)))
    return FunctionValue(e, machine.activation.scope, "<lambda>", tuple(defaults))


def define_class(machine: Machine, s: facts.Class) -> Value:
    """What ``class`` binds."""
    activation = machine.activation
    activation.closed_over = True
    written = _bases(machine, s)
    if written is None:
        return Unknown("no class can inherit from a module")
    bases = tuple(_single_base(machine, base) for base in written)
    others = tuple(_other_bases(machine, written, bases))
    metaclass = _metaclass(machine, s)
    decorators = (machine.evaluate(called(decorator)) for decorator in s.decorators)
    names = frozenset(value.dotted for value in decorators if value.dotted)
    registering = registries.decorators_of(machine, s)
    prefix = "" if activation.scope.kind == "module" else activation.scope.qualified + "."
    key = machine.store.new_key()
    scope = Scope(key, activation.scope, activation.module, "class", prefix + s.name)
    cls = ClassValue(s, scope, prefix + s.name, bases, key, (), names, others, metaclass)
    object.__setattr__(cls, "mro", linearize(cls))
    machine.activations.append(Activation(prefix + s.name, activation.module, scope, s.body, machine.store.depth))
    try:
        machine.execute(s.body)
    finally:
        machine.activations.pop()
    _own_functions(machine, cls)
    if ENUM_BASES & set(cls.external_bases()):
        enums.make_members(machine, cls)
    return registries.announce(machine, s, cls, registering)


def _bases(machine: Machine, s: facts.Class) -> list[Value] | None:
    """What a class derives from, as it is written; None where that is to be a module."""
    bases: list[Value] = []
    for argument in s.bases:
        if argument.keyword is None:
            base = machine.evaluate(argument.value)
            if refusals.is_module(machine, base):
                return None
            bases.extend(_unpacked(machine, base) if argument.star else (base,))
    return bases


def _unpacked(machine: Machine, bases: Value) -> tuple[Value, ...]:
    """What ``*bases`` gives a class to derive from."""
    items = bases.items(machine)
    return (Unknown("bases that are not known"),) if items is None or items.open else items.values


def _single_base(machine: Machine, value: Value) -> Value:
    """A base that depends on a branch (``try: import …``): the first class among the alternatives."""
    return next((_base(machine, option) for option in alternatives(value) if _is_class(option)), _base(machine, value))


def _is_class(value: Value) -> bool:
    return isinstance(value, (ClassValue, External, Partial))


def _base(machine: Machine, value: Value) -> Value:
    match value:
        case External(path=path):
            return External(machine.library.canonical(path))
        case Builtin(name=name):
            return External(name)
        case Partial(function=ClassValue() as cls):  # a name of C++ for a class template with its arguments
            return cls
    return value


def _other_bases(machine: Machine, written: Sequence[Value], chosen: Sequence[Value]) -> Iterator[Value]:
    """What the bases are where a branch is taken that is not followed here; no class derives from a constant, such as
    the None that stands for a failed import."""
    for value, first in zip(written, chosen, strict=True):
        for option in alternatives(value):
            base = _base(machine, option)
            if base != first and not isinstance(base, Known):
                yield base


def _metaclass(machine: Machine, s: facts.Class) -> Value | None:
    keywords = {given.keyword: machine.evaluate(given.value) for given in s.bases if given.keyword is not None}
    return keywords.get("metaclass")


def _own_functions(machine: Machine, cls: ClassValue) -> None:
    """Tell the functions of a class body which class they belong to, for ``super()``."""
    for statement in methods_of(cls):
        functions = (machine.store.get(cls.key, statement.name), machine.store.get(cls.key, SETTERS[statement.name]))
        for function in functions:
            if isinstance(function, FunctionValue) and function.owner is None:
                object.__setattr__(function, "owner", cls)


def _definitions(body: list[facts.Stmt]) -> Iterator[facts.Function]:
    for statement in body:
        match statement:
            case facts.Function():
                yield statement
            case facts.If():
                yield from _definitions(statement.body)
                yield from _definitions(statement.orelse)
            case facts.Try():
                yield from _definitions(statement.body)


def methods_of(cls: ClassValue) -> list[facts.Function]:
    """The functions that a class body defines."""
    return list(_definitions(cls.ir.body))


def linearize(cls: ClassValue) -> tuple[Value, ...]:
    """The method resolution order (C3); a broken one falls back to depth first, the end of a long one is unknown."""
    order = _linearized(cls)
    if len(order) <= CLASSES:
        return order
    return (*order[:CLASSES], Unknown("more base classes inside each other than are followed"))


def _linearized(cls: ClassValue) -> tuple[Value, ...]:
    if len(cls.bases) == 1 and isinstance(cls.bases[0], ClassValue):
        return (cls, *cls.bases[0].mro)
    rows = [list(base.mro) if isinstance(base, ClassValue) else [base] for base in cls.bases]
    rows.append(list(cls.bases))
    order: list[Value] = [cls]
    while any(rows):
        rows = [row for row in rows if row]
        for row in rows:
            head = row[0]
            if not any(_is_in(head, other[1:]) for other in rows):
                break
        else:
            head = rows[0][0]
        order.append(head)
        rows = [[value for value in row if not _equal(value, head)] for row in rows]
    return tuple(order)


def _equal(value: Value, other: Value) -> bool:
    return value is other or (isinstance(value, External) and value == other)


def _is_in(value: Value, row: list[Value]) -> bool:
    return any(_equal(value, other) for other in row)
