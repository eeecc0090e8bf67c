"""TMO001, TMO002, TMO003 and TMO005: waits without a limit, and limits whose outcome nobody reads."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.reach import (
    argument,
    calls_of,
    creations_of,
    endpoint_words,
    has_limit,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
    same_expression,
    waits_for_ever,
)
from archlint.checks.registry import Options, finding, rule
from archlint.facts import model as facts
from archlint.finding import Finding, Place, Related
from archlint.program.values import External, Instance, Known

if TYPE_CHECKING:
    from archlint.program.model import ApiCall, Creation
    from archlint.system.model import System

WAIT_FOR_SERVICE = "rclpy.client.Client.wait_for_service"
WAIT_FOR_SERVER = "rclpy.action.client.ActionClient.wait_for_server"
WAIT_FOR_MESSAGE = "rclpy.wait_for_message.wait_for_message"
READY = ("rclpy.client.Client.service_is_ready", "rclpy.action.client.ActionClient.server_is_ready")
_LIMIT = {
    WAIT_FOR_SERVICE: "timeout_sec",
    WAIT_FOR_SERVER: "timeout_sec",
    WAIT_FOR_MESSAGE: "time_to_wait",
}
_CALL = "rclpy.client.Client.call"
_SEND_GOAL = "rclpy.action.client.ActionClient.send_goal"
_SPIN = "rclpy.spin_until_future_complete"
_EXECUTOR_SPIN = "rclpy.executors.Executor.spin_until_future_complete"
_IN_CALLBACKS = frozenset(
    {
        "subscription",
        "timer",
        "service",
        "execute",
        "goal",
        "cancel",
        "accepted",
        "feedback",
        "done",
        "parameter",
    }
)


@rule("TMO001")
def wait_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Waits for a service, an action server or a message that nothing limits."""
    yield from one_for_each_place(
        _limitless_wait(system, call)
        for _, call in calls_of(system, _LIMIT)
        # Below zero a client does not wait at all; wait_for_message() then waits for ever.
        if waits_for_ever(call, _LIMIT[call.api], negative=call.api == WAIT_FOR_MESSAGE)
    )


def _limitless_wait(system: System, call: ApiCall) -> Finding:
    function, limit = call.api.rpartition(".")[2], _LIMIT[call.api]
    awaited = "a message" if call.api == WAIT_FOR_MESSAGE else endpoint_words(call.creation, _kind(call))
    look = "received, message = " if call.api == WAIT_FOR_MESSAGE else "if not "
    return finding(
        "TMO001",
        call.place,
        f"{function}() waits for {awaited} without limit: if it never comes, nothing after this line runs",
        help=f"set a limit and look at the answer: {look}{function}(…, {limit}=5.0)"
        if call.api == WAIT_FOR_MESSAGE
        else f"set a limit and look at the answer: {look}….{function}({limit}=5.0):",
        related=way_to(call, call.creation if call.api != WAIT_FOR_MESSAGE else None),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, _name_of(call.creation), function),
    )


@rule("TMO002")
def call_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Blocking calls that wait for their answer without limit."""
    yield from one_for_each_place(
        _limitless_call(system, call, options.distros)
        for _, call in calls_of(system, (_CALL, _SEND_GOAL))
        if call.api == _SEND_GOAL or waits_for_ever(call, "timeout_sec", negative=False)
    )


def _limitless_call(system: System, call: ApiCall, distros: tuple[str, ...]) -> Finding:
    function = call.api.rpartition(".")[2]
    answer = "the result of" if call.api == _SEND_GOAL else "the answer of"
    return finding(
        "TMO002",
        call.place,
        f"{function}() waits for {answer} {endpoint_words(call.creation, _kind(call))} without limit: "
        "if it is lost, this never returns",
        help=_help_for_call(call, distros),
        related=way_to(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, _name_of(call.creation), function),
    )


def _help_for_call(call: ApiCall, distros: tuple[str, ...]) -> str:
    if call.api == _SEND_GOAL:
        return (
            "send_goal() has no timeout: use send_goal_async() with done callbacks, "
            "or spin on its future with a timeout"
        )
    in_callback = call.context.role in _IN_CALLBACKS
    asynchronous = (
        "call_async() and a done callback"
        if in_callback
        else "call_async() and rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)"
    )
    if distros == ("humble",):
        return f"call() has no timeout in humble: use {asynchronous}"
    if "humble" in distros:
        return f"jazzy and later: call(request, timeout_sec=2.0); in every distribution: {asynchronous}"
    return f"call(request, timeout_sec=2.0), or {asynchronous}"


@rule("TMO003")
def spin_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Spins until a future is complete that nothing limits."""
    yield from one_for_each_place(
        _limitless_spin(system, call)
        for _, call in calls_of(system, (_SPIN, _EXECUTOR_SPIN))
        if waits_for_ever(call, "timeout_sec") and not _own_future(call)
    )


