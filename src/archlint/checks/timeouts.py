"""TMO001: waits without a limit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_example, is_not_installed
from archlint.analysis.left_over import is_dead
from archlint.analysis.limit_sites import sites_of_wait
from archlint.analysis.reach import (
    calls_of,
    creations_of,
    node_name,
    one_for_each_place,
    waits_for_ever,
)
from archlint.analysis.source_code import source_code
from archlint.checks.folding import class_around, folds, of_one_class, of_one_package, package_around
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import uncalled_in_program
from archlint.checks.wait_words import (
    MAKE_IT_EARLIER,
    WAIT_FOR_MESSAGE,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    asked_alone,
    is_at_its_default,
    kind_of,
    made_here,
    name_of,
    passed_on,
    related_path,
    server_words,
)
from archlint.connections.lessons import is_lesson
from archlint.execution.announced_waits import (
    is_announced_beside_others,
    is_announced_start,
    is_documented_start,
    is_ended_by_hand,
    is_second_wait,
    is_start_in_order,
    says_something,
)
from archlint.execution.asking_scripts import asks_once, is_launched, is_step_of_asking_script
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.called_by_hand import is_command, is_driven_by_hand
from archlint.execution.client_loops import is_for_each_client
from archlint.execution.own_timers import ends_its_timer_before
from archlint.execution.present_servers import is_there
from archlint.execution.same_servers import has_answered_elsewhere
from archlint.finding import Finding, Severity
from archlint.model import Role
from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System
_MINOR = "minor"
_LIMIT = {
    WAIT_FOR_SERVICE: "timeout_sec",
    WAIT_FOR_SERVER: "timeout_sec",
    WAIT_FOR_MESSAGE: "time_to_wait",
}


@rule("TMO001", scope=Scope.CODE, taste=True, scripts=False)
def wait_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Waits for a service, an action server or a message that nothing limits; those of scripts, and of what nothing
    calls, in a lesson and with ``scripts``."""
    minor, lesson = options.flag("scripts"), is_lesson(system)
    calls = list(calls_of(system, _LIMIT))
    called = {call.place for _, call in calls if call.context.role != Role.METHOD}
    yield from one_for_each_place(
        _limitless_wait(system, program, call, asked_alone(call, (other for _, other in calls)))
        for program, call in calls
        # What a method that nothing calls gets to, too, says nothing of those that are called.
        if not (call.context.role == Role.METHOD and call.place in called)
        # Below zero a client does not wait at all; wait_for_message() then waits forever.
        and waits_for_ever(source_code(system), call, _LIMIT[call.api], negative=call.api == WAIT_FOR_MESSAGE)
        and not _is_unused(system, program, call)
        and not is_announced_start(system, call)
        and not is_announced_beside_others(system, program, call)
        and (minor or not _is_minor(system, program, call) or (lesson and not _is_command(system, program, call)))
        and not (is_ended_by_hand(system, call) and _is_minor(system, program, call))
        and not is_there(system, call)
        and not has_answered_elsewhere(system, call)
        and not _has_waited_at_start(system, program, call)
        and not is_second_wait(system, program, call)
        and not _is_in_a_loop_that_tells(system, call)
    )


