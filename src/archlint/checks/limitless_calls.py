"""TMO002: blocking calls that wait for their answer without limit, and what to write in their place."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_example
from archlint.analysis.limit_sites import sites_of_call
from archlint.analysis.order import always_comes_before
from archlint.analysis.pinned import distros_to_judge
from archlint.analysis.reach import (
    calls_of,
    creations_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    waits_for_ever,
)
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.unused_results import is_needed_to_return, stands_alone
from archlint.checks.folding import class_around, folds, of_one_class
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.timeouts import is_uncalled
from archlint.checks.wait_words import (
    READY,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    kind_of,
    name_of,
    related_path,
    server_words,
)
from archlint.connections.lessons import is_lesson
from archlint.execution.asking_scripts import has_only_clients
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import CALL
from archlint.execution.joined_threads import stuck_joins
from archlint.execution.paces import runs_beside_itself
from archlint.execution.piling_waits import piling_up
from archlint.execution.spins import is_spun_by_constructors_alone
from archlint.execution.stuck import spoken_of
from archlint.execution.threaded_waits import threaded_waits
from archlint.execution.threads import is_daemon
from archlint.execution.waits import DONE, other_arm_only_sends, waits
from archlint.finding import Finding, Severity
from archlint.model import ExecutorKind, Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_LOOKS_FOR_SERVER = (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY)
_CALL = "rclpy.client.Client.call"
_SEND_GOAL = "rclpy.action.client.ActionClient.send_goal"

_ANOTHER = "another thread"
_NOBODY = "nobody yet"
_EXECUTOR = "its executor, later"
_UNKNOWN = "nobody knows"
_SPINS = (_ANOTHER, _UNKNOWN)


@rule("TMO002", scope=Scope.CODE, in_use=True, uncalled=False, lost_answers=False)
def call_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Blocking calls that wait for their answer without limit; those of functions that nothing calls in a lesson and
    with ``uncalled``, those of programs that are there to ask once, and have found their server, in a lesson and with
    ``lost-answers``."""
    lesson = is_lesson(system)
    uncalled, seldom = options.flag("uncalled") or lesson, options.flag("lost-answers") or lesson
    distros = distros_to_judge(system.workspace, options.distros)
    yield from one_for_each_place(
        _limitless_call(system, program, call, distros)
        for program, call in _limitless(system, options)
        if not is_unanswerable(program, call) and (uncalled or not is_uncalled(call))
        if not (is_uncalled(call) and _is_of_no_use(program, call))
        if seldom or not (_asks_once(system, program, call) or _is_shown(call))
    )


def _is_of_no_use(program: Program, call: ApiCall) -> bool:
    """Whether nothing spins the node of a call once it is made: the call would wait for ever, and a limit would always
    expire, so that whoever calls it has to begin with that."""
    node = call.node if call.creation is None else call.creation.node
    return node is not None and is_spun_by_constructors_alone(program, node)


def _is_shown(call: ApiCall) -> bool:
    """Whether a call is on the way of an example: whoever runs it looks on."""
    return is_example(call.file) and not runs_in_executor(call.context)


def _asks_once(system: System, program: Program, call: ApiCall) -> bool:
    """Whether all that a program is there for is a request to a server that it has looked for on every way."""
    code, clients = source_code(system), {client.place for client in creations_of(call.receiver)}
    if not has_only_clients(program) or call.looped or call.context.role not in (Role.MAIN, Role.MODULE):
        return False
    return any(
        other.api in _LOOKS_FOR_SERVER
        and not clients.isdisjoint(client.place for client in creations_of(other.receiver))
        and always_comes_before(code, other, call)
        for other in program.calls
    )


def unanswerable_calls(system: System, options: Options) -> Iterator[Finding]:
    """Blocking calls that nothing can answer while they wait: nobody spins the node then."""
    return (
        _unanswerable(system, program, call, options.distros)
        for program, call in _limitless(system, options)
        if is_unanswerable(program, call)
    )


def unanswerable_loops(system: System) -> Iterator[Finding]:
    """Loops at the start of a program that ask whether a response is there, while nothing spins the node."""
    for wait in waits(system):
        call, program = wait.call, wait.program
        known = program.executable and not program.exhausted and not is_uncalled(call)
        if call.api != DONE or wait.kind != CALL or wait.bounded or not known or call.context.role not in _AT_START:
            continue
        if _spinner(call, program, wait.client) in (_NOBODY, _EXECUTOR):
            yield finding(
                "EXE009",
                call.place,
                f"this loop never ends: nothing spins the node of {endpoint_words(wait.client, kind_of(call))} "
                "meanwhile, so the response is never processed",
                help="rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)",
                related=related_path(call, wait.client),
                node=node_name(system, call.node or call.context.node),
                identity=(call.function, name_of(wait.client), "done"),
            )


_AT_START = (Role.INIT, Role.MAIN, Role.MODULE)


def _limitless(system: System, options: Options) -> Iterator[tuple[Program, ApiCall]]:
    reported = spoken_of(system, options.distros) | {wait.call.place for wait in piling_up(system)}
    reported |= {row.wait.call.place for row in stuck_joins(system, options.distros)}
    return (
        (program, call)
        for program, call in calls_of(system, (_CALL, _SEND_GOAL))
        if not _is_wait_of_daemon(system, program, call)
        and call.place not in reported
        and _is_without_limit(source_code(system), call)
    )


def _is_without_limit(code: SourceCode, call: ApiCall) -> bool:
    return call.api == _SEND_GOAL or waits_for_ever(code, call, "timeout_sec", negative=False)


