"""EXE003: callbacks that keep their thread while nothing else can run on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.left_over import is_left_unmade
from archlint.analysis.order import is_called_in_branches
from archlint.analysis.reach import calls_at_start, creations_of, judged_calls, one_for_each_place
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.added_waits import added_waits
from archlint.checks.brief_waits import are_brief
from archlint.checks.callback_findings import finding_in_callback, told_at
from archlint.checks.folding import folds
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_loops import endless_in_callbacks
from archlint.checks.wait_words import MAKE_IT_EARLIER, made_here
from archlint.connections.lessons import is_lesson
from archlint.execution import blocking
from archlint.execution.attribute_loops import attribute_loops
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.commands import is_soon_over
from archlint.execution.deadlock import threads_of
from archlint.execution.demonstrations import stands_for_work
from archlint.execution.kept_waiting import Waiting, blocks_nobody, is_one_chain, keeps_intake_alone, who_waits
from archlint.execution.long_stays import LongStay, long_stays, period_of
from archlint.execution.loop_times import in_loops
from archlint.execution.own_timers import ends_its_timer_after
from archlint.execution.request_paces import is_pause_before_the_next
from archlint.execution.retries import gives_up_loudly, is_step_of_a_retry, retries_after_errors, tries_until_it_works
from archlint.execution.short_stays import comes_last
from archlint.execution.sleeps import Stay
from archlint.execution.spins import is_spin_call
from archlint.execution.staged import is_between_moves, speaks_beside
from archlint.execution.states import leaves_its_state
from archlint.execution.stuck import clients_of_handlers, clients_of_stuck_callbacks, functions_that_ask
from archlint.execution.unset_parameters import is_off_by_default
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch_files.unset_parameters import may_be_set
from archlint.model import Role
from archlint.packaging.inner_distributions import is_imported_by_its_own_name

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.systems.model import System

PAUSE = 1.0
"""Seconds of sleep that the next message may be late, where a node only takes in these messages."""


@rule("EXE003", scope=Scope.CODE, by_program=True, taste=True, alone=False)
def slow_callback(system: System, options: Options) -> Iterator[Finding]:
    """Sleeps and waits for the world outside that callbacks reach: one finding for the function that holds them.  In a
    lesson, and with ``alone``, also where that delays nothing but the callback's own next turn and slow timers."""
    code, quiet, workspace = source_code(system), not options.flag("alone"), system.workspace
    longest_first = partial(_longest_first, code)
    lesson = quiet and is_lesson(system)
    alone = lesson or not quiet
    asked = clients_of_handlers(system, options.distros) | clients_of_stuck_callbacks(system, options.distros)
    reported = functions_that_ask(system, options.distros)
    endless = {loop.loop for loop in attribute_loops(system)} | endless_in_callbacks(system, options.distros)
    spinning = {id(call.context) for _, call in judged_calls(system) if is_spin_call(call)}
    turning = {id(call.context) for _, call in judged_calls(system) if _turns(call)}
    functions: dict[tuple[str, str], dict[Place, LongStay]] = {}
    for program, call, stay in long_stays(system):
        if _is_for_others(call, stay) or _is_in_a_copied_library(system, call) or _is_never_made(system, call):
            continue
        if workspace is not None and is_off_by_default(system, call, partial(may_be_set, workspace)):
            continue
        if not endless.isdisjoint(call.loops):
            continue  # EXE009 says that the loop never ends, or TMO004 what alone ends it
        if id(call.context) in (spinning if stay.kind == "discovery" else turning):
            continue  # EXE001 says what is wrong, and its cure is this one's
        if _is_of_a_retry(code, call, stay):
            continue  # there are few attempts, or the sleep between them is told
        if stay.kind == "sleep" and call.branch_arms and call.place in calls_at_start(system):
            continue  # a device is opened again as at the start: without it the callback can do nothing
        if stay.kind == "sleep" and (ends_its_timer_after(system, call) or (quiet and speaks_beside(code, call))):
            continue  # the timer sleeps once; and beside words that are spoken, a pause is short
        if stay.kind == "sleep" and not alone and stands_for_work(code, call.context):
            continue  # what waits meanwhile is what it is there to show
        if stay.kind == "lock" or _answers_in_time(call, stay):
            continue  # few processes hold a file for more than a moment, and the answer depends on the server
        if not asked.isdisjoint((call.context.place, client.place) for client in creations_of(call.receiver)):
            continue  # SRV003 and EXE002 speak of the request that follows: this is part of the same wait
        if any((call.file, call.function, client.place) in reported for client in creations_of(call.receiver)):
            continue  # other callbacks get to the same two waits, of which SRV003 speaks
        place, function = told_at(system, call)
        rows = functions.setdefault((place.file, function), {})
        known = rows.get(call.place)
        if known is None or len(call.chain) < len(known[1].chain):
            rows[call.place] = (program, call, stay)
    slow_functions = [
        sorted(rows.values(), key=longest_first)
        for rows in functions.values()
        if _is_worth_a_line(system, [*rows.values()], lesson=lesson, quiet=quiet)
    ]
    worst: dict[tuple[str, ...], LongStay] = {}
    for [row, *_] in slow_functions:
        cause = _cause(row[1].context)
        worst[cause] = min(worst.get(cause, row), row, key=longest_first)
    yield from one_for_each_place(
        _slow(system, rows, _place_of(system, worst[_cause(rows[0][1].context)])) for rows in slow_functions
    )
    yield from one_for_each_place(added_waits(system, {id(call.context) for _, call, _ in long_stays(system)}))