def _own_future(call: ApiCall) -> bool:
    """Whether the future is one that the code completes itself: then no answer is waited for."""
    future = argument(call, "future")
    return isinstance(future, Instance) and isinstance(future.cls, External)


def _limitless_spin(system: System, call: ApiCall) -> Finding:
    clients = creations_of(argument(call, "future"))
    client = clients[0] if len({creation.place for creation in clients}) == 1 else None
    awaited = f"the answer of {endpoint_words(client)}" if client else "the future"
    return finding(
        "TMO003",
        call.place,
        f"spins until {awaited} has come, without limit: if it never comes, the next line never runs",
        help="set timeout_sec, and ask future.done() afterwards",
        related=way_to(call, client),
        node=node_name(system, call.context.node),
        identity=(call.function, _name_of(client), "spin_until_future_complete"),
    )


@rule("TMO005")
def ignored_wait_result(system: System, options: Options) -> Iterator[Finding]:
    """Waits with a timeout whose answer is thrown away, and that nothing asks for later."""
    asked = _clients_asked_for(system)
    yield from one_for_each_place(
        _ignored(system, call)
        for _, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER))
        if _thrown_away(call)
        and has_limit(call, "timeout_sec")
        and asked.isdisjoint(creation.place for creation in creations_of(call.receiver))
    )


def _thrown_away(call: ApiCall) -> bool:
    statement = call.statement
    return isinstance(statement, facts.Expression) and same_expression(statement.value, call.expression)


def _clients_asked_for(system: System) -> set[Place]:
    """Where the clients are created that somebody asks whether their server is there."""
    found: set[Place] = set()
    for _, call in calls_of(system, (*READY, WAIT_FOR_SERVICE, WAIT_FOR_SERVER)):
        if not _thrown_away(call):
            found.update(creation.place for creation in creations_of(call.receiver))
    return found


def _ignored(system: System, call: ApiCall) -> Finding:
    function = call.api.rpartition(".")[2]
    ready = "server_is_ready" if call.api == WAIT_FOR_SERVER else "service_is_ready"
    return finding(
        "TMO005",
        call.place,
        f"nobody looks at what {function}() says about {endpoint_words(call.creation, _kind(call))}: "
        "when the time is up, the code goes on as if it were there",
        help=f"if not ….{function}(…): do without it; or ask {ready}() before each request",
        related=way_to(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, _name_of(call.creation), function),
    )


def _kind(call: ApiCall) -> str:
    return "action" if call.api.startswith("rclpy.action.") else "service"


def _name_of(creation: Creation | None) -> str:
    return "" if creation is None else creation.name.text or ""


def way_to(call: ApiCall, client: Creation | None) -> list[Related]:
    """The calls on the way from a callback; what leads there from ``main`` goes without saying, but for the
    call that leaves out a limit which this one passes on."""
    hops = list(related_chain(call))
    if call.context.role not in _IN_CALLBACKS:
        hops = hops[-1:] if _passed_on(call) else []
    return [*hops, *related_creation(client)]


def _passed_on(call: ApiCall) -> bool:
    """Whether the limit is an argument of the function around, at its default."""
    limits = (argument(call, name) for name in ("timeout_sec", "time_to_wait"))
    return any(isinstance(limit, Known) and limit.kind == "argument_default" for limit in limits)
