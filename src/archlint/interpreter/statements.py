"""The statements of the symbolic run, one function a kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from archlint.interpreter import calls, caught, containers, decisions, definitions, hints, refusals
from archlint.interpreter.assignment import assign
from archlint.interpreter.augmented import augmented, forget_counters
from archlint.interpreter.expressions import evaluate_test
from archlint.interpreter.heap import Layer
from archlint.interpreter.items import delete_item
from archlint.interpreter.machine import UNROLL, Machine, Status
from archlint.interpreter.values import NONE, External, Items, Unknown, Value, reason
from archlint.reasons import NOT_A_CONSTANT
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module


def _assign(machine: Machine, s: facts.Assign) -> Status:
    value = machine.evaluate(s.value)
    for target in s.targets:
        assign(machine, target, value)
    return None


def _annotated(machine: Machine, s: facts.Annotated) -> Status:
    if s.value is not None:
        assign(machine, s.target, hints.annotated(machine, machine.evaluate(s.value), s.annotation))
    return None


def _expression(machine: Machine, s: facts.Expression) -> Status:
    machine.evaluate(s.value)
    if isinstance(s.value, facts.Call) and calls.never_returns(machine, s.value):
        return "raise"
    return None


def _return(machine: Machine, s: facts.Return) -> Status:
    value = NONE if s.value is None else machine.evaluate(s.value)
    activation = machine.activation
    straight = machine.store.depth == activation.depth + 1
    activation.returns.append((value, None if straight else machine.store.above(activation.depth)))
    return "return"


def _raise(machine: Machine, s: facts.Raise) -> Status:
    if s.value is not None:
        machine.evaluate(s.value)
    return "raise"


def _if(machine: Machine, s: facts.If) -> Status:
    test, truth = evaluate_test(machine, s.test)
    if truth is not None:
        return machine.execute(s.body if truth else s.orelse)
    key = machine.key_of(s.span)
    machine.library.undecided(key, test)
    results = []
    for arm, block in enumerate((s.body, s.orelse)):
        with machine.arm(key, arm) as taken:
            decisions.narrow(machine, s.test, arm == 0)
            status = machine.execute(block)
        results.append((status, taken[0]))
    joined = machine.join(results)
    ended = [status for status, _ in results]
    if joined is None and ended.count(None) == 1:
        # The other arm goes to the next round: what follows here knows how the test came out.
        decisions.narrow(machine, s.test, ended[0] is None)
    return joined


def _for(machine: Machine, s: facts.For) -> Status:
    iterable = machine.evaluate(s.iterable)
    if refusals.refuses_to_iterate(machine, iterable):
        return "raise"
    activation = machine.activation
    activation.loops.append(s)
    try:
        items = containers.iterate(machine, iterable)
        if items is None or items.open or len(items.values) > UNROLL:
            return _loop_of_unknown(machine, s, iterable, items)
        for item in items.values:
            assign(machine, s.target, item)
            status = machine.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return _otherwise(machine, s)


def _otherwise(machine: Machine, s: facts.For | facts.While) -> Status:
    """The ``else`` of a loop: only one of two ways on where a ``break`` may have left the loop."""
    if not s.orelse or id(s) not in machine.activation.left:
        return machine.execute(s.orelse)
    machine.activation.left.discard(id(s))
    return machine.join([machine.branch(machine.key_of(s.span), 0, s.orelse), (None, {})])


def _loop_of_unknown(machine: Machine, s: facts.For, iterable: Value, items: Items | None) -> Status:
    key = machine.key_of(s.span)
    if items is not None and len(items.values) <= UNROLL:
        for number, item in enumerate(items.values):
            with machine.arm(key + f"#{number}", 0) as taken:
                assign(machine, s.target, item)
                machine.execute(s.body)
            machine.store.merge([taken[0], {}])
        if items.whole or any(isinstance(item, Unknown) for item in items.values):
            return None
    with machine.arm(key, 0) as taken:
        forget_counters(machine, s.body)
        why = reason(iterable)
        if why is NOT_A_CONSTANT:
            why = "what the loop runs over is not known"
        assign(machine, s.target, containers.unknown_item(machine, iterable, why))
        status = machine.execute(s.body)
    _maybe_a_round(machine, status, taken[0])
    return None


def _maybe_a_round(machine: Machine, status: Status, written: Layer) -> None:
    """Go on after a body that may have run, or not."""
    machine.join([(None if status in ("break", "continue") else status, written), (None, {})])


def _while(machine: Machine, s: facts.While) -> Status:
    activation = machine.activation
    activation.loops.append(s)
    try:
        for _ in range(UNROLL):
            _, truth = evaluate_test(machine, s.test)
            if truth is False:
                break
            constant = isinstance(s.test, facts.Literal)
            if truth is None or constant:
                return _loop_once(machine, s, certain=constant)
            status = machine.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return _otherwise(machine, s)


def _loop_once(machine: Machine, s: facts.While, certain: bool) -> Status:
    if certain:
        forget_counters(machine, s.body)
        status = machine.execute(s.body)
        return status if status in ("return", "raise") else None
    with machine.arm(machine.key_of(s.span), 0) as taken:
        decisions.narrow(machine, s.test, True)
        forget_counters(machine, s.body)
        status = machine.execute(s.body)
    _maybe_a_round(machine, status, taken[0])
    return None


def _with(machine: Machine, s: facts.With) -> Status:
    for item in s.items:
        value = calls.enter(machine, machine.evaluate(item.value))
        if item.target is not None:
            assign(machine, item.target, value)
    return machine.execute(s.body)


def _try(machine: Machine, s: facts.Try) -> Status:
    activation = machine.activation
    forgiving = any(caught.may_expect_missing_attribute(handler) for handler in s.handlers)
    activation.tries += 1
    activation.forgiving += forgiving
    try:
        status = machine.execute(s.body)
    finally:
        activation.tries -= 1
        activation.forgiving -= forgiving
    if status is None and s.orelse:
        status = machine.execute(s.orelse)
    results: list[tuple[Status, Layer]] = [(status, {})]
    key = machine.key_of(s.span)
    # What ends in `break` is the first of several attempts: the others are for the case that it fails.
    attempt = status == "break" and all(caught.only_goes_on(handler) for handler in s.handlers)
    for arm, handler in enumerate([] if attempt else s.handlers, start=1):
        if status is None and (_cannot_raise(s.body) or caught.is_import_error(handler.type)):
            continue
        with machine.arm(key, arm) as taken:
            if handler.name is not None:
                machine.assign_name(handler.name, Unknown("an exception"))
            handled = machine.execute(handler.body)
        results.append((handled, taken[0]))
    status = machine.join(results) if len(results) > 1 else status
    if s.final:
        final = machine.execute(s.final)
        return final or status
    return status


def _cannot_raise(body: list[facts.Stmt]) -> bool:
    """Whether a block only binds constants."""
    return all(map(_binds_constant, body))


def _binds_constant(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Assign(value=facts.Literal(), targets=targets):
            return all(target.variable for target in targets)
    return False


def _match(machine: Machine, s: facts.Match) -> Status:
    subject = machine.evaluate(s.subject)
    key = machine.key_of(s.span)
    results: list[tuple[Status, Layer]] = []
    for arm, case in enumerate(s.cases):
        verdict = decisions.matches(machine, case.pattern, subject)
        if verdict is False:
            continue
        with machine.arm(key, arm) as taken:
            decisions.bind_pattern(machine, case.pattern, subject)
            guard = None if case.guard is None else evaluate_test(machine, case.guard)[1]
            certain = verdict is True and (case.guard is None or guard is True)
            if guard is False:
                continue
            if certain and not results:
                break
            status = machine.execute(case.body)
        results.append((status, taken[0]))
        if certain:
            return machine.join(results)
    else:
        results.append((None, {}))
        return machine.join(results)
    # The first case that can match does match: no branch at all.
    decisions.bind_pattern(machine, case.pattern, subject)
    return machine.execute(case.body)


def _import(machine: Machine, s: facts.Import) -> Status:
    importer = machine.activation.module
    found = machine.index.find(importer, s.module)
    if s.alias is not None:
        machine.assign_name(s.alias, External(s.module) if found is None else machine.import_module(found))
        return None
    if found is not None:
        machine.import_module(found)
    top = s.module.partition(".")[0]
    first = machine.index.find(importer, top)
    machine.assign_name(top, External(top) if first is None else machine.import_module(first))
    return None


def _import_from(machine: Machine, s: facts.ImportFrom) -> Status:
    importer = machine.activation.module
    found = machine.index.find(importer, s.module, s.level)
    dotted = machine.index.absolute_name(importer, s.module, s.level)
    for name, bound in s.names:
        if name == "*":
            _import_star(machine, found, dotted)
            continue
        value: Value | None = None
        if found is not None and found is not importer:
            value = machine.module_attribute(found, name)
            if value is None:
                value = (
                    Unknown(f"'{name}' is defined later in an import cycle")
                    if found.state == "running"
                    else Unknown(f"{found.name} has no '{name}'")
                )
        else:
            below = machine.index.find(importer, f"{s.module}.{name}" if s.module else name, s.level)
            if below is None:
                value = machine.library.imported(f"{dotted}.{name}", s.span)
            else:
                value = machine.import_module(below)
        machine.assign_name(bound, value)
    return None


def _import_star(machine: Machine, found: Module | None, dotted: str) -> None:
    if found is None:
        machine.activation.module.star_externals.append(dotted)
        return
    machine.import_module(found)
    assert found.scope is not None
    exports = found.facts.exports
    for name, value in machine.store.variables(found.scope.key):
        if name in exports if exports is not None else not name.startswith("_"):
            machine.assign_name(name, value)
    machine.activation.module.star_externals.extend(found.star_externals)


def _function(machine: Machine, s: facts.Function) -> Status:
    machine.assign_name(s.name, definitions.define_function(machine, s))
    return None


def _class(machine: Machine, s: facts.Class) -> Status:
    machine.assign_name(s.name, definitions.define_class(machine, s))
    return None


def _delete(machine: Machine, s: facts.Delete) -> Status:
    for target in s.targets:
        if isinstance(target, facts.Subscript):
            delete_item(machine, machine.evaluate(target.value), machine.evaluate(target.index))
    return None


def _assert(machine: Machine, s: facts.Assert) -> Status:
    machine.evaluate(s.test)
    decisions.narrow(machine, s.test, True)
    return None


def _jump(machine: Machine, s: facts.Jump) -> Status:
    return None if s.kind == "pass" else s.kind


def _nothing(machine: Machine, s: facts.Global) -> Status:
    return None


STATEMENTS: dict[type, Callable[[Machine, Any], Status]] = {
    facts.Assign: _assign,
    facts.Annotated: _annotated,
    facts.Augmented: augmented,
    facts.Expression: _expression,
    facts.Return: _return,
    facts.Raise: _raise,
    facts.If: _if,
    facts.For: _for,
    facts.While: _while,
    facts.With: _with,
    facts.Try: _try,
    facts.Match: _match,
    facts.Import: _import,
    facts.ImportFrom: _import_from,
    facts.Global: _nothing,
    facts.Delete: _delete,
    facts.Assert: _assert,
    facts.Jump: _jump,
    facts.Function: _function,
    facts.Class: _class,
}
