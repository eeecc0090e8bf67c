"""TMO004: loops that only the appearance of a service or an action server ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.reach import calls_at_start, calls_of, creations_of, has_limit, node_name, related_creation
from archlint.analysis.source_code import source_code
from archlint.checks.folding import class_around, folds, of_one_class, of_one_package, package_around
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import (
    MAKE_IT_EARLIER,
    READY,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    kind_of,
    made_here,
    related_path,
    server_words,
)
from archlint.connections.lessons import is_lesson
from archlint.execution.announced_waits import says_something
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.kept_waiting import blocks_nobody, is_one_chain
from archlint.execution.present_servers import is_there, was_waited_for
from archlint.execution.stuck import clients_of_handlers
from archlint.execution.wait_loops import LoopEnd, end_of, only_the_server_ends
from archlint.finding import Finding, Place, Related, Severity
from archlint.model import Role
from archlint.python_code.foreign_awaits import foreign_awaits

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System

_IN_CLASS = "class"


@rule("TMO004", scope=Scope.CODE, by_program=True, in_use=True, start_up=False)
def endless_wait_loop(system: System, options: Options) -> Iterator[Finding]:
    """Loops that repeat until a server appears, and that nothing else ends.  Those with which a program starts count in
    a lesson, if they do not say what they wait for, and with ``start-up``."""
    code, raising = source_code(system), {call.place for _, call in foreign_awaits(system)}
    for calls, end in _endless_loops(system, options.distros, start_up=options.flag("start-up")):
        # A round of the loop that awaits asyncio's sleep raises, as EXE010 says, and ends it.
        if raising.isdisjoint(code.calls_in(calls[0].loops[-1])):
            yield _endless(system, calls, end, beside=_spin_beside(system, calls[0]))


def endless_in_callbacks(system: System, distros: Sequence[str]) -> frozenset[Place]:
    """Those of such loops that callbacks come to."""
    loops = _endless_loops(system, distros, start_up=False)
    return frozenset(call.loops[-1] for calls, _ in loops for call in calls if runs_in_executor(call.context))


def _endless_loops(
    system: System, distros: Sequence[str], *, start_up: bool
) -> Iterator[tuple[list[ApiCall], LoopEnd]]:
    """Such loops: the calls of each that wait, and what ends it."""
    asked, lesson = clients_of_handlers(system, distros), is_lesson(system)
    code = source_code(system)
    loops: dict[Place, list[ApiCall]] = {}
    for program, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY)):
        if not (call.api in READY or has_limit(call, "timeout_sec")) or not only_the_server_ends(code.loop(call)):
            continue
        if is_there(system, call) or was_waited_for(system, call):
            continue
        if runs_in_executor(call.context):
            if blocks_nobody(call.context, program) or (not lesson and is_one_chain(call, program)):
                continue
        elif not start_up and (not lesson or says_something(code.loop(call))):
            continue
        if not program.refused.isdisjoint(code.calls_in(call.loops[-1])):
            continue  # an error ends the loop
        # A handler that asks the server afterwards is SRV003's: this is part of the same wait.
        if asked.isdisjoint((call.context.place, client.place) for client in creations_of(call.receiver)):
            loops.setdefault(call.loops[-1], []).append(call)
    for key in sorted(loops):
        end = end_of(code.loop_at(key))
        known = frozenset(call.place.span for call in loops[key])
        # Of several servers one may be enough: then all of them must be known.
        if end is not None and (end.spans <= known if end.any_of_them else not end.spans.isdisjoint(known)):
            yield [call for call in loops[key] if call.place.span in end.spans], end


def _spin_beside(system: System, call: ApiCall) -> bool:
    """Whether an executor in a thread of its own runs the callbacks of the node that a loop is for."""
    node = call.node or call.context.node
    uses = (use for program in system.programs for use in program.executors)
    return node is not None and any(use.in_thread and node in use.nodes for use in uses)


def _endless(system: System, calls: Sequence[ApiCall], end: LoopEnd, *, beside: bool) -> Finding:
    """A callback that loops blocks its node; a program that starts up has nothing else to do yet, unless something
    spins ``beside`` it."""
    in_callback = [call for call in calls if runs_in_executor(call.context)]
    call = (in_callback or calls)[0]
    alike = [other for other in calls if other.context is call.context]
    ready = "server_is_ready" if kind_of(call) == "action" else "service_is_ready"
    stands = "the callback does not return and blocks its thread"
    if not in_callback:
        alone = call.context.role == Role.THREAD or beside
        stands = "this thread does nothing else" if alone else "the node does nothing else"
    diagnostic = finding(
        "TMO004",
        call.place,
        f"this loop ends only when {_what_comes(system, alike, end)}: until then {stands}",
        help=_help(system, call, ready) if in_callback else "end it after some attempts: for _ in range(10):",
        related=[*related_path(call, call.creation), *_other_clients(call, alike)],
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, "" if call.creation is None else call.creation.name.text or "", "loop"),
    )
    if in_callback:
        return replace(diagnostic, group=(_IN_CLASS, call.file, class_around(call.function), diagnostic.help))
    return replace(diagnostic, severity=Severity.INFO, group=package_around(system.workspace, call.file))


def _what_comes(system: System, calls: Sequence[ApiCall], end: LoopEnd) -> str:
    """The servers that end the loop."""
    missing = list(dict.fromkeys(server_words(system, call.creation, kind_of(call)) for call in calls))
    if len(missing) == 1:
        return f"{missing[0]} becomes available"
    joined = f"{', '.join(missing[:-1])} {'or' if end.any_of_them else 'and'} {missing[-1]}"
    return f"{joined} {'becomes' if end.any_of_them else 'become'} available"


def _other_clients(call: ApiCall, calls: Sequence[ApiCall]) -> list[Related]:
    creations = [
        other.creation for other in calls if other.creation is not None and other.creation is not call.creation
    ]
    return list(dict.fromkeys(related for creation in creations for related in related_creation(creation)))


def _help(system: System, call: ApiCall, ready: str) -> str:
    """What a callback does instead; a client that it has just made has found no server yet, and where the node gets to
    the same loop while it starts, it has to wait there."""
    if made_here(call):
        return MAKE_IT_EARLIER
    if call.place in calls_at_start(system):
        return f"wait where the node starts, before it calls this, and only check here: if not ….{ready}():"
    return f"check without waiting, and handle the case that it is missing: if not ….{ready}():"


@folds("TMO004")
def _of_one_owner(findings: Sequence[Finding]) -> Finding:
    """The finding for all such loops with which the programs of a package start, or of a file in none; of callbacks
    for those of a class that are to be changed in the same way."""
    kind, *rest = findings[0].group
    if kind != _IN_CLASS:
        return of_one_package(findings, "loop", "another such loop is here")
    class_findings = [replace(finding, group=tuple(rest)) for finding in findings]
    return of_one_class(class_findings, "loop", "another such loop is here")
