"""Evaluating expressions: operators, attributes, items, truth and what a test proves."""

from __future__ import annotations

import operator
import posixpath
from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING, Any

from archlint.facts import model as facts
from archlint.program import calls
from archlint.program.attributes import get_attribute, set_attribute
from archlint.program.store import Entries, Items
from archlint.program.values import (
    FALSE,
    NONE,
    TRUE,
    ApiMethod,
    AttributesValue,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
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
    NodeValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
    join_texts,
    one_of,
    reason,
    via,
)

if TYPE_CHECKING:
    from archlint.program.run import Run

__all__ = ["Items", "evaluate", "get_attribute", "set_attribute"]

CARTESIAN = 36
"""How many combinations of alternatives one operation follows."""
TEXT_LIMIT = 4096
ITEM_LIMIT = 4096


def evaluate(run: Run, expression: facts.Expr) -> Value:
    return _EXPRESSIONS[expression.__class__](run, expression)


# ------------------------------------------------------------------------------------------ simple things


def _literal(run: Run, e: facts.Literal) -> Value:
    if isinstance(e.value, str):
        return Known(e.value, origin=run.place(e.span), kind="literal")
    return Known(e.value)


def _name(run: Run, e: facts.Name) -> Value:
    value = run.lookup(e.id)
    if value is not None:
        return value
    if e.id in calls.BUILTINS:
        return Builtin(e.id)
    foreign = star_imported(run, run.activation.module.star_externals, e.id)
    if foreign is not None:
        return foreign
    return Unknown(f"'{e.id}' is not defined where this file can be read alone", name=e.id)


def star_imported(run: Run, packages: Sequence[str], name: str) -> Value | None:
    """A name that may come from a star import of a foreign package; None where there is no such import.

    Interface packages hold class names only; where several could have it, the table of interfaces decides, and
    where that does not know either, the name is unknown.
    """
    interfaces = [package for package in packages if package.endswith((".msg", ".srv", ".action"))]
    candidates = [p for p in packages if p in interfaces] if name[:1].isupper() and interfaces else list(packages)
    if len(candidates) > 1 and run.interfaces is not None:
        defines = run.interfaces.defines
        verdicts = {p: defines(p.partition(".")[0], p.partition(".")[2], name) for p in interfaces}
        sure = [p for p in candidates if verdicts.get(p)]
        candidates = sure or [p for p in candidates if verdicts.get(p) is not False]
    if len(set(candidates)) == 1:
        return External(f"{candidates[0]}.{name}")
    return Unknown(f"'{name}' comes from one of several star imports") if candidates else None


def _attribute(run: Run, e: facts.Attribute) -> Value:
    return get_attribute(run, run.evaluate(e.value), e.attr, e)


def _call(run: Run, e: facts.Call) -> Value:
    return calls.evaluate_call(run, e)


def _opaque(run: Run, e: facts.Opaque) -> Value:
    return Unknown(f"{e.what} is not followed")


def _starred(run: Run, e: facts.Starred) -> Value:
    return run.evaluate(e.value)


def _lambda(run: Run, e: facts.Lambda) -> Value:
    return calls.define_lambda(run, e)


def _assigned(run: Run, e: facts.Assigned) -> Value:
    from archlint.program.run import assign

    value = run.evaluate(e.value)
    assign(run, e.target, value)
    return value


def _await(run: Run, e: facts.Await) -> Value:
    return calls.awaited(run, run.evaluate(e.value), e)


def _yield(run: Run, e: facts.Yield) -> Value:
    value = NONE if e.value is None else run.evaluate(e.value)
    run.activation.yields.append(value)
    return Unknown("what is sent into a generator")


# ------------------------------------------------------------------------------------------- collections


def new_list(run: Run, values: Sequence[Value], kind: str = "list", open_: bool = False) -> ListValue:
    made = ListValue(run.store.new_key(), kind)
    run.store.set(made.key, "#items", Items(tuple(values), open_))
    return made


