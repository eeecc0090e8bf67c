"""Parameters that are declared with a type alone, and that nothing sets before they are read.

Source: ``Node.get_parameter`` of rclpy raises ParameterUninitializedException, and ``declare_parameter<T>(name)`` of
rclcpp throws UninitializedStaticallyTypedParameterException by itself, both since Galactic.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import declared_by, followed
from archlint.analysis.kept import once
from archlint.analysis.pinned import is_from_before_galactic
from archlint.launch_files.set_parameters import set_nodes
from archlint.launch_files.unloaded_parameter_files import parameter_files
from archlint.model import Role
from archlint.model.given import Constant
from archlint.place import Place
from archlint.records import dataclass
from archlint.systems.nodes import key_of
from archlint.systems.overrides import sets_all_that_is_set
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.model import Blueprint, ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


@dataclass(frozen=True)
class Unset:
    """A parameter without a value: ``place`` is where its node stops, ``launched`` where a launch file starts that."""

    node: Node
    name: str
    place: Place
    declared: Place
    launched: Place


@dataclass(frozen=True)
class _Launch:
    """One start of a node: where, and which parameters it is given; None where it may be given any."""

    place: Place
    given: frozenset[str] | None


def unset_parameters(system: System) -> Iterator[Unset]:
    """What a node reads of a parameter without a value, where launch files start it and none of them gives one."""
    workspace = system.workspace
    if workspace is None or is_from_before_galactic(workspace):
        return
    for node in system.nodes:
        declared = declared_by(node)
        if node.blueprint is None or declared is None or node.program is None or node.program.exhausted:
            continue
        if not node.blueprint.just_rclpy or not followed(node):
            continue
        rows = {name: row for name, (row, *others) in declared.items() if not others and _is_unset(row)}
        launches = _launches(workspace).get(key_of(node.blueprint), ()) if rows else ()
        for name, row in rows.items():
            if launches and all(launch.given is not None and name not in launch.given for launch in launches):
                stops = _stops_at(workspace, node, name, row)
                if stops is not None:
                    yield Unset(node, name, stops, row.place, launches[0].place)


def may_be_set(workspace: WorkspaceIndex, node: Blueprint, name: str) -> bool:
    """Whether a launch file that starts a node gives it a parameter, or may give it any, or a parameter file of the
    workspace has one of that name, whoever loads it."""
    launches = _launches(workspace).get(key_of(node), ())
    return name in _in_parameter_files(workspace) or any(
        launch.given is None or name in launch.given for launch in launches
    )


@once
def _in_parameter_files(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(
        entry.name for _, file in parameter_files(workspace) for section in file.sections for entry in section.entries
    )


def _is_unset(row: ParameterDeclaration) -> bool:
    """Whether a parameter has a type, and no value from the code."""
    has_type = row.without_default and row.type is not None and not row.dynamic
    return has_type and not row.given and not row.conditional and not row.uncalled


@once
def _launches(workspace: WorkspaceIndex) -> Mapping[object, list[_Launch]]:
    """The starts of each node class by launch files, with the default arguments of these."""
    launches: dict[object, list[_Launch]] = {}
    for system in workspace.systems:
        for node, settings in set_nodes(system):
            started = node.started
            if started is None or started.dormant:
                continue
            is_known = node.resolution in ("exact", "parameter") and sets_all_that_is_set(started)
            given = frozenset(setting.name for setting in settings) if is_known else None
            for blueprint in node.blueprints:
                launches.setdefault(key_of(blueprint), []).append(_Launch(started.place, given))
    return launches


def _stops_at(workspace: WorkspaceIndex, node: Node, name: str, row: ParameterDeclaration) -> Place | None:
    """Where the node stops for want of the value; None where it may not."""
    files = {row.place.file} | {frame.place.file for frame in row.chain}
    if is_cpp(row.place.file):
        line = workspace.tree.lines(row.place.file, row.place.line, row.place.end_line)
        has_type = "declare_parameter<" in "".join("".join(line).split())
        return row.place if has_type and not _mentioned(workspace, files, _CATCHES) else None
    assert node.program is not None
    for call in node.program.calls:
        if call.node is not node.blueprint or call.api != "rclpy.node.Node.get_parameter":
            continue
        value = call.arguments.get("name")
        if not isinstance(value, Constant) or value.value != name or value.parameters:
            continue
        depends = call.in_try or call.conditional or bool(call.branch_arms) or call.context.role == Role.METHOD
        if not depends and not _mentioned(workspace, files | {call.place.file}, _SETS):
            return call.place
    return None


_SETS = ("set_parameters", "set_parameters_atomically", "_parameter_overrides", "parameter_overrides")
_CATCHES = ("catch", "parameter_overrides")


def _mentioned(workspace: WorkspaceIndex, files: Collection[str], words: Collection[str]) -> bool:
    return any(workspace.code.mentions(file, word) for file in files for word in words)


__all__ = ["Unset", "may_be_set", "unset_parameters"]