def never_returns(code: SourceCode, program: Program, call: ApiCall) -> bool:
    """Whether a call waits for an answer without a limit, and nothing can answer it: EXE009."""
    waits = call.api in (_CALL, _SEND_GOAL) and _is_without_limit(code, call)
    return waits and is_unanswerable(program, call)


def is_unanswerable(program: Program, call: ApiCall) -> bool:
    """Whether a program waits at its start, on the thread that would spin the node of an endpoint or a rate
    afterwards."""
    return program.executable and is_unanswerable_at_start(program, call)


def is_unanswerable_at_start(program: Program, call: ApiCall) -> bool:
    """The same of code that nothing here is seen to start."""
    known = not program.exhausted and call.creation is not None and not is_uncalled(call)
    at_start = call.context.role in _AT_START
    return known and at_start and _spinner(call, program) in (_NOBODY, _EXECUTOR)


def _unanswerable(system: System, program: Program, call: ApiCall, distros: tuple[str, ...]) -> Finding:
    function = call.api.rpartition(".")[2]
    return finding(
        "EXE009",
        call.place,
        f"{function}() never returns: nothing spins the node of {endpoint_words(call.creation, kind_of(call))} while "
        "this thread waits, so the response is never processed",
        help=_help(source_code(system), call, _spinner(call, program), distros),
        related=related_path(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )


def _is_wait_of_daemon(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a call is what a daemon thread was made for: it waits once, nobody waits for it, and it is gone when
    the program ends."""
    callback, workspace = call.context, system.workspace
    place = callback.registered
    if callback.role != Role.THREAD or call.chain or call.enclosing_loops or place is None or workspace is None:
        return False
    return _spinner(call, program) != _NOBODY and is_daemon(workspace, place)


def _limitless_call(system: System, program: Program, call: ApiCall, distros: tuple[str, ...]) -> Finding:
    function = call.api.rpartition(".")[2]
    answer = "the result of" if call.api == _SEND_GOAL else "the response from"
    spinner = _spinner(call, program)
    advice = _help(source_code(system), call, spinner, distros)
    diagnostic = finding(
        "TMO002",
        call.place,
        f"{function}() waits for {answer} {server_words(system, call.creation, kind_of(call))} without a timeout: "
        f"if it is lost, this never returns{_if_often(system, call)}",
        help=advice,
        related=related_path(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )
    severity = Severity.INFO if is_uncalled(call) else diagnostic.severity
    group = (call.file, class_around(call.function), severity.label, spinner, advice)
    diagnostic = replace(diagnostic, severity=severity, group=group)
    # Where nobody spins meanwhile, a limit would always expire.
    return (
        replace(diagnostic, sites=sites_of_call(system.workspace, call.place, distros))
        if spinner in _SPINS
        else diagnostic
    )


@folds("TMO002")
def _of_one_owner(findings: Sequence[Finding]) -> Finding:
    """The finding for all such calls of a class that are to be replaced in the same way."""
    return of_one_class(findings, "call", "it calls without a timeout here, too")


_COMES = {Role.SUBSCRIPTION: "messages come", Role.EXECUTE: "goals come"}


def _if_often(system: System, call: ApiCall) -> str:
    """What else becomes of a callback that may run beside itself, where nothing says how often."""
    comes = _COMES.get(call.context.role)
    if (
        comes is None
        or not runs_beside_itself(call.context)
        or not any(wait.call is call for wait in threaded_waits(system))
    ):
        return ""
    return f"; if {comes} faster than responses, all threads wait, and none is left to process one"


def _spinner(call: ApiCall, program: Program, client: Creation | None = None) -> str:
    """Who spins the client's node while the call waits: that decides what can replace the call."""
    client = client or call.creation
    role = call.context.role
    if runs_in_executor(call.context):
        return _ANOTHER
    node = call.node if client is None else client.node
    if node is None or node.caller_unknown or node.escapes or role not in (*_AT_START, Role.THREAD):
        return _UNKNOWN
    uses = program.executors_of(node)
    if any(use.in_thread for use in uses) or (uses and role == Role.THREAD):
        return _ANOTHER
    if role == Role.THREAD or node.executor == ExecutorKind.UNKNOWN or node.runs_elsewhere:
        return _UNKNOWN
    return _EXECUTOR if any(node not in use.spells for use in uses) else _NOBODY


_LONGER = ", with more seconds than the server ever takes"


def _help(code: SourceCode, call: ApiCall, spinner: str, distros: tuple[str, ...]) -> str:
    goal = call.api == _SEND_GOAL
    sent = "send_goal_async()" if goal else "call_async()"
    if spinner == _NOBODY:
        return f"{sent} and rclpy.spin_until_future_complete(node, future, timeout_sec=…){_LONGER}"
    if spinner == _EXECUTOR:
        # rclpy's own function would take the node from its executor for good.
        return f"{sent} and executor.spin_until_future_complete(future, timeout_sec=…){_LONGER}"
    unread = spinner == _UNKNOWN and stands_alone(code, call)
    if (runs_in_executor(call.context) and not is_needed_to_return(code, call)) or (
        unread and not other_arm_only_sends(code, call)
    ):
        return f"{sent} and continue in a done callback: future.add_done_callback(…)"
    if not goal and "humble" not in distros:
        return f"call(request, timeout_sec=…){_LONGER}"
    who = "in a thread that does not spin" if spinner == _UNKNOWN else "another thread spins the node"
    return f"{who}: {sent}, and wait with event.wait(timeout=…) for an Event that a done callback sets{_LONGER}"
