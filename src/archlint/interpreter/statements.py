"""The statements of the symbolic run, one function a kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from archlint.interpreter import calls, caught, containers, decisions, definitions, expressions, hints, refusals
from archlint.interpreter.augmented import augmented, forget_counters
from archlint.interpreter.heap import Items, Layer
from archlint.interpreter.machine import UNROLL, Run, Status
from archlint.interpreter.values import NONE, External, Unknown, Value, alternatives, one_of
from archlint.libraries.rclpy import escapes, messages
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module


def assign(run: Run, target: facts.Expr, value: Value) -> None:
    """Bind an assignment target."""
    kind = target.__class__
    if kind is facts.Name:
        assert isinstance(target, facts.Name)
        run.assign_name(target.id, value)
    elif kind is facts.Attribute:
        assert isinstance(target, facts.Attribute)
        expressions.set_attribute(run, run.evaluate(target.value), target.attr, value, target)
    elif kind is facts.Subscript:
        assert isinstance(target, facts.Subscript)
        containers.set_item(run, run.evaluate(target.value), run.evaluate(target.index), value)
    elif kind is facts.Sequence:
        assert isinstance(target, facts.Sequence)
        _unpack(run, target.elements, value)
    elif kind is facts.Starred:
        assert isinstance(target, facts.Starred)
        assign(run, target.value, value)


def _unpack(run: Run, targets: list[facts.Expr], value: Value) -> None:
    if isinstance(value, (Unknown,)):
        for target in targets:
            assign(run, target, value)
        return
    rows = []
    for alternative in alternatives(value):
        items = containers.iterate(run, alternative)
        rows.append(None if items is None or items.open else list(items.values))
    stars = [i for i, target in enumerate(targets) if isinstance(target, facts.Starred)]
    if any(row is None for row in rows) or stars or any(len(row or ()) != len(targets) for row in rows):
        if len(rows) == 1 and rows[0] is not None and len(stars) == 1 and len(rows[0]) >= len(targets) - 1:
            row, at = rows[0], stars[0]
            after = len(targets) - at - 1
            middle = row[at : len(row) - after]
            for target, item in zip(targets[:at], row[:at], strict=True):
                assign(run, target, item)
            assign(run, targets[at], containers.new_list(run, middle))
            for target, item in zip(targets[at + 1 :], row[len(row) - after :], strict=True):
                assign(run, target, item)
            return
        unknown = Unknown("the items of this value are not known")
        escapes.lost(run, unknown, (value,), "it is unpacked from a list")
        for target in targets:
            assign(run, target, unknown)
        return
    for i, target in enumerate(targets):
        assign(run, target, one_of(row[i] for row in rows if row is not None))


def _assign(run: Run, s: facts.Assign) -> Status:
    value = run.evaluate(s.value)
    for target in s.targets:
        assign(run, target, value)
    return None


def _annotated(run: Run, s: facts.Annotated) -> Status:
    if s.value is not None:
        assign(run, s.target, hints.annotated(run, run.evaluate(s.value), s.annotation))
    elif run.activation.scope.kind == "class" and isinstance(s.target, facts.Name):
        pass  # a dataclass field without a default; its value comes from the constructor
    return None


def _expression(run: Run, s: facts.Expression) -> Status:
    run.evaluate(s.value)
    if isinstance(s.value, facts.Call) and calls.never_returns(run, s.value):
        return "raise"
    return None


def _return(run: Run, s: facts.Return) -> Status:
    value = NONE if s.value is None else run.evaluate(s.value)
    activation = run.activation
    straight = run.store.depth == activation.depth + 1
    activation.returns.append((value, None if straight else run.store.above(activation.depth)))
    return "return"


def _raise(run: Run, s: facts.Raise) -> Status:
    if s.value is not None:
        run.evaluate(s.value)
    return "raise"


def _if(run: Run, s: facts.If) -> Status:
    test = run.evaluate(s.test)
    truth = decisions.truth(run, test)
    if truth is not None:
        return run.execute(s.body if truth else s.orelse)
    key = run.key_of(s.span)
    run.note_open_test(key, test)
    results = []
    for arm, block in enumerate((s.body, s.orelse)):
        with run.arm(key, arm) as taken:
            decisions.narrow(run, s.test, arm == 0)
            status = run.execute(block)
        results.append((status, taken[0]))
    joined = run.join(results)
    ended = [status for status, _ in results]
    if joined is None and ended.count(None) == 1:
        # The other arm goes to the next round: what follows here knows how the test came out.
        decisions.narrow(run, s.test, ended[0] is None)
    return joined


def _for(run: Run, s: facts.For) -> Status:
    iterable = run.evaluate(s.iterable)
    if refusals.refuses_to_iterate(run, iterable):
        return "raise"
    activation = run.activation
    activation.loops.append(s)
    try:
        items = containers.iterate(run, iterable)
        if items is None or items.open or len(items.values) > UNROLL:
            return _loop_of_unknown(run, s, iterable, items)
        for item in items.values:
            assign(run, s.target, item)
            status = run.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return _otherwise(run, s)


def _otherwise(run: Run, s: facts.For | facts.While) -> Status:
    """The ``else`` of a loop: only one of two ways on where a ``break`` may have left the loop."""
    if not s.orelse or id(s) not in run.activation.left:
        return run.execute(s.orelse)
    run.activation.left.discard(id(s))
    return run.join([run.branch(run.key_of(s.span), 0, s.orelse), (None, {})])


def _loop_of_unknown(run: Run, s: facts.For, iterable: Value, items: Items | None) -> Status:
    key = run.key_of(s.span)
    if items is not None and len(items.values) <= UNROLL:
        for number, item in enumerate(items.values):
            with run.arm(key + f"#{number}", 0) as taken:
                assign(run, s.target, item)
                run.execute(s.body)
            run.store.merge([taken[0], {}])
        if items.whole or any(isinstance(item, Unknown) for item in items.values):
            return None
    from archlint.interpreter.values import reason

    with run.arm(key, 0) as taken:
        forget_counters(run, s.body)
        why = reason(iterable)
        if why == "the value is not a constant":
            why = "what the loop runs over is not known"
        assign(run, s.target, containers.unknown_item(run, iterable, why))
        status = run.execute(s.body)
    _maybe_a_round(run, status, taken[0])
    return None


def _maybe_a_round(run: Run, status: Status, written: Layer) -> None:
    """Go on after a body that may have run, or not."""
    run.join([(None if status in ("break", "continue") else status, written), (None, {})])


def _while(run: Run, s: facts.While) -> Status:
    activation = run.activation
    activation.loops.append(s)
    try:
        for _ in range(UNROLL):
            truth = decisions.truth(run, run.evaluate(s.test))
            if truth is False:
                break
            constant = isinstance(s.test, facts.Literal)
            if truth is None or constant:
                return _loop_once(run, s, certain=constant)
            status = run.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return _otherwise(run, s)


def _loop_once(run: Run, s: facts.While, certain: bool) -> Status:
    if certain:
        forget_counters(run, s.body)
        status = run.execute(s.body)
        return status if status in ("return", "raise") else None
    with run.arm(run.key_of(s.span), 0) as taken:
        decisions.narrow(run, s.test, True)
        forget_counters(run, s.body)
        status = run.execute(s.body)
    _maybe_a_round(run, status, taken[0])
    return None


def _with(run: Run, s: facts.With) -> Status:
    for item in s.items:
        value = calls.enter(run, run.evaluate(item.value))
        if item.target is not None:
            assign(run, item.target, value)
    return run.execute(s.body)


def _try(run: Run, s: facts.Try) -> Status:
    activation = run.activation
    forgiving = any(caught.may_expect_missing_attribute(handler) for handler in s.handlers)
    activation.tries += 1
    activation.forgiving += forgiving
    try:
        status = run.execute(s.body)
    finally:
        activation.tries -= 1
        activation.forgiving -= forgiving
    if status is None and s.orelse:
        status = run.execute(s.orelse)
    results: list[tuple[Status, Layer]] = [(status, {})]
    key = run.key_of(s.span)
    # What ends in `break` is the first of several attempts: the others are for the case that it fails.
    attempt = status == "break" and all(caught.only_goes_on(handler) for handler in s.handlers)
    for arm, handler in enumerate([] if attempt else s.handlers, start=1):
        if status is None and (_cannot_raise(s.body) or caught.is_import_error(handler.type)):
            continue
        with run.arm(key, arm) as taken:
            if handler.name is not None:
                run.assign_name(handler.name, Unknown("an exception"))
            handled = run.execute(handler.body)
        results.append((handled, taken[0]))
    status = run.join(results) if len(results) > 1 else status
    if s.final:
        final = run.execute(s.final)
        return final or status
    return status


def _cannot_raise(body: list[facts.Stmt]) -> bool:
    """Whether a block only binds constants."""
    return all(
        isinstance(statement, facts.Assign)
        and isinstance(statement.value, facts.Literal)
        and all(isinstance(target, facts.Name) for target in statement.targets)
        for statement in body
    )


def _match(run: Run, s: facts.Match) -> Status:
    subject = run.evaluate(s.subject)
    key = run.key_of(s.span)
    results: list[tuple[Status, Layer]] = []
    for arm, case in enumerate(s.cases):
        verdict = decisions.matches(run, case.pattern, subject)
        if verdict is False:
            continue
        with run.arm(key, arm) as taken:
            decisions.bind_pattern(run, case.pattern, subject)
            guard = None if case.guard is None else decisions.truth(run, run.evaluate(case.guard))
            certain = verdict is True and (case.guard is None or guard is True)
            if guard is False:
                continue
            if certain and not results:
                break
            status = run.execute(case.body)
        results.append((status, taken[0]))
        if certain:
            return run.join(results)
    else:
        results.append((None, {}))
        return run.join(results)
    # The first case that can match does match: no branch at all.
    decisions.bind_pattern(run, case.pattern, subject)
    return run.execute(case.body)


def _import(run: Run, s: facts.Import) -> Status:
    importer = run.activation.module
    found = run.index.find(importer, s.module)
    if s.alias is not None:
        run.assign_name(s.alias, External(s.module) if found is None else run.import_module(found))
        return None
    if found is not None:
        run.import_module(found)
    top = s.module.partition(".")[0]
    first = run.index.find(importer, top)
    run.assign_name(top, External(top) if first is None else run.import_module(first))
    return None


def _import_from(run: Run, s: facts.ImportFrom) -> Status:
    importer = run.activation.module
    found = run.index.find(importer, s.module, s.level)
    dotted = run.index.absolute_name(importer, s.module, s.level)
    for name, bound in s.names:
        if name == "*":
            _import_star(run, found, dotted)
            continue
        value: Value | None = None
        if found is not None and found is not importer:
            value = run.module_attribute(found, name)
            if value is None:
                value = (
                    Unknown(f"'{name}' is defined later in an import cycle")
                    if found.state == "running"
                    else Unknown(f"{found.name} has no '{name}'")
                )
        else:
            below = run.index.find(importer, f"{s.module}.{name}" if s.module else name, s.level)
            if below is None:
                messages.note_interface(run, f"{dotted}.{name}", s.span)
                value = messages.missing_interface(run, f"{dotted}.{name}") or External(f"{dotted}.{name}")
            else:
                value = run.import_module(below)
        run.assign_name(bound, value)
    return None


def _import_star(run: Run, found: Module | None, dotted: str) -> None:
    if found is None:
        run.activation.module.star_externals.append(dotted)
        return
    run.import_module(found)
    assert found.scope is not None
    exports = found.facts.exports
    for (key, name), value in list(run.store.layers[0].items()):
        if key == found.scope.key and isinstance(name, str) and isinstance(value, Value):
            public = name in exports if exports is not None else not name.startswith("_")
            if public:
                run.assign_name(name, value)
    run.activation.module.star_externals.extend(found.star_externals)


def _function(run: Run, s: facts.Function) -> Status:
    run.assign_name(s.name, definitions.define_function(run, s))
    return None


def _class(run: Run, s: facts.Class) -> Status:
    run.assign_name(s.name, definitions.define_class(run, s))
    return None


def _delete(run: Run, s: facts.Delete) -> Status:
    for target in s.targets:
        if isinstance(target, facts.Subscript):
            containers.delete_item(run, run.evaluate(target.value), run.evaluate(target.index))
    return None


def _assert(run: Run, s: facts.Assert) -> Status:
    run.evaluate(s.test)
    decisions.narrow(run, s.test, True)
    return None


def _jump(run: Run, s: facts.Jump) -> Status:
    return None if s.kind == "pass" else s.kind


def _nothing(run: Run, s: facts.Global) -> Status:
    return None


STATEMENTS: dict[type, Callable[[Run, Any], Status]] = {
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
