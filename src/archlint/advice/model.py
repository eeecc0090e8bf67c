"""What is advised for one connection, and what shows how it is used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.place import Place


class Use(StringEnum):
    """What a connection is used as."""

    STREAM = "stream"
    """Data that is sent again and again, whether or not anything has happened."""
    COMMAND = "command"
    """Something is to be done, on an occasion; at most whether it worked comes back."""
    QUERY = "query"
    """Data is asked for, on an occasion or seldom."""
    TASK = "task"
    """What is asked for takes long."""
    UNKNOWN = "unknown"


@dataclass(frozen=True, order=True)
class Evidence:
    """What shows how a connection is used, and where that is written."""

    place: Place
    words: str


@dataclass(frozen=True)
class Judged:
    """How a connection is used, and what fits.

    ``fits`` is None where that cannot be known; ``reason`` says why it fits, or why nothing is known; ``instead`` says
    what to write where another kind would fit better.
    """

    use: Use
    fits: ConnectionKind | None
    reason: str
    instead: str = ""
    rate: float | None = None
    """How often a second, where that is known."""
    evidence: tuple[Evidence, ...] = ()


@dataclass(frozen=True)
class Advice:
    """How a topic, service or action is used in some systems: the names of launch files, or none for all nodes."""

    kind: ConnectionKind
    name: str
    types: tuple[str, ...]
    judged: Judged
    systems: tuple[str, ...] = ()

    @property
    def is_fitting(self) -> bool | None:
        """Whether the kind that it is fits; None where that cannot be known."""
        return None if self.judged.fits is None else self.judged.fits == self.kind


def unknown(reason: str, evidence: tuple[Evidence, ...] = ()) -> Judged:
    """A use that cannot be known."""
    return Judged(Use.UNKNOWN, None, reason, evidence=evidence)


__all__ = ["Advice", "Evidence", "Judged", "Use", "unknown"]
