"""Evaluating expressions: operators, attributes, items, truth and what a test proves."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.interpreter import calls, definitions
from archlint.interpreter.attributes import get_attribute, set_attribute
from archlint.interpreter.containers import (
    ITEM_LIMIT,
    entries_of,
    get_item,
    hashable,
    items_of,
    iterate,
    new_dict,
    new_list,
    slice_of,
    unknown_item,
)
from archlint.interpreter.decisions import narrow, truth
from archlint.interpreter.formatting import CARTESIAN, combine, format_one
from archlint.interpreter.operators import binary, compare_values
from archlint.interpreter.values import (
    NO_PARAMETERS,
    NONE,
    Builtin,
    DictValue,
    EachValue,
    External,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    constant,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Run

__all__ = ["evaluate", "get_attribute", "set_attribute"]


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
    return definitions.define_lambda(run, e)


def _assigned(run: Run, e: facts.Assigned) -> Value:
    from archlint.interpreter.statements import assign

    value = run.evaluate(e.value)
    assign(run, e.target, value)
    return value


def _await(run: Run, e: facts.Await) -> Value:
    return calls.awaited(run, run.evaluate(e.value), e)


def _yield(run: Run, e: facts.Yield) -> Value:
    value = NONE if e.value is None else run.evaluate(e.value)
    run.activation.yields.append(value)
    return Unknown("what is sent into a generator")


def _sequence(run: Run, e: facts.Sequence) -> Value:
    values: list[Value] = []
    open_, whole = False, True
    for element in e.elements:
        if isinstance(element, facts.Starred):
            items = iterate(run, run.evaluate(element.value))
            if items is None:
                open_, whole = True, False
            else:
                values.extend(items.values)
                open_, whole = open_ or items.open, whole and items.whole
        else:
            values.append(run.evaluate(element))
    if len(values) > ITEM_LIMIT:
        open_, whole = True, False
    return new_list(run, values[:ITEM_LIMIT], e.kind, open_, whole)


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
    from archlint.interpreter.machine import UNROLL
    from archlint.interpreter.statements import assign

    activation = run.activation
    outermost = run.evaluate(e.generators[0].iterable)  # in the scope around: a class body has names of its own
    scope = run.new_scope(activation.scope, activation.module, "comprehension", activation.qualified)
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
            value = NONE if e.value is None else run.evaluate(e.value)
            rows.append((run.evaluate(e.element), value))
            return
        generator = e.generators[depth]
        iterable = run.evaluate(generator.iterable) if depth else outermost
        items = iterate(run, iterable)
        values: Sequence[Value]
        if items is None or len(items.values) > min(UNROLL, run.items_left):
            open_, whole = True, False
            why = reason(iterable)
            why = "what the loop runs over is not known" if why.startswith("the value") else why
            values = (iterable.element if isinstance(iterable, EachValue) else Unknown(why),)
        else:
            open_ = open_ or items.open
            whole = whole and items.whole
            # What is filled later is gone through once, with an item that is not known.
            later = items.open and not items.whole and not items.values
            values = (unknown_item(run, iterable, "what is in the collection is not known"),) if later else items.values
            run.items_left -= len(values)
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
    return new_list(run, [element for element, _ in rows], "set" if e.kind == "set" else "list", open_, whole)


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
        return one_of(slice_of(run, alternative, bounds) for alternative in alternatives(value))
    index = run.evaluate(e.index)
    found = [get_item(run, container, at) for container in alternatives(value) for at in alternatives(index)]
    return one_of(found[:CARTESIAN])


def _binary(run: Run, e: facts.Binary) -> Value:
    left, right = run.evaluate(e.left), run.evaluate(e.right)
    return binary(run, e.op, left, right, e.span)


def _format_string(run: Run, e: facts.FormatString) -> Value:
    parts: list[Value] = []
    for part in e.parts:
        if isinstance(part, str):
            parts.append(Known(part))
            continue
        value = run.evaluate(part.value)
        if part.conversion in ("r", "a") or part.spec:
            value = one_of(format_one(option, part.conversion, part.spec) for option in alternatives(value))
        parts.append(value)
    return combine(run, parts, e.span)


def _unary(run: Run, e: facts.Unary) -> Value:
    value = run.evaluate(e.operand)
    if e.op == "not":
        known = truth(run, value)
        return Unknown(reason(value)) if known is None else Known(not known, via(value))
    if isinstance(value, Known) and isinstance(value.value, (int, float)):
        number = value.value
        if e.op == "-":
            return constant(-number, value.via)
        if e.op == "+":
            return constant(+number, value.via)
        if isinstance(number, int):
            return constant(~number, value.via)
    return Unknown(reason(value))


def _boolean(run: Run, e: facts.Boolean) -> Value:
    """``and``/``or``: the first operand that decides, or one of those that may."""
    possible: list[Value] = []
    stop = e.op == "or"
    pushed = 0
    key = run.key_of(e.span)
    depth = run.store.depth
    asked: frozenset[str] = NO_PARAMETERS
    try:
        for number, operand in enumerate(e.values):
            value = run.evaluate(operand)
            if stop and asked:
                # What stands in for a parameter that may be empty can be set by that parameter.
                value = one_of(_chosen_by(asked, option) for option in alternatives(value))
            last = number == len(e.values) - 1
            verdict = truth(run, value)
            if last or verdict is stop:
                possible.append(value)
                break
            if verdict is None:
                possible.extend(_with_truth(run, value, stop))
                asked |= via(*alternatives(value))
                # What follows runs only if this operand did not decide.
                run.store.push()
                run.note_open_test(f"{key}#{number}", value)
                run.arms.append((f"{key}#{number}", 0))
                narrow(run, operand, not stop)
                pushed += 1
    finally:
        for _ in range(pushed):
            run.arms.pop()
        if pushed:
            run.store.merge([run.store.cut(depth), {}])
    return one_of(possible)


def _chosen_by(parameters: frozenset[str], value: Value) -> Value:
    return replace(value, via=value.via | parameters) if isinstance(value, Known) else value


def _with_truth(run: Run, value: Value, wanted: bool) -> list[Value]:
    """The alternatives of a value that can be as true as wanted; an unknown truth value of a test is itself."""
    return [option for option in alternatives(value) if truth(run, option) in (None, wanted)]


def _conditional(run: Run, e: facts.Conditional) -> Value:
    test = run.evaluate(e.test)
    verdict = truth(run, test)
    if verdict is not None:
        return run.evaluate(e.body if verdict else e.orelse)
    key = run.key_of(e.span)
    run.note_open_test(key, test)
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
        verdicts.append(compare_values(run, op, left, right))
        left = right
    if len(used) == 2 and None not in verdicts and NONE in used and _is_set(used[0] if used[1] == NONE else used[1]):
        return Known(verdicts[0])  # a parameter keeps its type: one that is set is never None
    if False in verdicts:
        return Known(False, via(*used))
    if None in verdicts:
        inside = [item for value in used if isinstance(value, ListValue) for item in items_of(run, value).values]
        return Unknown(reason(*used, *inside), next(iter(sorted(via(*used))), None))
    return Known(True, via(*used))


def _is_set(value: Value) -> bool:
    return all(isinstance(option, Known) and option.value is not None for option in alternatives(value))


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
