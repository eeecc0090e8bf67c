"""Which calls wait for the answer of a service or an action, in which way, and for which client."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import (
    argument,
    creations_of,
    has_limit,
    judged_calls,
    same_expression,
)
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.deadlock import AWAIT, CALL, SPIN
from archlint.execution.future_loops import awaits_in_each_round, gives_up, loop_until_done
from archlint.model import Role
from archlint.model.given import Constant, Future, Object
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import names_in
from archlint.syntax.walk import called_name, calls_in, given_to, is_none, statements_of

if TYPE_CHECKING:
    from archlint.execution.blocking import Form
    from archlint.finding import Place
    from archlint.model import ApiCall, Creation, Program
    from archlint.model.given import Given, ObjectIdentity
    from archlint.systems.model import System

BLOCKING_CALLS = (
    "rclpy.client.Client.call",
    "rclpy.action.client.ActionClient.send_goal",
    "rclpy.action.client.ClientGoalHandle.get_result",
    "rclpy.action.client.ClientGoalHandle.cancel_goal",
)
SPINS_FOR_FUTURE = (
    "rclpy.spin_until_future_complete",
    "rclpy.executors.Executor.spin_until_future_complete",
    "rclpy.executors.Executor.spin_once_until_future_complete",
)
_SENDS = frozenset({"call_async", "send_goal_async"})
_LIMITS = ("timeout_sec", "timeout")
DONE = "rclpy.task.Future.done"
_ADD_DONE_CALLBACK = "rclpy.task.Future.add_done_callback"
_EVENT_WAIT = "threading.Event.wait"
_EVENT_SET = "threading.Event.set"


_Signals = dict["ObjectIdentity | Place | None", "Creation"]
"""Clients by the events that their answers set: the object, and the place where it is made."""


@dataclass(frozen=True)
class Wait:
    """A place where code stands still until an answer has come.

    ``limited`` says that a timeout ends it;
    ``bounded``, that one does, or that a limit is given which is not known.
    """

    kind: Form
    call: ApiCall
    client: Creation
    program: Program
    limited: bool = False
    bounded: bool = False
    on_global_executor: bool = False
    """Whether the loop around it calls ``rclpy.spin_once(node)``, which knows nothing of another executor."""
    goes_round: bool = False
    """Whether it is a loop of spins with a timeout each."""


@once
def waits(system: System) -> list[Wait]:
    """Every wait for an answer outside of test code, in the order of the source."""
    all_waits: list[Wait] = []
    code = source_code(system)
    signals = _signals(system)
    for program, call in judged_calls(system):
        for kind, clients in _waits_of(code, call, signals.get(program, {})):
            if clients:
                limited = any(has_limit(call, name) for name in _LIMITS) or (call.api == DONE and gives_up(code, call))
                bounded = limited or any(_may_end(argument(call, name)) for name in _LIMITS)
                globally = kind == SPIN and call.api == DONE and _spins_on_global_executor(code, call)
                goes_round = kind == SPIN and call.api == DONE and _spins_for_moments(code, call)
                all_waits.append(Wait(kind, call, clients[0], program, limited, bounded, globally, goes_round))
    return all_waits


def _may_end(limit: Given | None) -> bool:
    """Whether a limit is given, as far as is known: one that may be None is none."""
    return limit is not None and all(
        not isinstance(option, Constant) or (isinstance(option.value, (int, float)) and option.value >= 0)
        for option in limit.alternatives
    )


def _spins_in_loop(code: SourceCode, call: ApiCall) -> list[facts.Call]:
    loop = loop_until_done(code, call)
    return [] if loop is None else [each for each in calls_in(loop) if called_name(each).startswith("spin")]


def _spins_for_moments(code: SourceCode, call: ApiCall) -> bool:
    """Whether all spins of a loop have a timeout, as far as it stands there."""
    limits = [given_to(each, "timeout_sec", None) for each in _spins_in_loop(code, call)]
    return bool(limits) and all(limit is not None and not is_none(limit) for limit in limits)


def _spins_on_global_executor(code: SourceCode, call: ApiCall) -> bool:
    spins = _spins_in_loop(code, call)
    return bool(spins) and all(
        each.func.dotted.startswith(("rclpy.spin", "spin")) and given_to(each, "executor", None) is None
        for each in spins
    )


def _waits_of(code: SourceCode, call: ApiCall, signals: _Signals) -> Iterator[tuple[Form, tuple[Creation, ...]]]:
    if call.api in BLOCKING_CALLS:
        yield CALL, creations_of(call.receiver)
    elif call.api in SPINS_FOR_FUTURE:
        yield SPIN, creations_of(argument(call, "future"))
    elif call.api.endswith(".await"):
        yield AWAIT, creations_of(call.receiver)
    elif call.api == DONE:
        loop = loop_until_done(code, call)
        if loop is not None:
            if awaits_in_each_round(loop):
                if not gives_up(code, call):
                    yield AWAIT, creations_of(call.receiver)
                return
            spins = not names_in(loop).isdisjoint({"spin", "spin_once", "spin_until_future_complete"})
            yield SPIN if spins else CALL, creations_of(call.receiver)
    elif call.api == _EVENT_WAIT and isinstance(call.receiver, Object):
        client = signals.get(call.receiver.identity) or signals.get(call.receiver.place)
        if client is not None:
            yield CALL, (client,)


def name_of_future(code: SourceCode, call: ApiCall) -> str:
    """The variable or attribute that a spin is given as its future: the functions of rclpy take the node before it."""
    written = code.call_at(call.place)
    at = 1 if call.api.startswith("rclpy.spin") else 0
    given = None if written is None else given_to(written, "future", at)
    return "" if given is None else given.dotted


def other_arm_only_sends(code: SourceCode, call: ApiCall) -> bool:
    """Whether the other arm of an ``if`` around a wait sends without waiting: then the wait is there for those who want
    to."""
    asked = code.expression(call)
    for branch in statements_of(code.body(call), facts.If):
        waits_here = [
            any(same_expression(inner, asked) for inner in calls_in(arm)) for arm in (branch.body, branch.orelse)
        ]
        sends = [any(called_name(inner) in _SENDS for inner in calls_in(arm)) for arm in (branch.orelse, branch.body)]
        if any(waits and only_sends for waits, only_sends in zip(waits_here, sends, strict=True)):
            return True
    return False


@once
def asked_clients(system: System) -> dict[tuple[Program, Place], tuple[Creation, ...]]:
    """The clients whose responses done callbacks take, by the program and the place where these are registered."""
    return {
        (program, call.place): creations_of(call.receiver)
        for program, call in judged_calls(system)
        if call.api == _ADD_DONE_CALLBACK and isinstance(call.receiver, Future)
    }


def _signals(system: System) -> dict[Program, _Signals]:
    """Event objects that the done callback of a future sets, with the client whose answer that is.

    Each program has clients of its own: a file that is run both as an executable and as a script is two programs.
    """
    clients = asked_clients(system)
    signals: dict[Program, _Signals] = {}
    of_place: dict[tuple[Program, Place], list[Creation]] = {}
    for program, call in judged_calls(system):
        if call.api == _EVENT_SET and call.context.role == Role.DONE and isinstance(call.receiver, Object):
            of_future = clients.get((program, call.context.registered)) if call.context.registered else None
            if of_future:
                signals.setdefault(program, {}).setdefault(call.receiver.identity, of_future[0])
                if call.receiver.place is not None:
                    of_place.setdefault((program, call.receiver.place), []).append(of_future[0])
    # A callback that several timers have makes an event each time, and its done callback was followed once.
    for (program, place), given in of_place.items():
        if all(creation is given[0] for creation in given):
            signals[program][place] = given[0]
    return signals
