"""The statements of the symbolic run, one function a kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from archlint.interpreter import caught, definitions, hints
from archlint.interpreter.assignment import assign
from archlint.interpreter.attributes import method_of
from archlint.interpreter.augmented import augmented
from archlint.interpreter.call_expressions import never_returns
from archlint.interpreter.conditions import evaluate_test
from archlint.interpreter.heap import Layer
from archlint.interpreter.imports import import_from, import_module
from archlint.interpreter.items import delete_item
from archlint.interpreter.loops import for_each, while_it_holds
from archlint.interpreter.machine import Machine, Status
from archlint.interpreter.narrowing import narrow
from archlint.interpreter.patterns import bind_pattern, matches
from archlint.interpreter.values import NONE, ClassValue, Instance, ListValue, Unknown, Value
from archlint.reasons import Uninformative
from archlint.syntax import facts
from archlint.syntax.walk import statements_of


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
    if isinstance(s.value, facts.Call) and never_returns(machine, s.value):
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
    key = machine.branch_at(s.span)
    why = machine.leave_open(key, test)
    results = []
    for arm, block in enumerate((s.body, s.orelse)):
        with machine.arm(key, arm) as taken:
            narrow(machine, s.test, arm == 0)
            status = machine.execute(block)
        machine.end_arm(key, arm, status)
        results.append((status, taken[0]))
    joined = machine.join(results, why)
    ended = [status for status, _ in results]
    if joined is None and ended.count(None) == 1:
        # The other arm goes to the next round: what follows here knows how the test came out.
        narrow(machine, s.test, ended[0] is None)
    return joined


def _with(machine: Machine, s: facts.With) -> Status:
    for item in s.items:
        value = _entered(machine, machine.evaluate(item.value))
        if item.target is not None:
            assign(machine, item.target, value)
    return machine.execute(s.body)


def _entered(machine: Machine, value: Value) -> Value:
    """What ``with value as x`` binds."""
    match value:
        case ListValue(kind="generator"):
            items = value.items(machine)
            return items.values[0] if items.values else Unknown(Uninformative("the value of a context manager"))
        case Instance(cls=ClassValue()):
            method = method_of(machine, value, "__enter__")
            if method is not None:
                return machine.call(method)
    return value


def _try(machine: Machine, s: facts.Try) -> Status:
    activation = machine.activation
    before = activation.ended_arms
    try:
        status = _tried(machine, s)
    except caught.Raised as raised:
        if all(handler is not raised.handler for handler in s.handlers):
            raise
        status = _handle(machine, raised.handler)
    if s.final:
        ended, activation.ended_arms = activation.ended_arms, before
        final = machine.execute(s.final)
        activation.ended_arms |= ended
        return final or status
    return status


def _tried(machine: Machine, s: facts.Try) -> Status:
    """Run a ``try``, and its handlers for the case that something goes wrong."""
    unknown = machine.unknown_results
    status = _attempt(machine, s)
    goes_well = machine.unknown_results == unknown and status != "raise" and _only_reads(machine, s.body)
    if status is None and s.orelse:
        status = machine.execute(s.orelse)
    results: list[tuple[Status, Layer]] = [(status, {})]
    key = machine.branch_at(s.span)
    # What ends in `break` is the first of several attempts: the others are for the case that it fails.
    attempt = status == "break" and all(caught.only_goes_on(handler) for handler in s.handlers)
    for arm, handler in enumerate([] if attempt or goes_well else s.handlers, start=1):
        if status is None and (_cannot_raise(s.body) or caught.is_import_error(handler.type)):
            continue
        with machine.arm(key, arm) as taken:
            handled = _handle(machine, handler)
        machine.end_arm(key, arm, handled)
        results.append((handled, taken[0]))
    return machine.join(results) if len(results) > 1 else status


def _attempt(machine: Machine, s: facts.Try) -> Status:
    """Run the body of a ``try``."""
    activation = machine.activation
    forgiving = any(caught.may_expect_missing_attribute(handler) for handler in s.handlers)
    expecting = any(map(caught.expects_refusal, s.handlers))
    activation.tries += 1
    activation.forgiving += forgiving
    activation.expecting_refusals += expecting
    activation.catching.append((s, len(machine.branch_arms)))
    try:
        return machine.execute(s.body)
    finally:
        activation.catching.pop()
        activation.tries -= 1
        activation.forgiving -= forgiving
        activation.expecting_refusals -= expecting


def _handle(machine: Machine, handler: facts.Handler) -> Status:
    if handler.name is not None:
        machine.assign_name(handler.name, Unknown("an exception"))
    # What is done where an attribute was missing is the other way, for other versions: neither has to be there.
    activation, other_way = machine.activation, caught.names_missing_attribute(handler)
    activation.forgiving += other_way
    activation.expecting_refusals += other_way
    try:
        return machine.execute(handler.body)
    finally:
        activation.forgiving -= other_way
        activation.expecting_refusals -= other_way


def _only_reads(machine: Machine, body: list[facts.Stmt]) -> bool:
    """Whether a block, of which all is known, is expected to end well: it neither raises nor imports."""
    leaves = (facts.Raise, facts.Import, facts.ImportFrom)
    return machine.library.expects_to_read() and not any(
        isinstance(statement, leaves) for statement in statements_of(body)
    )


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
    key = machine.branch_at(s.span)
    results: list[tuple[Status, Layer]] = []
    for arm, case in enumerate(s.cases):
        verdict = matches(machine, case.pattern, subject)
        if verdict is False:
            continue
        with machine.arm(key, arm) as taken:
            bind_pattern(machine, case.pattern, subject)
            guard = None if case.guard is None else evaluate_test(machine, case.guard)[1]
            certain = verdict is True and (case.guard is None or guard is True)
            if guard is False:
                continue
            if certain and not results:
                break
            status = machine.execute(case.body)
        machine.end_arm(key, arm, status)
        results.append((status, taken[0]))
        if certain:
            return machine.join(results)
    else:
        results.append((None, {}))
        return machine.join(results)
    # The first case that can match does match: no branch at all.
    bind_pattern(machine, case.pattern, subject)
    return machine.execute(case.body)


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
        elif isinstance(target, facts.Name):
            machine.library.unbound(machine.activation, target.id)
    return None


def _assert(machine: Machine, s: facts.Assert) -> Status:
    machine.evaluate(s.test)
    narrow(machine, s.test, True)
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
    facts.For: for_each,
    facts.While: while_it_holds,
    facts.With: _with,
    facts.Try: _try,
    facts.Match: _match,
    facts.Import: import_module,
    facts.ImportFrom: import_from,
    facts.Global: _nothing,
    facts.Delete: _delete,
    facts.Assert: _assert,
    facts.Jump: _jump,
    facts.Function: _function,
    facts.Class: _class,
}
