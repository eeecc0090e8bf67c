"""Ends that a name may have and that are not known: those of nodes without source, or without a known name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.lookup.index import PROVIDERS, Index
from archlint.lookup.instances import Instance, unknown_ends
from archlint.lookup.renamed_names import CannotRename
from archlint.lookup.words import code, where
from archlint.model import NAMED
from archlint.ros import names, well_known

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind


def refuse_known_elsewhere(kind: ConnectionKind, old: str) -> None:
    if kind == "topic" and any(topic.name == old for topic in well_known.TOPICS):
        raise CannotRename(f"{code(old)} has this name in every ROS 2 system: other tools know it by that")


def refuse_unknown_ends(index: Index, kind: ConnectionKind, old: str, types: set[str | None]) -> None:
    for end in unknown_ends(index):
        if NAMED[end.kind] != kind or end.node.test or (end.type is not None and types and end.type not in types):
            continue
        if end.name is None or names.pattern_matches(end.name, old):
            words = f"the name of the {end.kind.replace('_', ' ')} at {where(end.place)} is not known"
            raise CannotRename(f"{words}: it may be {code(old)}", end.place)


def refuse_open_side(index: Index, old: str, ends: Sequence[Instance]) -> None:
    """A node whose source is not here has the name, or one side alone is known and such a node may be the other."""
    for row in ends:
        if row.end is not None and row.end.external:
            words = (
                f"{code(row.end.node.name or 'a node')}, whose source is not in this workspace, calls it {code(old)}"
            )
            raise CannotRename(f"{words}: remap that in the launch file first", row.place)
    if len({row.end.kind in PROVIDERS for row in ends if row.end is not None}) > 1:
        return
    for system, _ in index.systems:
        is_there = any(row.end is not None and row.end.node in system.nodes for row in ends)
        for node in system.nodes if is_there else ():
            if node.is_stranger and node.launch_place is not None:
                name = code(node.name or node.executable or "a node")
                words = (
                    f"only one side of {code(old)} is in this workspace; {name}, whose source is not, may be the other"
                )
                raise CannotRename(words, node.launch_place)


__all__ = ["refuse_known_elsewhere", "refuse_open_side", "refuse_unknown_ends"]
