"""Whether all that runs in a system is in sight."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight as followed
from archlint.launch.kinds import StartedKind

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


def is_complete(system: System) -> bool:
    """Whether the system is closed, all of it is in sight, and it is no part of another one."""
    if not system.closed or not in_sight(system):
        return False
    others = (
        [] if system.workspace is None else [other for other in system.workspace.systems if other.launched is not None]
    )
    if system.launched is None:
        return not others  # what runs is what the launch files start
    included = {i.reference.source for other in others if other.launched is not None for i in other.launched.included}
    return system.launched.file not in included


def in_sight(system: System) -> bool:
    """Whether the source of everything that runs is here, so that nobody unseen publishes, listens or serves: no
    node and no included launch file of another workspace, no plain process (``ros2 topic pub``, a simulator), no
    node that is passed to a library, no helper of a node that is not known, and no C++ that was not understood."""
    if _is_misread(system) or system.unowned or any(node.is_stranger or not _seen(node) for node in system.nodes):
        return False
    launched = system.launched
    if launched is None:
        return True
    processes = any(started.kind == StartedKind.PROCESS and not started.dormant for started in launched.started)
    elsewhere = any(include.reference.source is None and not include.dormant for include in launched.included)
    return not (processes or elsewhere or launched.gaps)


def _is_misread(system: System) -> bool:
    packages = frozenset[str | None]() if system.workspace is None else system.workspace.code.misread
    return bool(packages) and any(node.program and node.program.package in packages for node in system.nodes)


def _seen(node: Node) -> bool:
    """Whether a node's endpoints are those that its own code creates, and all of that code was followed: no base
    class from elsewhere, no library that is given the node."""
    if node.doubt is not None or (node.program is not None and node.program.exhausted):
        return False
    if not all(followed(blueprint) for blueprint in node.blueprints):
        return False
    return all(blueprint.just_rclpy for blueprint in node.blueprints)
