"""What launch files and parameter files set on the nodes of a launched system."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import declared_by, followed
from archlint.analysis.kept import once
from archlint.launch.named_files import Replacing, Rewriting, Written
from archlint.launch.parameter_sources import ParameterFileUse
from archlint.launch.started import Started
from archlint.systems.overrides import Setting, applied

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


def set_nodes(system: System) -> Iterator[tuple[Node, list[Setting]]]:
    """The nodes of a launched system whose source is here, with what is set on each.  One whose name ROS rejects never
    starts, and nothing is set on it."""
    workspace = system.workspace
    if system.launched is None or workspace is None:
        return
    for node in system.nodes:
        if node.started is not None and node.blueprint is not None and node.error is None:
            full = node.name if node.resolution in ("exact", "parameter") else None
            yield node, applied(node.started, full, workspace.parameters_of)


def node_meant(system: System, node: Node, setting: Setting, others: Sequence[Node]) -> Node:
    """The node of a process that a value is for, where it reaches several of them: the one that declares most, and not
    a helper that asks something.  What the launch file sets reaches all, a section of a file those of one name."""
    reached = [other for other in others if setting.written is None or other.name == node.name]
    mine = [node, *(other for other in reached if other.blueprint is not None)]
    order = [id(entry) for entry in system.entries]
    return min(mine, key=lambda row: (-len(declared_by(row) or ()), order.index(id(row))))


def others_are_not_run(workspace: WorkspaceIndex) -> bool:
    """Whether only one of several launch files was asked for: the others may load the same files."""
    return workspace.explicit and len(workspace.launch_files.all()) > 1


@once
def files_of(system: System) -> list[str]:
    """The parameter files that a launched system loads."""
    files: dict[str, None] = {}
    for started in system.launched.started if system.launched is not None else ():
        files.update(dict.fromkeys(files_of_process(started)))
    return list(files)


@once
def systems_that_load(workspace: WorkspaceIndex) -> dict[str, list[System]]:
    """The launched systems that load each parameter file."""
    systems: dict[str, list[System]] = {}
    for system in workspace.systems:
        for file in files_of(system):
            systems.setdefault(file, []).append(system)
    return systems


@once
def rewritten_files(workspace: WorkspaceIndex) -> frozenset[str | None]:
    """The parameter files of which a launch makes another one, in which the sections may have other keys."""
    return frozenset(
        use.reference.source
        for system in workspace.systems
        for started in (system.launched.started if system.launched is not None else ())
        for use in started.parameters
        if isinstance(use, ParameterFileUse) and not all(map(_keeps_keys, use.changes))
    )


def _keeps_keys(change: Rewriting | Replacing | Written) -> bool:
    """Whether nothing but values of parameters becomes another one."""
    return isinstance(change, Rewriting) and not change.keys and not change.root_key


def files_of_process(started: Started) -> list[str]:
    uses = [parameter for parameter in started.parameters if isinstance(parameter, ParameterFileUse)]
    return [use.reference.source for use in uses if use.reference.source is not None]


def declared_in(workspace: WorkspaceIndex, started: Started) -> set[str] | None:
    """The names that the nodes of an executable declare, without what its arguments change; None where that is not
    known."""
    wanted = started.package.text, started.executable.text
    nodes = [
        node
        for system in workspace.systems
        if system.launched is None
        for node in system.nodes
        if node.program is not None and (node.program.package, node.program.name) == wanted
    ]
    declared = [declared_by(node) for node in nodes]
    if not nodes or not all(map(followed, nodes)) or None in declared:
        return None
    return {name for names in declared for name in names or ()}
