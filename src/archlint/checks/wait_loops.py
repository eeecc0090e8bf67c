"""TMO004: loops that only the appearance of a service or an action server ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.asking_scripts import is_seen_to_wait
from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.left_over import is_dead, is_never_made
from archlint.analysis.present_servers import is_there
from archlint.analysis.reach import calls_of, creations_of, has_limit, node_name
from archlint.analysis.source_code import source_code
from archlint.analysis.stuck import clients_of_handlers
from archlint.analysis.wait_loops import only_the_server_ends
from archlint.checks.folding import folds, of_one_function
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
from archlint.finding import Finding, Place, Severity
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


@rule("TMO004", scope=Scope.CODE, by_program=True, in_use=True)
def endless_wait_loop(system: System, options: Options) -> Iterator[Finding]:
    """Loops that repeat until a server appears, and that nothing else ends."""
    asked = clients_of_handlers(system, options.distros)
    code = source_code(system)
    loops: dict[Place, list[ApiCall]] = {}
    for program, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY)):
        if not (call.api in READY or has_limit(call, "timeout_sec")) or not only_the_server_ends(code.loop(call)):
            continue
        if is_dead(system.workspace, program, call) or is_never_made(system.workspace, call):
            continue
        if is_there(system, call) or is_seen_to_wait(system, program, call, creations_of(call.receiver)):
            continue
        if not program.refused.isdisjoint(code.calls_in(call.loops[-1])):
            continue  # an error ends the loop
        # A handler that asks the server afterwards is SRV003's: this is part of the same wait.
        if asked.isdisjoint((call.context.place, client.place) for client in creations_of(call.receiver)):
            loops.setdefault(call.loops[-1], []).append(call)
    yield from (_endless(system, loops[key]) for key in sorted(loops))


def _endless(system: System, calls: Sequence[ApiCall]) -> Finding:
    """A callback that loops blocks its node; a program that starts up has nothing else to do yet."""
    in_callback = [call for call in calls if runs_in_executor(call.context)]
    call = (in_callback or calls)[0]
    kind = kind_of(call)
    missing = server_words(system, call.creation, kind)
    ready = "server_is_ready" if kind == "action" else "service_is_ready"
    stands = "the callback does not return and blocks its thread"
    if not in_callback:
        stands = "this thread does nothing else" if call.context.role == Role.THREAD else "the node does nothing else"
    diagnostic = finding(
        "TMO004",
        call.place,
        f"this loop ends only when {missing} becomes available: until then {stands}",
        help=_help(call, ready) if in_callback else "end the loop when ROS shuts down: while rclpy.ok() and not …:",
        related=related_path(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, "" if call.creation is None else call.creation.name.text or "", "loop"),
    )
    return diagnostic if in_callback else replace(diagnostic, severity=Severity.INFO, group=(call.file, call.function))


def _help(call: ApiCall, ready: str) -> str:
    """What a callback does instead; a client that it has just made has found no server yet."""
    if made_here(call):
        return MAKE_IT_EARLIER
    return f"check without waiting, and handle the case that it is missing: if not ….{ready}():"


@folds("TMO004")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """The finding for all such loops that a program comes to one after the other as it starts."""
    return of_one_function(findings, "loop", "another such loop is here")
