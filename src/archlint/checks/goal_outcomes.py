"""ACT003: execute callbacks with a path that leaves the goal without an outcome."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.assumptions import MOST, NOTHING, Known, after, dotted, variables, within
from archlint.analysis.kept import once
from archlint.analysis.reach import (
    calls_of,
    endpoint_words,
    judged_calls,
    node_name,
    one_for_each_place,
)
from archlint.analysis.source_code import source_code
from archlint.checks.handlers import handlers_of, only_a_stub, related_handler
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.control_flow import ends_of
from archlint.syntax.walk import called_name, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System

_ENDS = ("succeed", "abort", "canceled")
_DECIDES = frozenset({*_ENDS, "is_active"})
_State = tuple[bool, Known]
"""Whether the goal has its outcome, and what is known of the variables."""
_LOOKS = frozenset({"str", "repr", "print", "type", "id", "isinstance", "hasattr", "format"})
"""Builtins that leave a goal as it is."""


@dataclass(frozen=True)
class _Goal:
    """A goal under the names that its callback has for it, such as ``goal_handle`` and ``self.goal``; ``ended_here``
    tells that no other code of its program ends a goal, and ``seen`` are the methods that were followed."""

    names: frozenset[str]
    ended_here: bool
    seen: frozenset[str]


@rule("ACT003", scope=Scope.CODE)
def goal_without_outcome(system: System, options: Options) -> Iterator[Finding]:
    """Ends of execute callbacks that leave the goal without an outcome."""
    yield from one_for_each_place(
        found
        for callback, function in handlers_of(system, Role.EXECUTE)
        for found in _undecided(system, callback, function)
    )


def _undecided(system: System, callback: Callback, function: facts.Function) -> Iterator[Finding]:
    name = _parameter(callback, function)
    if name is None or only_a_stub(function.body) or _reaches_elsewhere(function, name):
        return
    followed = variables(function.body)
    if len(followed) > MOST:
        return
    goal = _Goal(_names_of(function, name), _ended_only_in(system, callback), _followed(system))

    def step(state: _State, fact: facts.Base) -> _State:
        decided, known = state
        return decided or _decides(fact, goal) or _hands_on(fact, goal), after(known, fact, followed)

    def branch(state: _State, test: facts.Expr, truth: bool) -> _State | None:
        if _says_it_is_down(test, truth):
            return None  # ROS is shut down: no outcome would reach anybody
        known = within(state[1], test, truth, followed)
        return None if known is None else (state[0], known)

    ends = ends_of(function.body, (False, NOTHING), step, branch)
    open_: dict[int, facts.Return] = {}
    for one, reached in ends.returns:
        if any(not decided for decided, _ in reached):
            open_[id(one)] = one
    for end in open_.values():
        yield _undecided_at(system, callback, Place.of(callback.file, end.span), "ends here", "return")
    if any(not decided for decided, _ in ends.falls):
        yield _undecided_at(system, callback, callback.place, "can reach its end", "end")


def _says_it_is_down(test: facts.Expr, truth: bool) -> bool:
    """Whether ``rclpy.ok()`` or ``self.context.ok()`` comes out false."""
    if isinstance(test, facts.Unary) and test.op == "not":
        return _says_it_is_down(test.operand, not truth)
    return (
        not truth
        and isinstance(test, facts.Call)
        and called_name(test) == "ok"
        and not any(one.star for one in test.args)
    )


def _undecided_at(system: System, callback: Callback, place: Place, what: str, end: str) -> Finding:
    return finding(
        "ACT003",
        place,
        f"the execute callback of {endpoint_words(callback.creation)} {what} on a path without succeed(), abort() "
        "or canceled(): rclpy then aborts the goal",
        help="call succeed(), abort() or canceled() on every path",
        related=related_handler(callback, place),
        node=node_name(system, callback.node),
        identity=(callback.name, end),
    )


def _parameter(callback: Callback, function: facts.Function) -> str | None:
    """The name of the parameter that takes the goal."""
    positional = [param.name for param in function.params if param.kind in ("positional_only", "normal")]
    at = callback.bound_arguments
    return positional[at] if at < len(positional) else None


def _names_of(function: facts.Function, name: str) -> frozenset[str]:
    """The names that a callback gives its goal: ``self.goal = goal_handle``."""
    names = {name}
    for statement in statements_of(function.body):
        if isinstance(statement, facts.Assign) and dotted(statement.value) in names:
            names |= {dotted(target) for target in statement.targets} - {""}
    return frozenset(names)


# ------------------------------------------------------------------------------------------- who ends the goal


def _decides(fact: facts.Base, goal: _Goal) -> bool:
    """Whether a statement gives the goal its outcome, or asks whether somebody else has (``is_active``)."""
    return any(
        isinstance(part, facts.Attribute) and part.attr in _DECIDES and dotted(part.value) in goal.names
        for part in parts_of(fact)
    )


def _hands_on(fact: facts.Base, goal: _Goal) -> bool:
    """Whether a statement gives the goal to somebody who may end it, or keeps it where others find it."""
    if isinstance(fact, facts.Assign) and dotted(fact.value) in goal.names:
        return not goal.ended_here and not all(isinstance(target, facts.Name) for target in fact.targets)
    looked_at = [part.value for part in parts_of(fact) if isinstance(part, facts.Attribute)]
    for part in parts_of(fact):
        if isinstance(part, facts.Call) and (called_name(part) in _LOOKS or (goal.ended_here and _is_own(part, goal))):
            looked_at += [given.value for given in part.args]
    seen = {id(one) for one in looked_at}
    targets = fact.targets if isinstance(fact, facts.Assign) else []
    seen |= {id(part) for target in targets for part in parts_of(target)}
    return any(dotted(part) in goal.names and id(part) not in seen for part in parts_of(fact))


def _is_own(call: facts.Call, goal: _Goal) -> bool:
    """A method of the same object whose code is seen."""
    function = call.func
    return isinstance(function, facts.Attribute) and dotted(function.value) == "self" and function.attr in goal.seen


@once
def _followed(system: System) -> frozenset[str]:
    """Names of methods that something is known of: they make a call that is looked at."""
    return frozenset(call.function.rpartition(".")[2] for _, call in judged_calls(system))


def _ended_only_in(system: System, callback: Callback) -> bool:
    """Whether nothing but execute callbacks themselves ends goals, as far as all of their node's code is seen."""
    if callback.node is None or not callback.node.complete:
        return False
    if any(function != handler for function, handler in _endings(system)):
        return False
    others = (other for program in system.programs for other in program.callbacks if other.role != Role.EXECUTE)
    return not any(_ends_some(source_code(system).function(other)) for other in others)


@once
def _endings(system: System) -> list[tuple[str, str]]:
    """The calls that end a goal: the function around, and the callback that it runs in."""
    apis = [f"rclpy.action.server.ServerGoalHandle.{name}" for name in _ENDS]
    return [(call.function, call.context.name) for _, call in calls_of(system, apis)]


def _ends_some(function: facts.Function | facts.Lambda | None) -> bool:
    inside = function.body if isinstance(function, facts.Function) else function
    return any(isinstance(part, facts.Attribute) and part.attr in _ENDS for part in parts_of(inside))


def _reaches_elsewhere(function: facts.Function, goal: str) -> bool:
    """Whether a function inside the callback uses the goal: when that runs is not known."""
    return any(
        isinstance(part, facts.Name) and part.id == goal for inner in _inner(function) for part in parts_of(inner)
    )


def _inner(function: facts.Function) -> Iterator[facts.Function | facts.Lambda]:
    return (
        part
        for statement in function.body
        for part in parts_of(statement)
        if isinstance(part, (facts.Function, facts.Lambda))
    )
