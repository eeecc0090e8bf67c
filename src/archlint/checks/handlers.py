"""SRV007 and ACT003: handlers with a path that leaves out what rclpy expects of them at the end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.paths import Ends, ends_of, names_passed_on
from archlint.checks.reach import endpoint_words, node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.facts import model as facts
from archlint.facts.walk import parts_of
from archlint.finding import Finding, Place, Related
from archlint.workspace.test_code import is_test_file

if TYPE_CHECKING:
    from archlint.program.model import Callback
    from archlint.system.model import System

_OUTCOMES = frozenset({"succeed", "abort", "canceled", "is_active"})


def _handlers(system: System, role: str) -> Iterator[tuple[Callback, facts.Function]]:
    """The functions that are given as callbacks of a role and whose code is all there is to see."""
    for program in system.programs:
        for callback in program.callbacks:
            function = callback.function
            if callback.role != role or not isinstance(function, facts.Function) or is_test_file(callback.file):
                continue
            if not function.decorators and not function.is_generator:
                yield callback, function


def _parameter(callback: Callback, function: facts.Function, number: int) -> str | None:
    """The name of the parameter that takes rclpy's argument ``number``."""
    positional = [param.name for param in function.params if param.kind in ("positional_only", "normal")]
    at = callback.bound_arguments + number
    return positional[at] if at < len(positional) else None


# --------------------------------------------------------------------------------------------------- SRV007


@rule("SRV007")
def missing_response(system: System, options: Options) -> Iterator[Finding]:
    """Ends of service handlers that give no response."""
    yield from one_for_each_place(
        (
            *(
                one
                for callback, function in _handlers(system, "service")
                for one in _missing(system, callback, function)
            ),
            *_missing_of_lambdas(system),
        )
    )


def _missing_of_lambdas(system: System) -> Iterator[Finding]:
    for program in system.programs:
        for callback in program.callbacks:
            if callback.role == "service" and isinstance(callback.function, facts.Lambda):
                what = _no_response(callback.function.body)
                if what is not None and not is_test_file(callback.file):
                    yield _missing_at(system, callback, callback.place, f"gives {what}, which is no response", "lambda")


def _missing(system: System, callback: Callback, function: facts.Function) -> Iterator[Finding]:
    if _only_a_stub(function.body):
        return
    ends: Ends[bool] = ends_of(function.body, False, lambda state, fact: state)
    for end in {id(one): one for one, states in ends.returns if states}.values():
        what = _no_response(end.value)
        if what is not None:
            place = Place.of(callback.file, end.span)
            yield _missing_at(system, callback, place, f"returns {what} here, which is no response", "return")
    if ends.falls:
        yield _missing_at(system, callback, callback.place, "can run off its end without a response", "end")


def _missing_at(system: System, callback: Callback, place: Place, what: str, end: str) -> Finding:
    return finding(
        "SRV007",
        place,
        f"the handler of {endpoint_words(callback.creation)} {what}: rclpy raises a TypeError, "
        "and the caller waits in vain",
        help="return the response on every path; it can say that something went wrong",
        related=_handler(callback, place),
        node=node_name(system, callback.node),
        identity=(callback.name, end),
    )


def _no_response(value: facts.Expr | None) -> str | None:
    """What a ``return`` gives that can be no response, in words; None where it may be one."""
    if value is None:
        return "nothing"
    if isinstance(value, facts.Literal):
        return repr(value.value)
    if isinstance(value, facts.FormatString):
        return "a text"
    if isinstance(value, facts.Sequence):
        return f"a {value.kind}"
    if isinstance(value, facts.Mapping):
        return "a dict"
    if isinstance(value, facts.Compare) or (isinstance(value, facts.Unary) and value.op == "not"):
        return "a bool"
    return None


def _only_a_stub(body: list[facts.Stmt]) -> bool:
    """``pass``, ``...`` or a docstring: something that is still to be written, or overridden."""
    return all(
        (isinstance(s, facts.Jump) and s.kind == "pass")
        or (isinstance(s, facts.Expression) and isinstance(s.value, (facts.Literal, facts.Opaque)))
        for s in body
    )


# --------------------------------------------------------------------------------------------------- ACT003


@rule("ACT003")
def goal_without_outcome(system: System, options: Options) -> Iterator[Finding]:
    """Ends of execute callbacks that leave the goal without an outcome."""
    yield from one_for_each_place(
        found for callback, function in _handlers(system, "execute") for found in _undecided(system, callback, function)
    )


def _undecided(system: System, callback: Callback, function: facts.Function) -> Iterator[Finding]:
    goal = _parameter(callback, function, 0)
    if goal is None or _only_a_stub(function.body) or _reaches_elsewhere(function, goal):
        return

    def step(decided: bool, fact: facts.Base) -> bool:
        return decided or _decides(fact, goal) or names_passed_on(fact, goal)

    ends = ends_of(function.body, False, step)
    states: dict[int, frozenset[bool]] = {}
    for one, reached in ends.returns:
        states[id(one)] = states.get(id(one), frozenset()) | reached
    for end in {id(one): one for one, _ in ends.returns}.values():
        if False in states[id(end)]:
            yield _undecided_at(system, callback, Place.of(callback.file, end.span), "ends here", "return")
    if False in ends.falls:
        yield _undecided_at(system, callback, callback.place, "can run off its end", "end")


def _undecided_at(system: System, callback: Callback, place: Place, what: str, end: str) -> Finding:
    return finding(
        "ACT003",
        place,
        f"the execute callback of {endpoint_words(callback.creation)} {what} on a path without succeed(), abort() or "
        "canceled(): rclpy takes the goal for aborted",
        help="say on every path how the goal ended",
        related=_handler(callback, place),
        node=node_name(system, callback.node),
        identity=(callback.name, end),
    )


def _decides(fact: facts.Base, goal: str) -> bool:
    """Whether a statement gives the goal its outcome, or asks whether somebody else has (``is_active``)."""
    return any(
        isinstance(part, facts.Attribute)
        and part.attr in _OUTCOMES
        and isinstance(part.value, facts.Name)
        and part.value.id == goal
        for part in parts_of(fact)
    )


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


def _handler(callback: Callback, place: Place) -> list[Related]:
    found = [] if place == callback.place else [Related(callback.place, f"{callback.name} is the handler")]
    if callback.registered is not None:
        found.append(Related(callback.registered, "it is handed over here"))
    return found
