"""What kinds of entities, callbacks, callback groups and executors there are."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind


class EntityKind(StringEnum):
    """What a create call makes, in the words of the graph's JSON."""

    PUBLISHER = "publisher"
    SUBSCRIBER = "subscriber"
    SERVICE = "service"
    CLIENT = "client"
    ACTION_SERVER = "action_server"
    ACTION_CLIENT = "action_client"
    TIMER = "timer"
    GUARD_CONDITION = "guard_condition"


NAMED: Mapping[EntityKind, ConnectionKind] = {
    EntityKind.PUBLISHER: "topic",
    EntityKind.SUBSCRIBER: "topic",
    EntityKind.SERVICE: "service",
    EntityKind.CLIENT: "service",
    EntityKind.ACTION_SERVER: "action",
    EntityKind.ACTION_CLIENT: "action",
}
"""What the name of an endpoint is a name of."""
ENDPOINT_KINDS = tuple(NAMED)
SERVER_OF: Mapping[EntityKind, EntityKind] = {
    EntityKind.CLIENT: EntityKind.SERVICE,
    EntityKind.ACTION_CLIENT: EntityKind.ACTION_SERVER,
}
"""What kind of server answers a client."""


class GroupKind(StringEnum):
    """What a callback group lets run at once."""

    DEFAULT = "default"
    """The node's own group, which is mutually exclusive."""
    MUTUALLY_EXCLUSIVE = "mutually_exclusive"
    REENTRANT = "reentrant"
    UNKNOWN = "unknown"


class Role(StringEnum):
    """What calls a function: an executor, a thread, or the program itself."""

    SUBSCRIPTION = "subscription"
    TIMER = "timer"
    SERVICE = "service"
    EXECUTE = "execute"
    """Of an action server, as the next three."""
    GOAL = "goal"
    CANCEL = "cancel"
    ACCEPTED = "accepted"
    FEEDBACK = "feedback"
    DONE = "done"
    """Of a future."""
    PARAMETER = "parameter"
    EVENT = "event"
    GUARD = "guard"
    TASK = "task"
    FILTER = "filter"
    LIFECYCLE = "lifecycle"
    THREAD = "thread"
    INIT = "init"
    MAIN = "main"
    MODULE = "module"
    METHOD = "method"
    """A method that nothing in the workspace calls."""
    LAUNCH = "launch"
    """A launch file."""


class ExecutorKind(StringEnum):
    """Which executor spins a node, in the words of the graph's JSON."""

    SINGLE_THREADED = "single_threaded"
    MULTI_THREADED = "multi_threaded"
    EVENTS = "events"
    NONE = "none"
    """Nothing spins it."""
    UNKNOWN = "unknown"
