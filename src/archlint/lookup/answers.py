"""What editors are told: plain data, without a word of the protocol."""

from __future__ import annotations

from typing import Literal

from archlint.finding import Edit
from archlint.place import Place
from archlint.records import dataclass

CompletionKind = Literal["topic", "service", "action", "type", "parameter", "package", "executable", "node"]


@dataclass(frozen=True)
class Hover:
    """``text`` is Markdown; ``place`` is what it is about."""

    text: str
    place: Place


@dataclass(frozen=True)
class Completion:
    """One text to put in the place of what is typed so far (``replaces``).  ``detail`` is a short note beside it; a
    smaller ``rank`` comes first, and ``also`` are edits elsewhere that it needs: an import."""

    text: str
    kind: CompletionKind
    detail: str
    replaces: Place
    rank: int = 0
    also: tuple[Edit, ...] = ()


@dataclass(frozen=True)
class Link:
    """A place that leads to a place in a file of the workspace."""

    place: Place
    target: Place


@dataclass(frozen=True)
class Renamable:
    """A name that can be renamed: its place without quotes, and how it is written there."""

    place: Place
    text: str


@dataclass(frozen=True)
class Renamed:
    """All edits of a renaming, in the order of files and lines."""

    edits: tuple[Edit, ...]


@dataclass(frozen=True)
class Refused:
    """Why something is not renamed, in a sentence; ``place`` is what stands in the way."""

    reason: str
    place: Place | None = None


__all__ = ["Completion", "CompletionKind", "Edit", "Hover", "Link", "Refused", "Renamable", "Renamed"]
