"""What decides whether a create call is reached: nothing, what a callback was called with, or some state."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from archlint.syntax import facts
from archlint.syntax.control_flow import always_raises, graph_of
from archlint.syntax.flow_blocks import Block, without_exceptions
from archlint.syntax.flow_deciders import MOST
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


def proven_of(run: Run) -> tuple[tuple[Place, bool], ...]:
    """The ``if`` statements that lead to what runs now and ask for names which are no function's own, with how their
    conditions came out."""
    return tuple(
        (activation.place(statement.span), truth)
        for activation in run.activations
        if activation.statement is not None
        for statement, truth in _proven(Itself(activation.body), Itself(activation.statement))
        if activation.scope.kind != "function" or not _asks(statement.test) & (activation.scope.bound or frozenset())
    )


def _asks(test: facts.Expr) -> set[str]:
    return {part.id for part in parts_of(test, facts.Name)}


@lru_cache(maxsize=4096)
def _proven(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> tuple[tuple[facts.If, bool], ...]:
    graph = graph_of(body.fact)
    edges = [(edge.source.statement, edge.holds) for edge in graph.outcomes(graph.of(wanted.fact))]
    return tuple((statement, holds) for statement, holds in edges if isinstance(statement, facts.If))


def is_cleaning_up(run: Run) -> bool:
    """Whether what runs now is there because something failed, and runs once: on the way to it is an ``except``, and no
    loop that tries again; or an ``except`` that always raises, or that (or ``finally``) shuts the node down; or every
    way on raises, and no ``try`` is around."""
    caught = any(activation.tries for activation in run.activations)
    recovers = any(
        id(activation.statement) in _in_handlers(Itself(activation.body))
        for activation in run.activations
        if activation.statement is not None
    )
    return (recovers and not run.enclosing_loops()) or any(
        _cleans_up(Itself(activation.body), Itself(activation.statement))
        or (not caught and _raises_next(Itself(activation.body), Itself(activation.statement)))
        for activation in run.activations
        if activation.statement is not None
    )


def _cleans_up(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> bool:
    return id(wanted.fact) in _in_clean_up(body)


@lru_cache(maxsize=1024)
def _in_clean_up(body: Itself[Sequence[facts.Stmt]]) -> frozenset[int]:
    return frozenset(
        id(inner)
        for statement in statements_of(body.fact, facts.Try)
        for block, handles in ((statement.final, False), *((handler.body, True) for handler in statement.handlers))
        if (handles and always_raises(block)) or any(called_name(call) in _ENDS for call in calls_in(block))
        for inner in statements_of(block)
    )


@lru_cache(maxsize=1024)
def _in_handlers(body: Itself[Sequence[facts.Stmt]]) -> frozenset[int]:
    return frozenset(
        id(inner)
        for statement in statements_of(body.fact, facts.Try)
        for handler in statement.handlers
        for inner in statements_of(handler.body)
    )


def _raises_next(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> bool:
    blocks = graph_of(body.fact).of(wanted.fact)
    return bool(blocks) and _raising(body).issuperset(blocks)


@lru_cache(maxsize=1024)
def _raising(body: Itself[Sequence[facts.Stmt]]) -> frozenset[Block]:
    """The blocks from which every way leads to a ``raise``."""
    graph = graph_of(body.fact)
    raising = [block for block in graph.blocks if isinstance(block.fact, facts.Raise)]
    others = graph.before(graph.exits, without_exceptions, avoiding=raising).union(graph.exits) if raising else ()
    return frozenset(graph.blocks).difference(others) if raising else frozenset()


_ENDS = frozenset({"shutdown", "try_shutdown", "destroy_node"})


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
