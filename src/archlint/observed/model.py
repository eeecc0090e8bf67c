"""What was observed, whichever file it comes from, and how it differs from the source."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Final, Literal

from archlint.model import EntityKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.ros.qos import Qos

Form = Literal["recording", "bag", "monitor"]
RECORDING: Final = "recording"
BAG: Final = "bag"
MONITOR: Final = "monitor"

Status = Literal["missing", "unexpected", "different"]
Subject = EntityKind | Literal["node", "topic", "parameter"]
"""What a difference is about: the end of a node, or something else."""
MISSING: Final = "missing"
UNEXPECTED: Final = "unexpected"
DIFFERENT: Final = "different"


@dataclass(frozen=True)
class SeenEnd:
    """A publisher, subscription, service, client or end of an action of a running node.

    ``kind`` is as of endpoints.  ``type`` and ``qos`` are None where the file does not say; a policy of ``qos``
    is None where the middleware did not.
    """

    kind: EntityKind
    name: str
    type: str | None
    qos: Qos | None = None


@dataclass(frozen=True)
class SeenParameter:
    """A parameter that a running node has declared; ``type`` is None where it is not set, or not known."""

    name: str
    type: str | None


@dataclass(frozen=True)
class SeenNode:
    """A running node under its full name; ``count`` is how many nodes have that name, ``place`` where in the file
    it stands.  ``parameters`` is None where they were not asked for."""

    name: str
    ends: tuple[SeenEnd, ...]
    place: Place
    count: int = 1
    parameters: tuple[SeenParameter, ...] | None = None


@dataclass(frozen=True)
class SeenTopic:
    """A topic of a bag, with the QoS that its publishers offered."""

    name: str
    type: str
    offered: tuple[Qos, ...]
    place: Place


@dataclass(frozen=True)
class Observed:
    """The content of one file.

    ``form`` is ``recording`` (of archlint's own recorder), ``bag`` (a rosbag2 ``metadata.yaml``: ``topics`` only) or
    ``monitor`` (a message with the graph).  ``kinds`` are the kinds of ends that the file would report: what is not
    among its ends of another kind may well be there.  ``settled`` is False where the discovery was still going on.
    """

    file: str
    form: Form
    digest: str
    """A hash of the file's content."""
    nodes: tuple[SeenNode, ...] = ()
    topics: tuple[SeenTopic, ...] = ()
    kinds: frozenset[EntityKind] = frozenset()
    settled: bool = True


@dataclass(frozen=True)
class Difference:
    """One thing in which the running system differs from the source.

    ``node`` is the full name of the node that it is about, ``name`` that of the entity (for a node, its own).
    ``place`` is in the source where something there is about it, else in the observed file.
    ``expected`` and ``observed`` are the two sides in words, empty where there is none.  Of a ``doubtful`` one no
    launch file says that it should be otherwise.
    """

    status: Status
    kind: Subject
    name: str
    node: str | None
    message: str
    help: str
    place: Place
    expected: str = ""
    observed: str = ""
    related: tuple[tuple[Place, str], ...] = ()
    seen: SeenNode | SeenEnd | None = None
    doubtful: bool = False


@dataclass(frozen=True)
class Comparison:
    """What came of holding a system against what was observed.

    ``with_what`` says in words what was compared.  ``nodes`` and ``ends`` count what both sides have;
    ``left_open`` are running nodes and ends (in words) that may well be what the source leaves open.
    """

    observed: Observed
    with_what: str
    differences: tuple[Difference, ...]
    nodes: int = 0
    ends: int = 0
    left_open: tuple[str, ...] = ()
    notes: tuple[str, ...] = field(default=())
