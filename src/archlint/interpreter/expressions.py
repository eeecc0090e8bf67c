"""The expressions of the symbolic run, one function a kind."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING, Any

from archlint.interpreter import definitions
from archlint.interpreter.assignment import assign
from archlint.interpreter.attributes import get_attribute, has_member
from archlint.interpreter.builtins import BUILTINS
from archlint.interpreter.call_expressions import awaited, evaluate_call
from archlint.interpreter.comprehensions import comprehension
from archlint.interpreter.conditions import evaluate_test, operands
from archlint.interpreter.containers import (
    ITEM_LIMIT,
    entry_key,
    new_dict,
    new_list,
)
from archlint.interpreter.formatting import CARTESIAN, combine, format_one
from archlint.interpreter.items import get_item, slice_of
from archlint.interpreter.narrowing import narrow
from archlint.interpreter.operators import binary, compare_values
from archlint.interpreter.values import (
    NONE,
    Builtin,
    DictValue,
    Known,
    ListValue,
    Unknown,
    UnknownKey,
    Value,
    alternatives,
    chosen_for,
    constant,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

__all__ = ["EXPRESSIONS"]


# ------------------------------------------------------------------------------------------ simple things


def _literal(machine: Machine, e: facts.Literal) -> Value:
    if isinstance(e.value, str):
        return Known(e.value, origin=machine.place(e.span), kind="literal")
    return Known(e.value)


def _name(machine: Machine, e: facts.Name) -> Value:
    value = machine.lookup(e.id)
    if value is not None:
        return value
    if e.id in BUILTINS:
        return Builtin(e.id)
    namespace, mark, name = e.id.rpartition("::")
    if mark:  # of C++: what another file calls a namespace
        alias = machine.lookup(f"{namespace}::")
        return _name(machine, facts.Name(name, e.span)) if alias is None else get_attribute(machine, alias, name)
    foreign = machine.star_imported(machine.activation.module.star_externals, e.id)
    if foreign is not None:
        return foreign
    return Unknown(f"'{e.id}' is not defined in this file", name=e.id)


def _implicit(machine: Machine, e: facts.Implicit) -> Value:
    """A member of the object, or a name of the file."""
    itself = machine.lookup("self")
    if itself is not None and has_member(machine, itself, e.name):
        return get_attribute(machine, itself, e.name)
    cls = None if itself is None else itself.own_class
    bases = cls.mro if cls is not None and e.name[:1].isupper() else ()
    inherited = next((base for base in bases if base.dotted.rpartition(".")[2] == e.name), None)
    if inherited is not None:  # the name of a base means that class, whatever else is called so
        return inherited
    value = machine.lookup(e.name)
    if value is not None:
        return value
    foreign = machine.star_imported(machine.activation.module.star_externals, e.name) if e.name[:1].isupper() else None
    if foreign is not None:
        return foreign
    if itself is None or cls is None:
        return Unknown(f"'{e.name}' is not defined in this file", name=e.name)
    return get_attribute(machine, itself, e.name)


def _attribute(machine: Machine, e: facts.Attribute) -> Value:
    return get_attribute(machine, machine.evaluate(e.value), e.attr, e)


def _opaque(machine: Machine, e: facts.Opaque) -> Value:
    return Unknown(f"{e.what} is not followed")


def _starred(machine: Machine, e: facts.Starred) -> Value:
    return machine.evaluate(e.value)


def _lambda(machine: Machine, e: facts.Lambda) -> Value:
    return definitions.define_lambda(machine, e)


def _assigned(machine: Machine, e: facts.Assigned) -> Value:
    value = machine.evaluate(e.value)
    assign(machine, e.target, value)
    return value


def _await(machine: Machine, e: facts.Await) -> Value:
    return awaited(machine, machine.evaluate(e.value), e)


def _yield(machine: Machine, e: facts.Yield) -> Value:
    value = NONE if e.value is None else machine.evaluate(e.value)
    machine.activation.yields.append(value)
    return Unknown("a value that is sent into a generator")


def _sequence(machine: Machine, e: facts.Sequence) -> Value:
    values: list[Value] = []
    open_, exhaustive = False, True
    for element in e.elements:
        if isinstance(element, facts.Starred):
            items = machine.evaluate(element.value).items(machine)
            if items is None:
                open_, exhaustive = True, False
            else:
                values.extend(items.values)
                open_, exhaustive = open_ or items.open, exhaustive and items.exhaustive
        else:
            values.append(machine.evaluate(element))
    if len(values) > ITEM_LIMIT:
        open_, exhaustive = True, False
    return new_list(machine, values[:ITEM_LIMIT], e.kind, open_, exhaustive)


def _mapping(machine: Machine, e: facts.Mapping) -> Value:
    entries: dict[Hashable, tuple[Value, Value]] = {}
    open_ = False
    for key_expression, value_expression in zip(e.keys, e.values, strict=True):
        value = machine.evaluate(value_expression)
        if key_expression is None:
            other = value.entries(machine)
            entries.update({} if other is None else other.entries)
            open_ = open_ or other is None or other.open
            continue
        key = machine.evaluate(key_expression)
        at = entry_key(machine, key)
        if at is None:
            open_ = True
            entries[UnknownKey(len(entries))] = (key, value)
        else:
            entries[at] = (key, value)
    return new_dict(machine, entries, open_)


def _slice_bounds(machine: Machine, index: facts.Slice) -> slice | None:
    bounds: list[int | None] = []
    for part in (index.lower, index.upper, index.step):
        value = NONE if part is None else machine.evaluate(part)
        if not value.is_none and value.whole_number is None:
            return None
        bounds.append(value.whole_number)
    return slice(*bounds)


def _subscript(machine: Machine, e: facts.Subscript) -> Value:
    value = machine.evaluate(e.value)
    if isinstance(e.index, facts.Slice):
        bounds = _slice_bounds(machine, e.index)
        return one_of(slice_of(machine, alternative, bounds) for alternative in alternatives(value))
    index = machine.evaluate(e.index)
    if isinstance(value, DictValue) and isinstance(index, Known):
        machine.library.note_key(value, index, e)
    items = [get_item(machine, container, at) for container in alternatives(value) for at in alternatives(index)]
    machine.unknown_results += any(isinstance(item, Unknown) for item in items)
    return one_of(items[:CARTESIAN])


def _binary(machine: Machine, e: facts.Binary) -> Value:
    left, right = machine.evaluate(e.left), machine.evaluate(e.right)
    return binary(machine, e.op, left, right, e.span)


def _format_string(machine: Machine, e: facts.FormatString) -> Value:
    parts: list[Value] = []
    for part in e.parts:
        if isinstance(part, str):
            parts.append(Known(part))
            continue
        value = machine.evaluate(part.value)
        if part.conversion in ("r", "a") or part.spec:
            value = one_of(format_one(option, part.conversion, part.spec) for option in alternatives(value))
        parts.append(value)
    return combine(machine, parts, e.span)


def _unary(machine: Machine, e: facts.Unary) -> Value:
    if e.op == "not":
        return evaluate_test(machine, e)[0]
    value = machine.evaluate(e.operand)
    match e.op, value.constant:
        case "-", int(number) | float(number):
            return constant(-number, value.via)
        case "+", int(number) | float(number):
            return constant(+number, value.via)
        case "~", int(number):
            return constant(~number, value.via)
    return Unknown(reason(value), of_class=value.number_class)


def _boolean(machine: Machine, e: facts.Boolean) -> Value:
    return operands(machine, e)[0]


def _conditional(machine: Machine, e: facts.Conditional) -> Value:
    test, verdict = evaluate_test(machine, e.test)
    if verdict is not None:
        return machine.evaluate(e.body if verdict else e.orelse)
    key = machine.branch_at(e.span)
    why = machine.leave_open(key, test)
    values = []
    layers = []
    for arm, expression in enumerate((e.body, e.orelse)):
        with machine.arm(key, arm) as taken:
            narrow(machine, e.test, arm == 0)
            values.append(machine.evaluate(expression))
        layers.append(taken[0])
    machine.store.merge(layers, why)
    return chosen_for(one_of(values), why)


def _compare(machine: Machine, e: facts.Compare) -> Value:
    left = machine.evaluate(e.left)
    verdicts: list[bool | None] = []
    used = [left]
    for op, expression in zip(e.ops, e.comparators, strict=True):
        right = machine.evaluate(expression)
        used.append(right)
        verdicts.append(compare_values(machine, op, left, right))
        left = right
    if len(used) == 2 and None not in verdicts and NONE in used and _is_set(used[0] if used[1] == NONE else used[1]):
        return Known(verdicts[0])  # a parameter keeps its type: one that is set is never None
    if False in verdicts:
        return Known(False, via(*used))
    if None in verdicts:
        inside = [item for value in used if isinstance(value, ListValue) for item in value.items(machine).values]
        return Unknown(reason(*used, *inside), next(iter(sorted(via(*used))), None))
    return Known(True, via(*used))


def _is_set(value: Value) -> bool:
    return all(option.constant is not None for option in alternatives(value))


EXPRESSIONS: dict[type, Callable[[Machine, Any], Value]] = {
    facts.Literal: _literal,
    facts.Name: _name,
    facts.Implicit: _implicit,
    facts.Attribute: _attribute,
    facts.Call: evaluate_call,
    facts.Subscript: _subscript,
    facts.Slice: lambda machine, e: Unknown("a slice"),
    facts.Binary: _binary,
    facts.Unary: _unary,
    facts.Boolean: _boolean,
    facts.Compare: _compare,
    facts.Conditional: _conditional,
    facts.FormatString: _format_string,
    facts.Sequence: _sequence,
    facts.Mapping: _mapping,
    facts.Starred: _starred,
    facts.Comprehension: comprehension,
    facts.Lambda: _lambda,
    facts.Assigned: _assigned,
    facts.Await: _await,
    facts.Yield: _yield,
    facts.Opaque: _opaque,
}