def _is_worth_a_line(system: System, rows: Sequence[LongStay], *, lesson: bool, quiet: bool) -> bool:
    """Whether the stays of one function delay what counts; in a lesson, or with ``alone``, nearly any delay does."""
    code = source_code(system)
    if all(_is_left_alone(system, *row) for row in rows) or are_brief(system, rows, quiet=quiet):
        return False
    if not all(_delays_nothing(code, row) for row in rows):
        return not quiet or lesson or not all(_only_late_intake(code, row) for row in rows)
    return not quiet or (lesson and not all(_is_occasional(code, row) for row in rows))


def _is_for_others(call: ApiCall, stay: Stay) -> bool:
    """Whether SRV008 has a bound of its own for a wait; a transition may take its time, and so may the way out of what
    has failed."""
    is_sleep_of_handler = call.context.role == Role.SERVICE and stay.kind == "sleep"
    return is_sleep_of_handler or call.context.role == Role.LIFECYCLE or call.cleaning


def _is_never_made(system: System, call: ApiCall) -> bool:
    """Whether a callback is of a node that the program which defines it does not make, but others of its classes."""
    node = call.context.node
    return node is not None and is_left_unmade(system.workspace, node.place.file, node.class_name)


def _is_in_a_copied_library(system: System, call: ApiCall) -> bool:
    """Whether a way to a call leads into a library that lies in the package and that pip may have installed as well:
    nobody knows which copy the import finds."""
    workspace, files = system.workspace, [*(frame.place.file for frame in call.chain), call.file]
    ways = {(importer, file) for importer, file in pairwise(files) if file != importer}
    return workspace is not None and any(is_imported_by_its_own_name(workspace, *way) for way in sorted(ways))


def _place_of(system: System, row: LongStay) -> str:
    place, _ = told_at(system, row[1])
    return _as_text(place)


def _as_text(place: Place) -> str:
    return f"{place.file}:{place.line}:{place.column}"


def _longest_first(code: SourceCode, row: LongStay) -> tuple[float, Place]:
    """What is worst of several lines: that which holds its thread up the longest, as a rule."""
    _, call, stay = row
    usual = _A_MOMENT if stay.kind == "process" and is_soon_over(code, call) else _USUAL.get(stay.kind, math.inf)
    if stay.seconds is None:
        return -usual, call.place
    return -(stay.seconds if stay.kind in ("sleep", "discovery") else min(stay.seconds, usual)), call.place


_A_WHILE = 3.0
"""Seconds that a message may be old by when it is read, if all that is done with it is to keep it."""
_A_MOMENT = 0.05
"""Seconds that a command takes which only sets or asks something."""
_USUAL = {"sleep": 1.0, "process": 1.0, "keyboard": 4.0, "network": 5.0, "message": 5.0}
"""Seconds that something takes as a rule: a sleep whose time is not known, other waits whatever their limit is."""


def _is_left_alone(system: System, program: Program, call: ApiCall, stay: Stay) -> bool:
    """Whether nothing at all waits but the callback's own next turn, and nothing is lost if that is late."""
    code, role = source_code(system), call.context.role
    if stay.kind == "discovery" and not made_here(call) and is_one_chain(call, program):
        return True
    if role == Role.SUBSCRIPTION and stay.kind == "sleep":
        minor = (stay.seconds is None and not call.looped) or in_loops(code, call, stay, with_callers=True) <= PAUSE
    elif role == Role.DONE and stay.kind == "sleep":
        minor = is_pause_before_the_next(system, call)
    else:
        period = period_of(system, call)
        in_time = period is None or (stay.seconds or 0.0) <= period
        brief = (
            bool(call.branch_arms) and stay.kind == "sleep" and in_loops(code, call, stay, with_callers=True) <= PAUSE
        )
        minor = role in _RUNS_AGAIN and (in_time or brief or leaves_its_state(code, call))
    return minor and not made_here(call) and who_waits(code, call, program) == Waiting.NOBODY


