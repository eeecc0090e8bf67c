"""What decides whether a create call is reached: nothing, what a callback was called with, or some state."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from archlint.syntax import facts
from archlint.syntax.control_flow import always_raises
from archlint.syntax.parts import Itself
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.activation import Activation
    from archlint.libraries.run import Run
    from archlint.model import GuardKind

NOTHING: Final = ""
ARGUMENTS: Final = "arguments"
STATE: Final = "state"

_PLAIN = frozenset(
    {"abs", "all", "any", "bool", "float", "int", "isinstance", "len", "list", "max", "min", "round", "set", "str"}
)
"""Builtins that look at their arguments and at nothing else."""


def guard_of(run: Run) -> GuardKind:
    """What an ``if`` around what runs now, or an early return in front of it, asks; on the whole way there.

    Only the callback itself is known to be called with something new each time: what a helper gets may well be
    the caller's state.
    """
    found: GuardKind = NOTHING
    for number, one in enumerate(run.activations):
        tests = _tests_on_the_way(one.body, one.statement)
        if tests is None or (tests and (number != 1 or not _about_arguments(tests, one))):
            return STATE
        found = ARGUMENTS if tests else found
    return found


def proven_of(run: Run) -> tuple[tuple[Place, bool], ...]:
    """The ``if`` statements around what runs now, with how their conditions came out, that ask for names which are no
    function's own."""
    return tuple(
        (one.place(statement.span), truth)
        for one in run.activations
        for statement, truth in _proven(one.body, one.statement)
        if one.scope.kind != "function" or not _asks(statement.test) & (one.scope.bound or frozenset())
    )


def _asks(test: facts.Expr) -> set[str]:
    return {part.id for part in parts_of(test, facts.Name)}


def _proven(block: Sequence[facts.Stmt], wanted: facts.Stmt | None) -> list[tuple[facts.If, bool]]:
    at = _layout(Itself(block))[0].get(id(wanted))
    if at is None or block[at] is wanted:
        return []
    statement = block[at]
    inner = next(one for one in statement.blocks if id(wanted) in _layout(Itself(one))[0])
    below = _proven(inner, wanted)
    return [(statement, inner is statement.body), *below] if isinstance(statement, facts.If) else below


def is_cleaning_up(run: Run) -> bool:
    """Whether what runs now is there because something failed, and the callback ends with it: on the way to it is an
    ``except`` that always raises, or that (or ``finally``) shuts the node down."""
    return any(_cleans_up(one.body, one.statement) for one in run.activations)


def _cleans_up(block: Sequence[facts.Stmt], wanted: facts.Stmt | None) -> bool:
    at = _layout(Itself(block))[0].get(id(wanted))
    if at is None or block[at] is wanted:
        return False
    statement = block[at]
    inner = next(one for one in statement.blocks if id(wanted) in _layout(Itself(one))[0])
    if isinstance(statement, facts.Try):
        handled = any(inner is handler.body for handler in statement.handlers)
        if handled and always_raises(inner):
            return True
        if (handled or inner is statement.final) and any(called_name(call) in _ENDS for call in calls_in(inner)):
            return True
    return _cleans_up(inner, wanted)


_ENDS = frozenset({"shutdown", "try_shutdown", "destroy_node"})


def _tests_on_the_way(block: Sequence[facts.Stmt], wanted: facts.Stmt | None) -> list[facts.Expr] | None:
    """The conditions that decide whether a statement of a block is reached; None where there is more to it."""
    places, exits = _layout(Itself(block))
    at = places.get(id(wanted))
    found: list[facts.Expr] = []
    for number in exits:
        if at is not None and number >= at:
            break
        tests = _tests_within(block[number])
        if tests is None:
            return None
        found += tests
    if at is None:
        # What runs is no statement of this block, such as the head of a loop.
        return None if exits else found
    inner = _inner_tests(block[at], wanted)
    return None if inner is None else [*found, *inner]


def _inner_tests(statement: facts.Stmt, wanted: facts.Stmt | None) -> list[facts.Expr] | None:
    if statement is wanted:
        return []
    match statement:
        case facts.With() | facts.For():
            return _tests_on_the_way(statement.body, wanted)
        case facts.Try(body) if id(wanted) in _layout(Itself(body))[0]:
            return _tests_on_the_way(body, wanted)
        case facts.If(test, body, orelse):
            inner = _tests_on_the_way(body if id(wanted) in _layout(Itself(body))[0] else orelse, wanted)
            return None if inner is None else [test, *inner]
    return None


def _tests_within(statement: facts.Stmt) -> list[facts.Expr] | None:
    """The conditions of a statement that may leave the function; None where something else than ``if`` decides."""
    found = []
    for one in statements_of([statement]):
        match one:
            case facts.If(test):
                found.append(test)
            case facts.Try() | facts.While() | facts.Match():
                return None
    return found


def _about_arguments(tests: Sequence[facts.Expr], activation: Activation) -> bool:
    """Whether conditions look at nothing but what a function was called with."""
    function = activation.function
    if function is None or not isinstance(function.ir, facts.Function):
        return False
    known = {param.name for param in function.ir.params} - {"self", "cls"}
    for statement in statements_of(activation.body):
        match statement:
            case facts.Assign(targets, value):
                names = {target.variable for target in targets}
            case facts.For(target, value) if target.variable:
                names = {target.variable}
            case _:
                continue
        known = known | names if _looks_at(value, known) else known - names
    return all(_looks_at(test, known) for test in tests)


def _looks_at(expression: facts.Expr, known: set[str]) -> bool:
    """Whether an expression is made of known names, literals, constants and classes, and asks at least one of these
    names."""
    names = [part.id for part in parts_of(expression, facts.Name)]
    asked = [name for name in names if name not in _PLAIN and not name[:1].isupper()]
    plain = all(call.func.attribute or called_name(call) in _PLAIN for call in calls_in(expression))
    return plain and bool(asked) and known.issuperset(asked)


@lru_cache(maxsize=4096)
def _layout(key: Itself[Sequence[facts.Stmt]]) -> tuple[dict[int, int], tuple[int, ...]]:
    """In which statement of a block each statement lies, and those that may leave the function."""
    places: dict[int, int] = {}
    exits: dict[int, None] = {}
    for number, statement in enumerate(key.fact):
        for one in statements_of([statement]):
            places[id(one)] = number
            if isinstance(one, (facts.Return, facts.Raise)):
                exits[number] = None
    return places, tuple(exits)
