"""Waits for the server of one client where another client is meant, for whose server nothing waits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_before
from archlint.analysis.reach import argument, creations_of, judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.finding import Place
from archlint.model import EntityKind, Role
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_WAITS = frozenset({"rclpy.client.Client.wait_for_service", "rclpy.action.client.ActionClient.wait_for_server"})
_ASKS = _WAITS | {"rclpy.client.Client.service_is_ready", "rclpy.action.client.ActionClient.server_is_ready"}
_SENDS = frozenset(
    {
        "rclpy.client.Client.call",
        "rclpy.client.Client.call_async",
        "rclpy.action.client.ActionClient.send_goal",
        "rclpy.action.client.ActionClient.send_goal_async",
    }
)
_CLIENTS = frozenset({EntityKind.CLIENT, EntityKind.ACTION_CLIENT})
_METHODS = frozenset({"wait_for_service", "wait_for_server", "service_is_ready", "server_is_ready"})
_OTHER_WAYS = frozenset(
    {"get_service_names_and_types", "get_service_names_and_types_by_node", "count_services", "get_node_names"}
    | {"get_node_names_and_namespaces", "wait_for_node"}
)
"""Methods of a node by which code may learn that a server is there without asking its client."""


@dataclass(frozen=True)
class MistakenWait:
    """A wait for the server of a client.  Nothing waits for that of ``meant``: ``then`` sends to it next, or, where
    that is None, ``before`` has waited for the same server already."""

    wait: ApiCall
    waited_for: Creation
    meant: Creation
    then: ApiCall | None = None
    before: ApiCall | None = None


@once
def mistaken_waits(system: System) -> list[MistakenWait]:
    """The waits for the wrong one of two clients of a node, one for each place."""
    calls: dict[Program, _Calls] = {}
    for program, call in judged_calls(system):
        if call.api in _ASKS or call.api in _SENDS:
            calls.setdefault(program, _Calls([], [])).add(call)
    first: dict[Place, MistakenWait] = {}
    for program, of_program in calls.items():
        if of_program.all_known and not _may_ask_otherwise(system, program, of_program):
            for mistaken in _of_program(system, of_program):
                first.setdefault(mistaken.wait.place, mistaken)
    return [first[place] for place in sorted(first)]


@dataclass(frozen=True)
class _Calls:
    """What a program asks its clients, and what it sends with them."""

    asks: list[ApiCall]
    sends: list[ApiCall]

    def add(self, call: ApiCall) -> None:
        (self.asks if call.api in _ASKS else self.sends).append(call)

    @property
    def all_known(self) -> bool:
        """Whether it is known of each question and each request which client it is of."""
        return all(creations_of(call.receiver) for call in (*self.asks, *self.sends))


def _may_ask_otherwise(system: System, program: Program, calls: _Calls) -> bool:
    """Whether the files of a program ask for servers where that was not followed, or in another way."""
    code, workspace = source_code(system), system.workspace
    if workspace is None:
        return True
    followed = {call.place for call in calls.asks}
    files = {program.file, *(call.file for call in (*calls.asks, *calls.sends))}
    files.update(creation.place.file for call in calls.sends for creation in creations_of(call.receiver))
    for file in sorted(files):
        file_facts = code.facts_at(file)
        for call in everything_in([] if file_facts is None else file_facts.body, facts.Call):
            name = call.func.last_name
            if name in _OTHER_WAYS or (name in _METHODS and Place.of(file, call.span) not in followed):
                return True
    return False


def _of_program(system: System, calls: _Calls) -> Iterator[MistakenWait]:
    asked = {id(creation) for call in calls.asks for creation in creations_of(call.receiver)}
    for wait in calls.asks:
        if wait.api in _WAITS and (client := _client_of(wait)) is not None:
            mistaken = _sends_to_another(system, calls, wait, client, asked)
            mistaken = mistaken or _waits_again(system, calls, wait, client, asked)
            if mistaken is not None:
                yield mistaken


def _client_of(call: ApiCall) -> Creation | None:
    """The one client that a call is of, where that is one for certain."""
    creations = creations_of(call.receiver)
    only = creations[0] if len(creations) == 1 else None
    return None if only is None or only.destroyed or only.name.resolution != "exact" else only


# ------------------------------------------------------------------------------------- the next request is another's


def _sends_to_another(
    system: System, calls: _Calls, wait: ApiCall, client: Creation, asked: set[int]
) -> MistakenWait | None:
    """``if not self.sensor.wait_for_service(…): return`` before ``self.motor.call_async(…)``: the function that waits
    sends nothing with the client that it waits for, and nothing asks whether the other's server is there."""
    code = source_code(system)
    sends = [call for call in calls.sends if _is_of_same_function(call, wait) and call.place > wait.place]
    if not sends or any(_is_used_from(call, wait, client) for call in calls.sends):
        return None
    for send in sends:
        other = _client_of(send)
        if other is None or id(other) in asked or other.kind != client.kind or other.node is not client.node:
            continue
        if always_comes_before(code, wait, send) and _are_apart(system, client, other):
            return MistakenWait(wait, client, other, then=send)
    return None


