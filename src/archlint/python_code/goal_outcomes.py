"""The ends of execute callbacks that leave their goal without an outcome: neither succeeded, aborted nor canceled."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import calls_of, judged_calls
from archlint.analysis.source_code import FunctionFacts, source_code
from archlint.finding import Place
from archlint.libraries.api_signatures import attributes_of
from archlint.model import Role
from archlint.python_code.assumptions import MOST, NOTHING, Known, after, dotted, variables, within
from archlint.python_code.handler_ends import HandlerEnd, handlers_of, is_stub
from archlint.python_code.raising_helpers import never_returns
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System

_ENDS = ("succeed", "abort", "canceled")
_DECIDES = frozenset({*_ENDS, "is_active"})
_EXECUTES = frozenset({"execute", "notify_execute"})
_State = tuple[bool, Known]
"""Whether the goal has its outcome, and what is known of the variables."""
_LOOKS = frozenset({"str", "repr", "print", "type", "id", "isinstance", "hasattr", "format"})
"""Builtins that leave a goal as it is."""


@dataclass(frozen=True)
class _Goal:
    """A goal under the names that its callback has for it, such as ``goal_handle`` and ``self.goal``; ``ended_here``
    says that no other code of its program ends a goal, and ``seen`` are the methods that were followed.  ``refused``
    are the calls that end the callback with an exception, which is an outcome: rclpy aborts the goal."""

    names: frozenset[str]
    ended_here: bool
    seen: frozenset[str]
    file: str
    refused: frozenset[Place]


def ends_without_outcome(system: System) -> Iterator[HandlerEnd]:
    """The ends of execute callbacks that some way reaches without an outcome of the goal."""
    for callback, function in handlers_of(system, Role.EXECUTE):
        if not never_runs(system, callback):
            yield from _undecided(system, callback, function)


def never_runs(system: System, callback: Callback) -> bool:
    """Whether a server has a callback of its own for accepted goals and no code there executes one: rclpy runs the
    execute callback only when ``execute()`` of the goal is called, which its default does at once."""
    accepting = [
        other for other in system.callbacks if other.role == Role.ACCEPTED and other.creation is callback.creation
    ]
    code = source_code(system)
    files = [code.facts_at(file) for file in {callback.file, *(other.file for other in accepting)}]
    return bool(accepting) and not any(file is None or _executes(file) for file in files)


def _executes(file: facts.Facts) -> bool:
    """Whether code has ``execute`` of an object: the execute callback itself is often called so, too."""
    attributes = everything_in(file.body, facts.Attribute)
    return any(attribute.attr in _EXECUTES and attribute.value.variable != "self" for attribute in attributes)


def _undecided(system: System, callback: Callback, function: facts.Function) -> Iterator[HandlerEnd]:
    name = _parameter(callback, function)
    if name is None or is_stub(function.body) or _reaches_elsewhere(function, name):
        return
    raises = never_returns(system.workspace, callback.file, function)
    followed = variables(function.body)
    if len(followed) > MOST:
        return
    goal = _Goal(
        _names_of(function, name), _ended_only_in(system, callback), _followed(system), callback.file, _refused(system)
    )

    def step(state: _State, fact: facts.Base) -> _State:
        decided, known = state
        settled = decided or _decides(fact, goal) or _passes_on(fact, goal) or raises(fact)
        return settled, after(known, fact, followed)

    def branch(state: _State, test: facts.Expr, truth: bool) -> _State | None:
        if says_it_is_down(test, truth):
            return None  # ROS is shut down: no outcome would reach anybody
        known = within(state[1], test, truth, followed)
        return None if known is None else (state[0], known)

    if _may_be_ended_and_raise(function, goal):
        return
    ends = graph_of(function.body).ends((False, NOTHING), step, branch, lambda fact: not _works(fact, goal))
    undecided = [end for end, states in ends.returns if any(not decided for decided, _ in states)]
    for end in {id(end): end for end in undecided}.values():
        yield HandlerEnd(callback, Place.of(callback.file, end.span), "return")
    if any(not decided for decided, _ in ends.falls):
        yield HandlerEnd(callback, callback.place, "end")


def _may_be_ended_and_raise(function: facts.Function, goal: _Goal) -> bool:
    """Whether code that is given the goal in a ``try`` may have ended it before it raises what is caught here."""
    attempts = [attempt for attempt in statements_of(function.body, facts.Try) if attempt.handlers]
    return any(_passes_on(fact, goal) for attempt in attempts for fact in statements_of(attempt.body))


def says_it_is_down(test: facts.Expr, truth: bool) -> bool:
    """Whether ``rclpy.ok()`` or ``self.context.ok()`` comes out false."""
    match test:
        case facts.Unary(op="not"):
            return says_it_is_down(test.operand, not truth)
        case facts.Call():
            return not truth and called_name(test) == "ok" and not any(given.star for given in test.args)
    return False


def _parameter(callback: Callback, function: facts.Function) -> str | None:
    """The name of the parameter that takes the goal."""
    positional = [param.name for param in function.params if param.kind in ("positional_only", "normal")]
    at = callback.bound_arguments
    return positional[at] if at < len(positional) else None


def _names_of(function: facts.Function, name: str) -> frozenset[str]:
    """The names that a callback gives its goal: ``self.goal = goal_handle``."""
    names = {name}
    for statement in statements_of(function.body, facts.Assign):
        if dotted(statement.value) in names:
            names |= {dotted(target) for target in statement.targets} - {""}
    return frozenset(names)


# ------------------------------------------------------------------------------------------- who ends the goal


def _decides(fact: facts.Base, goal: _Goal) -> bool:
    """Whether a statement gives the goal its outcome, asks whether somebody else has (``is_active``), or fails."""
    attributes = parts_of(fact, facts.Attribute)
    if any(attribute.attr in _DECIDES and dotted(attribute.value) in goal.names for attribute in attributes):
        return True
    if any(_has_no_such_method(call, goal) for call in calls_in(fact)):
        return True
    return bool(goal.refused) and any(Place.of(goal.file, call.span) in goal.refused for call in calls_in(fact))


def _has_no_such_method(call: facts.Call, goal: _Goal) -> bool:
    """A method that no goal has, such as ``goal_handle.fail()``: the AttributeError aborts the goal."""
    known = attributes_of("rclpy.action.server.ServerGoalHandle")
    match call.func:
        case facts.Attribute(attr=name, value=of):
            return known is not None and name not in known and dotted(of) in goal.names
    return False


def _works(fact: facts.Base, goal: _Goal) -> bool:
    """Whether a statement only ends the goal or reads something of it.  If that raises, the goal has an outcome
    already or none can be given to it: no line of the callback mends what a ``try`` around it catches."""
    match fact:
        case facts.Expression(value=inner) | facts.Unary(op="not", operand=inner):
            return _works(inner, goal)
        case facts.Call(func=facts.Attribute(attr=name, value=of), args=[]):
            return name in _ENDS and dotted(of) in goal.names
        case facts.Attribute(value=of):
            return dotted(of) in goal.names
    return False


def _passes_on(fact: facts.Base, goal: _Goal) -> bool:
    """Whether a statement gives the goal to somebody who may end it, or keeps it where others find it."""
    targets: list[facts.Expr] = []
    if isinstance(fact, facts.Assign):
        if dotted(fact.value) in goal.names:
            return not goal.ended_here and not all(target.variable for target in fact.targets)
        targets = fact.targets
    looked_at = [part.value for part in parts_of(fact, facts.Attribute)]
    for call in calls_in(fact):
        if called_name(call) in _LOOKS or (goal.ended_here and _is_own(call, goal)):
            looked_at += [given.value for given in call.args]
    seen = {id(expression) for expression in looked_at} | {id(part) for target in targets for part in parts_of(target)}
    return any(dotted(part) in goal.names and id(part) not in seen for part in parts_of(fact))


def _is_own(call: facts.Call, goal: _Goal) -> bool:
    """A method of the same object whose code is seen."""
    name = called_name(call)
    return call.func.dotted == f"self.{name}" and name in goal.seen


@once
def _followed(system: System) -> frozenset[str]:
    """Names of methods that something is known of: they make a call that is looked at."""
    return frozenset(call.function.rpartition(".")[2] for _, call in judged_calls(system))


@once
def _refused(system: System) -> frozenset[Place]:
    """The calls that rclpy refuses, or does not have."""
    return frozenset(call.place for program in system.programs for call in program.refused_calls)


def _ended_only_in(system: System, callback: Callback) -> bool:
    """Whether nothing but execute callbacks themselves ends goals, as far as all of their node's code is seen."""
    if callback.node is None or not callback.node.complete:
        return False
    if any(function != handler for function, handler in _endings(system)):
        return False
    return not _others_end_some(system)


@once
def _others_end_some(system: System) -> bool:
    """Whether some callback that is no execute callback has a call that may end a goal."""
    code = source_code(system)
    functions = {Itself(code.function(other)) for other in system.callbacks if other.role != Role.EXECUTE}
    return any(_ends_some(function.fact) for function in functions)


@once
def _endings(system: System) -> list[tuple[str, str]]:
    """The calls that end a goal: the function around, and the callback that it runs in."""
    apis = [f"rclpy.action.server.ServerGoalHandle.{name}" for name in _ENDS]
    return [(call.function, call.context.name) for _, call in calls_of(system, apis)]


def _ends_some(function: FunctionFacts | None) -> bool:
    inside = None if function is None else function.body
    return any(part.attr in _ENDS for part in parts_of(inside, facts.Attribute))


def _reaches_elsewhere(function: facts.Function, goal: str) -> bool:
    """Whether a function inside the callback uses the goal: when that runs is not known."""
    return any(
        part.id == goal
        for statement in function.body
        for kind in (facts.Function, facts.Lambda)
        for inner in parts_of(statement, kind)
        for part in parts_of(inner, facts.Name)
    )


__all__ = ["ends_without_outcome", "never_runs", "says_it_is_down"]
