"""What of a system can be held against a running one: which nodes, and whether all that they have is known."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight as followed

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


def what_is_compared(system: System) -> str:
    """What a running system is held against, in words."""
    if system.launched is not None:
        given = " ".join(f"{name}:={value}" for name, value in sorted(system.launched.arguments.items()))
        return f"the system that {system.name} starts" + (f" with {given}" if given else "")
    return "all nodes of the workspace under their default names (without --launch it is not known which of them run)"


def place_of(node: Node) -> Place:
    """Where the source says that a node is to run: in the launch file, else where it is written."""
    if node.launch_place is not None:
        return node.launch_place
    assert node.blueprint is not None
    return node.blueprint.place


def is_complete_node(system: System, node: Node) -> bool:
    """Whether all that a node creates was seen, so that anything else is a difference."""
    if node.doubt is not None or node.unfollowed is not None or not node.blueprints:
        return False
    if node.program is not None and node.program.exhausted:
        return False
    return all(followed(blueprint) and blueprint.just_rclpy for blueprint in node.blueprints)
