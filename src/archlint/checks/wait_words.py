"""What is said of a wait for a server or a message: for whom it is, and how the code comes there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    argument,
    creations_of,
    endpoint_words,
    names_at,
    related_chain,
    related_creation,
)
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.waits import BLOCKING_CALLS
from archlint.finding import Related
from archlint.model import EntityKind, Role
from archlint.model.given import Constant, Future

if TYPE_CHECKING:
    from collections.abc import Iterable

    from archlint.analysis.reach import AskedKind
    from archlint.model import ApiCall, Callback, Creation
    from archlint.systems.model import System

WAIT_FOR_SERVICE = "rclpy.client.Client.wait_for_service"
WAIT_FOR_SERVER = "rclpy.action.client.ActionClient.wait_for_server"
WAIT_FOR_MESSAGE = "rclpy.wait_for_message.wait_for_message"
READY = ("rclpy.client.Client.service_is_ready", "rclpy.action.client.ActionClient.server_is_ready")
MAKE_IT_EARLIER = "create the client in the constructor, and check here without waiting whether its server is available"

_CALL, _SEND_GOAL = "call_async(…)", "send_goal_async(…)"
_OF_A_GOAL = frozenset({"cancel_goal_async", "get_result_async"})
"""Methods of the handle of a goal, without arguments."""
CONTINUE_WHEN_DONE = "send the request with call_async(), return, and continue in a done callback"
_ADD_CALLBACK = "{}.add_done_callback(…), return, and continue there"
_CONTINUE_WITH_FUTURE = "give the future a done callback with add_done_callback(…), return, and continue there"
_AWAIT = "make the execute callback async, and await {}: the goal continues with the response"


def when_done(callback: Callback, call: ApiCall, client: Creation | None, written: str = "") -> str:
    """How to get the answer that a call waits for without waiting.  An execute callback that returns has ended its
    goal; it holds no callback group, so that it may await.  ``written`` is the name of the future that it waits for."""
    of_no_request = client is None and _is_of_no_request(call)
    future = written if of_no_request else ""
    if callback.role == Role.EXECUTE:
        return _AWAIT.format(future or ("the future" if of_no_request else to_await(call, client)))
    if of_no_request:
        return _ADD_CALLBACK.format(future) if future else _CONTINUE_WITH_FUTURE
    sends = to_await(call, client)
    return CONTINUE_WHEN_DONE if sends == _CALL else _ADD_CALLBACK.format(sends)


def _is_of_no_request(call: ApiCall) -> bool:
    """Whether a call is given a future of which nothing shows that it is a request's: tf2's buffer makes some, too."""
    future = argument(call, "future")
    return future is not None and not any(isinstance(option, Future) for option in future.alternatives)


def to_await(call: ApiCall, client: Creation | None) -> str:
    """The call whose future has the answer that a call waits for, as it is written."""
    future = argument(call, "future") or call.receiver
    sent = {option.api for option in future.alternatives if isinstance(option, Future)} if future is not None else set()
    method = f"{call.api}_async" if call.api in BLOCKING_CALLS else sent.pop() if len(sent) == 1 else ""
    name = method.rpartition(".")[2]
    if name in _OF_A_GOAL:
        return f"{name}()"
    return _SEND_GOAL if client is not None and client.kind == EntityKind.ACTION_CLIENT else _CALL


def made_here(call: ApiCall) -> bool:
    """Whether the client is made by the same run of the callback: no server is found yet, however ready it is."""
    return any(
        creation.context is call.context or _made_in_function_of(call, creation)
        for creation in creations_of(call.receiver)
    )


def _made_in_function_of(call: ApiCall, creation: Creation) -> bool:
    """Whether the function around a call makes the client in front of it.  What led there first may have been another
    callback."""
    of_function = bool(call.function) and creation.function == call.function
    return of_function and creation.place.file == call.file and creation.place.span < call.place.span


def kind_of(call: ApiCall) -> AskedKind:
    return "action" if call.api.startswith("rclpy.action.") else "service"


def server_words(system: System, creation: Creation | None, kind: AskedKind = "service") -> str:
    """``the service 'enable_motor'``; without a name where other runs of the same code ask under another one."""
    if creation is not None and len(names_at(system).get(creation.place, ())) > 1:
        return endpoint_words(None, "action" if creation.kind == EntityKind.ACTION_CLIENT else "service")
    return endpoint_words(creation, kind)


def asked_alone(call: ApiCall, calls: Iterable[ApiCall]) -> Creation | None:
    """The client that a call is made on; None where other ways to the same line, or others of some ``calls`` that
    stand there, make it on one of another name."""
    here = [call, *(other for other in calls if other.place == call.place)]
    names = {client.name.text for other in here for client in creations_of(other.receiver)}
    names |= {client.name.text for other in here for _, _, clients in other.call_chains for client in clients}
    return call.creation if call.creation is None or names <= {call.creation.name.text} else None


def passed_on(call: ApiCall) -> str:
    """What to do where the limit is an argument of the function around that its callers leave out."""
    function = call.function.rpartition(".")[2]
    return f"pass {function}() a timeout where it is called, or give the parameter a default other than None"


def name_of(creation: Creation | None) -> str:
    return "" if creation is None else creation.name.text or ""


def related_path(call: ApiCall, client: Creation | None) -> list[Related]:
    """The calls on the way from a callback; what leads there from ``main`` goes without saying, but for the
    call that leaves out a limit which this one passes on."""
    hops = list(related_chain(call))
    if not runs_in_executor(call.context):
        hops = hops[-1:] if is_at_its_default(call) else []
    return [*hops, *related_creation(client)]


def is_at_its_default(call: ApiCall) -> bool:
    """Whether the limit is an argument of the function around, at its default."""
    limits = (argument(call, name) for name in ("timeout_sec", "time_to_wait"))
    return any(isinstance(limit, Constant) and limit.origin_kind == "argument_default" for limit in limits)
