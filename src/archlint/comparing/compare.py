"""Two sides, each with its systems, and all that differs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from archlint.comparing.changes import Change, Spot, Status, in_order, risky, safe
from archlint.comparing.ends import EndChanges, Ends
from archlint.comparing.graphs import Graph, Node
from archlint.comparing.interfaces import interface_changes
from archlint.comparing.launches import argument_changes, remapping_changes
from archlint.comparing.nodes import node_added, node_changes, node_removed
from archlint.comparing.pairing import paired_nodes
from archlint.comparing.parameters import parameter_changes
from archlint.comparing.renamed import topics_renamed
from archlint.comparing.sketch import Sketch, sketch_of
from archlint.records import dataclass

_Class = tuple[str | None, str | None]
"""A package, and a class of it."""


@dataclass(frozen=True)
class Comparison:
    """What differs, the heaviest first; ``sketch`` is what a picture of it shows."""

    changes: tuple[Change, ...]
    sketch: Sketch


def compare(before: Sequence[Graph], after: Sequence[Graph]) -> Comparison:
    """Compare the systems of both sides, by their launch files.  Where each side has one, it is the same one."""
    old, new = {graph.system: graph for graph in before}, {graph.system: graph for graph in after}
    if len(before) == len(after) == 1:
        old = {after[0].system: before[0]}
    changes: list[Change] = []
    launched = _launched(before) & _launched(after)
    for system in sorted(dict.fromkeys((*old, *new)), key=lambda name: (name is None, name or "")):
        if system in old and system in new:
            differing = _systems(old[system], new[system], launched if system is None else frozenset())
            changes += [replace(change, systems=(system,)) for change in differing]
        elif system is not None:
            changes.append(_launch_file(system, system in new))
    ordered = in_order(changes)
    return Comparison(tuple(ordered), sketch_of(ordered, old, new))


def _launch_file(file: str, is_new: bool) -> Change:
    judgement = (
        safe("nothing that was there is touched") if is_new else risky("`ros2 launch` does not start it any more")
    )
    status = Status.ADDED if is_new else Status.REMOVED
    return Change(status, "launch_file", file, judgement, spot=Spot(file, 1, not is_new), systems=(file,))


def _launched(graphs: Sequence[Graph]) -> frozenset[_Class]:
    """The node classes that launch files start."""
    return frozenset(_class_of(node) for graph in graphs if graph.system is not None for node in graph.nodes)


def _class_of(node: Node) -> _Class:
    return node.package, node.class_name


def _systems(before: Graph, after: Graph, launched: frozenset[_Class]) -> list[Change]:
    """Of the ``launched`` nodes, other systems say under which names they run."""
    ends = EndChanges(Ends(before), Ends(after))
    pairs = paired_nodes(_judged(before), _judged(after))
    changes: list[Change] = []
    for node in pairs.removed:
        gone = [ends.removed(node, kind, end, with_node=True) for kind, end in node.ends() if end.is_known]
        changes += [node_removed(node, gone), *gone] if _counts(node) else gone
    for node in pairs.added:
        new = [ends.added(node, kind, end, with_node=True) for kind, end in node.ends() if end.is_known]
        changes += [node_added(node, new), *new] if _counts(node) else new
    for old, node in pairs.both:
        of_node = _of_node(old, node, ends)
        named_elsewhere = _class_of(node) in launched
        changes += [change for change in of_node if not (named_elsewhere and change.status == Status.RENAMED)]
    changes += [*argument_changes(before, after), *interface_changes(before, after)]
    return topics_renamed(changes, ends)


def _judged(graph: Graph) -> list[Node]:
    """Test code changes nothing of the architecture."""
    return [node for node in graph.nodes if not node.test]


def _counts(node: Node) -> bool:
    return node.is_node or node.name is not None


def _of_node(old: Node, new: Node, ends: EndChanges) -> Iterator[Change]:
    moved = list(ends.of_node(old, new))
    yield from node_changes(old, new)
    yield from moved
    yield from parameter_changes(old, new)
    yield from remapping_changes(old, new, any(change.status == Status.RENAMED for change in moved))
