"""Functions and classes: how they are defined, and how objects are made of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter import hints, refusals
from archlint.interpreter.attributes import bind, class_lookup, get_attribute
from archlint.interpreter.values import (
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    External,
    FunctionValue,
    Instance,
    Known,
    Partial,
    Scope,
    Unknown,
    Value,
    alternatives,
    as_default,
    one_of,
)
from archlint.libraries.rclpy import effects, escapes
from archlint.libraries.rclpy import names as rclpy_names
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Run


def define_function(run: Run, s: facts.Function) -> Value:
    activation = run.activation
    activation.closed_over = True
    defaults = []
    for param in s.params:
        if param.default is not None:
            defaults.append((param.name, as_default(run.evaluate(param.default))))
    owner_scope = activation.scope
    prefix = "" if owner_scope.kind == "module" else owner_scope.qualified + "."
    names: set[str] = set()
    foreign: list[Value] = []
    for decorator in s.decorators:
        _read_decorator(run, s, decorator, names, foreign)
    value: Value = FunctionValue(s, owner_scope, prefix + s.name, tuple(defaults), None, frozenset(names))
    if "setter" in names:
        before = run.store.get(owner_scope.key, s.name)
        run.store.set(owner_scope.key, f"#setter:{s.name}", value)
        return before if isinstance(before, Value) else value
    for decorator_value in reversed(foreign):
        decorated = run.call(decorator_value, [value], {})
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


def _read_decorator(run: Run, s: facts.Function, decorator: facts.Expr, names: set[str], foreign: list[Value]) -> None:
    if isinstance(decorator, facts.Attribute) and decorator.attr in ("setter", "getter", "deleter"):
        names.add(decorator.attr)
        return
    value = run.evaluate(decorator)
    path = value.path if isinstance(value, External) else value.name if isinstance(value, Builtin) else ""
    if path in _KNOWN_DECORATORS:
        names.add(_KNOWN_DECORATORS[path])
    elif isinstance(value, (FunctionValue, Partial, ClassValue)):
        foreign.append(value)


def define_lambda(run: Run, e: facts.Lambda) -> Value:
    run.activation.closed_over = True
    defaults = []
    for param in e.params:
        if param.default is not None:
            defaults.append((param.name, run.evaluate(param.default)))
    return FunctionValue(e, run.activation.scope, "<lambda>", tuple(defaults))


def define_class(run: Run, s: facts.Class) -> Value:
    from archlint.interpreter import registries
    from archlint.interpreter.machine import Activation

    activation = run.activation
    activation.closed_over = True
    bases: list[Value] = []
    for argument in s.bases:
        if argument.keyword is None and not argument.star:
            base = run.evaluate(argument.value)
            if refusals.is_module(base):
                return Unknown("no class can inherit from a module")
            bases.append(_single_base(base))
        elif argument.keyword is not None:
            run.evaluate(argument.value)
    decorators: set[str] = set()
    for decorator in s.decorators:
        value = run.evaluate(decorator.func if isinstance(decorator, facts.Call) else decorator)
        if isinstance(value, External):
            decorators.add(value.path)
    registering = registries.decorators_of(run, s)
    prefix = "" if activation.scope.kind == "module" else activation.scope.qualified + "."
    key = run.store.new_key()
    scope = Scope(key, activation.scope, activation.module, "class", prefix + s.name)
    cls = ClassValue(s, scope, prefix + s.name, tuple(bases), key, (), frozenset(decorators))
    object.__setattr__(cls, "mro", linearize(cls))
    run.activations.append(Activation(prefix + s.name, activation.module, scope, s.body, run.store.depth))
    try:
        run.execute(s.body)
    finally:
        run.activations.pop()
    _own_functions(run, cls)
    if rclpy_names.ENUM_BASES & set(cls.external_bases()):
        _make_members(run, cls)
    return registries.announce(run, s, cls, registering)


def _single_base(value: Value) -> Value:
    """A base that depends on a branch (``try: import …``): the first class among the alternatives."""
    for option in alternatives(value):
        if isinstance(option, (ClassValue, External)):
            return External(rclpy_names.canonical(option.path)) if isinstance(option, External) else option
    if isinstance(value, Builtin):
        return External(value.name)
    return value


def _own_functions(run: Run, cls: ClassValue) -> None:
    """Tell the functions of a class body which class they belong to, for ``super()``."""
    for statement in _definitions(cls.ir.body):
        value = run.store.get(cls.key, statement.name)
        if isinstance(value, FunctionValue) and value.owner is None:
            object.__setattr__(value, "owner", cls)
        setter = run.store.get(cls.key, f"#setter:{statement.name}")
        if isinstance(setter, FunctionValue) and setter.owner is None:
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


def _make_members(run: Run, cls: ClassValue) -> None:
    members: dict[str, Value] = {}
    for name in _assigned(cls.ir.body):
        value = run.store.get(cls.key, name)
        if isinstance(value, External) and value.path == "enum.auto":
            value = _automatic(cls, name, list(members.values()))
        if not isinstance(value, Value):
            value = Unknown("an enum value")
        first = next((other for other, held in members.items() if isinstance(held, Known) and held == value), None)
        if first is not None:  # a second name of the same member
            run.store.set(cls.key, name, run.store.get(cls.key, first))
            continue
        member = Instance(cls, run.store.new_key())
        run.store.set(member.key, "value", value)
        run.store.set(member.key, "_value_", value)
        run.store.set(member.key, "name", Known(name))
        run.store.set(member.key, "#enum", True)
        run.store.set(cls.key, name, member)
        members[name] = value
    run.store.set(cls.key, "#members", tuple(members))


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


GIVEN = "#given"
"""The slot of what the constructor of a class that derives from one of launch's was given, by name or position."""


