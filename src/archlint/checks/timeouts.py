"""TMO001, TMO003 and TMO005: waits without a limit, and limits whose outcome nobody reads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.left_over import is_dead, is_never_made
from archlint.analysis.limit_sites import sites_of_spin, sites_of_wait
from archlint.analysis.own_futures import spins_for_a_message, spins_for_own_future
from archlint.analysis.reach import (
    argument,
    calls_of,
    creations_of,
    endpoint_words,
    has_limit,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
    waits_for_ever,
)
from archlint.analysis.source_code import source_code
from archlint.analysis.stuck import spoken_of
from archlint.analysis.unused_results import is_thrown_away
from archlint.checks.folding import all_sites, folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.model import Role
from archlint.model.given import Constant

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation
    from archlint.systems.model import System

WAIT_FOR_SERVICE = "rclpy.client.Client.wait_for_service"
WAIT_FOR_SERVER = "rclpy.action.client.ActionClient.wait_for_server"
WAIT_FOR_MESSAGE = "rclpy.wait_for_message.wait_for_message"
READY = ("rclpy.client.Client.service_is_ready", "rclpy.action.client.ActionClient.server_is_ready")
_LIMIT = {
    WAIT_FOR_SERVICE: "timeout_sec",
    WAIT_FOR_SERVER: "timeout_sec",
    WAIT_FOR_MESSAGE: "time_to_wait",
}
_SPIN = "rclpy.spin_until_future_complete"
_EXECUTOR_SPIN = "rclpy.executors.Executor.spin_until_future_complete"
MAKE_IT_EARLIER = "create the client in the constructor, and check here without waiting whether its server is available"


@rule("TMO001", scope=Scope.CODE, in_use=True)
def wait_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Waits for a service, an action server or a message that nothing limits."""
    calls = list(calls_of(system, _LIMIT))
    called = {call.place for _, call in calls if call.context.role != Role.METHOD}
    yield from one_for_each_place(
        _limitless_wait(system, call)
        for _, call in calls
        # What a method that nothing calls gets to, too, says nothing of those that are called.
        if not (call.context.role == Role.METHOD and call.place in called)
        # Below zero a client does not wait at all; wait_for_message() then waits for ever.
        and waits_for_ever(source_code(system), call, _LIMIT[call.api], negative=call.api == WAIT_FOR_MESSAGE)
        and not is_never_made(system.workspace, call)
    )


def _limitless_wait(system: System, call: ApiCall) -> Finding:
    function = call.api.rpartition(".")[2]
    awaited = "a message" if call.api == WAIT_FOR_MESSAGE else endpoint_words(call.creation, kind_of(call))
    found = finding(
        "TMO001",
        call.place,
        f"{function}() waits for {awaited} without a timeout: if it never comes, nothing after this line runs",
        help=_help_for_wait(call, function),
        related=way_to(call, call.creation if call.api != WAIT_FOR_MESSAGE else None),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )
    # Whoever waits in a callback had better not wait at all.
    return replace(
        found,
        sites=None
        if runs_in_executor(call.context)
        else sites_of_wait(system.workspace, call.place, name_of(call.creation)),
        severity=Severity.INFO if _is_step_of_script(call) or is_uncalled(call) else found.severity,
    )


def is_uncalled(call: ApiCall) -> bool:
    """Whether a call is in a function that nothing here calls: whoever does may be anywhere, or nobody."""
    return call.context.role == Role.METHOD


def _is_step_of_script(call: ApiCall) -> bool:
    """Whether a program waits for a server on its own way, not in a node's constructor: it has nothing else to do yet,
    and whoever runs it sees that it waits."""
    functions = (call.function, *(hop.caller for hop in call.chain))
    in_constructor = any(name.rpartition(".")[2] == "__init__" for name in functions)
    return call.context.role in (Role.MAIN, Role.MODULE) and call.api != WAIT_FOR_MESSAGE and not in_constructor


def _help_for_wait(call: ApiCall, function: str) -> str:
    """What to write; a callback does not wait, or everything else of its node waits with it."""
    of_message = call.api == WAIT_FOR_MESSAGE
    if runs_in_executor(call.context):
        if made_here(call):
            return MAKE_IT_EARLIER
        return (
            "create a subscription, and continue in its callback"
            if of_message
            else f"check without waiting: if not ….{_ready(call)}():"
        )
    if of_message:
        return f"set a timeout and check the result: received, message = {function}(…, {_LIMIT[call.api]}=5.0)"
    return f"set a timeout and check the result: if not ….{function}({_LIMIT[call.api]}=5.0):"


def made_here(call: ApiCall) -> bool:
    """Whether the client is made by the same run of the callback: no server is found yet, however ready it is."""
    made = creations_of(call.receiver)
    return any(creation.context is call.context for creation in made)


