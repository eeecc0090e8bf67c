"""The code behind what linking yields: the call that a record stands for, its loops, the function of a callback.

A program names code by its place.  Here a place leads back to the facts of its file: down the statements that hold it,
so that a look-up costs as much as the code is deep, and each is made once.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import once_for
from archlint.syntax.walk import calls_in, main_guard

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Creation
    from archlint.systems.model import System, WorkspaceIndex

Loop = facts.While | facts.For
FunctionFacts = facts.Function | facts.Lambda


@dataclass(frozen=True)
class _Spot:
    """What is around a place of a file, and what is written there."""

    body: Sequence[facts.Stmt] = ()
    """The body that runs as one: of the innermost function, class or main guard, or of the module; of a lambda none."""
    statements: tuple[facts.Stmt, ...] = ()
    """The statements of that body which hold the place, outermost first."""
    written: facts.Base | None = None
    """The call, ``await`` or lambda that fills the place."""
    owner: facts.Function | facts.Class | None = None
    """Whose body it is; None for a module and of a lambda."""


@dataclass
class SourceCode:
    """The facts of a workspace by place, as far as its files were read."""

    facts_at: Callable[[str], facts.Facts | None]
    _spots: dict[Place, _Spot] = field(default_factory=dict)

    def expression(self, call: ApiCall) -> facts.Call | None:
        """The call itself; an ``await`` is one without arguments."""
        written = self._spot(call.place).written
        if isinstance(written, facts.Await):
            return facts.Call(written.value, [], written.span)
        return written if isinstance(written, facts.Call) else None

    def call_at(self, place: Place) -> facts.Call | None:
        """The call that fills a place."""
        written = self._spot(place).written
        return written if isinstance(written, facts.Call) else None

    def arguments(self, call: ApiCall) -> Sequence[facts.Argument]:
        """The arguments of a call as they are written."""
        expression = self.expression(call)
        return () if expression is None else expression.args

    def statement(self, call: ApiCall) -> facts.Stmt | None:
        """The innermost statement that holds a call."""
        return self.statement_at(call.place)

    def statement_at(self, place: Place) -> facts.Stmt | None:
        """The innermost statement that holds a place."""
        around = self._spot(place).statements
        return around[-1] if around else None

    def body(self, call: ApiCall) -> Sequence[facts.Stmt]:
        """The body of the function that holds a call."""
        return self.body_at(call.place)

    def body_at(self, place: Place) -> Sequence[facts.Stmt]:
        """The body of the function that holds a place."""
        return self._spot(place).body

    def function_at(self, place: Place) -> facts.Function | None:
        """The ``def`` whose body holds a place."""
        owner = self._spot(place).owner
        return owner if isinstance(owner, facts.Function) else None

    def loops(self, call: ApiCall) -> tuple[Loop, ...]:
        """The loops of the same function around a call, outermost first."""
        return tuple(loop for loop in map(self.loop_at, call.loops) if loop is not None)

    def loop(self, call: ApiCall) -> Loop | None:
        """The innermost loop of the same function around a call."""
        loops = self.loops(call)
        return loops[-1] if loops else None

    def loop_at(self, place: Place) -> Loop | None:
        """The loop that fills a place."""
        return next((statement for statement in self._filling(place) if isinstance(statement, Loop)), None)

    def calls_in(self, place: Place) -> list[Place]:
        """The places of the calls in the loop that fills a place."""
        return [Place.of(place.file, call.span) for call in calls_in(self.loop_at(place))]

    def proven(self, creation: Creation) -> tuple[tuple[facts.Expr, bool], ...]:
        """The conditions around a create call that ask for no local variable, with how they came out."""
        return tuple(
            (statement.test, truth)
            for place, truth in creation.proven
            for statement in self._filling(place)
            if isinstance(statement, facts.If)
        )

    def function(self, callback: Callback) -> FunctionFacts | None:
        """The code of a callback; None for what is not followed."""
        if callback.function is None:
            return None
        place = callback.function.place
        spot = self._spot(place)
        inner = spot.statements[-1] if spot.statements else None
        if isinstance(inner, facts.Function) and inner.name_span == place.span:
            return inner
        return spot.written if isinstance(spot.written, facts.Lambda) else None

    def definition(self, callback: Callback) -> facts.Function | None:
        """The ``def`` of a callback; None for a lambda, and for what is not followed."""
        function = self.function(callback)
        return function if isinstance(function, facts.Function) else None

    def _filling(self, place: Place) -> Iterator[facts.Stmt]:
        return (statement for statement in self._spot(place).statements if _fills(statement, place.span))

    def _spot(self, place: Place) -> _Spot:
        spot = self._spots.get(place)
        if spot is None:
            file_facts = self.facts_at(place.file)
            spot = self._spots[place] = _Spot() if file_facts is None else _look_up(file_facts, place.span)
        return spot


def source_code(system: System) -> SourceCode:
    """The code that a system was made of."""
    return SourceCode(lambda file: None) if system.workspace is None else code_of(system.workspace)


@once
def code_of(workspace: WorkspaceIndex) -> SourceCode:
    """The code of a workspace."""
    return SourceCode(workspace.facts_at)


def _look_up(file_facts: facts.Facts, span: facts.Span) -> _Spot:
    body: Sequence[facts.Stmt] = file_facts.body
    around: list[facts.Stmt] = []
    owner: facts.Function | facts.Class | None = None
    block, statement = _step(span, [body])
    guard = main_guard(file_facts) if isinstance(statement, facts.If) else None
    while statement is not None:
        around.append(statement)
        if _fills(statement, span) and statement.blocks:
            break
        definition = statement if isinstance(statement, (facts.Function, facts.Class)) else None
        block, below = _step(span, statement.blocks if definition is None else [definition.body])
        if below is not None and (definition is not None or (guard is not None and block is guard.body)):
            body, around, owner = block, [], definition
        statement = below
    written, in_lambda = _written(around[-1], span) if around else (None, False)
    return _Spot((), (), written) if in_lambda else _Spot(body, tuple(around), written, owner)


def _step(span: facts.Span, blocks: Sequence[Sequence[facts.Stmt]]) -> tuple[Sequence[facts.Stmt], facts.Stmt | None]:
    """The block, and the statement of it, that holds a span."""
    for block in blocks:
        starts = _starts(block)
        last = bisect_right(starts, span[:2])
        for statement in block if not starts else block[last - 1 : last]:
            if _holds(statement, span):
                return block, statement
    return (), None


@once_for
def _starts(block: Sequence[facts.Stmt]) -> Sequence[tuple[int, int]]:
    """Where the statements of a block begin; nothing where one does not begin behind the end of the one before, as in
    C++, where several may come of one."""
    spans: list[facts.Span] = [getattr(statement, "span", (0, 0, 0, 0)) for statement in block]
    in_order = all(before[2:] <= after[:2] < after[2:] for before, after in pairwise([(0, 0, 0, 0), *spans]))
    return [span[:2] for span in spans] if in_order else ()


def _written(statement: facts.Stmt, span: facts.Span) -> tuple[facts.Base | None, bool]:
    """The call, ``await`` or lambda of a statement that fills a span, and whether that is in the body of a lambda."""
    stack: list[tuple[facts.Base, bool]] = [(statement, False)]
    while stack:
        item, in_lambda = stack.pop()
        if not _may_hold(item, span):
            continue
        match item:
            case facts.Call() | facts.Await() | facts.Lambda() if item.span == span:
                return item, in_lambda
            case facts.Lambda(params=params, body=body):
                stack += [*((param, in_lambda) for param in params), (body, True)]
            case _:
                stack += [(child, in_lambda) for child in item.children()]
    return None, False


def _holds(fact: facts.Base, span: facts.Span) -> bool:
    around: facts.Span | None = getattr(fact, "span", None)
    return around is not None and around[:2] <= span[:2] and span[2:] <= around[2:]


def _fills(fact: facts.Base, span: facts.Span) -> bool:
    return getattr(fact, "span", None) == span


def _may_hold(fact: facts.Base, span: facts.Span) -> bool:
    return not hasattr(fact, "span") or _holds(fact, span)


__all__ = ["FunctionFacts", "Loop", "SourceCode", "code_of", "source_code"]
