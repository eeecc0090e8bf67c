"""Commands that a timer computes from what a subscription stored last, however long ago that was."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.own_methods import Method, methods_reached
from archlint.analysis.reach import calls_of, creations_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.sharing import COMMANDS
from archlint.finding import Place
from archlint.model import EntityKind, Role
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in, targets_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Callback, Creation
    from archlint.systems.model import System

_PUBLISH = "rclpy.publisher.Publisher.publish"
_OF_TIME = ("age", "alive", "clock", "deadline", "elapsed", "expire", "fresh", "heartbeat", "last_seen", "liveliness")
_ALSO_OF_TIME = ("monotonic", "now", "perf_counter", "recent", "stale", "stamp", "time", "timeout", "watchdog")
_EVENTS = frozenset(
    {
        "nav_msgs/msg/OccupancyGrid",
        "nav_msgs/msg/Path",
        "std_msgs/msg/Bool",
        "std_msgs/msg/Empty",
        "std_msgs/msg/String",
    }
)
_OF_EVENTS = frozenset(
    {
        "config",
        "enable",
        "enabled",
        "goal",
        "map",
        "mode",
        "path",
        "plan",
        "target",
        "trajectory",
        "waypoint",
        "waypoints",
    }
)
"""Types and words of topics whose messages count until the next one comes, however long that takes."""


@dataclass(frozen=True)
class UnagedInput:
    """What is published at ``call`` by the timer callback ``call.context`` comes of ``self.attribute``, which the
    callback of ``subscription`` sets at ``stored``."""

    call: ApiCall
    command: Creation
    attribute: str
    subscription: Creation
    stored: Place


def unaged_inputs(system: System) -> Iterator[UnagedInput]:
    """The first such input of each command that a timer publishes."""
    code = source_code(system)
    seen: set[tuple[Place, Place]] = set()
    for _, call in calls_of(system, (_PUBLISH,)):
        node, command = call.context.node, next(iter(creations_of(call.receiver)), None)
        if call.context.role != Role.TIMER or node is None or command is None or command.type not in COMMANDS:
            continue
        methods = _methods(code, call.context)
        if not methods or any(_is_about_time(method) for method in methods):
            continue
        read = {part.attribute for method in methods for part in everything_in(method.code.body) if method.is_own(part)}
        changed = {name for method in methods for name, _ in _stores(method)}
        row = _stored_by_subscription(code, node, read - changed)
        if row is not None and (call.context.place, command.place) not in seen:
            seen.add((call.context.place, command.place))
            yield UnagedInput(call, command, *row)


def _stored_by_subscription(
    code: SourceCode, node: Blueprint, attributes: set[str]
) -> tuple[str, Creation, Place] | None:
    """The first of some attributes that subscriptions alone set, and that none of them notes the time of."""
    for creation in node.creations:
        callback = creation.callbacks.get(Role.SUBSCRIPTION)
        if creation.kind != EntityKind.SUBSCRIBER or callback is None or _is_event(creation):
            continue
        methods = _methods(code, callback)
        if any(_is_about_time(method) for method in methods):
            continue
        for method in methods:
            for name, statement in _stores(method):
                if name in attributes and _comes_of_the_message(statement, method):
                    return name, creation, Place.of(callback.file, statement.span)
    return None


def _is_event(subscription: Creation) -> bool:
    words = (subscription.name.text or "").replace("/", "_").lower().split("_")
    return subscription.type in _EVENTS or not _OF_EVENTS.isdisjoint(words)


def _methods(code: SourceCode, callback: Callback) -> list[Method]:
    function, file = code.definition(callback), code.facts_at(callback.file)
    return [] if function is None or file is None else methods_reached(function, file)


def _is_about_time(method: Method) -> bool:
    """Whether a method has any word for the time, or for how old something is."""
    words = {word for name in names_in(method.code.body) for word in name.lower().strip("_").split("_")}
    return not words.isdisjoint((*_OF_TIME, *_ALSO_OF_TIME)) or not names_in(method.code.body).isdisjoint(_OF_TIME)


def _stores(method: Method) -> Iterator[tuple[str, facts.Assign]]:
    for statement in everything_in(method.code.body, facts.Assign):
        for target in (part for whole in statement.targets for part in targets_in(whole)):
            if method.is_own(target):
                yield target.last_name, statement


def _comes_of_the_message(statement: facts.Assign, method: Method) -> bool:
    message = method.code.params[-1].name if len(method.code.params) > 1 else ""
    return message in names_in(statement)


__all__ = ["UnagedInput", "unaged_inputs"]