def new_dict(run: Run, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> DictValue:
    made = DictValue(run.store.new_key())
    run.store.set(made.key, "#items", Entries(entries, open_))
    return made


def items_of(run: Run, value: ListValue) -> Items:
    items = run.store.get(value.key, "#items")
    return items if isinstance(items, Items) else Items((), True)


def entries_of(run: Run, value: DictValue) -> Entries:
    entries = run.store.get(value.key, "#items")
    return entries if isinstance(entries, Entries) else Entries({}, True)


def hashable(value: Value) -> Hashable | None:
    """What stands for a value as a key; None where it is not known."""
    if isinstance(value, Known):
        return (type(value.value).__name__ if isinstance(value.value, str) else "", value.value)
    if isinstance(value, (Instance, ClassValue, EntityValue)):
        return ("#", id(value))
    if isinstance(value, External):
        return ("#external", value.path)
    return None


def iterate(run: Run, value: Value) -> Items | None:
    """The items that iterating yields; None where nothing is known of them."""
    if isinstance(value, ListValue):
        return items_of(run, value)
    if isinstance(value, DictValue):
        entries = entries_of(run, value)
        return Items(tuple(key for key, _ in entries.entries.values()), entries.open)
    if isinstance(value, Known) and isinstance(value.value, str):
        if len(value.value) > 256:
            return None
        return Items(tuple(Known(character, value.via) for character in value.value))
    if isinstance(value, ClassValue):
        members = enum_members(run, value)
        return Items(tuple(members)) if members else None
    if isinstance(value, Instance):
        return _fields_of_tuple(run, value)
    if isinstance(value, OneOf):
        rows = [iterate(run, alternative) for alternative in value.values]
        known = [row for row in rows if row is not None]
        if not known:
            return None
        union: list[Value] = []
        for row in known:
            union.extend(item for item in row.values if item not in union)
        same = len(known) == len(rows) and all(row == known[0] for row in known)
        return Items(tuple(union), not same or known[0].open)
    return None


def _fields_of_tuple(run: Run, value: Instance) -> Items | None:
    """The items of a named tuple."""
    names = run.store.get(value.key, "#fields")
    if not isinstance(names, tuple):
        return None
    fields = [run.store.get(value.key, name) for name in names]
    return Items(tuple(field for field in fields if isinstance(field, Value)))


def unknown_item(run: Run, iterable: Value, why: str) -> Value:
    if isinstance(iterable, Unknown) and iterable.parameter is not None:
        return Unknown(iterable.reason, iterable.parameter)
    return Unknown(why)


def enum_members(run: Run, cls: ClassValue) -> list[Value]:
    names = run.store.get(cls.key, "#members")
    if not isinstance(names, tuple):
        return []
    found = [run.store.get(cls.key, name) for name in names]
    return [value for value in found if isinstance(value, Value)]


def _sequence(run: Run, e: facts.Sequence) -> Value:
    values: list[Value] = []
    open_ = False
    for element in e.elements:
        if isinstance(element, facts.Starred):
            items = iterate(run, run.evaluate(element.value))
            if items is None:
                open_ = True
            else:
                values.extend(items.values)
                open_ = open_ or items.open
        else:
            values.append(run.evaluate(element))
    return new_list(run, values[:ITEM_LIMIT], e.kind, open_ or len(values) > ITEM_LIMIT)


def _mapping(run: Run, e: facts.Mapping) -> Value:
    entries: dict[Hashable, tuple[Value, Value]] = {}
    open_ = False
    for key_expression, value_expression in zip(e.keys, e.values, strict=True):
        value = run.evaluate(value_expression)
        if key_expression is None:
            if isinstance(value, DictValue):
                other = entries_of(run, value)
                entries.update(other.entries)
                open_ = open_ or other.open
            else:
                open_ = True
            continue
        key = run.evaluate(key_expression)
        at = hashable(key)
        if at is None:
            open_ = True
            entries[("#unknown", len(entries))] = (key, value)
        else:
            entries[at] = (key, value)
    return new_dict(run, entries, open_)


def _comprehension(run: Run, e: facts.Comprehension) -> Value:
    from archlint.program.run import assign

    activation = run.activation
    scope = run.new_scope(activation.scope, activation.module, "comprehension", activation.qualified)
    kept, activation.scope = activation.scope, scope
    activation.scopes.append(scope.key)
    rows: list[tuple[Value, Value]] = []
    open_ = False

    def walk(depth: int) -> None:
        nonlocal open_
        if len(rows) > ITEM_LIMIT:
            open_ = True
            return
        if depth == len(e.generators):
            value = NONE if e.value is None else run.evaluate(e.value)
            rows.append((run.evaluate(e.element), value))
            return
        generator = e.generators[depth]
        iterable = run.evaluate(generator.iterable)
        items = iterate(run, iterable)
        values: Sequence[Value]
        if items is None or len(items.values) > ITEM_LIMIT:
            open_ = True
            why = reason(iterable)
            values = (Unknown("what the loop runs over is not known" if why.startswith("the value") else why),)
        else:
            open_ = open_ or items.open
            values = items.values
        for item in values:
            assign(run, generator.target, item)
            truths = [truth(run, run.evaluate(condition)) for condition in generator.conditions]
            if False in truths:
                continue
            if None in truths:
                open_ = True
            walk(depth + 1)

    try:
        walk(0)
    finally:
        activation.scope = kept
    if e.kind == "dict":
        entries: dict[Hashable, tuple[Value, Value]] = {}
        for key, value in rows:
            at = hashable(key)
            open_ = open_ or at is None
            entries[at if at is not None else ("#unknown", len(entries))] = (key, value)
        return new_dict(run, entries, open_)
    return new_list(run, [element for element, _ in rows], "set" if e.kind == "set" else "list", open_)


def _slice_bounds(run: Run, index: facts.Slice) -> slice | None:
    bounds: list[int | None] = []
    for part in (index.lower, index.upper, index.step):
        value = NONE if part is None else run.evaluate(part)
        if not isinstance(value, Known) or not (value.value is None or isinstance(value.value, int)):
            return None
        bounds.append(value.value)
    return slice(*bounds)


def _subscript(run: Run, e: facts.Subscript) -> Value:
    value = run.evaluate(e.value)
    if isinstance(e.index, facts.Slice):
        bounds = _slice_bounds(run, e.index)
        return one_of(_slice(run, alternative, bounds) for alternative in alternatives(value))
    index = run.evaluate(e.index)
    found = [get_item(run, container, at) for container in alternatives(value) for at in alternatives(index)]
    return one_of(found[:CARTESIAN])


def _slice(run: Run, value: Value, bounds: slice | None) -> Value:
    if bounds is None or bounds.step == 0:
        return Unknown("a slice whose bounds are not known")
    if isinstance(value, ListValue):
        items = items_of(run, value)
        if items.open:
            return Unknown("the items of this list are not known")
        return new_list(run, items.values[bounds], value.kind)
    if isinstance(value, Known) and isinstance(value.value, str):
        return Known(value.value[bounds], value.via)
    return Unknown(reason(value))


def get_item(run: Run, container: Value, index: Value) -> Value:
    """``container[index]``."""
    if isinstance(container, ListValue):
        items = items_of(run, container)
        if isinstance(index, Known) and isinstance(index.value, int):
            inside = -len(items.values) <= index.value < len(items.values)
            if inside and not items.open:
                return items.values[index.value]
            return Unknown("the items of this list are not known")
        if items.values and not items.open:
            return one_of(items.values)
        return Unknown(reason(index, *items.values[:1]))
    if isinstance(container, DictValue):
        return get_entry(run, container, index, None)
    if isinstance(container, Known) and isinstance(container.value, str):
        if isinstance(index, Known) and isinstance(index.value, int):
            try:
                return Known(container.value[index.value], container.via | index.via)
            except IndexError:
                return Unknown("an index outside of the text")
        return Unknown(reason(index))
    if isinstance(container, ClassValue):
        if isinstance(index, Known) and isinstance(index.value, str):
            member = run.store.get(container.key, index.value)  # an enum by name, or a generic class
            if isinstance(member, Value):
                return member
        return container
    if isinstance(container, External):
        return _external_item(container, index)
    if isinstance(container, Instance):
        items_ = _fields_of_tuple(run, container)
        if items_ is not None and isinstance(index, Known) and isinstance(index.value, int):
            return items_.values[index.value] if abs(index.value) < len(items_.values) else Unknown("no such item")
        method = get_attribute(run, container, "__getitem__")
        if isinstance(method, BoundMethod):
            return run.call(method, [index], {})
    if isinstance(container, AttributesValue) and isinstance(index, Known) and isinstance(index.value, str):
        return get_attribute(run, container.instance, index.value)
    if isinstance(container, Unknown):
        return Unknown(container.reason, container.parameter)
    return Unknown(reason(container, index))


def _external_item(container: External, index: Value) -> Value:
    """``os.environ['X']``, an enum by name, or a generic such as ``list[str]``."""
    name = index.value if isinstance(index, Known) else None
    if container.path == "os.environ":
        if name in ENVIRONMENT:
            return Known(ENVIRONMENT[str(name)])
        return Unknown(f"the environment variable {name!s}" if name else "an environment variable")
    if container.path == "sys.version_info" and name == 0:
        return Known(PYTHON[0])
    if container.path.startswith("rclpy.qos.") and isinstance(name, str):
        return External(f"{container.path}.{name.upper()}")
    return container


ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
"""What the environment of every ROS 2 process says."""


def get_entry(run: Run, container: DictValue, index: Value, default: Value | None) -> Value:
    """``dict[index]``, or ``dict.get(index, default)`` where a default is given."""
    entries = entries_of(run, container)
    at = hashable(index)
    if at is not None:
        found = entries.entries.get(at)
        if found is not None:
            return _with_via(found[1], via(index))
        if entries.open:
            why = Unknown("the dict has entries that are not known")
            return why if default is None else one_of((default, why))
        if default is None:
            return _made_entry(run, container, index)
        return default
    values = [value for _, value in entries.entries.values()]
    if default is not None:
        values.append(default)
    if entries.open or not values:
        return Unknown(reason(index, *values[:1]))
    return one_of(values)


def _made_entry(run: Run, container: DictValue, index: Value) -> Value:
    """What a ``defaultdict`` makes for a new key."""
    factory = run.store.get(container.key, "#factory")
    if not isinstance(factory, Value):
        return Unknown("the dict has no such key")
    made = run.call(factory, [], {})
    set_item(run, container, index, made)
    return made


def _with_via(value: Value, parameters: frozenset[str]) -> Value:
    if parameters and isinstance(value, Known):
        return Known(value.value, value.via | parameters, value.origin, value.kind)
    return value


def set_item(run: Run, container: Value, index: Value, value: Value) -> None:
    """``container[index] = value``; where it is one of several containers, each may now hold it."""
    several = isinstance(container, OneOf)
    for target in alternatives(container):
        if isinstance(target, DictValue):
            entries = entries_of(run, target)
            at = hashable(index)
            updated = dict(entries.entries)
            if at is None:
                updated[("#unknown", len(updated))] = (index, value)
                if len(updated) <= ITEM_LIMIT:
                    run.store.set(target.key, "#items", Entries(updated, True))
                continue
            if several and at in updated:
                value = one_of((updated[at][1], value))
            updated[at] = (index, value)
            if len(updated) <= ITEM_LIMIT:
                run.store.set(target.key, "#items", Entries(updated, entries.open))
        elif isinstance(target, ListValue):
            items = items_of(run, target)
            if isinstance(index, Known) and isinstance(index.value, int) and not items.open:
                values = list(items.values)
                if -len(values) <= index.value < len(values):
                    values[index.value] = value
                    run.store.set(target.key, "#items", Items(tuple(values)))
            else:
                run.store.set(target.key, "#items", Items((*items.values, value)[:ITEM_LIMIT], True))
        elif isinstance(target, AttributesValue):
            if isinstance(index, Known) and isinstance(index.value, str):
                set_attribute(run, target.instance, index.value, value)
        elif isinstance(target, Instance):
            method = get_attribute(run, target, "__setitem__")
            if isinstance(method, BoundMethod):
                run.call(method, [index, value], {})


def delete_item(run: Run, container: Value, index: Value) -> None:
    at = hashable(index)
    if isinstance(container, DictValue):
        entries = entries_of(run, container)
        kept = {key: entry for key, entry in entries.entries.items() if key != at}
        run.store.set(container.key, "#items", Entries(kept, entries.open or at is None))
    elif isinstance(container, ListValue):
        run.store.set(container.key, "#items", Items(items_of(run, container).values, True))


# --------------------------------------------------------------------------------------------- operators

_ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "//": operator.floordiv,
    "%": operator.mod,
    "**": operator.pow,
    "&": operator.and_,
    "|": operator.or_,
    "^": operator.xor,
    "<<": operator.lshift,
    ">>": operator.rshift,
}


