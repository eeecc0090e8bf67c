"""How a function can end: a small analysis of control flow over facts.

Every path through a body is followed at once, as the set of states that may hold at a point.  A state is
whatever a rule wants to remember on the way, such as whether the goal has its outcome by now; raising is an
end of its own and never reported.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from archlint.syntax import facts
from archlint.syntax.walk import has_literal_true

State = TypeVar("State", bound=Hashable)

_EXITS = frozenset({("sys", "exit"), ("os", "_exit"), ("os", "abort")})


@dataclass
class Ends(Generic[State]):
    """The ends of a body: each ``return`` with the states that reach it, and those that run off the end."""

    returns: list[tuple[facts.Return, frozenset[State]]] = field(default_factory=list)
    falls: frozenset[State] = frozenset()


@dataclass
class _Flow(Generic[State]):
    """Where control may be after a block."""

    next: frozenset[State] = frozenset()
    breaks: frozenset[State] = frozenset()
    continues: frozenset[State] = frozenset()
    raises: frozenset[State] = frozenset()
    """States in which something may have raised."""
    returns: list[tuple[facts.Return, frozenset[State]]] = field(default_factory=list)

    def leave(self, other: _Flow[State]) -> None:
        """Take over every way out of ``other`` but its end."""
        self.breaks |= other.breaks
        self.continues |= other.continues
        self.raises |= other.raises
        self.returns.extend(other.returns)


def ends_of(
    body: Sequence[facts.Stmt],
    start: State,
    step: Callable[[State, facts.Base], State],
    branch: Callable[[State, facts.Expr, bool], State | None] | None = None,
) -> Ends[State]:
    """How a body can end; ``step`` gives the state after a statement's (or a condition's) own expressions, ``branch``
    the state in an arm of an ``if``, None where the arm cannot be entered in that state."""
    flow = _Walk(step, branch).block(body, frozenset({start}))
    return Ends(flow.returns, flow.next)


class _Walk(Generic[State]):
    def __init__(
        self,
        step: Callable[[State, facts.Base], State],
        branch: Callable[[State, facts.Expr, bool], State | None] | None,
    ) -> None:
        self.step = step
        self.branch = branch

    def block(self, body: Sequence[facts.Stmt], states: frozenset[State]) -> _Flow[State]:
        flow: _Flow[State] = _Flow(states)
        for statement in body:
            if not flow.next:
                break
            one = self.statement(statement, flow.next)
            flow.leave(one)
            flow.next = one.next
        return flow

    def after(self, fact: facts.Base | None, states: frozenset[State]) -> frozenset[State]:
        return states if fact is None else frozenset(self.step(state, fact) for state in states)

    def statement(self, s: facts.Stmt, states: frozenset[State]) -> _Flow[State]:
        if isinstance(s, facts.If):
            return self.choice(s, states)
        if isinstance(s, (facts.While, facts.For)):
            return self.loop(s, states)
        if isinstance(s, facts.Try):
            return self.attempt(s, states)
        if isinstance(s, facts.With):
            inner = states
            for item in s.items:
                inner = self.after(item.value, inner)
            return self.block(s.body, inner)
        if isinstance(s, facts.Match):
            return self.match(s, states)
        if isinstance(s, facts.Return):
            return _Flow(returns=[(s, self.after(s, states))], raises=states)
        if isinstance(s, facts.Raise):
            return _Flow(raises=states)
        if isinstance(s, facts.Jump):
            if s.kind == "break":
                return _Flow(breaks=states)
            return _Flow(continues=states) if s.kind == "continue" else _Flow(states)
        if isinstance(s, (facts.Function, facts.Class, facts.Import, facts.ImportFrom, facts.Global)):
            return _Flow(states)
        if _never_returns(s):
            return _Flow(raises=states)
        after = self.after(s, states)
        return _Flow(after, raises=states | after)

    def choice(self, s: facts.If, states: frozenset[State]) -> _Flow[State]:
        states = self.after(s.test, states)
        flow: _Flow[State] = _Flow(raises=states)
        truth = bool(s.test.value) if isinstance(s.test, facts.Literal) else None
        for wanted, body in ((True, s.body), (False, s.orelse)):
            if truth is None or truth is wanted:
                one = self.block(body, self.entering(s.test, wanted, states))
                flow.leave(one)
                flow.next |= one.next
        return flow

    def entering(self, test: facts.Expr, truth: bool, states: frozenset[State]) -> frozenset[State]:
        if self.branch is None:
            return states
        found = (self.branch(state, test, truth) for state in states)
        return frozenset(state for state in found if state is not None)

    def loop(self, s: facts.While | facts.For, states: frozenset[State]) -> _Flow[State]:
        head = s.test if isinstance(s, facts.While) else s.iterable
        endless = isinstance(s, facts.While) and has_literal_true(s.test)
        flow: _Flow[State] = _Flow()
        seen: frozenset[State] = frozenset()
        entering = self.after(head, states)
        while not entering <= seen:
            seen |= entering
            one = self.block(s.body, seen)
            flow.raises |= one.raises
            flow.returns.extend(one.returns)
            flow.breaks |= one.breaks
            entering = self.after(head, one.next | one.continues)
        ended = frozenset() if endless else seen
        if isinstance(s, facts.While):
            ended = self.entering(s.test, False, ended)
        after = self.block(s.orelse, ended)
        result: _Flow[State] = _Flow(after.next | flow.breaks, raises=flow.raises | states)
        result.returns = flow.returns
        result.leave(after)
        return result

    def attempt(self, s: facts.Try, states: frozenset[State]) -> _Flow[State]:
        body = self.block(s.body, states)
        rest = self.block(s.orelse, body.next)
        flow: _Flow[State] = _Flow(rest.next)
        flow.breaks, flow.continues = body.breaks | rest.breaks, body.continues | rest.continues
        flow.returns = [*body.returns, *rest.returns]
        raised = body.raises | states
        flow.raises = rest.raises | (frozenset() if _catches_all(s) else raised)
        for handler in s.handlers:
            one = self.block(handler.body, raised)
            flow.leave(one)
            flow.next |= one.next
        return self.finish(s, flow) if s.final else flow

    def finish(self, s: facts.Try, flow: _Flow[State]) -> _Flow[State]:
        """``finally`` runs on every way out, and may leave the function itself."""
        every = flow.next | flow.breaks | flow.continues | flow.raises
        for _, states in flow.returns:
            every |= states
        final = self.block(s.final, every)
        if not final.next:
            return final
        done: _Flow[State] = _Flow(self.block(s.final, flow.next).next)
        done.breaks = self.block(s.final, flow.breaks).next
        done.continues = self.block(s.final, flow.continues).next
        done.raises = self.block(s.final, flow.raises).next
        done.returns = [(end, self.block(s.final, states).next) for end, states in flow.returns]
        done.leave(final)
        return done

    def match(self, s: facts.Match, states: frozenset[State]) -> _Flow[State]:
        states = self.after(s.subject, states)
        flow: _Flow[State] = _Flow(raises=states)
        open_ = True
        for case in s.cases:
            one = self.block(case.body, self.after(case.guard, states))
            flow.leave(one)
            flow.next |= one.next
            if case.guard is None and case.pattern.kind == "capture":
                open_ = False
                break
        if open_:
            flow.next |= states
        return flow


def _catches_all(s: facts.Try) -> bool:
    return any(handler.type is None for handler in s.handlers)


def _never_returns(s: facts.Stmt) -> bool:
    """``sys.exit()`` and ``assert False``."""
    if isinstance(s, facts.Assert):
        return isinstance(s.test, facts.Literal) and not s.test.value
    if not isinstance(s, facts.Expression) or not isinstance(s.value, facts.Call):
        return False
    called = s.value.func
    if isinstance(called, facts.Name):
        return called.id in ("exit", "quit")
    return (
        isinstance(called, facts.Attribute)
        and isinstance(called.value, facts.Name)
        and (called.value.id, called.attr) in _EXITS
    )


def always_raises(body: Sequence[facts.Stmt]) -> bool:
    """Whether every way through a block ends in an exception that leaves it."""
    flow = _Walk[bool](lambda state, fact: state, None).block(body, frozenset({False}))
    return not (flow.next or flow.breaks or flow.continues or any(states for _, states in flow.returns))


def always_left(loop: facts.While | facts.For) -> bool:
    """Whether every way through the body of a loop leaves it: it never goes round again."""
    flow = _Walk[bool](lambda state, fact: state, None).block(loop.body, frozenset({False}))
    return not (flow.next or flow.continues)


def comes_round(loop: facts.While | facts.For, statement: facts.Stmt) -> bool:
    """Whether a loop may go round again after a statement in it has run: not where ``break``, ``return`` or ``raise``
    always follows it."""
    if statement is loop or isinstance(statement, facts.Global):
        return True
    inside = statement.span

    def step(state: bool, fact: facts.Base) -> bool:
        span = getattr(fact, "span", None)
        return state or (span is not None and inside[:2] <= span[:2] and span[2:] <= inside[2:])

    flow = _Walk(step, None).block(loop.body, frozenset({False}))
    return True in flow.next | flow.continues
