"""Spins for as long as nobody else spins: a flag, set where another spin is started, keeps callbacks away from them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall


def is_while_nobody_spins(code: SourceCode, spin: ApiCall) -> bool:
    """Whether a spin is reached only where a flag is false that is set together with the start of another spin::

    def wait(self, future):
        if self.running:
            future_event.wait()
        else:
            rclpy.spin_until_future_complete(self, future)

    def start(self):
        self.running = True
        Thread(target=self.executor.spin).start()
    """
    file_facts = code.facts_at(spin.file)
    body = [] if file_facts is None else file_facts.body
    flags = {name for test in _false_before(code.body(spin), spin) for name in _flags(test, body)}
    return bool(flags) and not flags.isdisjoint(_set_beside_spins(body))


def _false_before(body: Sequence[facts.Stmt], spin: ApiCall) -> Iterator[facts.Expr]:
    """The tests that come out false on every way through a function to a spin."""
    graph = graph_of(body)
    for edge in graph.outcomes(graph.evaluating(spin.place.span)):
        match edge.test:
            case facts.Unary(op="not", operand=operand) if edge.holds:
                yield operand
            case test if test is not None and not edge.holds:
                yield test


def _flags(test: facts.Expr, body: Sequence[facts.Stmt]) -> Iterator[str]:
    """The variables and attributes that a test is the value of, also by way of a function of the file."""
    match test:
        case facts.Call(args=[]):
            for function in everything_in(body, facts.Function):
                if function.name == called_name(test):
                    for end in everything_in(function.body, facts.Return):
                        yield from _named(end.value)
        case _:
            yield from _named(test)


def _named(value: facts.Expr | None) -> Iterator[str]:
    match value:
        case facts.Name() | facts.Attribute():
            yield value.last_name
        case facts.Conditional(body=if_so, orelse=otherwise):
            yield from _named(if_so)
            yield from _named(otherwise)


def _set_beside_spins(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """What functions set to True that also start to spin."""
    return frozenset(
        target.last_name
        for function in everything_in(body, facts.Function)
        if any(part.attr == "spin" for part in everything_in(function.body, facts.Attribute))
        for assignment in everything_in(function.body, facts.Assign)
        if assignment.value.truth is True
        for target in assignment.targets
    )


__all__ = ["is_while_nobody_spins"]
