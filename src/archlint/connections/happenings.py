"""Topics that say that something has happened: of such, several nodes may have one to report."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import creations_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.arbitration import WORDS
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

_PUBLISH = "rclpy.publisher.Publisher.publish"
_BOOL = "std_msgs/msg/Bool"
_STRING = "std_msgs/msg/String"
_SIGNALS = frozenset({_BOOL, "std_msgs/msg/Empty", _STRING})
"""Messages that carry a word at most."""
_HAPPENED = frozenset(
    {"alarm", "alarms", "alert", "alerts", "event", "events", "notification", "notifications"}
    | {"clicked", "completed", "detected", "done", "finished", "heard", "occurred", "pressed", "reached", "received"}
    | {"released", "requested", "tapped", "triggered"}
)


def are_events(system: System, publishers: Sequence[Endpoint]) -> bool:
    """Whether publishers of one topic signal events: its name says so, or it is a Bool; and no Bool takes one back with
    false, which makes it a state."""
    if any(end.type != _BOOL and (end.type not in _SIGNALS or not _is_event(end.name)) for end in publishers):
        return False
    said: dict[Place, list[bool]] = {}
    for call in system.calls:
        if call.api == _PUBLISH:
            for creation in creations_of(call.receiver):
                said.setdefault(creation.place, []).append(_only_true(source_code(system), call))
    flags = {end.place for end in publishers if end.type == _BOOL}
    return all(place in said and all(said[place]) for place in flags)


_REQUESTS = frozenset({"command", "commands", "cmd", "cmds", "queue", "request", "requests", "task", "tasks"})


def are_requests(connection: Connection) -> bool:
    """Whether what several say on a topic is asked of one node, one text at a time, or is by its name something to do
    once, such as to toggle: none takes back another."""
    words = connection.name.rpartition("/")[2].lower().split("_")
    asked = {id(end.node) for end in connection.users}
    named = _REQUESTS if connection.types == [_STRING] else _ONCE
    is_word = bool(connection.types) and WORDS.issuperset(connection.types)
    return is_word and len(asked) == 1 and not named.isdisjoint(words)


_ONCE = frozenset({"request", "requests", "reset", "toggle", "trigger"})
"""Words for what is to be done once for each message, whatever number or flag says what."""


def _is_event(topic: str | None) -> bool:
    return topic is not None and not _HAPPENED.isdisjoint(topic.rpartition("/")[2].lower().split("_"))


def _only_true(code: SourceCode, call: ApiCall) -> bool:
    """Whether a message of one field that is published is true, whichever way led there."""
    values = values_published(code, call)
    return bool(values) and all(value.is_true for value in values)


def values_published(code: SourceCode, call: ApiCall) -> list[facts.Expr]:
    """What the fields of the message that a call publishes are given, in the call or around it in its function."""
    given = code.arguments(call)
    if len(given) != 1:
        return []
    match given[0].value:
        case facts.Call(args=args):
            return [arg.value for arg in args if arg.keyword]
        case facts.Name(id=name):
            assigned = statements_of(code.body(call), facts.Assign)
            return [value for assignment in assigned for value in _values_of(assignment, name)]
    return []


def _values_of(statement: facts.Assign, name: str) -> list[facts.Expr]:
    """What a statement gives the field of the message that a variable holds."""
    fields = [target.attribute for target in statement.targets if target.dotted == f"{name}.{target.attribute}"]
    values = [statement.value] * len(fields)
    if isinstance(statement.value, facts.Call) and any(target.variable == name for target in statement.targets):
        values += [arg.value for arg in statement.value.args]
    return values