def _has_waited_at_start(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a callback waits for a server that its program has waited for before it spun anything, or in a timer that
    starts it all: it was there."""
    code = source_code(system)
    clients = {client.place for client in creations_of(call.receiver)}
    return runs_in_executor(call.context) and any(
        other.api == call.api
        and (other.context.role in (Role.INIT, Role.MAIN) or _is_start(system, other))
        and other.context is not call.context
        and bool(clients)
        and clients == {client.place for client in creations_of(other.receiver)}
        and waits_for_ever(code, other, _LIMIT[other.api])
        for other in program.calls
    )


def _is_in_a_loop_that_tells(system: System, call: ApiCall) -> bool:
    """Whether a program starts with a loop that waits again and again, and says so: its author knows that the server
    may be late, and wants to see it."""
    return call.context.role in (Role.INIT, Role.MAIN) and says_something(source_code(system).loop(call))


def _is_start(system: System, call: ApiCall) -> bool:
    """Whether a timer that ends itself comes to a call: it starts, once, what the node is there for."""
    return ends_its_timer_before(system, call)


def _is_unused(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a call is in a method of a program that nothing calls, or of a script in no package, from which nobody
    imports it."""
    workspace = system.workspace
    if workspace is None or call.context.role != Role.METHOD:
        return False
    if uncalled_in_program(system, call.place) is not None:
        return True
    return workspace.package_of(call.file) is None and is_dead(workspace, program, call)


class _Cure(StringEnum):
    """What there is to do about a wait."""

    MAKE_EARLIER = "make the client earlier"
    SUBSCRIBE = "subscribe"
    ASK = "ask whether the server is ready"
    PASS_ON = "pass a limit on"
    LIMIT = "set a limit"


def _limitless_wait(system: System, program: Program, call: ApiCall, client: Creation | None) -> Finding:
    """``client`` is the one that the line waits for the server of, where there are no others."""
    function = call.api.rpartition(".")[2]
    several = call.api != WAIT_FOR_MESSAGE and is_for_each_client(source_code(system), call)
    awaited = "a message" if call.api == WAIT_FOR_MESSAGE else server_words(system, client, kind_of(call))
    if several:
        awaited = f"{kind_of(call)} after {kind_of(call)}"
    cure = _cure(system, call)
    diagnostic = finding(
        "TMO001",
        call.place,
        f"{function}() waits for {awaited} without a timeout: if it never comes, nothing after this line runs",
        help=_help_for_wait(cure, call, function),
        related=related_path(call, client if call.api != WAIT_FOR_MESSAGE else None),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )
    group: tuple[str, ...] = (call.file, class_around(call.function), cure, function)
    severity = diagnostic.severity
    if _is_minor(system, program, call):
        severity, group = Severity.INFO, (*package_around(system.workspace, call.file), _MINOR)
    # Whoever waits in a callback had better not wait at all.
    return replace(
        diagnostic,
        sites=None
        if runs_in_executor(call.context)
        else sites_of_wait(system.workspace, call.place, "" if several else name_of(client)),
        severity=severity,
        group=group,
    )


@folds("TMO001")
def of_one_owner(findings: Sequence[Finding]) -> Finding:
    """The finding for all such waits of a class or function with which the same is to be done; for all of a package
    that only whoever starts the program waits for."""
    if findings[0].group[-1] == _MINOR:
        return of_one_package(findings, "wait", "it waits without a timeout here, too")
    return of_one_class(findings, "wait", "it waits without a timeout here, too")


def _is_minor(system: System, program: Program, call: ApiCall) -> bool:
    """Whether whoever runs the program sees that it waits, and nothing else of it does."""
    workspace = system.workspace
    if workspace is not None and workspace.package_of(call.file) and is_not_installed(workspace, call.file):
        return True
    if (
        is_uncalled(call)
        or _is_step_of_script(call)
        or _is_start(system, call)
        or is_documented_start(system, call)
        or is_start_in_order(program, call)
        or is_step_of_asking_script(system, program, call)
    ):
        return True
    if not runs_in_executor(call.context) and is_example(call.file):
        return True
    node = call.node or call.context.node
    if node is None or call.context.role not in (Role.MAIN, Role.INIT) or is_launched(system.workspace, node):
        return False
    return is_driven_by_hand(source_code(system), program, node)


def _is_command(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a wait is of a program that somebody starts in a terminal to ask one thing: without the server there is
    nothing that it could do, and Ctrl-C ends it."""
    node = call.node or call.context.node
    if call.context.role not in (Role.MAIN, Role.INIT) or (node is not None and is_launched(system.workspace, node)):
        return False
    return is_command(source_code(system), call.file) or asks_once(system, program, call)


def is_uncalled(call: ApiCall) -> bool:
    """Whether a call is in a function that nothing here calls: whoever does may be anywhere, or nobody."""
    return call.context.role == Role.METHOD


def _is_step_of_script(call: ApiCall) -> bool:
    """Whether a program waits for a server on its own way, not in a node's constructor: it has nothing else to do yet,
    and whoever runs it sees that it waits."""
    functions = (call.function, *(hop.caller for hop in call.chain))
    in_constructor = any(name.rpartition(".")[2] == "__init__" for name in functions)
    return call.context.role in (Role.MAIN, Role.MODULE) and call.api != WAIT_FOR_MESSAGE and not in_constructor


def _cure(system: System, call: ApiCall) -> _Cure:
    """A callback does not wait, or everything else of its node waits with it; one that starts it all comes but once."""
    if not runs_in_executor(call.context) or (_is_start(system, call) and not made_here(call)):
        return _Cure.PASS_ON if is_at_its_default(call) else _Cure.LIMIT
    if made_here(call):
        return _Cure.MAKE_EARLIER
    return _Cure.SUBSCRIBE if call.api == WAIT_FOR_MESSAGE else _Cure.ASK


def _help_for_wait(cure: _Cure, call: ApiCall, function: str) -> str:
    match cure:
        case _Cure.MAKE_EARLIER:
            return MAKE_IT_EARLIER
        case _Cure.SUBSCRIBE:
            return "create a subscription, and continue in its callback"
        case _Cure.ASK:
            return f"check without waiting: if not ….{_ready(call)}():"
        case _Cure.PASS_ON:
            return passed_on(call)
    if call.api == WAIT_FOR_MESSAGE:
        return f"set a timeout and check the result: received, message = {function}(…, {_LIMIT[call.api]}=5.0)"
    return f"set a timeout and check the result: if not ….{function}({_LIMIT[call.api]}=5.0):"


def _ready(call: ApiCall) -> str:
    return "server_is_ready" if kind_of(call) == "action" else "service_is_ready"
