"""The communication graph as frozen objects: what ``archlint graph --format json`` writes, field by field."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import msgspec

from archlint.render.json import render
from archlint.systems.model import System

Value = bool | int | float | str | tuple[Any, ...] | None
"""What a parameter holds."""


class _Part(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, rename=lambda n: n.rstrip("_")):
    """A part of a graph; it cannot be changed, and two with the same content are equal."""


class QosProfile(_Part, frozen=True, kw_only=True):
    """The quality of service of an endpoint; what its code does not say is ``system_default``.  Times in seconds."""

    history: str | None
    depth: int | None
    reliability: str | None
    durability: str | None
    liveliness: str | None = "system_default"
    deadline_s: float | None = None
    lifespan_s: float | None = None
    lease_s: float | None = None


class Endpoint(_Part, frozen=True, kw_only=True):
    """One end of a topic, a service or an action, and the call that creates it.

    ``name`` is the final name, None where it is not known; ``written`` is what the code says.  ``resolution`` is
    ``exact``, ``parameter``, ``partial`` (``*`` stands for what only data decides) or ``unknown``.  ``callback`` is
    None for a publisher or a client.
    """

    name: str | None
    type: str | None
    qos: QosProfile | None
    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    written: str | None
    resolution: str
    parameter: str | None
    conditional: bool
    callback_group: str
    reason: str | None
    error: str | None
    callback: str | None = None


class Timer(_Part, frozen=True, kw_only=True):
    """A timer of a node; its period is in seconds, None where it is not known."""

    period_s: Value
    callback: str | None
    file: str
    line: int
    column: int
    parameter: str | None
    conditional: bool
    callback_group: str


class Parameter(_Part, frozen=True, kw_only=True):
    """A parameter that a node declares, or that is set on a node whose source is not here (``value``)."""

    name: str | None
    type: str | None
    default: Value
    file: str
    line: int
    column: int
    conditional: bool
    override: Value = None
    override_reason: str | None = None
    value: Value = None
    reason: str | None = None


class Remapping(_Part, frozen=True, kw_only=True):
    """A remapping that a launch file gives a node."""

    from_: str | None
    to: str | None


class KnownFrom(_Part, frozen=True, kw_only=True):
    """Where it is known from what a node has whose source is not in the workspace."""

    source: str
    versions: Mapping[str, str]
    """The version that was read, by distribution."""
    open: tuple[str, ...]
    """Why it may have more; empty where it does not."""


class Node(_Part, frozen=True, kw_only=True):
    """A node, or with ``is_node`` false what is created on a node that is not known."""

    name: str | None
    class_: str | None
    package: str | None
    executable: str | None
    executables: tuple[str, ...]
    file: str | None
    line: int | None
    is_node: bool
    lifecycle: bool
    executor: str | None
    launched_by: str | None
    external: bool
    known_from: KnownFrom | None
    condition: str | None
    remappings: tuple[Remapping, ...]
    test: bool
    complete: bool
    error: str | None
    publishers: tuple[Endpoint, ...]
    subscribers: tuple[Endpoint, ...]
    services: tuple[Endpoint, ...]
    clients: tuple[Endpoint, ...]
    action_servers: tuple[Endpoint, ...]
    action_clients: tuple[Endpoint, ...]
    timers: tuple[Timer, ...]
    parameters: tuple[Parameter, ...]
    overrides: tuple[str, ...]
    """The names of the parameters that a launch file sets."""


class Undelivered(_Part, frozen=True, kw_only=True):
    """Two ends of a topic between which quality of service lets no message through."""

    publisher: str | None
    subscriber: str | None
    reason: str


class Topic(_Part, frozen=True, kw_only=True):
    """A topic, with the names of the nodes at its ends; None stands for nodes whose name is not known."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[str | None, ...]
    subscribers: tuple[str | None, ...]
    undelivered: tuple[Undelivered, ...]


class Service(_Part, frozen=True, kw_only=True):
    """A service or an action, with the names of the nodes at its ends."""

    name: str
    types: tuple[str, ...]
    servers: tuple[str | None, ...]
    clients: tuple[str | None, ...]


class Unresolved(_Part, frozen=True, kw_only=True):
    """What could not be followed: an endpoint without a known name, a call, a launched node; and why."""

    kind: str
    file: str
    line: int
    column: int
    reason: str


class LaunchArgument(_Part, frozen=True, kw_only=True):
    """An argument that a launch file declares; ``default`` is None, too, where it is not known."""

    name: str
    required: bool
    default: str | None
    choices: tuple[str, ...]
    file: str
    line: int


class InterfaceField(_Part, frozen=True, kw_only=True):
    """A field of an interface; ``section`` is the part of a service or an action that it is in."""

    section: str
    name: str
    type: str
    default: Value
    line: int


class InterfaceConstant(_Part, frozen=True, kw_only=True):
    """A constant of an interface."""

    section: str
    name: str
    type: str
    value: Value
    line: int


class Interface(_Part, frozen=True, kw_only=True):
    """An interface that the workspace defines."""

    name: str
    file: str
    fields: tuple[InterfaceField, ...]
    constants: tuple[InterfaceConstant, ...]


class Graph(_Part, frozen=True, kw_only=True):
    """Who talks to whom.  ``system`` is the launch file, None for all nodes of a workspace."""

    version: int
    system: str | None
    nodes: tuple[Node, ...]
    topics: tuple[Topic, ...]
    services: tuple[Service, ...]
    actions: tuple[Service, ...]
    unresolved: tuple[Unresolved, ...]
    launch_arguments: tuple[LaunchArgument, ...]
    interfaces: tuple[Interface, ...]


def graph_of(system: System) -> Graph:
    """The graph of one system, such as one of :meth:`Workspace.systems`."""
    # Not with msgspec's own reader: the name of a file may hold what is no UTF-8.
    return msgspec.convert(json.loads(render(system)), Graph)