def _binary(run: Run, e: facts.Binary) -> Value:
    left, right = run.evaluate(e.left), run.evaluate(e.right)
    return binary(run, e.op, left, right, e.span)


def binary(run: Run, op: str, left: Value, right: Value, span: facts.Span) -> Value:
    """``left op right`` over all alternatives."""
    found = [_binary_one(run, op, one, other, span) for one in alternatives(left) for other in alternatives(right)]
    return one_of(found[:CARTESIAN])


def _is_text(value: Value) -> bool:
    return (isinstance(value, Known) and isinstance(value.value, str)) or isinstance(value, Holed)


def _binary_one(run: Run, op: str, left: Value, right: Value, span: facts.Span) -> Value:
    left, right = plain_text(run, left), plain_text(run, right)
    if op == "+" and (_is_text(left) or _is_text(right)):
        both_known = isinstance(left, Known) and isinstance(right, Known)
        if both_known and not (_is_text(left) and _is_text(right)):
            return Unknown("adding a text and something else fails")
        return join_texts((left, right), run.place(span))
    if op == "/" and isinstance(left, Known) and isinstance(right, Known) and _is_text(left) and _is_text(right):
        return Known(posixpath.join(str(left.value), str(right.value)), via(left, right))  # of a pathlib.Path
    if op == "%" and _is_text(left):
        return percent_format(run, left, right, span)
    if op == "+" and isinstance(left, ListValue) and isinstance(right, ListValue):
        one, other = items_of(run, left), items_of(run, right)
        return new_list(run, (one.values + other.values)[:ITEM_LIMIT], left.kind, one.open or other.open)
    if op == "|" and isinstance(left, DictValue) and isinstance(right, DictValue):
        first, second = entries_of(run, left), entries_of(run, right)
        return new_dict(run, {**first.entries, **second.entries}, first.open or second.open)
    if op == "*" and isinstance(left, ListValue) and isinstance(right, Known):
        items = items_of(run, left)
        if isinstance(right.value, int) and 0 <= right.value * len(items.values) <= ITEM_LIMIT:
            return new_list(run, items.values * right.value, left.kind, items.open)
    if isinstance(left, Known) and isinstance(right, Known):
        return _arithmetic(op, left, right)
    return Unknown(reason(left, right), next(iter(sorted(via(left, right))), None))


