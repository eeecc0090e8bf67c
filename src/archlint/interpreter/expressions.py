"""Evaluating expressions: operators, attributes, items, truth and what a test proves."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.interpreter import calls, definitions
from archlint.interpreter.assignment import assign
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.containers import (
    ITEM_LIMIT,
    hashable,
    items_of,
    iterate,
    new_dict,
    new_list,
    unknown_item,
)
from archlint.interpreter.decisions import narrow, truth
from archlint.interpreter.formatting import CARTESIAN, combine, format_one
from archlint.interpreter.items import get_item, slice_of
from archlint.interpreter.machine import UNROLL
from archlint.interpreter.operators import binary, compare_values
from archlint.interpreter.values import (
    NO_PARAMETERS,
    NONE,
    Builtin,
    Known,
    ListValue,
    Unknown,
    UnknownKey,
    Value,
    alternatives,
    constant,
    one_of,
    reason,
    via,
)
from archlint.reasons import Uninformative
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

__all__ = ["EXPRESSIONS", "evaluate_test"]


# ------------------------------------------------------------------------------------------ simple things


def _literal(machine: Machine, e: facts.Literal) -> Value:
    if isinstance(e.value, str):
        return Known(e.value, origin=machine.place(e.span), kind="literal")
    return Known(e.value)


def _name(machine: Machine, e: facts.Name) -> Value:
    value = machine.lookup(e.id)
    if value is not None:
        return value
    if e.id in calls.BUILTINS:
        return Builtin(e.id)
    foreign = machine.star_imported(machine.activation.module.star_externals, e.id)
    if foreign is not None:
        return foreign
    return Unknown(f"'{e.id}' is not defined in this file", name=e.id)


def _attribute(machine: Machine, e: facts.Attribute) -> Value:
    return get_attribute(machine, machine.evaluate(e.value), e.attr, e)


def _call(machine: Machine, e: facts.Call) -> Value:
    return calls.evaluate_call(machine, e)


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
    return calls.awaited(machine, machine.evaluate(e.value), e)


def _yield(machine: Machine, e: facts.Yield) -> Value:
    value = NONE if e.value is None else machine.evaluate(e.value)
    machine.activation.yields.append(value)
    return Unknown("what is sent into a generator")


def _sequence(machine: Machine, e: facts.Sequence) -> Value:
    values: list[Value] = []
    open_, whole = False, True
    for element in e.elements:
        if isinstance(element, facts.Starred):
            items = iterate(machine, machine.evaluate(element.value))
            if items is None:
                open_, whole = True, False
            else:
                values.extend(items.values)
                open_, whole = open_ or items.open, whole and items.whole
        else:
            values.append(machine.evaluate(element))
    if len(values) > ITEM_LIMIT:
        open_, whole = True, False
    return new_list(machine, values[:ITEM_LIMIT], e.kind, open_, whole)


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
        at = hashable(key)
        if at is None:
            open_ = True
            entries[UnknownKey(len(entries))] = (key, value)
        else:
            entries[at] = (key, value)
    return new_dict(machine, entries, open_)


def _why_unknown_items(iterable: Value) -> str:
    match reason(iterable):
        case Uninformative():
            return "what the loop runs over is not known"
        case why:
            return why


def _comprehension(machine: Machine, e: facts.Comprehension) -> Value:
    activation = machine.activation
    outermost = machine.evaluate(e.generators[0].iterable)  # in the scope around: a class body has names of its own
    scope = machine.new_scope(activation.scope, activation.module, "comprehension", activation.qualified)
    kept, activation.scope = activation.scope, scope
    activation.scopes.append(scope.key)
    rows: list[tuple[Value, Value]] = []
    open_, whole = False, True

    def walk(depth: int) -> None:
        nonlocal open_, whole
        if len(rows) > ITEM_LIMIT:
            open_, whole = True, False
            return
        if depth == len(e.generators):
            value = NONE if e.value is None else machine.evaluate(e.value)
            rows.append((machine.evaluate(e.element), value))
            return
        generator = e.generators[depth]
        iterable = machine.evaluate(generator.iterable) if depth else outermost
        items = iterate(machine, iterable)
        values: Sequence[Value]
        if items is None or len(items.values) > min(UNROLL, machine.items_left):
            open_, whole = True, False
            values = (iterable.each or Unknown(_why_unknown_items(iterable)),)
        else:
            open_ = open_ or items.open
            whole = whole and items.whole
            # What is filled later is gone through once, with an item that is not known.
            later = items.open and not items.whole and not items.values
            values = (
                (unknown_item(machine, iterable, "what is in the collection is not known"),) if later else items.values
            )
            machine.items_left -= len(values)
        for item in values:
            assign(machine, generator.target, item)
            truths = [evaluate_test(machine, condition)[1] for condition in generator.conditions]
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
            entries[at if at is not None else UnknownKey(len(entries))] = (key, value)
        return new_dict(machine, entries, open_)
    return new_list(machine, [element for element, _ in rows], "set" if e.kind == "set" else "list", open_, whole)


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
    found = [get_item(machine, container, at) for container in alternatives(value) for at in alternatives(index)]
    return one_of(found[:CARTESIAN])


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


def evaluate_test(machine: Machine, e: facts.Expr) -> tuple[Value, bool | None]:
    """The value of a test, and whether it holds (None where that is not known).  The two are asked for together
    because ``unknown and False`` never holds, though what its value is nobody knows."""
    match e:
        case facts.Boolean():
            return _operands(machine, e)
        case facts.Unary(op="not"):
            value, known = evaluate_test(machine, e.operand)
            return (Unknown(reason(value)), None) if known is None else (Known(not known, via(value)), not known)
    value = machine.evaluate(e)
    return value, truth(machine, value)


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
    return Unknown(reason(value))


def _boolean(machine: Machine, e: facts.Boolean) -> Value:
    return _operands(machine, e)[0]


def _operands(machine: Machine, e: facts.Boolean) -> tuple[Value, bool | None]:
    """``and``/``or``: the first operand that decides, or one of those that may; and whether the test holds, which
    a later operand can decide alone."""
    possible: list[Value] = []
    holds: bool | None = None
    stop = e.op == "or"
    pushed = 0
    key = machine.key_of(e.span)
    depth = machine.store.depth
    asked: frozenset[str] = NO_PARAMETERS
    try:
        for number, operand in enumerate(e.values):
            value, verdict = evaluate_test(machine, operand)
            if stop and asked:
                # What stands in for a parameter that may be empty can be set by that parameter.
                value = one_of(_chosen_by(asked, option) for option in alternatives(value))
            last = number == len(e.values) - 1
            if last or verdict is stop:
                possible.append(value)
                holds = verdict if verdict is stop or not pushed else None
                break
            if verdict is None:
                possible.extend(_with_truth(machine, value, stop))
                asked |= via(*alternatives(value))
                # What follows runs only if this operand did not decide.
                machine.store.push()
                machine.library.undecided(f"{key}#{number}", value)
                machine.branch_arms.append((f"{key}#{number}", 0))
                narrow(machine, operand, not stop)
                pushed += 1
    finally:
        for _ in range(pushed):
            machine.branch_arms.pop()
        if pushed:
            machine.store.merge([machine.store.cut(depth), {}])
    return one_of(possible), holds


def _chosen_by(parameters: frozenset[str], value: Value) -> Value:
    return replace(value, via=value.via | parameters) if isinstance(value, Known) else value


def _with_truth(machine: Machine, value: Value, wanted: bool) -> list[Value]:
    """The alternatives of a value that can be as true as wanted; an unknown truth value of a test is itself."""
    return [option for option in alternatives(value) if truth(machine, option) in (None, wanted)]


def _conditional(machine: Machine, e: facts.Conditional) -> Value:
    test, verdict = evaluate_test(machine, e.test)
    if verdict is not None:
        return machine.evaluate(e.body if verdict else e.orelse)
    key = machine.key_of(e.span)
    machine.library.undecided(key, test)
    found = []
    layers = []
    for arm, expression in enumerate((e.body, e.orelse)):
        with machine.arm(key, arm) as taken:
            narrow(machine, e.test, arm == 0)
            found.append(machine.evaluate(expression))
        layers.append(taken[0])
    machine.store.merge(layers)
    return one_of(found)


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
        inside = [item for value in used if isinstance(value, ListValue) for item in items_of(machine, value).values]
        return Unknown(reason(*used, *inside), next(iter(sorted(via(*used))), None))
    return Known(True, via(*used))


def _is_set(value: Value) -> bool:
    return all(option.constant is not None for option in alternatives(value))


EXPRESSIONS: dict[type, Callable[[Machine, Any], Value]] = {
    facts.Literal: _literal,
    facts.Name: _name,
    facts.Attribute: _attribute,
    facts.Call: _call,
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
    facts.Comprehension: _comprehension,
    facts.Lambda: _lambda,
    facts.Assigned: _assigned,
    facts.Await: _await,
    facts.Yield: _yield,
    facts.Opaque: _opaque,
}
