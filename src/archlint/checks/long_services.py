"""SRV008: service handlers that take so long that they should be actions."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.conditions import conditions
from archlint.analysis.kept import kept
from archlint.analysis.order import paths_to
from archlint.analysis.reach import endpoint_words, judged_calls, one_for_each_place
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.connections.actions_beside import action_beside
from archlint.connections.lessons import is_lesson
from archlint.execution.attribute_loops import attribute_loops
from archlint.execution.demonstrations import stands_for_work
from archlint.execution.kept_waiting import blocks_nobody
from archlint.execution.longest_way import Stretch, longest_way
from archlint.execution.loop_stops import can_be_stopped
from archlint.execution.loop_times import in_loops, varies_by_iteration, watches_the_clock
from archlint.execution.requested_times import lasts_as_requested
from archlint.execution.retries import around_future, gives_up, is_retry, reads_until_it_has
from archlint.execution.sleeps import Stay, stay_of
from archlint.execution.stuck import clients_of_handlers
from archlint.finding import Finding, Related, Severity
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.branches import BranchArms
    from archlint.finding import Place
    from archlint.model import ApiCall, Callback, Creation, Program
    from archlint.systems.model import System

LONG = 1.0
"""Seconds that a service handler may sleep, all in all: nobody writes an action for less."""
SHORT = 2.0
"""Seconds that a caller hardly minds, where they are known."""
POLLING = 2.0
"""Seconds that a loop may watch the clock for something that comes soon."""
SOON = 5.0
"""Seconds that such a loop may take as far as most callers care."""
BESIDE = 15.0
"""Seconds that loops with a limit may take beside all other callbacks: what they wait for comes, or they give up."""
RETRYING = 10.0
"""Seconds of pauses between some attempts, of which the first is to work."""
DEEP = 4
"""Calls between a handler and a wait from which on it takes long for all that it does, and not for that wait alone."""

_WHAT_IT_IS_FOR = "wait for what the pause is for, such as a response that an async handler awaits, or a newer message"
_AN_ACTION = "make it an action: clients then get feedback and a result, and can cancel"
_THAT_ACTION = "let clients send a goal to {} of this node instead"
_Sleep = tuple["ApiCall", Stay]


@rule("SRV008", scope=Scope.CODE, by_program=True, taste=True, pauses=False)
def long_running_service(system: System, options: Options) -> Iterator[Finding]:
    """Service handlers that sleep, once for long or again and again; one finding a handler.  Those that pause for a
    known while, for as long as the request says, or instead of work, and those whose name says that they wait, count in
    a lesson and with ``pauses``."""
    pauses = options.flag("pauses") or is_lesson(system)
    yield from one_for_each_place(
        diagnostic
        for callback, diagnostic in long_handlers(system, options.distros)
        if pauses or (diagnostic.severity is not Severity.INFO and not _is_meant(system, callback))
    )


_WAITS = frozenset({"block", "blocking", "sync", "synchronous", "wait"})


def _is_meant(system: System, callback: Callback) -> bool:
    """Whether a handler only stands for work, or has a service whose name says that its callers wait."""
    name = "" if callback.creation is None else callback.creation.name.text or ""
    return not _WAITS.isdisjoint(re.split(r"[/_]", name.lower())) or stands_for_work(source_code(system), callback)


def long_handlers(system: System, distros: Sequence[str]) -> Sequence[tuple[Callback, Finding]]:
    """The service handlers that take long, and what is to be said of each."""
    return kept(system, (long_handlers, tuple(distros)), lambda: tuple(_long_handlers(system, distros)))


def _long_handlers(system: System, distros: Sequence[str]) -> Iterator[tuple[Callback, Finding]]:
    code = source_code(system)
    endless = {loop.loop for loop in attribute_loops(system)}
    nested = {handler for handler, _ in clients_of_handlers(system, distros)}
    handlers: dict[tuple[Program, Place], list[_Sleep]] = {}
    for program, call in judged_calls(system):
        if not endless.isdisjoint(call.loops):
            continue  # EXE009 says that the loop never ends
        stay = stay_of(code, call) if call.context.role == Role.SERVICE else None
        if stay is not None and stay.kind == "sleep" and not around_future(code, call):
            handlers.setdefault((program, call.context.place), []).append((call, stay))
    diagnostics = (
        (
            sleeps[0][0].context,
            _long_service(system, program, sorted(sleeps, key=partial(_worst_first, code)), handler in nested),
        )
        for (program, handler), sleeps in handlers.items()
        if _in_all(system, sleeps) >= LONG
    )
    yield from ((callback, diagnostic) for callback, diagnostic in diagnostics if diagnostic is not None)


def _worst_first(code: SourceCode, sleep: _Sleep) -> tuple[bool, bool, float, Place]:
    """What has no known end is what makes a handler long; then what stands in the handler itself, in its order: it may
    share a helper with others; then the longest."""
    call, _ = sleep
    seconds, in_helper = _seconds(code, *sleep), bool(call.chain)
    return not math.isinf(seconds), in_helper, -seconds if in_helper else 0.0, call.place


def _in_all(system: System, sleeps: Sequence[_Sleep]) -> float:
    """Seconds that a handler sleeps for certain, each way through its branches by itself; what nobody knows has no
    end."""
    code = source_code(system)
    by_branch: dict[BranchArms, dict[Place, Stretch]] = {frozenset(): {}}
    for call, stay in sleeps:
        branch, path = conditions(system.workspace, call.branch_arms), next(paths_to(call))
        by_branch.setdefault(branch, {})[call.place] = path, _seconds(code, call, stay)
    ways = (
        [stretch for other, at in by_branch.items() if other <= branch for stretch in at.values()]
        for branch in by_branch
    )
    return max(longest_way(code, way) for way in ways)


def _seconds(code: SourceCode, call: ApiCall, stay: Stay) -> float:
    """How long a sleep takes in its loops, each ``for`` over what is not known taken for one round."""
    limited, retries = any(limit is not None for limit in call.limits), is_retry(code, call)
    seconds = in_loops(code, call, stay, unknown=1.0, with_callers=limited or retries)
    if limited and (seconds <= POLLING or (seconds < RETRYING and reads_until_it_has(code, call))):
        return 0.0
    return 0.0 if retries and seconds < RETRYING else seconds


def _long_service(
    system: System, program: Program, sleeps: Sequence[_Sleep], is_told_as_nested: bool
) -> Finding | None:
    """The finding for a handler; None where it soon ends, or is mild and who minds can send a goal instead, nobody has
    to wait, or SRV003 speaks of it (``is_told_as_nested``)."""
    (call, _), *others = sleeps
    callback = call.context
    further = {other.place: Related(other.place, f"then it {words.words}") for other, words in others}
    further.pop(call.place, None)
    asked, total = _is_as_asked(system, sleeps), _in_all(system, sleeps)
    watches = any(limit is not None for sleep_call, _ in sleeps for limit in sleep_call.limits)
    soon = total < SHORT or (total <= SOON and watches)
    action = _action_beside(callback)
    known = all(math.isfinite(in_loops(source_code(system), *sleep)) for sleep in sleeps)
    if (soon and known) or ((soon or asked) and action is not None):
        return None
    pause = known and total < SOON and not asked
    by_itself = pause or (math.isfinite(total) and total < BESIDE and watches)
    if (by_itself and blocks_nobody(callback, program)) or (pause and is_told_as_nested):
        return None
    advice = _WHAT_IT_IS_FOR if pause else _AN_ACTION
    diagnostic = finding_in_callback(
        "SRV008",
        system,
        program,
        call,
        f"the handler of {endpoint_words(callback.creation)} {_how_long(source_code(system), sleeps, total, asked)}",
        help=advice if action is None else _THAT_ACTION.format(endpoint_words(action)),
        further=further.values(),
        identity=(call.api,),
        group=(callback.place.file, "" if callback.node is None else callback.node.class_name, advice),
        in_own_file=True,
        deep=DEEP,
    )
    mild = asked or soon or pause or (math.isinf(total) and _give_up(source_code(system), sleeps))
    return replace(diagnostic, severity=Severity.INFO) if mild else diagnostic


def _give_up(code: SourceCode, sleeps: Sequence[_Sleep]) -> bool:
    """Whether all sleeps of which nobody knows how long they take are in loops that end by themselves."""
    return all(gives_up(code, call) for call, stay in sleeps if math.isinf(_seconds(code, call, stay)))


@folds("SRV008")
def _of_one_node(findings: Sequence[Finding]) -> Finding:
    """The finding for all handlers of a node that wait in the same way."""
    return with_others(findings, "another handler of the node takes", "more handlers of the node take", "long, too")


def _action_beside(callback: Callback) -> Creation | None:
    """The action that the node of a service has for the same thing."""
    if callback.node is None or callback.creation is None:
        return None
    return action_beside(callback.creation, callback.node.creations)


def _how_long(code: SourceCode, sleeps: Sequence[_Sleep], total: float, asked: bool) -> str:
    """What a handler does, and what its caller has of it."""
    (call, stay), *others = sleeps
    if asked:
        up_to = "up to " if watches_the_clock(code, call) else ""
        return f"sleeps for {up_to}as long as the request says: the caller cannot cancel"
    if math.isinf(total):
        waits = "meanwhile" if watches_the_clock(code, call) else "without knowing for how long"
        again = " in each iteration of a loop" if call.looped else ""
        end = "" if can_be_stopped(code, call) else " and cannot cancel"
        return f"{stay.words}{again}: the caller waits {waits}{end}"
    words = stay.words
    if any(other.place != call.place for other, _ in others):
        up_to = "up to " if any(limit is not None for sleep_call, _ in sleeps for limit in sleep_call.limits) else ""
        words = f"sleeps for {up_to}{total:.3g} s in all"
    elif call.looped and varies_by_iteration(code, call):
        words = "sleeps repeatedly, for a time that depends on the loop"
    elif call.looped and math.isinf(in_loops(code, call, stay)):
        words += " in each iteration of a loop"
    elif call.looped:
        up_to = "up to " if any(limit is not None for limit in call.limits) else ""
        words = f"sleeps for {up_to}{total:.3g} s in all, in a loop"
    return f"{words}: meanwhile the caller waits and cannot cancel"


def _is_as_asked(system: System, sleeps: Sequence[_Sleep]) -> bool:
    """Whether the request says how long a handler sleeps, but for what would be no finding by itself."""
    others = [sleep for sleep in sleeps if not _as_asked(source_code(system), *sleep)]
    return len(others) < len(sleeps) and _in_all(system, others) < LONG


def _as_asked(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether the request says how long a handler sleeps."""
    return (stay.seconds is None or watches_the_clock(code, call)) and lasts_as_requested(code, call)