def _arithmetic(op: str, left: Known, right: Known) -> Value:
    one, other = left.value, right.value
    if op not in _ARITHMETIC:
        return Unknown(f"the operator {op} is not followed")
    big = isinstance(one, (int, float)) and isinstance(other, (int, float))
    if op in ("**", "<<") and (not big or abs(float(other)) > 64):  # type: ignore[arg-type]
        return Unknown("a number too large to follow")
    if op == "*" and (isinstance(one, str) or isinstance(other, str)):
        length = len(one) if isinstance(one, str) else len(other) if isinstance(other, str) else 0
        count = other if isinstance(one, str) else one
        if not isinstance(count, int) or length * count > TEXT_LIMIT:
            return Unknown("a text too long to follow")
    try:
        result = _ARITHMETIC[op](one, other)
    except (TypeError, ValueError, ArithmeticError):
        return Unknown("an operation that fails")
    if not isinstance(result, (str, int, float, bool)):
        return Unknown("an operation whose result is not a constant")
    return Known(result, left.via | right.via)


def percent_format(run: Run, template: Value, argument: Value, span: facts.Span) -> Value:
    """``'…%s…' % argument``."""
    if not isinstance(template, Known) or not isinstance(template.value, str):
        return Unknown(reason(template))
    if isinstance(argument, ListValue) and argument.kind == "tuple":
        items = items_of(run, argument)
        if items.open:
            return Unknown("the arguments of % are not known")
        arguments = list(items.values)
    elif isinstance(argument, DictValue):
        return _percent_dict(run, template, argument, span)
    else:
        arguments = [argument]
    parts: list[Value] = []
    text = template.value
    at = 0
    import re

    for match in re.finditer(r"%(?:%|[-#0 +]*[\d.]*[hlL]?[a-zA-Z])", text):
        parts.append(Known(text[at : match.start()], template.via))
        at = match.end()
        if match.group() == "%%":
            parts.append(Known("%"))
            continue
        if not arguments:
            return Unknown("% has fewer arguments than the text asks for")
        parts.append(_formatted(match.group(), arguments.pop(0)))
    parts.append(Known(text[at:]))
    return _combine(run, parts, span)


