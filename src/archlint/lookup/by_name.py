"""What has a name: connections, nodes, coordinate frames and parameters, and which names there are."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.lookup.frames import frame_summary, known_frames
from archlint.lookup.index import Index
from archlint.lookup.mentions import Subject
from archlint.lookup.running_nodes import running_nodes
from archlint.lookup.summaries import NodeSummary, Summary, connection_summary, parameter_summary
from archlint.model import NAMED

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.systems.nodes import Node


def summaries(index: Index, name: str) -> list[Summary]:
    """All that has a name: topics, services and actions by their full names (the first slash may be missing) or else as
    the code writes them, nodes by their names or the names of their classes, coordinate frames and parameters by
    theirs."""
    full = name if name.startswith("/") else f"/{name}"
    connected = {key for key in _connected(index) if key[1] == full} or _written(index, name)
    answers: list[Summary] = [connection_summary(index, *key) for key in sorted(connected)]
    answers += [NodeSummary(node) for node in running_nodes(index) if name in _names_of(node) or node.name == full]
    frame = frame_summary(index, name)
    answers += [frame] if frame is not None else []
    parameters = sorted(s for s in index.subjects() if s.kind == "parameter" and s.name == name)
    return [*answers, *(parameter_summary(index, subject) for subject in parameters)]


def known_names(index: Index) -> list[str]:
    """All names that :func:`summaries` knows, sorted."""
    names = {name for _, name in _connected(index)}
    names.update(name for node in running_nodes(index) for name in (*_names_of(node), node.name or "") if name)
    return sorted(
        names | known_frames(index) | {subject.name for subject in index.subjects() if subject.kind == "parameter"}
    )


@once
def _connected(index: Index) -> Sequence[tuple[ConnectionKind, str]]:
    ends = (end for system, _ in index.systems for end in system.endpoints if end.resolved and not end.error)
    rows = dict.fromkeys((NAMED[end.kind], end.name) for end in ends if end.name is not None)
    return [(kind, name) for kind, name in rows if any(index.ends_of(Subject(kind, name)))]


def _written(index: Index, name: str) -> set[tuple[ConnectionKind, str]]:
    """The full names of what is created under a name."""
    known = set(_connected(index))
    ends = (end for system, _ in index.systems for end in system.endpoints if end.written == name)
    return known & {(NAMED[end.kind], end.name or "") for end in ends}


def _names_of(node: Node) -> Iterable[str]:
    """By what else a node is known."""
    return () if node.blueprint is None else (node.blueprint.class_name,)


__all__ = ["known_names", "summaries"]
