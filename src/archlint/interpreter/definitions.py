"""Functions and classes: how they are defined, and how objects are made of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter import containers, hints, refusals, registries
from archlint.interpreter.activation import Activation
from archlint.interpreter.attributes import bind, get_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.classes import SETTERS, class_lookup
from archlint.interpreter.modules import Scope
from archlint.interpreter.python_classes import ENUM_BASES
from archlint.interpreter.values import (
    MEMBERS,
    TUPLE_FIELDS,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    External,
    FunctionValue,
    Instance,
    Known,
    Partial,
    Unknown,
    Value,
    alternatives,
    as_default,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def define_function(machine: Machine, s: facts.Function) -> Value:
    activation = machine.activation
    activation.closed_over = True
    defaults = []
    for param in s.params:
        if param.default is not None:
            defaults.append((param.name, as_default(machine.evaluate(param.default))))
    owner_scope = activation.scope
    prefix = "" if owner_scope.kind == "module" else owner_scope.qualified + "."
    names: set[str] = set()
    foreign: list[Value] = []
    for decorator in s.decorators:
        _read_decorator(machine, s, decorator, names, foreign)
    function = FunctionValue(s, owner_scope, prefix + s.name, tuple(defaults), None, frozenset(names))
    if "setter" in names:
        before = machine.store.get(owner_scope.key, s.name)
        machine.store.set(owner_scope.key, SETTERS[s.name], function)
        return function if before is None else before
    value: Value = function
    for decorator_value in reversed(foreign):
        decorated = machine.call(decorator_value, CallSite([value]))
        if not isinstance(decorated, Unknown) and not (isinstance(decorated, Known) and decorated.value is None):
            value = decorated
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


def _read_decorator(
    machine: Machine, s: facts.Function, decorator: facts.Expr, names: set[str], foreign: list[Value]
) -> None:
    if isinstance(decorator, facts.Attribute) and decorator.attr in ("setter", "getter", "deleter"):
        names.add(decorator.attr)
        return
    value = machine.evaluate(decorator)
    path = value.path if isinstance(value, External) else value.name if isinstance(value, Builtin) else ""
    if path in _KNOWN_DECORATORS:
        names.add(_KNOWN_DECORATORS[path])
    elif isinstance(value, (FunctionValue, Partial, ClassValue)):
        foreign.append(value)


def define_lambda(machine: Machine, e: facts.Lambda) -> Value:
    machine.activation.closed_over = True
    defaults = []
    for param in e.params:
        if param.default is not None:
            defaults.append((param.name, machine.evaluate(param.default)))
    return FunctionValue(e, machine.activation.scope, "<lambda>", tuple(defaults))


def define_class(machine: Machine, s: facts.Class) -> Value:
    activation = machine.activation
    activation.closed_over = True
    bases: list[Value] = []
    for argument in s.bases:
        if argument.keyword is None and not argument.star:
            base = machine.evaluate(argument.value)
            if refusals.is_module(machine, base):
                return Unknown("no class can inherit from a module")
            bases.append(_single_base(machine, base))
        elif argument.keyword is not None:
            machine.evaluate(argument.value)
    decorators: set[str] = set()
    for decorator in s.decorators:
        value = machine.evaluate(decorator.func if isinstance(decorator, facts.Call) else decorator)
        if isinstance(value, External):
            decorators.add(value.path)
    registering = registries.decorators_of(machine, s)
    prefix = "" if activation.scope.kind == "module" else activation.scope.qualified + "."
    key = machine.store.new_key()
    scope = Scope(key, activation.scope, activation.module, "class", prefix + s.name)
    cls = ClassValue(s, scope, prefix + s.name, tuple(bases), key, (), frozenset(decorators))
    object.__setattr__(cls, "mro", linearize(cls))
    machine.activations.append(Activation(prefix + s.name, activation.module, scope, s.body, machine.store.depth))
    try:
        machine.execute(s.body)
    finally:
        machine.activations.pop()
    _own_functions(machine, cls)
    if ENUM_BASES & set(cls.external_bases()):
        _make_members(machine, cls)
    return registries.announce(machine, s, cls, registering)


def _single_base(machine: Machine, value: Value) -> Value:
    """A base that depends on a branch (``try: import …``): the first class among the alternatives."""
    for option in alternatives(value):
        if isinstance(option, (ClassValue, External)):
            return External(machine.library.canonical(option.path)) if isinstance(option, External) else option
    if isinstance(value, Builtin):
        return External(value.name)
    return value


def _own_functions(machine: Machine, cls: ClassValue) -> None:
    """Tell the functions of a class body which class they belong to, for ``super()``."""
    for statement in _definitions(cls.ir.body):
        value = machine.store.get(cls.key, statement.name)
        if isinstance(value, FunctionValue) and value.owner is None:
            object.__setattr__(value, "owner", cls)
        setter = machine.store.get(cls.key, SETTERS[statement.name])
        if setter is not None and setter.owner is None:
            object.__setattr__(setter, "owner", cls)


def _definitions(body: list[facts.Stmt]) -> list[facts.Function]:
    found: list[facts.Function] = []
    for statement in body:
        if isinstance(statement, facts.Function):
            found.append(statement)
        elif isinstance(statement, facts.If):
            found.extend(_definitions(statement.body))
            found.extend(_definitions(statement.orelse))
        elif isinstance(statement, facts.Try):
            found.extend(_definitions(statement.body))
    return found


def methods_of(cls: ClassValue) -> list[facts.Function]:
    """The functions that a class body defines."""
    return _definitions(cls.ir.body)


def _make_members(machine: Machine, cls: ClassValue) -> None:
    members: dict[str, Value] = {}
    for name in _assigned(cls.ir.body):
        value = machine.store.get(cls.key, name)
        if isinstance(value, External) and value.path == "enum.auto":
            value = _automatic(cls, name, list(members.values()))
        if value is None:
            value = Unknown("an enum value")
        first = next((other for other, held in members.items() if isinstance(held, Known) and held == value), None)
        same = None if first is None else machine.store.get(cls.key, first)
        if same is not None:  # a second name of the same member
            machine.store.set(cls.key, name, same)
            continue
        member = Instance(cls, machine.store.new_key(), is_member=True)
        machine.store.set(member.key, "value", value)
        machine.store.set(member.key, "_value_", value)
        machine.store.set(member.key, "name", Known(name))
        machine.store.set(cls.key, name, member)
        members[name] = value
    machine.store.set(cls.key, MEMBERS, tuple(members))


def _assigned(body: list[facts.Stmt]) -> Iterator[str]:
    """The names that are assigned in the body of a class, but for private ones."""
    for statement in body:
        targets: list[facts.Expr] = []
        if isinstance(statement, facts.Assign):
            targets = statement.targets
        elif isinstance(statement, facts.Annotated) and statement.value is not None:
            targets = [statement.target]
        for target in targets:
            if isinstance(target, facts.Name) and not target.id.startswith("_"):
                yield target.id


def _automatic(cls: ClassValue, name: str, before: list[Value]) -> Value:
    """What ``enum.auto()`` stands for: the next number, bit or, of a ``StrEnum``, the name."""
    bases = set(cls.external_bases())
    if "enum.StrEnum" in bases:
        return Known(name.lower())
    numbers = [value.value for value in before if isinstance(value, Known) and isinstance(value.value, int)]
    if len(numbers) < len(before) or numbers[-1:] != [max(numbers, default=0)][: len(numbers)]:
        return Unknown("an enum value")  # Pythons differ
    last = numbers[-1] if numbers else 0
    return Known(1 << last.bit_length() if {"enum.Flag", "enum.IntFlag"} & bases else last + 1)


def linearize(cls: ClassValue) -> tuple[Value, ...]:
    """The method resolution order (C3); a broken one falls back to depth first."""
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


def _equal(one: Value, other: Value) -> bool:
    return one is other or (isinstance(one, External) and one == other)


def _is_in(value: Value, row: list[Value]) -> bool:
    return any(_equal(value, other) for other in row)


def instantiate(machine: Machine, cls: ClassValue, site: CallSite) -> Value:
    """Make an object of a class of the workspace."""
    if machine.store.get(cls.key, MEMBERS):
        return _enum_member(machine, cls, site.args)
    made = _given_by_new(machine, cls, site) or allocate(machine, cls, site.expression)
    machine.library.constructing(made, cls, site)
    init, owner = class_lookup(machine, cls, "__init__")
    if init is not None:
        machine.call(bind(machine, init, made, cls), site)
    elif isinstance(owner, External):
        machine.library.call_method(ApiMethod(f"{owner.path}.__init__", made), site)
    elif any("dataclass" in name for name in _decorators(cls)) or "typing.NamedTuple" in cls.external_bases():
        _fill_dataclass(machine, made, cls, site)
    return made


def allocate(machine: Machine, cls: ClassValue, expression: facts.Call | None = None) -> Instance:
    """An object of a class, before its ``__init__``."""
    place = machine.place(expression.span) if expression is not None and machine.activations else None
    made = Instance(cls, machine.store.new_key(), place)
    machine.instances[made.key] = made
    machine.library.allocated(made)
    return made


def _given_by_new(machine: Machine, cls: ClassValue, site: CallSite) -> Instance | None:
    """The object that a ``__new__`` of ours gives: of a class with one object only, the one that there is."""
    new, _ = class_lookup(machine, cls, "__new__")
    if not isinstance(new, FunctionValue):
        return None
    given = machine.call(new, CallSite([cls, *site.args], site.keywords, site.expression))
    objects = [one for one in alternatives(given) if isinstance(one, Instance) and one.cls is cls]
    return min(objects, key=lambda one: one.key, default=None)


def _decorators(cls: ClassValue) -> set[str]:
    return {name for base in cls.mro if isinstance(base, ClassValue) for name in base.decorators}


def _enum_member(machine: Machine, cls: ClassValue, args: list[Value]) -> Value:
    members = containers.enum_members(machine, cls)
    if len(args) == 1 and isinstance(args[0], Known):
        for member in members:
            if isinstance(member, Instance) and machine.store.get(member.key, "value") == args[0]:
                return member
    return one_of(members) if members else Unknown("an enum without members")


def _fill_dataclass(machine: Machine, made: Instance, cls: ClassValue, site: CallSite) -> None:
    fields: dict[str, ClassValue] = {}
    for base in reversed(cls.mro):
        if isinstance(base, ClassValue):
            for statement in base.ir.body:
                if isinstance(statement, facts.Annotated) and isinstance(statement.target, facts.Name):
                    fields[statement.target.id] = base
    rest = list(site.args)
    for name, base in fields.items():
        value: Value | None
        if rest:
            value = rest.pop(0)
        elif name in site.keywords:
            value = site.keywords[name]
        elif site.open:
            value = Unknown("a field that is passed by * or **")
        else:
            value = machine.store.get(base.key, name)
            if isinstance(value, Instance) and value.note == "dataclasses.field":
                value = _field_default(machine, value)
            value = None if value is None else as_default(value)
        if value is not None:
            machine.library.kept(made.key, (value,), name)
        else:
            value = hints.declared(machine, cls, name) or Unknown(f"the field '{name}' is not set")
        machine.store.set(made.key, name, value)
    if "typing.NamedTuple" in cls.external_bases():
        machine.store.set(made.key, TUPLE_FIELDS, tuple(fields))
    after = get_attribute(machine, made, "__post_init__")
    if isinstance(after, BoundMethod):
        machine.call(after)


def _field_default(machine: Machine, declared: Instance) -> Value:
    if "default" in declared.arguments:
        return declared.arguments["default"]
    factory = declared.arguments.get("default_factory")
    return Unknown("a field without a default") if factory is None else machine.call(factory)