def _delays_nothing(code: SourceCode, row: LongStay) -> bool:
    """Whether a wait delays nothing that anybody would miss, or is for what the program asks whoever sits before it."""
    program, call, stay = row
    if stay.kind == "keyboard":
        return True
    return not made_here(call) and who_waits(code, call, program) in (Waiting.NOBODY, Waiting.SELDOM, Waiting.UNKNOWN)


def _only_late_intake(code: SourceCode, row: LongStay) -> bool:
    """Whether all that a short wait, or a sleep as the last step, delays is what somebody keeps until it is read."""
    program, call, stay = row
    last = stay.kind == "sleep" and comes_last(code, call)
    short = last or (-_longest_first(code, row)[0] <= _A_WHILE and not made_here(call))
    return _delays_nothing(code, row) or (short and keeps_intake_alone(code, call, program))


def _turns(call: ApiCall) -> bool:
    """Whether an execute callback spins again and again: more threads are the cure for that, too."""
    return call.context.role == Role.EXECUTE and call.looped and is_spin_call(call)


def _is_occasional(code: SourceCode, row: LongStay) -> bool:
    """Whether what a callback calls sleeps only under a condition, as where a connection is lost, or between moves."""
    _, call, stay = row
    return stay.kind == "sleep" and (is_called_in_branches(code, call) or is_between_moves(code, call))