def instantiate(
    run: Run,
    cls: ClassValue,
    args: list[Value],
    keywords: dict[str, Value],
    expression: facts.Call | None = None,
    open_arguments: bool = False,
) -> Value:
    """Make an object of a class of the workspace."""
    if run.store.get(cls.key, "#members"):
        return _enum_member(run, cls, args)
    made = _given_by_new(run, cls, args, keywords, expression) or allocate(run, cls, expression)
    if not open_arguments and any(path.startswith("launch") for path in cls.external_bases()):
        named = sorted(keywords.items(), key=lambda row: row[0])
        rows = [*((str(number), value) for number, value in enumerate(args)), *named]
        run.store.set(made.key, GIVEN, tuple(rows))
    init, owner = class_lookup(run, cls, "__init__")
    if init is not None:
        run.call(bind(run, init, made, cls), args, keywords, expression, open_arguments)
    elif isinstance(owner, External):
        path = rclpy_names.canonical(owner.path)
        effects.call_method(run, ApiMethod(f"{path}.__init__", made), args, keywords, expression, open_arguments)
    elif any("dataclass" in name for name in _decorators(cls)) or "typing.NamedTuple" in cls.external_bases():
        _fill_dataclass(run, made, cls, args, keywords, open_arguments)
    return made


def allocate(run: Run, cls: ClassValue, expression: facts.Call | None = None) -> Instance:
    """An object of a class, before its ``__init__``."""
    place = run.place(expression.span) if expression is not None and run.activations else None
    made = Instance(cls, run.store.new_key(), place)
    run.instances[made.key] = made
    effects.adopt(run, made)
    return made


def _given_by_new(
    run: Run, cls: ClassValue, args: list[Value], keywords: dict[str, Value], expression: facts.Call | None
) -> Instance | None:
    """The object that a ``__new__`` of ours gives: of a class with one object only, the one that there is."""
    new, _ = class_lookup(run, cls, "__new__")
    if not isinstance(new, FunctionValue):
        return None
    given = run.call(new, [cls, *args], keywords, expression)
    objects = [one for one in alternatives(given) if isinstance(one, Instance) and one.cls is cls]
    return min(objects, key=lambda one: one.key, default=None)


def _decorators(cls: ClassValue) -> set[str]:
    return {name for base in cls.mro if isinstance(base, ClassValue) for name in base.decorators}


def _enum_member(run: Run, cls: ClassValue, args: list[Value]) -> Value:
    from archlint.interpreter import containers

    members = containers.enum_members(run, cls)
    if len(args) == 1 and isinstance(args[0], Known):
        for member in members:
            if isinstance(member, Instance) and run.store.get(member.key, "value") == args[0]:
                return member
    return one_of(members) if members else Unknown("an enum without members")


def _fill_dataclass(
    run: Run,
    made: Instance,
    cls: ClassValue,
    args: list[Value],
    keywords: dict[str, Value],
    open_arguments: bool,
) -> None:
    fields: dict[str, ClassValue] = {}
    for base in reversed(cls.mro):
        if isinstance(base, ClassValue):
            for statement in base.ir.body:
                if isinstance(statement, facts.Annotated) and isinstance(statement.target, facts.Name):
                    fields[statement.target.id] = base
    rest = list(args)
    for name, base in fields.items():
        value: object
        if rest:
            value = rest.pop(0)
        elif name in keywords:
            value = keywords[name]
        elif open_arguments:
            value = Unknown("a field that is passed by * or **")
        else:
            value = run.store.get(base.key, name)
            if isinstance(value, Instance) and value.note == "dataclasses.field":
                value = _field_default(run, value)
            value = as_default(value) if isinstance(value, Value) else value
        if isinstance(value, Value):
            escapes.kept(run, made.key, (value,), name)
        if not isinstance(value, Value):
            value = hints.declared(run, cls, name) or Unknown(f"the field '{name}' is not set")
        run.store.set(made.key, name, value)
    if "typing.NamedTuple" in cls.external_bases():
        run.store.set(made.key, "#fields", tuple(fields))
    after = get_attribute(run, made, "__post_init__")
    if isinstance(after, BoundMethod):
        run.call(after, [], {})


def _field_default(run: Run, declared: Instance) -> Value:
    if "default" in declared.arguments:
        return declared.arguments["default"]
    factory = declared.arguments.get("default_factory")
    return Unknown("a field without a default") if factory is None else run.call(factory, [], {})
