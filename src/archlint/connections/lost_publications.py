"""Messages that a publisher sends once, straight after it is created: before subscriptions have matched it."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight
from archlint.analysis.kept import once
from archlint.analysis.own_names import is_named_only
from archlint.analysis.reach import calls_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.straight_after import LOGS, follows_at_once
from archlint.finding import Place
from archlint.model import EntityKind, Role
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in, once_for

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_PUBLISH = "rclpy.publisher.Publisher.publish"
_AT_START = frozenset({Role.INIT, Role.MAIN, Role.MODULE})
_QUICK = LOGS | {"to_msg", "now", "get_clock", "get_name", "float", "int", "bool", "len", "round", "list", "dict"}


@dataclass(frozen=True)
class LostPublication:
    """The only message of a publisher, sent as soon as that is created."""

    call: ApiCall
    publisher: Creation
    program: Program


@once
def lost_publications(system: System) -> list[LostPublication]:
    """Such messages that volatile publishers send, in the order of the source."""
    lost, code = [], source_code(system)
    calls: dict[Place, list[tuple[Program, ApiCall, Creation]]] = defaultdict(list)
    for program, call in calls_of(system, (_PUBLISH,)):
        if call.creation is not None:
            calls[call.creation.place].append((program, call, call.creation))
    for place in sorted(calls):
        program, call, publisher = calls[place][0]
        same = all(other.place == call.place and _is_at_start(other) for _, other, _ in calls[place])
        if same and _is_volatile(publisher) and _is_lost(system, code, call, publisher):
            lost.append(LostPublication(call, publisher, program))
    return lost


def _is_at_start(call: ApiCall) -> bool:
    return call.context.role in _AT_START and not call.looped


def _is_volatile(publisher: Creation) -> bool:
    known = publisher.qos is not None and publisher.qos.durability == "volatile"
    return known and publisher.kind == EntityKind.PUBLISHER and in_sight(publisher.node)


def _is_lost(system: System, code: SourceCode, call: ApiCall, publisher: Creation) -> bool:
    """Whether the message follows at once, and nothing else can send one."""
    published = code.expression(call)
    name = published.func.value.dotted if published is not None and isinstance(published.func, facts.Attribute) else ""
    read = None if system.workspace is None else system.workspace.facts_at(call.place.file)
    if published is None or read is None or not name or not _is_used_here_alone(system, code, call, name):
        return False
    graph = graph_of(code.body(call))
    reads = graph.evaluating(published.span)
    file = call.place.file
    return follows_at_once(
        graph,
        reads,
        name,
        lambda value: Place.of(file, getattr(value, "span", published.span)) == publisher.place,
        _QUICK | _messages(read),
    )


def _is_used_here_alone(system: System, code: SourceCode, call: ApiCall, name: str) -> bool:
    """Whether the publisher is used for this message only: a variable of the function, or an attribute that nothing
    else names."""
    workspace, attribute = system.workspace, name.rpartition(".")[2]
    read = None if workspace is None else workspace.facts_at(call.place.file)
    if workspace is None or read is None:
        return False
    if attribute == name:
        body = code.body(call)
        return sum(part.variable == name for part in everything_in(body)) == 2 and body is not read.body
    return is_named_only(workspace, call.place.file, attribute, times=2)


@once_for
def _messages(read: facts.Facts) -> frozenset[str]:
    """The classes of messages that a file imports."""
    imports = (part for part in everything_in(read.body, facts.ImportFrom) if part.module.endswith(".msg"))
    return frozenset(name for part in imports for _, name in part.names)


__all__ = ["LostPublication", "lost_publications"]