def _is_of_a_retry(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a short sleep comes before the next of some attempts, one of which is to work; or a process is a step of
    attempts without end, of which the sleep is told where that is worth a line."""
    if stay.kind == "process":
        return is_step_of_a_retry(code, call)
    if stay.kind != "sleep" or (stay.seconds or math.inf) > PAUSE:
        return False
    if retries_after_errors(code, call) or gives_up_loudly(code, call, stay):
        return True
    return tries_until_it_works(code, call) and in_loops(code, call, stay, with_callers=True) <= PAUSE


_RUNS_AGAIN = frozenset({Role.SUBSCRIPTION, Role.TIMER, Role.EXECUTE, Role.SERVICE})


@once
def _where_harmless(system: System) -> frozenset[Place]:
    """The calls that a program with several threads comes to where they are harmless: whoever has another program run
    the same class on one thread knows what that costs."""
    return frozenset(
        call.place
        for program, call in judged_calls(system)
        if runs_in_executor(call.context)
        and threads_of(call.context.node, program) == blocking.SEVERAL
        and blocks_nobody(call.context, program)
    )


@once
def held_up_by_goals(system: System) -> frozenset[int]:
    """The nodes, by their ``id()``, whose execute callbacks hold up all others: they are to have more threads."""
    return frozenset(
        id(call.context.node)
        for program, call, stay in long_stays(system)
        if call.context.role == Role.EXECUTE and not _is_left_alone(system, program, call, stay)
    )


_ITS_NEXT = {
    Role.SUBSCRIPTION: "message",
    Role.TIMER: "turn",
    Role.SERVICE: "request",
    Role.EXECUTE: "goal",
    Role.DONE: "answer",
}


def _slow(system: System, rows: Sequence[LongStay], worst: str) -> Finding:
    """The finding for a function; ``worst`` is the place of the longest wait of the node."""
    (program, call, stay), *others = rows
    callback = call.context
    period = period_of(system, call)
    if stay.kind == "sleep" and stay.seconds is not None and period is not None and stay.seconds > period:
        end = f", longer than its period of {period:g} s"
    else:
        end = _of_loop(source_code(system), call, stay)
    if others:
        end += _other_lines(call, stay, others)
    waiting = {who_waits(source_code(system), row[1], row[0]) for row in rows}
    elsewhere = _where_harmless(system)
    mild = all(row[1].place in elsewhere for row in rows)
    mild = mild or Waiting.OTHERS not in waiting or all(row[2].kind == "keyboard" for row in rows)
    meanwhile = _meanwhile(callback, program)
    if waiting == {Waiting.NOBODY}:
        meanwhile = f"the node has no other callback, but its next {_ITS_NEXT[callback.role]} has to wait"
    elif waiting <= {Waiting.NOBODY, Waiting.SELDOM}:
        meanwhile = "only timers that seldom run have to wait"
    elif Waiting.OTHERS not in waiting:
        meanwhile = "everything else on its thread has to wait"
    diagnostic = finding_in_callback(
        "EXE003",
        system,
        program,
        call,
        f"{callback_words(callback)} {stay.words}{end}: {meanwhile}",
        help=_instead(program, call, stay),
        further=(Related(other.place, f"here it {words.words}", again=True) for _, other, words in others),
        identity=(call.api,),
        group=(*_cause(callback), worst),
    )
    return replace(diagnostic, severity=Severity.INFO) if mild else diagnostic


def _other_lines(call: ApiCall, stay: Stay, others: Sequence[LongStay]) -> str:
    """What is said of the other lines of a function: whether they wait for the same kind of thing."""
    several = len(others) > 1
    if all(other.kind == stay.kind for _, _, other in others):
        return f", as {f'do {len(others)} more lines' if several else 'does another line'} of {call.function}"
    return f", and blocks at {f'{len(others)} more lines' if several else 'another line'} of {call.function}"


def _of_loop(code: SourceCode, call: ApiCall, stay: Stay) -> str:
    if stay.kind != "sleep" or not call.looped:
        return ""
    seconds = in_loops(code, call, stay, with_callers=True)
    in_all = "" if math.isinf(seconds) or stay.seconds == seconds else f", up to {seconds:.3g} s in all"
    return f" in each iteration of a loop{in_all}"


def _cause(callback: Callback) -> tuple[str, ...]:
    """What findings have in common that are told as one: the node, whose callbacks keep each other waiting, or a
    callback of no known node."""
    place = callback.place if callback.node is None else callback.node.place
    name = callback.name if callback.node is None else callback.node.class_name
    return (place.file, str(place.line), str(place.column), name)


@folds("EXE003")
def _of_one_cause(findings: Sequence[Finding]) -> Finding:
    """The finding for all functions with waits that the callbacks of one node get to."""
    first = next((row for row in findings if _as_text(row.place) == row.group[-1]), findings[0])
    others = [other for other in findings if other is not first]
    same = [other for other in others if other.identity[0] == first.identity[0]]
    callbacks = dict.fromkeys(other.identity[0] for other in others if other not in same)
    message = first.message
    if same:
        more = "another function" if len(same) == 1 else f"{len(same)} more functions"
        message += f"; it waits in {more}, too"
    if callbacks:
        several = len(callbacks) > 1
        message += f"; {f'{len(callbacks)} more callbacks' if several else 'another callback'} of the node "
        message += f"wait{'' if several else 's'}, too"
    rows = [row for other in others for row in _rows_of(other, "it" if other in same else other.identity[0])]
    return replace(first, message=message, related=(*first.related, *rows))


def _rows_of(diagnostic: Finding, who: str) -> Iterator[Related]:
    yield Related(diagnostic.place, f"here {who} waits in {diagnostic.identity[1].rpartition('.')[2]}(), too")
    yield from (line for line in diagnostic.related if line.again)


def _answers_in_time(call: ApiCall, stay: Stay) -> bool:
    """Whether a callback whose return value is the answer looks for a server for a limited time: it has to know."""
    return stay.kind == "discovery" and stay.seconds is not None and call.context.role in _ANSWERS


def _instead(program: Program, call: ApiCall, stay: Stay) -> str:
    """What to do; where the callback's return value is the answer, nothing can go on later."""
    if stay.kind == "discovery" and made_here(call):
        return MAKE_IT_EARLIER
    if stay.kind == "discovery" and call.context.role in _ANSWERS - {Role.EXECUTE}:
        return "check once without waiting, and respond that it is not available"
    if call.context.role == Role.PARAMETER:
        return "store the new value, return, and continue from a timer"  # its group is that of the node's own services
    if call.context.role in _ANSWERS:
        several = threads_of(call.context.node, program) == blocking.SEVERAL
        return _OWN_GROUP if several else f"spin the node with a MultiThreadedExecutor, and {_OWN_GROUP}"
    return _INSTEAD.get(stay.kind, "do it in a separate thread or a ThreadPoolExecutor")


_ANSWERS = frozenset({Role.SERVICE, Role.LIFECYCLE, Role.GOAL, Role.CANCEL, Role.PARAMETER, Role.EXECUTE})
"""Roles of callbacks that somebody waits for: what they return is the answer."""

_OWN_GROUP = "give this callback its own callback group"
_INSTEAD = {
    "sleep": "continue from a timer instead of sleeping",
    "discovery": "check once without waiting, and try again from a timer",
    "message": "create a subscription, and continue in its callback",
}


def _meanwhile(callback: Callback, program: Program) -> str:
    threads = threads_of(callback.node, program)
    if threads == blocking.SEVERAL:
        return "no other callback of its group runs in the meantime"
    if threads == blocking.ONE:
        return "no other callback of the node runs in the meantime"
    return "on a single-threaded executor no other callback runs in the meantime"
