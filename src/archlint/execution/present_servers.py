"""Waits for a server that has to be there by then: it has just been found, it has answered, or ROS has named it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_before, certainly_true, paths_to
from archlint.analysis.reach import creations_of, judged_calls, waits_for_ever
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.wait_loops import end_of, only_the_server_ends
from archlint.finding import Place
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.parts import names_in
from archlint.syntax.walk import called_name, calls_in, given_to, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation
    from archlint.systems.model import System

_ASKS = frozenset(
    {
        "rclpy.client.Client.wait_for_service",
        "rclpy.client.Client.service_is_ready",
        "rclpy.action.client.ActionClient.wait_for_server",
        "rclpy.action.client.ActionClient.server_is_ready",
    }
)
_ADD_DONE_CALLBACK = "rclpy.task.Future.add_done_callback"
_LISTS = frozenset({"get_service_names_and_types", "get_service_names_and_types_by_node"})
"""Methods of a node that name the services which are there."""

_Clients = frozenset[Place]
"""Where the clients are created that a call is for."""


def is_there(system: System, call: ApiCall) -> bool:
    """Whether the server that a call waits for is there: a wait for it costs nothing, and a loop ends at once."""
    clients = creations_of(call.receiver)
    code = source_code(system)
    if not clients:
        return False
    if all(_has_a_listed_name(code, client) for client in clients):
        return True
    if any(client.context is call.context for client in clients):
        return False  # it has not found anybody yet
    return _has_answered(system, call) or all(_was_found(system, path, _places(call)) for path in paths_to(call))


def was_waited_for(system: System, call: ApiCall, clients: Sequence[Creation] | None = None) -> bool:
    """Whether the same code has waited for the same client's server before, on every way to a call, and until it came:
    a loop that waits again ends at once.  The client is the call's own, unless ``clients`` are given."""
    code = source_code(system)
    clients = creations_of(call.receiver) if clients is None else clients
    return len(clients) == 1 and any(
        other.context is call.context
        and other.place != call.place
        and until_it_comes(code, other)
        and always_comes_before(code, other, call)
        for other in _waits_for(system).get(id(clients[0]), ())
    )


def may_find_nobody(system: System, client: Place) -> bool:
    """Whether some code looks for a client's server and goes on without it: it is made for a server that is absent."""
    return client in _unsure(system)


def is_looked_for(system: System, client: Creation) -> bool:
    """Whether any code looks for a client's server, for a time or until it comes."""
    return client.place in _looked_for(system)


@once
def _looked_for(system: System) -> frozenset[Place]:
    calls = [call for call in system.calls if call.api in _ASKS]
    # A helper looks for each of several servers in one line.
    others = (client for call in calls for _, _, clients in call.call_chains for client in clients)
    return frozenset(creation.place for creation in chain(others, *(creations_of(call.receiver) for call in calls)))


@once
def _unsure(system: System) -> frozenset[Place]:
    """Where the clients are made whose servers some code looks for only once, or for a time."""
    code = source_code(system)
    calls = (call for call in system.calls if call.api in _ASKS and not until_it_comes(code, call))
    return frozenset(creation.place for call in calls for creation in creations_of(call.receiver))


@once
def _waits_for(system: System) -> dict[int, list[ApiCall]]:
    """The calls that wait for a server, by the client (``id``) that they are for alone."""
    waits: dict[int, list[ApiCall]] = {}
    for _, call in judged_calls(system):
        clients = creations_of(call.receiver)
        if call.api in _ASKS and len(clients) == 1:
            waits.setdefault(id(clients[0]), []).append(call)
    return waits


def until_it_comes(code: SourceCode, call: ApiCall) -> bool:
    """Whether the code goes on from a wait only where it has found the server."""
    loop = code.loop(call)
    if isinstance(loop, facts.While) and only_the_server_ends(loop):
        end = end_of(loop)
        return end is not None and call.place.span in end.spans and (len(end.spans) == 1 or not end.any_of_them)
    return call.api.endswith(_WAITS) and waits_for_ever(code, call, "timeout_sec", negative=False)


_WAITS = (".wait_for_service", ".wait_for_server")


def _places(call: ApiCall) -> _Clients:
    return frozenset(client.place for client in creations_of(call.receiver))


def _was_found(system: System, path: Sequence[Place], clients: _Clients) -> bool:
    """Whether the way to a call leads on only where the server of the same client has been found."""
    asked = _asked_at(system)
    true_calls = certainly_true(source_code(system), path)
    return any(asked.get(Place.of(file, call.span)) == {clients} for file, call in true_calls)


@once
def _asked_at(system: System) -> dict[Place, set[_Clients]]:
    """Whose servers each call looks for."""
    clients_at: dict[Place, set[_Clients]] = {}
    for _, call in judged_calls(system):
        if call.api in _ASKS and creations_of(call.receiver):
            clients_at.setdefault(call.place, set()).add(_places(call))
    return clients_at


def _has_answered(system: System, call: ApiCall) -> bool:
    """Whether a done callback asks for the server whose answer it has been called with."""
    given = _clients_of_answers(system).get(call.context.registered) if call.context.registered else None
    return call.context.role == Role.DONE and given == {_places(call)}


@once
def _clients_of_answers(system: System) -> dict[Place, set[_Clients]]:
    """The clients whose answers a callback is registered for, by the place where it is."""
    clients_at: dict[Place, set[_Clients]] = {}
    for _, call in judged_calls(system):
        if call.api == _ADD_DONE_CALLBACK:
            clients_at.setdefault(call.place, set()).add(_places(call))
    return clients_at


# ------------------------------------------------------------------------------------------------- names of ROS's own


def _has_a_listed_name(code: SourceCode, client: Creation) -> bool:
    """Whether a client's name is one of ``get_service_names_and_types()``, and not made of it."""
    created = code.call_at(client.place)
    body = code.body_at(client.place)
    name = None if created is None else given_to(created, "srv_name", 1)
    return name is not None and bool(name.variable) and _is_listed(name.variable, body, frozenset())


def _is_listed(name: str, body: Sequence[facts.Stmt], asked: frozenset[str]) -> bool:
    """Whether all that a variable is given in a function comes out of a list of the services that are there."""
    values = list(_values_of(name, body))
    return bool(values) and name not in asked and all(_lists(value, body, asked | {name}) for value in values)


def _values_of(name: str, body: Sequence[facts.Stmt]) -> Iterator[facts.Expr]:
    for statement in statements_of(body):
        match statement:
            case facts.Assign(targets=targets, value=value):
                if any(name in names_in(target) for target in targets if not target.attribute):
                    yield value
            case facts.For(target=target, iterable=value) if name in names_in(target):
                yield value


def _lists(value: facts.Expr, body: Sequence[facts.Stmt], asked: frozenset[str]) -> bool:
    """Whether an expression picks from such a list: it adds nothing of its own."""
    if any(isinstance(part, (facts.Binary, facts.FormatString)) for part in parts_of(value)):
        return False
    if any(called_name(call) in _LISTS for call in calls_in(value)):
        return True
    match value:
        case facts.Name(id=name):
            return _is_listed(name, body, asked)
        case facts.Subscript(value=inner):
            return _lists(inner, body, asked)
    return False


__all__ = ["is_looked_for", "is_there", "may_find_nobody", "until_it_comes", "was_waited_for"]
