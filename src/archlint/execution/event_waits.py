"""Events that a callback waits for and that only another callback of its own executor and group sets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.opened_guards import is_behind_its_setter
from archlint.analysis.reach import has_limit, judged_calls
from archlint.analysis.source_code import source_code
from archlint.branches import ChoiceOfCallee
from archlint.execution.blocking import ONE, SAME
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import group_relation, threads_of
from archlint.model import Role
from archlint.model.given import Object
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.model.given import ObjectIdentity
    from archlint.systems.model import System

_WAIT = "threading.Event.wait"
_SET = "threading.Event.set"
ONLY_THREAD = "the executor's only thread is blocked in this callback"


@dataclass(frozen=True)
class EventWait:
    """A wait of one callback for another that cannot run meanwhile."""

    call: ApiCall
    setter: Callback
    program: Program
    limited: bool
    why: str


@once
def event_waits(system: System) -> list[EventWait]:
    """The waits for events that nothing but a callback kept out meanwhile sets."""
    waits = []
    for program, call, setters in waits_for_events(system):
        reasons = [kept_out(call.context, setter, program) for setter in setters]
        if all(reasons):
            waits.append(EventWait(call, setters[0], program, has_limit(call, "timeout"), reasons[0] or ""))
    return waits


@once
def waits_for_events(system: System) -> list[tuple[Program, ApiCall, list[Callback]]]:
    """The waits of callbacks for events that something sets, with what sets them, each time later."""
    setters: dict[ObjectIdentity, list[ApiCall]] = {}
    for _, call in judged_calls(system):
        if call.api == _SET and isinstance(call.receiver, Object):
            setters.setdefault(call.receiver.identity, []).append(call)
    waits = []
    for program, call in judged_calls(system):
        if call.api != _WAIT or not isinstance(call.receiver, Object) or not runs_in_executor(call.context):
            continue
        if any(isinstance(branch, ChoiceOfCallee) for branch, _ in call.branch_arms):
            continue  # one of several objects waits, and code that has several asks what it has before it calls
        setting = setters.get(call.receiver.identity, [])
        if setting and not is_behind_its_setter(source_code(system), call, setting):
            waits.append((program, call, [setter.context for setter in setting]))
    return waits


def kept_out(waiting: Callback, setter: Callback, program: Program) -> str | None:
    """Why a callback cannot run while the other waits; None where it may, or where nothing is known."""
    if setter.role == Role.DONE or not runs_in_executor(setter) or setter.node is not waiting.node:
        return None  # what a done callback sets is judged with the client it belongs to
    if threads_of(waiting.node, program) == ONE:
        return ONLY_THREAD
    grouped = waiting.group is not None and setter.group is not None
    if grouped and group_relation(waiting.group, setter.group) == SAME:
        return "both are in the same mutually exclusive callback group"
    return None