def _formatted(conversion: str, value: Value) -> Value:
    found: list[Value] = []
    for alternative in alternatives(value):
        if isinstance(alternative, Known):
            try:
                found.append(Known(conversion % (alternative.value,), alternative.via))
            except (TypeError, ValueError):
                found.append(Unknown("a format that fails"))
        elif conversion == "%s":
            found.append(alternative)
        else:
            found.append(Unknown(reason(alternative)))
    return one_of(found)


def _percent_dict(run: Run, template: Known, argument: DictValue, span: facts.Span) -> Value:
    import re

    assert isinstance(template.value, str)
    parts: list[Value] = []
    at = 0
    for match in re.finditer(r"%(?:%|\((\w+)\)([-#0 +]*[\d.]*[a-zA-Z]))", template.value):
        parts.append(Known(template.value[at : match.start()]))
        at = match.end()
        if match.group(1) is None:
            parts.append(Known("%"))
        else:
            value = get_entry(run, argument, Known(match.group(1)), None)
            parts.append(_formatted("%" + match.group(2), value))
    parts.append(Known(template.value[at:]))
    return _combine(run, parts, span)


def _combine(run: Run, parts: Sequence[Value], span: facts.Span | None) -> Value:
    """Join text parts over all combinations of their alternatives."""
    rows: list[list[Value]] = [[]]
    for part in parts:
        options = alternatives(part)
        if len(rows) * len(options) > CARTESIAN:
            options = (Unknown("more values than can be followed"),)
        rows = [[*row, option] for row in rows for option in options]
    place = None if span is None else run.place(span)
    return one_of(join_texts([text_of(run, part) for part in row], place) for row in rows)


def plain_text(run: Run, value: Value) -> Value:
    """A member of ``class X(str, Enum)`` is the text it holds; everything else is itself."""
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue) and run.store.get(value.key, "#enum"):
        held = run.store.get(value.key, "value")
        if {"str", "enum.StrEnum"} & set(value.cls.external_bases()) and isinstance(held, Value):
            return held
    return value


def text_of(run: Run, value: Value) -> Value:
    """``str(value)``."""
    if isinstance(value, (Known, Holed, Unknown)):
        return value
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        enum = run.store.get(value.key, "value") if run.store.get(value.key, "#enum") else None
        if isinstance(enum, Known) and _is_text_enum(value.cls):
            return enum
        for name in ("__str__", "__repr__"):
            method = get_attribute(run, value, name)
            if isinstance(method, BoundMethod):
                return run.call(method, [], {})
    return Unknown(reason(value))


