"""A graph as its JSON says it: what a comparison reads, be it saved in a file or made a moment ago."""

from __future__ import annotations

from typing import Any, Final, Literal

import msgspec

VERSION: Final = 1
"""Of the JSON of the graph."""

EndKind = Literal["publisher", "subscriber", "service", "client", "action_server", "action_client"]
Family = Literal["topic", "service", "action"]


class Kind(msgspec.Struct, frozen=True):
    """What there is to know of a kind of end."""

    family: Family
    provides: bool
    """Whether it offers what ends of the other kind use."""


KINDS: Final[dict[EndKind, Kind]] = {
    "publisher": Kind("topic", True),
    "subscriber": Kind("topic", False),
    "service": Kind("service", True),
    "client": Kind("service", False),
    "action_server": Kind("action", True),
    "action_client": Kind("action", False),
}


class End(msgspec.Struct, frozen=True):
    """An end of a topic, service or action; ``name`` is None where it is not known."""

    name: str | None
    type: str | None
    file: str
    line: int
    column: int
    written: str | None
    resolution: str
    parameter: str | None = None
    """The parameter that decides the name."""
    qos: dict[str, Any] | None = None
    conditional: bool = False
    callback: str | None = None
    error: str | None = None

    @property
    def is_known(self) -> bool:
        return self.name is not None and self.resolution in ("exact", "parameter") and self.error is None


class Parameter(msgspec.Struct, frozen=True):
    """A parameter that a node declares, or (with ``value``) that is set on a node whose source is not here."""

    name: str | None
    type: str | None
    default: Any
    file: str
    line: int
    override: Any = None
    """What a launch or parameter file sets."""
    override_reason: str | None = None
    value: Any = None


class Remapping(msgspec.Struct, frozen=True):
    source: str | None = msgspec.field(name="from")
    target: str | None = msgspec.field(name="to")


class Node(msgspec.Struct, frozen=True):
    name: str | None
    class_name: str | None = msgspec.field(name="class")
    package: str | None
    executable: str | None
    file: str | None
    line: int | None
    is_node: bool
    lifecycle: bool
    executor: str
    launched_by: str | None
    external: bool
    condition: str | None
    remappings: list[Remapping]
    test: bool
    complete: bool
    publishers: list[End]
    subscribers: list[End]
    services: list[End]
    clients: list[End]
    action_servers: list[End]
    action_clients: list[End]
    parameters: list[Parameter]
    overrides: list[str] | None = None
    """The parameters that launch and parameter files set, declared or not."""

    @property
    def shown(self) -> str:
        """How it is called, for people."""
        if self.name is not None:
            return self.name
        return f"{self.class_name} in {self.file}" if self.class_name else f"a node in {self.file}"

    def ends(self) -> list[tuple[EndKind, End]]:
        """All ends, with their kinds."""
        lists: list[tuple[EndKind, list[End]]] = [
            ("publisher", self.publishers),
            ("subscriber", self.subscribers),
            ("service", self.services),
            ("client", self.clients),
            ("action_server", self.action_servers),
            ("action_client", self.action_clients),
        ]
        return [(kind, end) for kind, ends in lists for end in ends]


class Field(msgspec.Struct, frozen=True):
    """A field of an interface, or a constant where it has a value."""

    section: str
    name: str
    type: str
    line: int
    default: Any = None
    value: Any = None


class Interface(msgspec.Struct, frozen=True):
    name: str
    file: str
    fields: list[Field]
    constants: list[Field]


class LaunchArgument(msgspec.Struct, frozen=True):
    """An argument of a launch file; ``default`` is a text, None where it is not known."""

    name: str
    required: bool
    default: str | None
    choices: list[str]
    file: str
    line: int


class Graph(msgspec.Struct, frozen=True):
    """One system.  ``system`` is its launch file, None for all nodes of a workspace."""

    version: int
    system: str | None
    nodes: list[Node]
    launch_arguments: list[LaunchArgument] | None = None
    interfaces: list[Interface] | None = None
    """Those that the workspace defines; None where the graph does not say (that of an older archlint)."""


class UnreadableGraph(Exception):
    """What cannot be taken for a graph; ``str()`` says why."""


def graph_of(document: object) -> Graph:
    """A graph from its plain data.  Raises :class:`UnreadableGraph`."""
    try:
        return msgspec.convert(document, Graph)
    except msgspec.ValidationError as error:
        raise UnreadableGraph(str(error)) from None


def read_graph(data: bytes) -> Graph:
    """A graph that was saved.  Raises :class:`UnreadableGraph`."""
    try:
        document = msgspec.json.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise UnreadableGraph(f"it is not JSON: {error}") from None
    version = document.get("version") if type(document) is dict else None
    if version is None or "nodes" not in document:
        raise UnreadableGraph("it is not what `archlint graph --format json` writes")
    if version != VERSION:
        raise UnreadableGraph(
            f"it has version {version} of the graph, and this archlint reads version {VERSION}: "
            "write it again with `archlint graph --format json`"
        )
    try:
        return graph_of(document)
    except UnreadableGraph as error:
        raise UnreadableGraph(
            f"an older archlint wrote it ({error}): write it again with `archlint graph --format json`"
        ) from None
