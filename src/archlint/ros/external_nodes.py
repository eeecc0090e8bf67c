"""What well-known nodes offer that come with ROS and not with the workspace: robot_state_publisher, rviz2, Nav2 …

The table is what ``scripts/generate_external_nodes`` reads in their sources, one version of each distribution.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any, Literal

import msgspec

from archlint.ros.parameter_types import ParameterType
from archlint.ros.qos import Durability, History, Reliability

FILE = Path(__file__).with_suffix(".json")

EndKind = Literal["publisher", "subscriber", "service", "client", "action_server", "action_client"]
"""In the words of the graph's JSON."""


class ExternalQos(msgspec.Struct, frozen=True, omit_defaults=True):
    """A quality-of-service profile; None is what is not known of it."""

    history: History | None = None
    depth: int | None = None
    reliability: Reliability | None = None
    durability: Durability | None = None


class ExternalEnd(msgspec.Struct, frozen=True, omit_defaults=True, forbid_unknown_fields=True):
    """An end of a topic, service or action, its name as the node's source writes it."""

    kind: EndKind
    name: str
    type: str | None = None
    qos: ExternalQos | None = None
    parameter: str | None = None
    """The parameter that decides the name; what stands there is its default."""
    conditional: bool = False
    """Whether parameters or what happens at run time decide if there is one."""
    distros: tuple[str, ...] = ()
    """Empty: all that the node is of."""


class ExternalParameter(msgspec.Struct, frozen=True, omit_defaults=True, forbid_unknown_fields=True):
    """A parameter that a node declares."""

    name: str
    type: ParameterType | None = None
    default: Any = None
    """None where there is none, or it is not known."""
    conditional: bool = False
    distros: tuple[str, ...] = ()


class OpenQuestion(msgspec.Struct, frozen=True, omit_defaults=True):
    """Why a node may have more than is listed."""

    reason: str
    distros: tuple[str, ...] = ()
    parameter: str | None = None
    """The parameter that decides it: with its default there is nothing more."""


class ExternalNode(msgspec.Struct, frozen=True, omit_defaults=True, forbid_unknown_fields=True):
    """One node of one or more executables of a package, under the name that its source gives it."""

    package: str
    executables: tuple[str, ...]
    """Components among them go by the names of their classes."""
    name: str | None = None
    namespace: str = ""
    lifecycle: bool = False
    source: str = ""
    versions: Mapping[str, str] = {}
    """The version that was read, by distribution."""
    ends: tuple[ExternalEnd, ...] = ()
    parameters: tuple[ExternalParameter, ...] = ()
    open: tuple[OpenQuestion, ...] = ()
    """Empty where the node has nothing but what is listed."""
    takes_any_parameter: bool = False
    """Whether it takes parameters that are not listed."""
    own_name: bool = False
    """Whether arguments of its own give it its name, and a namespace below that of the process, so that a launch file
    cannot."""
    conditional: bool = False
    """Whether its program makes it under a condition, such as a parameter."""


class ExternalNodes(msgspec.Struct, frozen=True):
    """The table."""

    nodes: tuple[ExternalNode, ...]


Programs = Mapping[tuple[str, str], Sequence[ExternalNode]]
"""The nodes of each program, by its package and the name of the executable or component."""


def by_program(nodes: Sequence[ExternalNode]) -> Programs:
    """Nodes by what starts them."""
    programs: dict[tuple[str, str], list[ExternalNode]] = {}
    for node in nodes:
        for executable in node.executables:
            programs.setdefault((node.package, executable), []).append(node)
    return programs


@cache
def well_known() -> Programs:
    """Read the table, once."""
    return by_program(msgspec.json.decode(FILE.read_bytes(), type=ExternalNodes).nodes)