def _is_text_enum(cls: ClassValue) -> bool:
    return any(path in ("enum.StrEnum",) for path in cls.external_bases())


def _format_string(run: Run, e: facts.FormatString) -> Value:
    parts: list[Value] = []
    for part in e.parts:
        if isinstance(part, str):
            parts.append(Known(part))
            continue
        value = run.evaluate(part.value)
        if part.conversion == "r" or part.spec:
            value = one_of(format_one(option, part.conversion, part.spec) for option in alternatives(value))
        parts.append(value)
    return _combine(run, parts, e.span)


def format_one(value: Value, conversion: str | None, spec: str | None) -> Value:
    """What one ``{value!conversion:spec}`` gives."""
    if not isinstance(value, Known):
        return value
    try:
        shown: object = repr(value.value) if conversion == "r" else value.value
        shown = str(shown) if conversion == "s" else shown
        text = format(shown, spec or "")
    except (TypeError, ValueError):
        return Unknown("a format that fails")
    return Known(text, value.via) if len(text) <= TEXT_LIMIT else Unknown("a text too long to follow")


def _unary(run: Run, e: facts.Unary) -> Value:
    value = run.evaluate(e.operand)
    if e.op == "not":
        known = truth(run, value)
        return Unknown(reason(value)) if known is None else Known(not known, via(value))
    if isinstance(value, Known) and isinstance(value.value, (int, float)):
        number = value.value
        if e.op == "-":
            return Known(-number, value.via)
        if e.op == "+":
            return Known(+number, value.via)
        if isinstance(number, int):
            return Known(~number, value.via)
    return Unknown(reason(value))


def _boolean(run: Run, e: facts.Boolean) -> Value:
    """``and``/``or``: the first operand that decides, or one of those that may."""
    possible: list[Value] = []
    stop = e.op == "or"
    pushed = 0
    key = run.key_of(e.span)
    depth = run.store.depth
    try:
        for number, operand in enumerate(e.values):
            value = run.evaluate(operand)
            last = number == len(e.values) - 1
            verdict = truth(run, value)
            if last or verdict is stop:
                possible.append(value)
                break
            if verdict is None:
                possible.extend(_with_truth(run, value, stop))
                # What follows runs only if this operand did not decide.
                run.store.push()
                run.arms.append((f"{key}#{number}", 0))
                narrow(run, operand, not stop)
                pushed += 1
    finally:
        for _ in range(pushed):
            run.arms.pop()
        if pushed:
            run.store.merge([run.store.cut(depth), {}])
    return one_of(possible)


def _with_truth(run: Run, value: Value, wanted: bool) -> list[Value]:
    """The alternatives of a value that can be as true as wanted; an unknown truth value of a test is itself."""
    return [option for option in alternatives(value) if truth(run, option) in (None, wanted)]


def _conditional(run: Run, e: facts.Conditional) -> Value:
    verdict = truth(run, run.evaluate(e.test))
    if verdict is not None:
        return run.evaluate(e.body if verdict else e.orelse)
    key = run.key_of(e.span)
    found = []
    layers = []
    for arm, expression in enumerate((e.body, e.orelse)):
        with run.arm(key, arm) as taken:
            narrow(run, e.test, arm == 0)
            found.append(run.evaluate(expression))
        layers.append(taken[0])
    run.store.merge(layers)
    return one_of(found)


def _compare(run: Run, e: facts.Compare) -> Value:
    left = run.evaluate(e.left)
    verdicts: list[bool | None] = []
    used = [left]
    for op, expression in zip(e.ops, e.comparators, strict=True):
        right = run.evaluate(expression)
        used.append(right)
        verdicts.append(_compare_values(run, op, left, right))
        left = right
    if False in verdicts:
        return Known(False, via(*used))
    if None in verdicts:
        return Unknown(reason(*used), next(iter(sorted(via(*used))), None))
    return Known(True, via(*used))


def _compare_values(run: Run, op: str, left: Value, right: Value) -> bool | None:
    found = {_compare_one(run, op, one, other) for one in alternatives(left) for other in alternatives(right)}
    return found.pop() if len(found) == 1 else None


