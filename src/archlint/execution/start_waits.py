"""What programs wait for at their start without a limit, and which of their own servers are not there until then."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain
from archlint.analysis.kept import once
from archlint.analysis.order import path_comes_before, paths_to
from archlint.analysis.reach import creations_of, judged_calls
from archlint.analysis.source_code import source_code
from archlint.execution.blocking import SPIN
from archlint.execution.present_servers import until_it_comes
from archlint.execution.spins import is_spun_in_sight
from archlint.execution.waits import waits
from archlint.model import SERVER_OF, EntityKind, Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Creation, Program
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_SERVERS = frozenset(SERVER_OF.values())
_AT_START = (Role.INIT, Role.MAIN, Role.MODULE)
_WAITS = ("rclpy.client.Client.wait_for_service", "rclpy.action.client.ActionClient.wait_for_server")


@dataclass(frozen=True)
class StartWait:
    """A wait that keeps a server from being there, or from answering, until another one is or does.

    ``for_response`` says that it is over when the other server has answered, and not as soon as that is there.
    """

    server: Endpoint
    comes_after: bool
    """Whether the server is made after the wait; else it is there by then, and nobody spins its node."""
    client: Endpoint
    call: ApiCall
    for_response: bool


@once
def start_waits(system: System) -> list[StartWait]:
    """The waits of all programs at their start, each with the servers that it keeps out."""
    ends = {id(end.creation): end for end in system.endpoints if end.resolved and not end.node.test}
    return [
        StartWait(server, comes_after, client, call, for_response)
        for program, call, asked, for_response in _endless(system)
        for client in [ends.get(id(asked))]
        if client is not None
        for creation, comes_after in _kept_out(system, program, call, for_response)
        for server in [ends.get(id(creation))]
        if server is not None and certain(server) and _is_only_one(system, server)
    ]


def _endless(system: System) -> Iterator[tuple[Program, ApiCall, Creation, bool]]:
    """The waits at the start of programs that nothing else ends, each with its client."""
    code = source_code(system)
    for program, call in judged_calls(system):
        clients = creations_of(call.receiver)
        if call.api in _WAITS and _is_at_start(program, call) and len(clients) == 1 and until_it_comes(code, call):
            yield program, call, clients[0], False
    for wait in waits(system):
        if wait.kind == SPIN and not wait.bounded and _is_at_start(wait.program, wait.call):
            yield wait.program, wait.call, wait.client, True


def _is_at_start(program: Program, call: ApiCall) -> bool:
    known = program.executable and not program.exhausted
    return known and call.context.role in _AT_START and not call.conditional and not call.in_try


def _kept_out(system: System, program: Program, call: ApiCall, for_response: bool) -> Iterator[tuple[Creation, bool]]:
    """The servers of a program that are made only after a wait, and those that do not answer before: a spin for a
    response serves what is there."""
    code = source_code(system)
    for node in program.nodes:
        if not _is_spun_afterwards(program, node):
            continue
        for creation in node.creations:
            if creation.kind not in _SERVERS or creation.context is not call.context:
                continue
            path = (*(frame.place for frame in creation.chain), creation.place)
            if all(path_comes_before(code, way, path) for way in paths_to(call)):
                yield creation, True
            elif not for_response:
                yield creation, False


def _is_spun_afterwards(program: Program, node: Blueprint) -> bool:
    """Whether it is known that no other thread spins a node."""
    return is_spun_in_sight(node) and not any(use.in_thread or use.astray for use in program.executors_of(node))


def _is_only_one(system: System, server: Endpoint) -> bool:
    """Whether no other node of the system has the same server."""
    connections = system.services if server.kind == EntityKind.SERVICE else system.actions
    connection = connections.get(server.name or "")
    return connection is not None and len(connection.providers) == 1


__all__ = ["StartWait", "start_waits"]
