"""PRM004 and nodes whose source is not here: those of which all parameters are known all the same, and those that run
beside others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import always_declared
from archlint.checks.launched_names import is_given_by_launch
from archlint.checks.misspelt_parameters import MISSPELT, is_misspelt
from archlint.checks.registry import finding
from archlint.finding import Finding
from archlint.launch_files.misplaced_parameters import misplaced_values
from archlint.model import ExecutorKind
from archlint.ros.parameter_types import type_of
from archlint.suggestions import hint, listed_for, nearest

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting


_MAKES_A_NODE = frozenset({"moveit.planning.MoveItPy", "rclcpp.Node"})
"""Classes that make a node of C++ in the process, which declares parameters of its own."""


def has_unseen_nodes(node: Node) -> bool:
    """Whether the process of a node makes another one, in C++ or of a class from elsewhere that is given to the same
    executor: what the launch file sets reaches that one as well."""
    if node.program is None:
        return False
    beside = any(use.astray and use.kind != ExecutorKind.NONE for use in node.program.executors)
    return beside or any(call.api in _MAKES_A_NODE for call in node.program.calls)


def unknown_to_externals(system: System) -> Iterator[Finding]:
    """Values that such a node is given for parameters which it does not declare, and those of a controller manager's
    controllers, once for the workspace."""
    if system.launched is None and system.workspace is not None:
        yield from _misplaced_for_controllers(system.workspace)
    places = Counter(place for node in system.nodes for place in _places(node))
    processes = Counter(id(node.started) for node in system.nodes)
    for node in system.nodes:
        known = node.known
        if known is None or known.takes_any_parameter or not known.complete or processes[id(node.started)] > 1:
            continue
        if is_given_by_launch(node):
            continue  # ROS rejects its name: it never starts
        declared = {row.name.text for row in node.declared if row.name.text is not None}
        for setting in node.settings:
            name = setting.name
            if name in declared or always_declared(name) or setting.shared or is_misspelt(name):
                continue
            several = (setting.written is not None and "*" in setting.key) or places[setting.place] > 1
            if several or any(name.startswith(f"{row}.") for row in declared):
                continue  # what is for several nodes, each takes its part of
            given = {other.name for other in node.settings}
            yield _finding(node, setting, _always_declared_by(node) - given)


def _misplaced_for_controllers(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """Values for controllers of ros2_controllers that stand beside the map which they belong into."""
    for row in misplaced_values(workspace):
        above = row.meant.removesuffix(f".{row.name}")
        yield finding(
            "PRM004",
            row.place,
            f"{row.owner} declares no parameter '{row.name}', so this value has no effect; did you mean '{row.meant}'?",
            help=f"write it below '{above}:'",
            identity=(row.owner, row.name),
            group=("misplaced", row.place.file, row.owner, row.name),
            meant=row.meant,
        )


def _always_declared_by(node: Node) -> set[str]:
    """The names that a node declares in each distribution that it is read in, and without conditions."""
    return {row.name.text for row in node.declared if row.name.text is not None and not row.conditional}


def _places(node: Node) -> set[Place]:
    """Where something is set that is for this node: a line that stands for several is counted once for each."""
    given = [] if node.started is None else node.started.parameters
    return {setting.place for setting in node.settings} | {parameter.place for parameter in given}


def _finding(node: Node, setting: Setting, free: set[str]) -> Finding:
    name = setting.name
    read = sorted(dict.fromkeys(node.known.versions.values())) if node.known is not None else []
    of = f" (as read in {', '.join(read)})" if read else ""
    near = nearest(name, free)
    return finding(
        "PRM004",
        setting.place,
        f"{node.shown} declares no parameter '{name}'{of}, so this value has no effect{hint(near)}",
        help=_other_type(node, near, setting) or (f"it declares {listed_for(name, free)}" if free else "remove it"),
        node=node.name,
        identity=(node.name or "", name),
        group=(MISSPELT if near else f"{node.shown} declares none of", node.package or "", node.executable or ""),
        meant=near or "",
    )


def _other_type(node: Node, near: str | None, setting: Setting) -> str:
    """What to write where the value is of another type than the parameter that was meant; empty where it fits."""
    kinds = {row.type for row in node.declared if row.name.text == near}
    given = type_of(setting.value)
    if near is None or len(kinds) != 1 or None in kinds or given is None or given in kinds:
        return ""
    return f"write '{near}' with a value of its type, {kinds.pop()}: with this one, of the type {given}, the node stops"


__all__ = ["has_unseen_nodes", "unknown_to_externals"]
