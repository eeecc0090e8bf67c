"""Both ends of a coordinate frame: who sends transforms that it is in, and who looks some up."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.transforms import looked_up_transforms, sent_transforms
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.analysis.transforms import Transform
    from archlint.lookup.index import Index
    from archlint.place import Place


@dataclass(frozen=True, eq=False)
class FrameSummary:
    """``sent`` are the transforms of which the frame is the child, ``hanging`` those of which it is the parent,
    ``looked_up`` those that nodes ask for with it as their target or source."""

    name: str
    sent: tuple[Transform, ...]
    hanging: tuple[Transform, ...]
    looked_up: tuple[Transform, ...]


def frame_summary(index: Index, name: str) -> FrameSummary | None:
    """What is known of a frame; None where no code that is here names it."""
    sent, looked_up = _known(index)
    summary = FrameSummary(
        name,
        tuple(row for row in sent if row.child == name),
        tuple(row for row in sent if row.parent == name),
        tuple(row for row in looked_up if name in (row.parent, row.child)),
    )
    return summary if summary.sent or summary.hanging or summary.looked_up else None


def known_frames(index: Index) -> set[str]:
    """The names of all frames."""
    return {name for rows in _known(index) for row in rows for name in (row.parent, row.child) if name is not None}


@once
def _known(index: Index) -> tuple[Sequence[Transform], Sequence[Transform]]:
    """What is sent and what is looked up."""
    sent = ((row, rank) for system, rank in index.systems for row in sent_transforms(system))
    looked_up = ((row, rank) for system, rank in index.systems for row in looked_up_transforms(system))
    return _each_once(sent), _each_once(looked_up)


def _each_once(rows: Iterable[tuple[Transform, int]]) -> Sequence[Transform]:
    """Each transform of a node once, as the systems have it that count most for its place."""
    best: dict[Place, int] = {}
    every = list(rows)
    for row, rank in every:
        best[row.place] = min(rank, best.get(row.place, rank))
    unique: dict[tuple[object, ...], Transform] = {}
    for row, rank in every:
        if rank == best[row.place]:
            node = None if row.node is None else row.node.name
            unique.setdefault((row.place, node, row.parent, row.child), row)
    return [unique[key] for key in sorted(unique, key=lambda key: tuple(map(_sortable, key)))]


def _sortable(part: object) -> object:
    return part or "" if part is None or isinstance(part, str) else part


__all__ = ["FrameSummary", "frame_summary", "known_frames"]