def _is_of_same_function(call: ApiCall, wait: ApiCall) -> bool:
    here = (call.context, call.file, call.function, call.chain)
    return here == (wait.context, wait.file, wait.function, wait.chain)


def _is_used_from(send: ApiCall, wait: ApiCall, client: Creation) -> bool:
    """Whether a request with the client that is waited for may follow the wait: in the same run of a callback, or in
    what it registers; what a program waits for at its start may follow any time."""
    if all(creation is not client for creation in creations_of(send.receiver)):
        return False
    if wait.context.role in (Role.INIT, Role.MAIN, Role.MODULE, Role.THREAD, Role.METHOD):
        return True
    return send.context is wait.context or send.context.role in (Role.DONE, Role.FEEDBACK, Role.THREAD, Role.TASK)


def _are_apart(system: System, client: Creation, other: Creation) -> bool:
    """Whether it is known who serves both, and no program serves the two of them: to have found the one then says
    nothing of the other."""
    first, second = (_servers_of(system, creation) for creation in (client, other))
    processes = {id(end.node.program) for end in first} & {id(end.node.program) for end in second}
    return bool(first and second) and not processes


def _servers_of(system: System, client: Creation) -> Sequence[Endpoint]:
    """The servers in the workspace of what a client asks for."""
    end = _ends(system).get(id(client))
    connections = system.services if client.kind == EntityKind.CLIENT else system.actions
    connection = None if end is None or end.name is None else connections.get(end.name)
    return () if connection is None else connection.providers


@once
def _ends(system: System) -> dict[int, Endpoint]:
    """The clients whose names are known, by the ``id`` of what was created."""
    return {id(end.creation): end for end in system.endpoints if end.kind in _CLIENTS and end.resolved}


# ------------------------------------------------------------------------------------------- the same wait once more


def _waits_again(
    system: System, calls: _Calls, wait: ApiCall, client: Creation, asked: set[int]
) -> MistakenWait | None:
    """The same statement about the same client a second time, next to the first one: a copy in which the client was to
    be another one."""
    code = source_code(system)
    before = next((call for call in calls.asks if _is_copied(code, call, wait, client)), None)
    if before is None or any(_is_between(send, before, wait, client) for send in calls.sends):
        return None
    others = [
        creation
        for creation in client.node.creations
        if creation.kind == client.kind and id(creation) not in asked and creation.name.resolution == "exact"
    ]
    if len(others) != 1 or others[0].destroyed or others[0].conditional:
        return None
    return MistakenWait(wait, client, others[0], before=before)


def _is_copied(code: SourceCode, first: ApiCall, wait: ApiCall, client: Creation) -> bool:
    same = first.api == wait.api and _is_of_same_function(first, wait) and first.place < wait.place
    if not same or _client_of(first) is not client or _limit(first) != _limit(wait):
        return False
    earlier, later = code.statement(first), code.statement(wait)
    if earlier is None or later is None or _shape(earlier) != _shape(later):
        return False
    blocks = [code.body(wait), *(block for inner in everything_in(code.body(wait)) for block in _blocks(inner))]
    return any(any(s is earlier for s in block) and any(s is later for s in block) for block in blocks)


def _blocks(part: facts.Base) -> Sequence[Sequence[facts.Stmt]]:
    return part.blocks if isinstance(part, (facts.If, facts.While, facts.For, facts.Try, facts.With)) else ()


def _shape(statement: facts.Stmt) -> list[type]:
    """What a statement is made of, whatever it says: its kind, and those of the statements in it."""
    return [type(statement), *(type(inner) for block in statement.blocks for inner in block)]


def _limit(wait: ApiCall) -> float | None:
    given = argument(wait, "timeout_sec")
    return None if given is None else given.seconds


def _is_between(send: ApiCall, before: ApiCall, wait: ApiCall, client: Creation) -> bool:
    """Whether something may be sent to the server between two waits for it."""
    return any(creation is client for creation in creations_of(send.receiver)) and (
        before.place < send.place < wait.place or bool(send.chain)
    )


def words_for_client(system: System, mistaken: MistakenWait) -> str:
    """The client that is meant, as the code calls it."""
    code = source_code(system)
    statement = code.statement_at(mistaken.meant.place)
    written = statement.targets[0].dotted if isinstance(statement, facts.Assign) else ""
    return written or "…"


__all__ = ["MistakenWait", "mistaken_waits", "words_for_client"]
