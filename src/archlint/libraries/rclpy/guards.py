"""What decides whether a create call is reached: nothing, what a callback was called with, or some state."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_deciders import MOST
from archlint.syntax.parts import Itself
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
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
    guard: GuardKind = NOTHING
    for number, activation in enumerate(run.activations):
        tests = _tests_on_path(activation.body, activation.statement)
        if tests is None or (tests and (number != 1 or not _about_arguments(tests, activation))):
            return STATE
        guard = ARGUMENTS if tests else guard
    return guard


def _tests_on_path(body: Sequence[facts.Stmt], wanted: facts.Stmt | None) -> Sequence[facts.Expr] | None:
    """The conditions that decide whether a statement is reached; None where there is more to it."""
    return [] if wanted is None else _deciding(Itself(body), Itself(wanted))


@lru_cache(maxsize=4096)
def _deciding(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> tuple[facts.Expr, ...] | None:
    graph = graph_of(body.fact)
    blocks = graph.of(wanted.fact)
    if graph.without_exceptions.isdisjoint(blocks):
        return None  # an exception leads there
    tests: list[facts.Expr] = []
    deciders = graph.deciders(blocks)
    if len(deciders) >= MOST:
        return None  # there may be others
    for block in deciders:
        match block.statement:
            case facts.If(test):
                tests.append(test)
            case facts.For():
                pass  # an item is something new each time
            case _:
                return None
    return tuple(tests)


def _about_arguments(tests: Sequence[facts.Expr], activation: Activation) -> bool:
    """Whether conditions look at nothing but what a function was called with."""
    function = activation.function
    if function is None or not isinstance(function.ir, facts.Function):
        return False
    known = _from_arguments(Itself(function.ir), Itself(activation.body))
    return all(_looks_at(test, known) for test in tests)


@lru_cache(maxsize=1024)
def _from_arguments(function: Itself[facts.Function], body: Itself[Sequence[facts.Stmt]]) -> frozenset[str]:
    """The parameters of a function, and the names of what is made of them alone."""
    known = frozenset(param.name for param in function.fact.params) - {"self", "cls"}
    for statement in statements_of(body.fact):
        match statement:
            case facts.Assign(targets, value):
                names = {target.variable for target in targets}
            case facts.For(target, value) if target.variable:
                names = {target.variable}
            case _:
                continue
        known = known | names if _looks_at(value, known) else known - names
    return known


def _looks_at(expression: facts.Expr, known: frozenset[str]) -> bool:
    """Whether an expression is made of known names, literals, constants and classes, and asks at least one of these
    names."""
    names = [part.id for part in parts_of(expression, facts.Name)]
    asked = [name for name in names if name not in _PLAIN and not name[:1].isupper()]
    plain = all(call.func.attribute or called_name(call) in _PLAIN for call in calls_in(expression))
    return plain and bool(asked) and known.issuperset(asked)
