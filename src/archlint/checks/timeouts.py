"""TMO001: waits without a limit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.left_over import is_never_made
from archlint.analysis.limit_sites import sites_of_wait
from archlint.analysis.reach import (
    calls_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    waits_for_ever,
)
from archlint.analysis.source_code import source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import (
    MAKE_IT_EARLIER,
    WAIT_FOR_MESSAGE,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    kind_of,
    made_here,
    name_of,
    related_path,
)
from archlint.finding import Finding, Severity
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System
_LIMIT = {
    WAIT_FOR_SERVICE: "timeout_sec",
    WAIT_FOR_SERVER: "timeout_sec",
    WAIT_FOR_MESSAGE: "time_to_wait",
}


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
        # Below zero a client does not wait at all; wait_for_message() then waits forever.
        and waits_for_ever(source_code(system), call, _LIMIT[call.api], negative=call.api == WAIT_FOR_MESSAGE)
        and not is_never_made(system.workspace, call)
    )


def _limitless_wait(system: System, call: ApiCall) -> Finding:
    function = call.api.rpartition(".")[2]
    awaited = "a message" if call.api == WAIT_FOR_MESSAGE else endpoint_words(call.creation, kind_of(call))
    diagnostic = finding(
        "TMO001",
        call.place,
        f"{function}() waits for {awaited} without a timeout: if it never comes, nothing after this line runs",
        help=_help_for_wait(call, function),
        related=related_path(call, call.creation if call.api != WAIT_FOR_MESSAGE else None),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )
    # Whoever waits in a callback had better not wait at all.
    return replace(
        diagnostic,
        sites=None
        if runs_in_executor(call.context)
        else sites_of_wait(system.workspace, call.place, name_of(call.creation)),
        severity=Severity.INFO if _is_step_of_script(call) or is_uncalled(call) else diagnostic.severity,
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


def _ready(call: ApiCall) -> str:
    return "server_is_ready" if kind_of(call) == "action" else "service_is_ready"
