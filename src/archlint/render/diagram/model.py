"""A picture as plain data.  Every text in it is visible and may be the user's: a format only has to escape it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Literal

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.finding import SeverityLabel
    from archlint.render.view import GroupBy

Key = tuple[str, str]
"""``(kind, name)`` of a shape, different for each."""
ShapeKind = Literal["node", "topic", "service", "action", "ends", "group"]
"""``ends`` are several topics, services or actions of the same nodes, or several nodes, in a list; a ``group`` is
collapsed."""
Tone = Literal[
    "node", "topic", "service", "action", "group", "wrong", "aside", "missing", "unexpected", "different", "note"
]
"""What a colour says."""
Stroke = Literal["solid", "dashed", "dotted"]


@dataclass(frozen=True)
class Badge:
    """The findings of one rule at one thing."""

    code: str
    severity: SeverityLabel
    messages: tuple[str, ...]

    @property
    def text(self) -> str:
        return self.code if len(self.messages) == 1 else f"{self.code} ×{len(self.messages)}"


@dataclass(frozen=True)
class Shape:
    """A node, what it talks over, or what stands for several of them."""

    key: Key
    kind: ShapeKind
    title: str
    lines: tuple[str, ...] = ()
    """What is said below the title: types, conditions, quality of service."""
    named: tuple[str, ...] = ()
    """What it is tied to without a line: ``→ /tf``, where very many nodes are, or where nobody else is."""
    remarks: tuple[str, ...] = ()
    """What is remarkable, such as that it is a hub."""
    badges: tuple[Badge, ...] = ()
    tone: Tone = "node"
    stroke: Stroke = "solid"
    details: tuple[str, ...] = ()
    """For whoever points at it."""
    matched: bool = True
    """Whether there is somebody at both ends; always of a node."""
    neighbour: bool = False
    helper: bool = False
    """Whether it only stands for a node that is not known."""
    groups: Mapping[GroupBy, str] = field(default_factory=dict)
    """By what nodes are grouped, and the group that this one is in."""
    holds: Mapping[str, int] = field(default_factory=dict)
    """How many of each kind it stands for, where these are several."""

    @property
    def label(self) -> tuple[str, ...]:
        """All that is written in it, badges aside."""
        return (self.title, *self.lines, *self.named, *self.remarks)


@dataclass(frozen=True)
class Line:
    """All ends that one node has at one interface in one direction, or several such lines.

    It runs with the data or the request.  ``broken`` says why nothing ever gets through, ``held_back`` what does not
    where something does.
    """

    tail: Key
    head: Key
    kind: ConnectionKind
    labels: tuple[str, ...] = ()
    broken: str = ""
    held_back: tuple[str, ...] = ()
    badges: tuple[Badge, ...] = ()
    tone: Tone = "topic"
    stroke: Stroke = "solid"
    directed: bool = True
    cycle: bool = False
    """Whether it is part of a circle of requests."""
    details: tuple[str, ...] = ()
    differs: bool = False
    """Whether a running system differs there; its tone says how."""

    @property
    def ends(self) -> tuple[Key, Key]:
        return self.tail, self.head


@dataclass(frozen=True)
class Diagram:
    """A picture.  ``groups`` has the title of the group that a shape is in, by its key."""

    shapes: Mapping[Key, Shape]
    lines: tuple[Line, ...]
    groups: Mapping[Key, str] = field(default_factory=dict)
    unframed: frozenset[str] = frozenset()
    """Groups that have no frame, which would tear the picture apart."""
    in_nodes: Mapping[str, int] = field(default_factory=dict)
    """How many of each kind have no shape and are named in nodes alone."""
    cut: Mapping[tuple[Key, Key, Key], str] = field(default_factory=dict)
    """From which node, over what, to which node nothing ever gets, and why."""
    caption: tuple[str, ...] = ()
    """What is to be said below the picture: counts, the pattern, what is left out, and what the marks mean."""

    @property
    def frames(self) -> dict[Key, str]:
        """The title of the frame that a shape is drawn in."""
        return {key: title for key, title in self.groups.items() if title not in self.unframed}


__all__ = ["Badge", "Diagram", "Key", "Line", "Shape", "ShapeKind", "Stroke", "Tone"]