_ORDER: dict[str, Callable[[Any, Any], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


def _compare_one(run: Run, op: str, left: Value, right: Value) -> bool | None:
    if op in ("not in", "!=", "is not"):
        opposite = {"not in": "in", "!=": "==", "is not": "is"}[op]
        verdict = _compare_one(run, opposite, left, right)
        return None if verdict is None else not verdict
    if op == "in":
        return _contains(run, left, right)
    if isinstance(left, External) and left.path == "sys.version_info":
        return _compare_version(run, op, right)
    if isinstance(left, Known) and isinstance(right, Known):
        if op == "==":
            return bool(left.value == right.value)
        if op == "is":
            return left.value is right.value if None in (left.value, right.value) else left.value == right.value
        try:
            return bool(_ORDER[op](left.value, right.value))
        except (TypeError, KeyError):
            return None
    if op in ("==", "is"):
        return _same(left, right)
    return None


PYTHON = (3, 10)
"""The oldest Python of a supported distribution: humble's."""


def _compare_version(run: Run, op: str, right: Value) -> bool | None:
    """``sys.version_info >= (3, 8)``: decided where it is the same for every supported Python."""
    if not isinstance(right, ListValue):
        return None
    numbers = tuple(item.value for item in items_of(run, right).values if isinstance(item, Known))
    if not numbers or not all(isinstance(number, int) for number in numbers):
        return None
    if numbers <= PYTHON:
        return {">=": True, ">": True, "<": False, "<=": False}.get(op)
    return None


_OBJECTS = (Instance, EntityValue, NodeValue, FunctionValue, BoundMethod, ClassValue, MessageValue, FutureValue)


def _same(left: Value, right: Value) -> bool | None:
    for one, other in ((left, right), (right, left)):
        if isinstance(one, Known) and one.value is None and is_object(other):
            return False
    if isinstance(left, _OBJECTS) and isinstance(right, _OBJECTS):
        return left == right if type(left) is type(right) else False
    if isinstance(left, External) and isinstance(right, External):
        return left == right
    return None


def is_object(value: Value) -> bool:
    """Whether a value is certainly not None."""
    return isinstance(
        value,
        (*_OBJECTS, ListValue, DictValue, Holed, ModuleValue, Partial, Builtin, ApiMethod),
    )


def _contains(run: Run, item: Value, container: Value) -> bool | None:
    if isinstance(container, Known) and isinstance(container.value, str):
        if isinstance(item, Known) and isinstance(item.value, str):
            return item.value in container.value
        return None
    if isinstance(container, DictValue):
        at = hashable(item)
        entries = entries_of(run, container)
        if at is None:
            return None
        return True if at in entries.entries else None if entries.open else False
    if isinstance(container, ListValue):
        items = items_of(run, container)
        verdicts = [_compare_one(run, "==", item, other) for other in items.values]
        if True in verdicts:
            return True
        return None if None in verdicts or items.open else False
    return None


# -------------------------------------------------------------------------------------- truth and narrowing


def truth(run: Run, value: Value) -> bool | None:
    """Whether a value is true; None where that is not known.

    A parameter's default is one value of many: the default decides nothing.
    """
    if isinstance(value, Known):
        return None if value.via else bool(value.value)
    if isinstance(value, OneOf):
        found = {truth(run, alternative) for alternative in value.values}
        return found.pop() if len(found) == 1 else None
    if isinstance(value, ListValue):
        items = items_of(run, value)
        return True if items.values and not items.open else None if items.open else False
    if isinstance(value, DictValue):
        entries = entries_of(run, value)
        return True if entries.entries and not entries.open else None if entries.open else False
    if isinstance(value, Holed):
        return True if any(value.parts) else None
    if is_object(value):
        return True
    return None


def narrow(run: Run, test: facts.Expr, holds: bool) -> None:
    """Keep what a test proves about a variable or attribute inside a branch."""
    if isinstance(test, facts.Unary) and test.op == "not":
        narrow(run, test.operand, not holds)
    elif isinstance(test, facts.Boolean):
        if (test.op == "and") == holds:
            for value in test.values:
                narrow(run, value, holds)
    elif isinstance(test, (facts.Name, facts.Attribute)):
        _keep(run, test, lambda value: _raw_truth(run, value) in (None, holds))
    elif isinstance(test, facts.Assigned):
        narrow(run, test.target, holds)
    elif isinstance(test, facts.Compare) and len(test.ops) == 1:
        op, other = test.ops[0], test.comparators[0]
        if op in ("is not", "!=", "not in"):
            op, holds = {"is not": "is", "!=": "==", "not in": "in"}[op], not holds
        if not isinstance(test.left, (facts.Name, facts.Attribute)) or op not in ("is", "==", "in"):
            return
        if not isinstance(other, (facts.Literal, facts.Name, facts.Attribute, facts.Sequence)):
            return
        right = run.evaluate(other)
        proven = right if holds and op == "==" and isinstance(right, Known) else None
        _keep(run, test.left, lambda value: _compare_values(run, op, value, right) in (None, holds), proven)


def _raw_truth(run: Run, value: Value) -> bool | None:
    """Like :func:`truth`, with a parameter's default taken at its word."""
    return bool(value.value) if isinstance(value, Known) else truth(run, value)


def _keep(
    run: Run,
    target: facts.Name | facts.Attribute,
    wanted: Callable[[Value], bool],
    proven: Value | None = None,
) -> None:
    """Drop the alternatives that a test rules out.  Where none is left (a parameter's default that this
    branch contradicts), the value is what the test proves, or unknown."""
    if isinstance(target, facts.Attribute) and not isinstance(target.value, facts.Name):
        return
    before = run.lookup(target.id) if isinstance(target, facts.Name) else run.evaluate(target)
    if before is None:
        return
    kept = [value for value in alternatives(before) if wanted(value)]
    after: Value
    if kept:
        after = one_of(kept)
        if proven is not None and isinstance(after, Unknown):
            after = proven
    elif proven is not None:
        after = Known(proven.value, via(before)) if isinstance(proven, Known) else proven
    else:
        names = sorted(via(before))
        if not names:
            return
        after = Unknown(f"the parameter '{names[0]}' decides it", names[0])
    if after is before or (isinstance(before, (Unknown, Known)) and after == before):
        return
    if isinstance(target, facts.Name):
        run.assign_name(target.id, after)
    else:
        set_attribute(run, run.evaluate(target.value), target.attr, after)


# ---------------------------------------------------------------------------------------------- patterns


def matches(run: Run, pattern: facts.Pattern, subject: Value) -> bool | None:
    if pattern.kind == "capture":
        return True
    if pattern.kind == "value" and pattern.value is not None:
        return _compare_values(run, "==", subject, run.evaluate(pattern.value))
    if pattern.kind == "or":
        verdicts = [matches(run, part, subject) for part in pattern.parts]
        return True if True in verdicts else None if None in verdicts else False
    if pattern.kind == "as" and pattern.parts:
        return matches(run, pattern.parts[0], subject)
    if pattern.kind == "mapping" and isinstance(subject, DictValue):
        return _matches_mapping(run, pattern, subject)
    if pattern.kind == "sequence" and isinstance(subject, ListValue):
        items = items_of(run, subject)
        if items.open or any(part.kind == "other" for part in pattern.parts):
            return None
        if len(items.values) != len(pattern.parts):
            return False
        verdicts = [matches(run, p, v) for p, v in zip(pattern.parts, items.values, strict=True)]
        return False if False in verdicts else None if None in verdicts else True
    return None


def _matches_mapping(run: Run, pattern: facts.Pattern, subject: DictValue) -> bool | None:
    entries = entries_of(run, subject)
    verdicts: list[bool | None] = []
    for part in pattern.parts:
        if part.kind != "entry" or part.value is None:
            continue
        at = hashable(run.evaluate(part.value))
        found = entries.entries.get(at) if at is not None else None
        if found is None:
            verdicts.append(None if entries.open or at is None else False)
        else:
            verdicts.append(matches(run, part.parts[0], found[1]))
    return False if False in verdicts else None if None in verdicts else True


def bind_pattern(run: Run, pattern: facts.Pattern, subject: Value) -> None:
    if pattern.name is not None:
        run.assign_name(pattern.name, subject)
    if pattern.kind == "mapping" and isinstance(subject, DictValue):
        entries = entries_of(run, subject).entries
        for part in pattern.parts:
            at = hashable(run.evaluate(part.value)) if part.value is not None else None
            if part.kind == "entry" and at in entries:
                bind_pattern(run, part.parts[0], entries[at][1])
            else:
                bind_pattern(run, part.parts[0], Unknown("part of a mapping"))
        return
    items = iterate(run, subject) if pattern.kind == "sequence" else None
    for number, part in enumerate(pattern.parts):
        if pattern.kind in ("as", "or"):
            bind_pattern(run, part, subject)
        elif items is not None and not items.open and number < len(items.values):
            bind_pattern(run, part, items.values[number])
        else:
            bind_pattern(run, part, Unknown("part of a value that a pattern takes apart"))


_EXPRESSIONS: dict[type, Callable[[Run, Any], Value]] = {
    facts.Literal: _literal,
    facts.Name: _name,
    facts.Attribute: _attribute,
    facts.Call: _call,
    facts.Subscript: _subscript,
    facts.Slice: lambda run, e: Unknown("a slice"),
    facts.Binary: _binary,
    facts.Unary: _unary,
    facts.Boolean: _boolean,
    facts.Compare: _compare,
    facts.Conditional: _conditional,
    facts.FormatString: _format_string,
    facts.Sequence: _sequence,
    facts.Mapping: _mapping,
    facts.Starred: _starred,
    facts.Comprehension: _comprehension,
    facts.Lambda: _lambda,
    facts.Assigned: _assigned,
    facts.Await: _await,
    facts.Yield: _yield,
    facts.Opaque: _opaque,
}

__all__ += ["FALSE", "TRUE"]
