"""Results that code uses after a wait with a timeout, without asking whether they have arrived."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import argument, calls_of, has_limit, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.waits import SPINS_FOR_FUTURE
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Frame, Program
    from archlint.systems.model import System

_CATCH_ALL = frozenset({"Exception", "BaseException", "AttributeError", "TypeError"})


@dataclass(frozen=True)
class UncheckedResult:
    """A use of a result that may be None, since the wait for it may have ended without it."""

    spin: ApiCall
    program: Program
    place: Place
    attribute: str
    """What is read of it; empty for an item."""


@dataclass(frozen=True)
class _Open:
    """Of what nobody has asked yet whether it is there, by the names that hold it: futures, and their results."""

    futures: frozenset[str] = frozenset()
    results: frozenset[str] = frozenset()

    @property
    def names(self) -> frozenset[str]:
        return self.futures | self.results

    def without(self, names: Iterable[str]) -> _Open:
        return _Open(self.futures.difference(names), self.results.difference(names))


_NOTHING = _Open()


@once
def unchecked_results(system: System) -> list[UncheckedResult]:
    """The first such use after each spin with a timeout, in the order of the source."""
    results, code = [], source_code(system)
    for program, call in calls_of(system, SPINS_FOR_FUTURE):
        if (
            has_limit(call, "timeout_sec")
            and argument(call, "future") is not None
            and not runs_in_executor(call.context)
        ):
            uses = _after_spin(code, call)
            results += [UncheckedResult(call, program, place, attribute) for place, attribute in uses]
    return results


def _after_spin(code: SourceCode, call: ApiCall) -> Iterator[tuple[Place, str]]:
    spin = code.expression(call)
    future = None if spin is None else _future_of(spin, call)
    if spin is None or not future:
        return
    flow = _Flow(code.body(call), spin, future)
    yield from ((Place.of(call.place.file, use.span), use.attribute) for use in flow.uses)
    if flow.is_returned:
        for chain in (call.chain, *(chain for chain, _, _ in call.call_chains)):
            yield from _in_callers(code, chain)


def _in_callers(code: SourceCode, chain: Sequence[Frame]) -> Iterator[tuple[Place, str]]:
    """The uses where a function that returns the result is called, and so on."""
    for frame in reversed(chain):
        call = code.call_at(frame.place)
        flow = None if call is None else _Flow(code.body_at(frame.place), call)
        if flow is None:
            return
        yield from ((Place.of(frame.place.file, use.span), use.attribute) for use in flow.uses)
        if not flow.is_returned:
            return


def _future_of(spin: facts.Call, call: ApiCall) -> str:
    """The name of the future that a spin is for."""
    place = call.argument_places.get("future")
    given = (argument.value for argument in spin.args)
    return next((value.dotted for value in given if place is not None and _is_at(value, place)), "")


def _is_at(value: facts.Expr, place: Place) -> bool:
    return Place.of(place.file, getattr(value, "span", (0, 0, 0, 0))) == place


class _Flow:
    """What becomes of a result in one function: of a future's, once a call has waited for it, or of what a call
    returns."""

    def __init__(self, body: Sequence[facts.Stmt], call: facts.Call, future: str = "") -> None:
        self.body = body
        self.call = call
        self.future = future
        graph = graph_of(body)
        self.tests = {id(edge.test) for block in graph.blocks for edge in block.edges}
        self.states = graph.states(_NOTHING, self._step, self._branch)
        self.blocks = graph.blocks
        self.returns = [statement for statement, _ in graph.returns]

    @property
    def uses(self) -> list[facts.Attribute | facts.Subscript]:
        """The first uses on any way through the function."""
        uses = {}
        for block in self.blocks:
            for state in self.states.get(block, frozenset()):
                for use in self._uses_in(block.fact, state):
                    uses[use.span] = use
        return [uses[span] for span in sorted(uses)]

    @property
    def is_returned(self) -> bool:
        """Whether the function may return it as it is."""
        return any(
            self._is_result(block.fact.value, state)
            for block in self.blocks
            for state in self.states.get(block, frozenset())
            if isinstance(block.fact, facts.Return) and block.fact.value is not None
        )

    def _is_result(self, value: facts.Expr, state: _Open) -> bool:
        if value.dotted:
            return value.dotted in state.results
        if not self.future and same_expression(value, self.call):
            return True
        return _future_asked(value, "result") in state.futures

    def _uses_in(self, fact: facts.Base | None, state: _Open) -> Iterator[facts.Attribute | facts.Subscript]:
        if fact is None or _chooses(fact) or self._is_caught(fact):
            return
        for part in parts_of(fact):
            match part:
                case facts.Attribute(value=value) | facts.Subscript(value=value) if self._is_result(value, state):
                    yield part

    def _is_caught(self, fact: facts.Base) -> bool:
        """Whether a ``try`` around it is there for whatever goes wrong."""
        return any(
            any(part is fact for part in parts_of(attempt.body)) and any(map(_catches_all, attempt.handlers))
            for attempt in statements_of(self.body, facts.Try)
        )

    # ---------------------------------------------------------------------------------- what is open when

    def _step(self, state: _Open, fact: facts.Base) -> _Open:
        if any(True for _ in self._uses_in(fact, state)):
            return _NOTHING  # it was there, or the function ends here
        if id(fact) in self.tests:
            return state  # how it comes out says more
        fetched = self._fetched(fact, state)
        state = state.without(_mentioned(fact, state.names) - fetched).without(_set_by(fact))
        if self.future and any(same_expression(call, self.call) for call in calls_in(fact)):
            return _Open(state.futures | {self.future}, state.results)
        if fetched or self._gets(fact):
            return _Open(state.futures, state.results | {target.dotted for target in fact.assigned})
        return state

    def _gets(self, fact: facts.Base) -> bool:
        """Whether a statement keeps what the call returns."""
        return not self.future and same_expression(_assigned_value(fact), self.call)

    def _fetched(self, fact: facts.Base, state: _Open) -> frozenset[str]:
        """The future whose result a statement keeps as it is."""
        value = _assigned_value(fact)
        return frozenset() if value is None else state.futures & {_future_asked(value, "result")}

    def _branch(self, state: _Open, test: facts.Expr, holds: bool) -> _Open:
        if _says_missing(test, holds, state):
            return state
        return state.without(_mentioned(test, state.names))


def _assigned_value(fact: facts.Base) -> facts.Expr | None:
    match fact:
        case facts.Assign(value=value, targets=[target]) | facts.Annotated(value=value, target=target):
            return value if target.dotted else None
    return None


def _says_missing(test: facts.Expr, holds: bool, state: _Open) -> bool:
    """Whether the result is certainly not there where a condition comes out so."""
    if test.negated is not None:
        return _says_missing(test.negated, not holds, state)
    match test:
        case facts.Compare(
            left=left, ops=["is" | "is not" | "==" | "!=" as op], comparators=[facts.Literal(value=None)]
        ):
            return (op in ("is", "==")) == holds and _holds_result(left, state)
    return not holds and (_future_asked(test, "done") in state.futures or _holds_result(test, state))


def _holds_result(value: facts.Expr, state: _Open) -> bool:
    return value.dotted in state.results or _future_asked(value, "result") in state.futures


def _future_asked(value: facts.Expr, method: str) -> str:
    """The name of what a method is called on without arguments: ``future`` of ``future.done()``."""
    match value:
        case facts.Call(func=facts.Attribute(value=asked, attr=name), args=[]) if name == method:
            return asked.dotted
    return ""


def _mentioned(fact: facts.Base, names: frozenset[str]) -> frozenset[str]:
    """Those of some names that a piece of code speaks of."""
    return names.intersection(part.dotted for part in parts_of(fact))


def _set_by(fact: facts.Base) -> frozenset[str]:
    """The names that a statement sets."""
    return frozenset(part.dotted for target in fact.assigned for part in parts_of(target)) - {""}


def _chooses(fact: facts.Base) -> bool:
    """Whether an expression goes on only where a part of it holds: ``future.done() and future.result().success``."""
    return any(
        isinstance(part, (facts.Boolean, facts.Conditional, facts.Comprehension)) for part in parts_of(fact)
    ) or any(called_name(call) in ("done", "hasattr", "getattr") for call in calls_in(fact))


def _catches_all(handler: facts.Handler) -> bool:
    return handler.type is None or not handler.caught.isdisjoint(_CATCH_ALL)


__all__ = ["UncheckedResult", "unchecked_results"]
