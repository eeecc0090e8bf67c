"""SRV005: answers that are waited for one after the other, though nothing but the waiting needs that."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.blocking import AWAIT
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.client_loops import clients_in_turn
from archlint.execution.dependent_waits import build_on_answers, runs_beside_others
from archlint.execution.loop_times import literal_rounds, loops_of_first_way
from archlint.execution.retries import is_retried
from archlint.execution.stuck import stuck_waits
from archlint.execution.waits import Wait, waits
from archlint.finding import Finding, Place, Related
from archlint.model import EntityKind, Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Frame
    from archlint.systems.model import System


@dataclass(frozen=True)
class _Step:
    """A wait on one of the ways to it: ``line`` is where the function that is looked at makes it, or calls what does.

    ``client`` is the one that this way asks."""

    line: Place
    chain: tuple[Frame, ...]
    wait: Wait
    client: Creation


@rule("SRV005", scope=Scope.CODE, limit=3)
def sequential_sync_calls(system: System, options: Options) -> Iterator[Finding]:
    """Callbacks and loop bodies that wait for several servers in turn."""
    limit, code = max(2, int(options.number("limit"))), source_code(system)
    yield from one_for_each_place(
        _in_turn(system, steps)
        for steps in _runs(system, options.distros)
        if _servers(steps) >= limit and not _build_on_answers(code, steps)
    )
    yield from one_for_each_place(
        _in_loop(system, wait, servers)
        for wait in waits(system)
        if _is_judged(code, wait) and wait.client.type not in _COMMANDS and wait.client.kind == EntityKind.CLIENT
        for servers in [clients_in_turn(code, wait)]
        if servers >= limit
    )


def _is_judged(code: SourceCode, wait: Wait) -> bool:
    """Whether a wait in a loop over clients is one of a callback, or of what a program repeats."""
    call = wait.call
    if not call.loops or call.context.role == Role.SERVICE or (wait.kind != AWAIT and is_retried(code, call)):
        return False
    repeated = len(call.enclosing_loops) > 1 and call.context.role in (Role.MAIN, Role.THREAD)
    return runs_in_executor(call.context) or repeated


def _servers(steps: Sequence[_Step]) -> int:
    """How many clients ask for something.  What one server is asked several times may well have an order, and so have
    commands: goals of actions, and services that answer nothing or no more than that they have done it."""
    return len(
        {
            id(step.client)
            for step in steps
            if step.client.kind == EntityKind.CLIENT and step.client.type not in _COMMANDS
        }
    )


_COMMANDS = frozenset({"std_srvs/srv/Empty", "std_srvs/srv/SetBool"})


def _build_on_answers(code: SourceCode, steps: Sequence[_Step]) -> bool:
    """Whether what is done between the waits may decide about a later one: a test, a name that an answer got, or a
    helper that waits several times."""
    if len({step.line for step in steps}) < len(steps):
        return True
    return build_on_answers(code.body_at(steps[0].line), {step.line.line for step in steps})


def _runs(system: System, distros: Sequence[str]) -> Iterator[list[_Step]]:
    """The waits of each callback, or of each loop of a program, that follow each other for certain."""
    code = source_code(system)
    # These never get an answer, or raise: other rules say so, and to wait elsewhere is the cure for both.
    stuck = {id(wait) for wait, _ in stuck_waits(system, distros)}
    by_run: dict[tuple[object, ...], list[_Step]] = {}
    for wait in waits(system):
        call = wait.call
        if not (runs_in_executor(call.context) or (call.looped and call.context.role in (Role.MAIN, Role.THREAD))):
            continue
        if id(wait) in stuck:
            continue
        if call.context.role == Role.SERVICE:
            continue  # SRV003 says of a handler that it waits, and for how many answers
        if wait.kind != AWAIT and is_retried(code, call):
            continue
        for chain, loops, clients in ((call.chain, loops_of_first_way(code, call), ()), *call.call_chains):
            # What is in the same arms of all branches runs together or not at all; a program that is no
            # callback has to run all of it.
            outermost = loops[:1] if not runs_in_executor(call.context) else ()
            if not runs_in_executor(call.context) and not _goes_on(code, outermost):
                continue
            key = (id(wait.program), id(call.context), call.branch_arms, outermost)
            client = clients[0] if clients else wait.client
            by_run.setdefault(key, []).append(_Step(call.place, chain, wait, client))
    for steps in by_run.values():
        yield from _sequences(code, steps)


_FEW = 10


def _goes_on(code: SourceCode, loops: Sequence[Place]) -> bool:
    """Whether what a program does on one of the ways to a wait is repeated.  What has no loop around runs once,
    whatever loops the other ways go through, and a script that plays the same few scenes again, ``for _ in range(2):``,
    is as good as written out."""
    rounds = None if not loops else literal_rounds(code.loop_at(loops[0]))
    return bool(loops) and (rounds is None or rounds >= _FEW)


def _sequences(code: SourceCode, steps: list[_Step]) -> Iterator[list[_Step]]:
    """One sequence a function that makes the waits, directly or through a helper each."""
    by_function: dict[str, dict[tuple[Place, Place], _Step]] = {}
    for step in steps:
        if runs_beside_others(code, step.chain):
            continue
        call, chain = step.wait.call, step.chain
        # The function that holds the call, and the one that calls the helper which does.
        by_function.setdefault(f"{call.file}:{call.function}", {})[call.place, call.place] = step
        if chain:
            last = chain[-1]
            by_caller = by_function.setdefault(f"{last.place.file}:{last.caller}", {})
            by_caller[last.place, call.place] = replace(step, line=last.place)
    for sequence in by_function.values():
        yield [sequence[key] for key in sorted(sequence)]


def _in_loop(system: System, wait: Wait, servers: int) -> Finding:
    """The finding for a loop over clients."""
    call = wait.call
    return finding(
        "SRV005",
        call.place,
        f"{_who(call)} waits for the responses of {servers} servers, one in each round of a loop: the waits add up, "
        "and one slow server delays all",
        help="send all the requests with call_async() first, and wait for their futures after the loop",
        related=[Related(wait.client.place, "the clients are created here")],
        node=node_name(system, call.node),
        identity=(call.context.name, str(servers)),
    )


def _who(call: ApiCall) -> str:
    callback = call.context
    return callback_words(callback) if runs_in_executor(callback) else f"a loop of {callback.name}()"


def _in_turn(system: System, steps: list[_Step]) -> Finding:
    first = steps[0].wait.call
    callback, who = first.context, _who(first)
    lines = {step.wait.call.place for step in steps}
    awaits = all(step.wait.kind == AWAIT for step in steps)
    return finding(
        "SRV005",
        # A helper with one waiting line is not what makes them several: whoever calls it again and again is.
        first.place if len(lines) == len(steps) else steps[0].line,
        f"{who} waits for the responses of {_servers(steps)} servers one after the other: the waits add up, and "
        "one slow server delays all",
        help="send all the requests with call_async() first, and then await their futures"
        if awaits
        else "send the requests with call_async() and continue when their futures are done",
        related=[
            Related(
                step.chain[-1].place if step.chain else step.wait.call.place, f"waits for {endpoint_words(step.client)}"
            )
            for step in steps
        ],
        node=node_name(system, first.node),
        identity=(callback.name, str(_servers(steps))),
    )
