"""A node of a system under its final name, what it has there, and who is connected."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

from archlint.model import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from archlint.architecture import ConnectionKind
    from archlint.branches import BranchArms
    from archlint.finding import Place
    from archlint.launch.started import Started
    from archlint.model import Blueprint, Creation, ExecutorKind, ParameterDeclaration, Program, Resolution
    from archlint.ros.qos import Qos
    from archlint.ros.remapping import RemapRule
    from archlint.systems.overrides import Setting
    from archlint.systems.resolution import FinalName, NodeName


@dataclass(frozen=True, eq=False)
class NamedCreation:
    """What a node creates, under its final name."""

    creation: Creation
    final: FinalName


@dataclass(frozen=True, eq=False)
class Endpoint:
    """A creation under its final name, with the node that it belongs to."""

    node: Node
    named: NamedCreation

    def __repr__(self) -> str:
        return f"<Endpoint {self.kind} {self.name} of {self.node.name}>"

    @property
    def creation(self) -> Creation:
        return self.named.creation

    @property
    def name(self) -> str | None:
        return self.named.final.name

    @property
    def error(self) -> str | None:
        return self.named.final.error

    @property
    def resolution(self) -> Resolution:
        return self.named.final.resolution

    @property
    def parameter(self) -> str | None:
        return self.named.final.parameter

    @property
    def reason(self) -> str | None:
        return self.named.final.reason

    @property
    def kind(self) -> EntityKind:
        return self.creation.kind

    @property
    def external(self) -> bool:
        """Whether its node is one whose source is not here."""
        return self.node.external

    @property
    def type(self) -> str | None:
        return self.creation.type

    @property
    def qos(self) -> Qos | None:
        return self.creation.qos

    @property
    def place(self) -> Place:
        return self.creation.place

    @property
    def conditional(self) -> bool:
        return self.creation.conditional

    @property
    def written(self) -> str | None:
        return self.creation.name.text

    @property
    def resolved(self) -> bool:
        """True for one known name, be it a parameter's default."""
        return self.named.final.resolved


@dataclass(frozen=True)
class KnownExternal:
    """Where it is known from what a node has whose source is not here."""

    source: str
    """The address of its source, or the file of the configuration."""
    versions: Mapping[str, str]
    """The version that was read, by distribution."""
    open: tuple[str, ...] = ()
    """Why it may have more than that; empty where it does not."""
    takes_any_parameter: bool = False
    conditional: bool = False
    """Whether its program makes it under a condition, such as a parameter."""
    name: str | None = None
    """The name that its source gives it, if a launch file can give it another one."""

    @property
    def complete(self) -> bool:
        """Whether it has nothing else."""
        return not self.open