def _ready(call: ApiCall) -> str:
    return "server_is_ready" if kind_of(call) == "action" else "service_is_ready"


@rule("TMO003", scope=Scope.CODE, taste=True)
def spin_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Spins until a future is complete that nothing limits.  Of a method that nothing calls, and of a client that
    nothing is seen to make, nobody knows whether it is ever there; a trial is ended by whoever runs it."""
    reported = spoken_of(system, options.distros)
    yield from one_for_each_place(
        _limitless_spin(system, call)
        for program, call in calls_of(system, (_SPIN, _EXECUTOR_SPIN))
        if waits_for_ever(source_code(system), call, "timeout_sec") and call.place not in reported
        if not is_dead(system.workspace, program, call) and not is_never_made(system.workspace, call)
        if not spins_for_own_future(call) or spins_for_a_message(system, call)
        if call.context.role != Role.METHOD or creations_of(argument(call, "future"))
    )


def _limitless_spin(system: System, call: ApiCall) -> Finding:
    clients = creations_of(argument(call, "future"))
    client = clients[0] if len({creation.place for creation in clients}) == 1 else None
    awaited = f"the response from {endpoint_words(client)}" if client else "the future"
    if spins_for_own_future(call):
        awaited = "the message that completes the future"
    return finding(
        "TMO003",
        call.place,
        f"spins until {awaited} arrives, without a timeout: if it never does, the next line never runs",
        help=_help_for_spin(call),
        related=way_to(call, client),
        node=node_name(system, call.context.node),
        identity=(call.function, name_of(client), "spin_until_future_complete"),
        group=(call.file, call.function),
        sites=sites_of_spin(system.workspace, call.place),
    )


def _help_for_spin(call: ApiCall) -> str:
    """What to write; where the limit is an argument of the function, its callers or its default leave it out."""
    if _passed_on(call):
        return (
            f"pass {call.function.rpartition('.')[2]}() a timeout where it is called, or give the parameter a "
            "default other than None"
        )
    return "set timeout_sec, and check future.done() afterwards"


@folds("TMO003")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """The finding for all such spins of a function: an action's goal is sent, and then its result awaited."""
    first, *others = findings
    lines, do = ("another line", "does") if len(others) == 1 else (f"{len(others)} more lines", "do")
    return replace(
        first,
        message=f"{first.message}; {lines} in {first.group[1]}() {do} the same",
        related=(*first.related, *(Related(one.place, "it spins without a timeout here, too") for one in others)),
        sites=all_sites(findings),
    )


@rule("TMO005", scope=Scope.CODE, in_use=True)
def ignored_wait_result(system: System, options: Options) -> Iterator[Finding]:
    """Waits with a timeout whose answer is thrown away, and that nothing asks for later."""
    asked = _clients_asked_for(system)
    yield from one_for_each_place(
        _ignored(system, call)
        for _, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER))
        if is_thrown_away(source_code(system), call)
        and not is_never_made(system.workspace, call)
        and has_limit(call, "timeout_sec")
        and asked.isdisjoint(creation.place for creation in creations_of(call.receiver))
    )


def _clients_asked_for(system: System) -> set[Place]:
    """Where the clients are created that somebody asks whether their server is there."""
    found: set[Place] = set()
    for _, call in calls_of(system, (*READY, WAIT_FOR_SERVICE, WAIT_FOR_SERVER)):
        if not is_thrown_away(source_code(system), call):
            found.update(creation.place for creation in creations_of(call.receiver))
    return found


def _ignored(system: System, call: ApiCall) -> Finding:
    function = call.api.rpartition(".")[2]
    return finding(
        "TMO005",
        call.place,
        f"the result of {function}() for {endpoint_words(call.creation, kind_of(call))} is ignored: after the "
        "timeout the code continues as if it were available",
        help=f"check the result, and handle the case that the server is not available: if not ….{function}(…):",
        related=way_to(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )


def kind_of(call: ApiCall) -> str:
    return "action" if call.api.startswith("rclpy.action.") else "service"


def name_of(creation: Creation | None) -> str:
    return "" if creation is None else creation.name.text or ""


def way_to(call: ApiCall, client: Creation | None) -> list[Related]:
    """The calls on the way from a callback; what leads there from ``main`` goes without saying, but for the
    call that leaves out a limit which this one passes on."""
    hops = list(related_chain(call))
    if not runs_in_executor(call.context):
        hops = hops[-1:] if _passed_on(call) else []
    return [*hops, *related_creation(client)]


def _passed_on(call: ApiCall) -> bool:
    """Whether the limit is an argument of the function around, at its default."""
    limits = (argument(call, name) for name in ("timeout_sec", "time_to_wait"))
    return any(isinstance(limit, Constant) and limit.origin_kind == "argument_default" for limit in limits)
