"""What requests carry, what becomes of the answers, and how long the handler takes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain, coexist
from archlint.analysis.kept import once
from archlint.analysis.reach import argument
from archlint.connections.own_types import is_defined
from archlint.execution.certain_sleeps import certain_sleep
from archlint.execution.paces import only_end, runs_beside_itself
from archlint.execution.request_paces import calls_in
from archlint.execution.waits import waits
from archlint.model import Role
from archlint.model.given import Message
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.execution.request_paces import RequestPace
    from archlint.finding import Place
    from archlint.model import ApiCall, Callback, Creation, FieldUse, Program
    from archlint.ros.interfaces import MessageClass
    from archlint.syntax.interfaces import FieldType
    from archlint.systems.model import System

_WORDS = frozenset({"string", "wstring"})


def answer_fields(program: Program, client: Creation) -> list[FieldUse]:
    """Where a program reads the answers that a client gets, or those of which client is not known."""
    return [
        use
        for use in program.field_uses
        if use.type == client.type and use.section_name == "Response" and use.access == "read"
        if use.client is None or use.client.place == client.place
    ]


def sends_measures(call: ApiCall) -> bool:
    """Whether a request carries numbers that are not constant: a speed, a position."""
    request = argument(call, "request")
    return isinstance(request, Message) and request.content == "measures"


def tells_only_success(system: System, client: Creation) -> bool:
    """Whether the answers of a service say at most whether it worked, and in words why not."""
    answer = _fields(system, client, "Response")
    if answer is None:
        return False
    says_so = any(map(_is_truth, answer)) and all(_is_truth(kind) or kind.name in _WORDS for kind in answer)
    return not answer or says_so


def is_own(system: System, client: Creation) -> bool:
    """Whether the workspace defines the type of a service, so that its both ends can be changed."""
    return system.workspace is not None and client.type is not None and is_defined(system.workspace, client.type)


def is_command(system: System, client: Creation) -> bool:
    """Whether a service takes something, and answers at most whether it worked: ``SetBool``."""
    return bool(_fields(system, client, "Request")) and tells_only_success(system, client)


def _fields(system: System, client: Creation, section_name: MessageClass) -> list[FieldType] | None:
    """The types of the fields of a service's requests or responses; None where they are not known."""
    table = None if system.workspace is None else system.workspace.interfaces
    section = None if table is None or client.type is None else table.section(client.type, section_name)
    return None if section is None else [field.type for field in section.fields]


def _is_truth(kind: FieldType) -> bool:
    return kind.name in ("bool", "boolean") and not kind.array


# ------------------------------------------------------------------------------------------ too many requests


@dataclass(frozen=True)
class Overrun:
    """A handler that takes ``seconds`` each time for certain, which is longer than until the next request comes."""

    seconds: float
    place: Place


def overrun(system: System, call: ApiCall, pace: RequestPace) -> Overrun | None:
    """The handler that cannot keep up with requests, of which nobody waits for the answers."""
    handler = _only_handler(system, call.creation)
    if pace.seconds is None or handler is None or _waits_for(system, call):
        return None
    sleeps = [(certain_sleep(system, other), other.place) for other in calls_in(system, handler)]
    total = sum(seconds for seconds, _ in sleeps)
    longest = max(sleeps, default=None)
    return None if longest is None or total <= pace.seconds else Overrun(total, longest[1])


def _waits_for(system: System, call: ApiCall) -> bool:
    """Whether the callback that sends a request waits for answers of that service."""
    if not call.api.endswith(".call_async"):
        return True
    return (id(call.context), id(call.creation)) in _awaited(system)


@once
def _awaited(system: System) -> frozenset[tuple[int, int]]:
    """The callbacks (``id``) that wait for answers, each with the client (``id``)."""
    return frozenset((id(wait.call.context), id(wait.client)) for wait in waits(system))


def _only_handler(system: System, client: Creation | None) -> Callback | None:
    """The callback of the only server of a client, unless it runs beside itself."""
    end = only_end(system, client)
    if end is None or not certain(end):
        return None
    service = system.services.get(end.name or "")
    servers = () if service is None else service.providers
    if len(servers) != 1 or not certain(servers[0]) or not coexist(system, end, servers[0]):
        return None
    handlers = [callback for callback in servers[0].creation.callbacks.values() if callback.role == Role.SERVICE]
    return handlers[0] if len(handlers) == 1 and not runs_beside_itself(handlers[0]) else None


__all__ = [
    "Overrun",
    "answer_fields",
    "is_command",
    "is_own",
    "overrun",
    "sends_measures",
    "tells_only_success",
]