@dataclass(frozen=True, eq=False)
class Node:
    """A node of a system.  ``name`` is its fully qualified name, None where unknown.

    The source of ``external`` nodes is not in this workspace, or ``unfollowed`` says why it was of no use: of these
    what the launch file says is known, and what comes from where ``known`` says.
    """

    name: str | None
    blueprint: Blueprint | None
    package: str | None
    executable: str | None
    executor: ExecutorKind
    launched_by: str | None = None
    external: bool = False
    unfollowed: str | None = None
    doubt: str | None = None
    """Why what was found of its code is perhaps not all: the launch file names much that is not in it."""
    creations: tuple[NamedCreation, ...] = ()
    """What it creates that has a name; :attr:`endpoints` are the same with the node itself."""
    alternatives: BranchArms = frozenset()
    """Branches of launch files that this node depends on (as ``Creation.branch_arms``)."""
    condition: str | None = None
    """What the launch file says of when it starts this node (``use_sim:=true``), where no argument decides that;
    None for always."""
    program: Program | None = None
    launch_place: Place | None = None
    overrides: Mapping[str, object] = field(default_factory=dict)
    settings: tuple[Setting, ...] = ()
    """The parameters that a launch file sets on an external node."""
    known: KnownExternal | None = None
    """Of an external node whose ends and parameters are known all the same."""
    declared: tuple[ParameterDeclaration, ...] = ()
    """The parameters of such a node."""
    resolution: Resolution = "exact"
    """How far ``name`` is known, as for endpoints; a ``partial`` name has holes."""
    error: str | None = None
    """Set where ROS rejects the node's name or namespace, in rmw's words."""
    executables: tuple[str, ...] = ()
    """All executables that start this node; ``executable`` is the first of them."""
    started: Started | None = None
    """What the launch file says of it."""
    own: NodeName | None = None
    """Its name and namespace apart, as far as they are known; None for a node whose source is not here."""
    rules: tuple[RemapRule, ...] = ()
    """The remap rules that its names meet, in rcl's order."""
    merged: tuple[Blueprint, ...] = ()
    """The same node as other executables make it; ``creations`` hold what these add."""

    def __repr__(self) -> str:
        return f"<Node {self.name}: {len(self.creations)} endpoints>"

    @property
    def shown(self) -> str:
        """What messages call it: its name, or what else is known of it."""
        if self.name is not None:
            return self.name
        if self.blueprint is not None:
            return self.blueprint.class_name
        given = None if self.started is None else self.started.name
        if given is not None and given.text is not None and given.resolution in ("exact", "parameter"):
            return f"the node '{given.text}'"
        return "a node" if self.package is None else f"a node of {self.package}"

    @cached_property
    def endpoints(self) -> tuple[Endpoint, ...]:
        """Made when they are asked for: a node and its endpoints refer to each other, and neither ever changes."""
        return tuple(Endpoint(self, named) for named in self.creations)

    @property
    def test(self) -> bool:
        return self.blueprint is not None and self.blueprint.test

    @property
    def is_node(self) -> bool:
        """False for what only stands for a node that is not known: a helper to which nothing here passes one."""
        return self.blueprint is None or not all(blueprint.caller_unknown for blueprint in self.blueprints)

    @property
    def is_stranger(self) -> bool:
        """Whether it may have ends that nothing tells of: its source is not here, nor is all of it known otherwise."""
        return self.external and (self.known is None or not self.known.complete)

    @property
    def domain(self) -> str | None:
        """The DDS domain that a launch file puts it in; None where it sets none."""
        return None if self.started is None else self.started.domain

    def of_kind(self, *kinds: EntityKind) -> Iterator[Endpoint]:
        return (endpoint for endpoint in self.endpoints if endpoint.kind in kinds)

    @property
    def blueprints(self) -> list[Blueprint]:
        return [] if self.blueprint is None else [self.blueprint, *self.merged]

    @property
    def timers(self) -> list[Creation]:
        """Each create call once, in source order."""
        timers = (c for b in self.blueprints for c in b.creations if c.kind == EntityKind.TIMER)
        return _once_for_each_place(timers)

    @property
    def parameters(self) -> list[ParameterDeclaration]:
        """Each declaration once, in source order; one call may declare several names."""
        return _once_for_each_place(p for b in self.blueprints for p in b.parameters)


@dataclass(frozen=True, eq=False)
class Connection:
    """All endpoints of one resolved topic, service or action name: ``providers`` are publishers or servers,
    ``users`` subscriptions or clients."""

    kind: ConnectionKind
    name: str
    providers: tuple[Endpoint, ...]
    users: tuple[Endpoint, ...]

    def __repr__(self) -> str:
        return f"<Connection {self.kind} {self.name}: {len(self.providers)} to {len(self.users)}>"

    @property
    def types(self) -> list[str]:
        return sorted({e.type for e in (*self.providers, *self.users) if e.type is not None})


def key_of(blueprint: Blueprint) -> object:
    return (blueprint.place, blueprint.class_name)


_Placed = TypeVar("_Placed", "Creation", "ParameterDeclaration")


def _once_for_each_place(items: Iterable[_Placed]) -> list[_Placed]:
    first: dict[tuple[Place, str, float], _Placed] = {}
    for item in items:
        first.setdefault((item.place, item.name.text or "", getattr(item, "period", None) or 0.0), item)
    return [first[key] for key in sorted(first)]
