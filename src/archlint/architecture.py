"""The architecture that a team declares: who owns a name, which connections must or must not be, layers."""

from __future__ import annotations

from collections.abc import Mapping
from fnmatch import fnmatchcase
from typing import Final, Literal

from archlint.finding import Place
from archlint.records import dataclass

Globs = tuple[str, ...]

ContractKind = Literal["forbid", "require", "independent", "types", "qos"]
FORBID: Final = "forbid"
REQUIRE: Final = "require"
INDEPENDENT: Final = "independent"
TYPES: Final = "types"
QOS: Final = "qos"
KINDS: tuple[ContractKind, ...] = (FORBID, REQUIRE, INDEPENDENT, TYPES, QOS)

ConnectionKind = Literal["topic", "service", "action"]
TOPIC: Final = "topic"
SERVICE: Final = "service"
ACTION: Final = "action"
CONNECTIONS: tuple[ConnectionKind, ...] = (TOPIC, SERVICE, ACTION)

Policy = Literal[
    "history", "reliability", "durability", "liveliness", "depth", "deadline", "lifespan", "liveliness-lease"
]
POLICIES: Mapping[Policy, tuple[str, ...]] = {
    "history": ("keep_last", "keep_all"),
    "reliability": ("reliable", "best_effort"),
    "durability": ("volatile", "transient_local"),
    "liveliness": ("automatic", "manual_by_topic"),
}
"""The policies of a profile that are words, and the words that a contract may ask for."""
NUMBERS: tuple[Policy, ...] = ("depth", "deadline", "lifespan", "liveliness-lease")
"""The policies that are numbers: a count of messages, and durations in seconds."""

PACKAGE = "package:"


@dataclass(frozen=True)
class Contract:
    """One ``[[contracts]]`` entry.  Nodes and names are patterns as :func:`matches` reads them.

    ``forbid`` has ``source`` and ``target``, and may say over which ``names``; ``require`` these too, or
    ``names`` with ``provider`` or ``user`` (or both) or with ``through``; ``independent`` has ``nodes``, no two
    of which are connected; ``types`` has ``names`` and the types that they may have; ``qos`` has ``names``, the
    ``policies`` that their ends must have, and may say which ends.
    """

    name: str
    kind: ContractKind
    place: Place
    source: Globs = ()
    target: Globs = ()
    connection: ConnectionKind | None = None
    """What ``names`` are; None where the contract has none."""
    names: Globs = ()
    provider: Globs = ()
    """Who publishes or serves."""
    user: Globs = ()
    """Who subscribes or calls."""
    through: Globs = ()
    nodes: Globs = ()
    types: Globs = ()
    policies: tuple[tuple[Policy, tuple[str | float, ...]], ...] = ()
    """Each policy with the values that are allowed."""
    given: tuple[tuple[str, object], ...] = ()
    """The keys and values as they are written, ``name`` and ``kind`` first."""

    @property
    def patterns(self) -> Globs:
        """Every pattern for a node or a name that it has."""
        return (
            *self.source,
            *self.target,
            *self.names,
            *self.provider,
            *self.user,
            *self.through,
            *self.nodes,
        )

    def as_table(self) -> dict[str, object]:
        return dict(self.given)


@dataclass(frozen=True)
class Layers:
    """``[layers]``: the nodes of each layer, from top to bottom."""

    order: tuple[str, ...]
    members: Mapping[str, Globs]

    def of(self, node: str, package: str | None) -> list[int]:
        """The positions of the layers that a node is in."""
        return [at for at, layer in enumerate(self.order) if matches(self.members[layer], node, package)]


def matches(globs: Globs, name: str, package: str | None = None) -> bool:
    """Whether a node (of a package), or a topic, service or action, is meant.

    ``/left/motor`` is a full name, ``/left/*`` everything in a namespace, however deep; a pattern without a slash
    in front stands for the end of a name, in any namespace; ``package:NAME`` for the nodes of a package.
    """
    return any(
        package is not None and fnmatchcase(package, glob.removeprefix(PACKAGE))
        if glob.startswith(PACKAGE)
        else _names(glob, name)
        for glob in globs
    )


def _names(glob: str, name: str) -> bool:
    return fnmatchcase(name, glob) or (not glob.startswith("/") and fnmatchcase(name, f"*/{glob}"))


def any_node(globs: Globs) -> bool:
    """Whether patterns stand for no node in particular: one is enough then, where else each is meant."""
    return any(glob in ("*", "/*", "**", "/**") for glob in globs)
