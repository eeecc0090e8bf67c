"""PRM002, PRM005 and PRM008: parameters that are declared and set, and how these fit together."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight
from archlint.analysis.cpp_nodes import names_cpp_node
from archlint.analysis.declarations import is_guarded, may_be_dynamic, surely_run_both
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.launch.kinds import FileStatus
from archlint.launch.model import ParameterFileUse, Started
from archlint.suggestions import did_you_mean, listed
from archlint.systems.overrides import Setting, applied, key_matches

if TYPE_CHECKING:
    from archlint.launch.model import Included
    from archlint.model import Blueprint, ParameterDeclaration
    from archlint.systems.model import Node, System, WorkspaceIndex

_ALWAYS = frozenset({"use_sim_time", "start_type_description_service"})
"""Parameters that rclpy declares for every node."""


def always_declared(name: str) -> bool:
    return name in _ALWAYS or name.startswith("qos_overrides.")


def declared_by(node: Node) -> dict[str, list[ParameterDeclaration]] | None:
    """The declarations of a node by name; None where not all of them can be known."""
    found: dict[str, list[ParameterDeclaration]] = {}
    for blueprint in node.blueprints:
        if blueprint.allow_undeclared_parameters or blueprint.automatically_declare_parameters:
            return None
        for declaration in blueprint.parameters:
            name = declaration.name
            if name.text is None or name.resolution not in ("exact", "parameter"):
                return None
            found.setdefault(name.text, []).append(declaration)
    return found


def followed(node: Node) -> bool:
    """Whether no code from elsewhere has the node, which may declare, read and set what it likes, and what is known
    of it fits what the launch file says."""
    return node.doubt is None and all(in_sight(blueprint) for blueprint in node.blueprints)


# ------------------------------------------------------------------------------------------------- PRM002


def _type_of(value: object) -> str | None:
    """The ROS type of a value of a launch or parameter file."""
    if isinstance(value, bool):
        return "bool"
    if isinstance(value, int):
        return "integer"
    if isinstance(value, float):
        return "double"
    if isinstance(value, str):
        return "string"
    if isinstance(value, list) and value:
        kinds = {_type_of(item) for item in value}
        kind = kinds.pop() if len(kinds) == 1 else None
        return None if kind is None or kind.endswith("_array") else f"{kind}_array"
    return None


@rule("PRM002", scope=Scope.SYSTEM)
def parameter_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Values from outside whose type is not the declared one."""
    for node, settings in set_nodes(system):
        if may_be_dynamic(system.workspace, node.parameters):
            continue
        declared: dict[str | None, list[ParameterDeclaration]] = {}
        for blueprint in node.blueprints:
            for declaration in blueprint.parameters:
                declared.setdefault(declaration.name.text, []).append(declaration)
        for setting in settings:
            rows = declared.get(setting.name, [])
            given = _type_of(setting.value)
            if len(rows) != 1 or given is None or rows[0].type in (None, given) or rows[0].dynamic:
                continue
            if rows[0].ignore_override or rows[0].conditional or rows[0].name.resolution != "exact":
                continue
            yield finding(
                "PRM002",
                setting.value_place or setting.place,
                f"parameter '{setting.name}' of {called(node)} is declared as {rows[0].type} and set to "
                f"{_shown(setting.value)}, of type {given}",
                help=_write(setting.value, rows[0].type),
                related=[Related(rows[0].place, "it is declared here")],
                node=node.name,
                identity=(node.name or "", setting.name),
            )


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "…"


def _write(value: object, wanted: str | None) -> str:
    if wanted == "double" and isinstance(value, int):
        return f"write {float(value)}: rclpy does not convert an integer to a double"
    if wanted == "double_array" and isinstance(value, list):
        return "write each number with a decimal point: rclpy does not convert integers to doubles"
    if wanted == "string":
        return "put it in quotes, or in a launch file wrap it: ParameterValue(…, value_type=str)"
    return f"set a value of type {wanted}: the node raises an exception when it declares the parameter"


def called(node: Node) -> str:
    """The name of a node, or its class where the name is not known."""
    return node.name or (node.blueprint.class_name if node.blueprint is not None else "the node")


def set_nodes(system: System) -> Iterator[tuple[Node, list[Setting]]]:
    """The nodes of a launched system whose source is here, with what is set on each."""
    workspace = system.workspace
    if system.launched is None or workspace is None:
        return
    for node in system.nodes:
        if node.started is not None and node.blueprint is not None:
            full = node.name if node.resolution in ("exact", "parameter") else None
            yield node, applied(node.started, full, workspace.parameters_of)


# ------------------------------------------------------------------------------------------------- PRM005


def others_are_not_run(workspace: WorkspaceIndex) -> bool:
    """Whether only one of several launch files was asked for: the others may load the same files."""
    return workspace.explicit and len(workspace.launch_files.all()) > 1


@rule("PRM005", scope=Scope.SYSTEM)
def parameters_for_unknown_node(system: System, options: Options) -> Iterator[Finding]:
    """Sections of parameter files for nodes that no launch file which loads them starts."""
    workspace = system.workspace
    if system.launched is None or workspace is None:
        return
    for file in files_of(system):
        started = _names_of_nodes(workspace, file)
        if started is None or _is_rewritten(workspace, file):
            continue
        keys = [one.key for one in workspace.parameters_of(file).sections if "*" not in one.key]
        for section in workspace.parameters_of(file).sections:
            if "*" in section.key or "$(" in section.key or any(key_matches(section.key, name) for name in started):
                continue
            last = section.key.rpartition("/")[2]
            right = sorted(name for name in started if name.rpartition("/")[2] == last)
            if right and all(any(key_matches(key, name) for key in keys) for name in right):
                continue  # each has a section of its own: this one is for a namespace that is not started now
            message = f"no launch file that loads this file starts a node '{section.key}'"
            help = f"nodes that load this file: {listed(sorted(started))}"
            if right:
                message += f"; did you mean '{right[0]}'?"
                help = f"the key must be the full name: write '{right[0]}:', or '/**/{last}:' for any namespace"
            elif others_are_not_run(workspace):
                continue
            else:
                meant = did_you_mean(section.key, started)
                if not meant and (_may_hold_more_nodes(workspace, file) or names_cpp_node(workspace, file, last)):
                    continue
                message += meant
            yield finding("PRM005", Place(file, *section.span), message, help=help, identity=(file, section.key))


def _is_rewritten(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a launch makes another file of this one, in which the keys may be others."""
    return any(
        isinstance(use, ParameterFileUse) and use.changes and use.reference.source == file
        for system in workspace.systems
        for started in (system.launched.started if system.launched is not None else ())
        for use in started.parameters
    )


def files_of(system: System) -> list[str]:
    files: dict[str, None] = {}
    for started in system.launched.started if system.launched is not None else ():
        files.update(dict.fromkeys(files_of_process(started)))
    return list(files)


def _may_hold_more_nodes(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a process gets the file whose source is not here, or whose nodes are in other hands: nav2's servers
    make the nodes of their costmaps."""
    return any(
        (node.external or not followed(node)) and node.started is not None and file in files_of_process(node.started)
        for system in workspace.systems
        for node in system.nodes
    )


def files_of_process(started: Started) -> list[str]:
    uses = [parameter for parameter in started.parameters if isinstance(parameter, ParameterFileUse)]
    return [use.reference.source for use in uses if use.reference.source is not None]


def _may_read(include: Included, file: str) -> bool:
    """Whether a launch file that is not here may load a parameter file of this workspace: it is of another package,
    so that it knows the file, or the folder that it lies in, from whoever includes it."""
    if include.handed is None or include.reference.status != FileStatus.EXTERNAL:
        return True
    name = posixpath.basename(file)
    return any(name in text or _is_folder(text) for text in include.handed)


def _is_folder(text: str) -> bool:
    return text.startswith("$(") and "." not in posixpath.basename(text)


def _names_of_nodes(workspace: WorkspaceIndex, file: str) -> set[str] | None:
    """The names of all nodes of the launches that load a file; None where one of them is not known."""
    found: set[str] = set()
    for system in workspace.systems:
        if system.launched is None or file not in files_of(system):
            continue
        if system.launched.gaps or any(started.dormant for started in system.launched.started):
            return None
        if any(i.reference.source is None and _may_read(i, file) for i in system.launched.included):
            return None
        for node in system.nodes:
            if node.name is None or node.resolution not in ("exact", "parameter"):
                return None
            found.add(node.name)
    return found or None


# ------------------------------------------------------------------------------------------------- PRM008


@rule("PRM008", scope=Scope.CODE)
def parameter_declared_twice(system: System, options: Options) -> Iterator[Finding]:
    """Parameters that one run of a node declares twice."""
    for node in system.nodes:
        for blueprint in node.blueprints:
            yield from _twice(system.workspace, node, blueprint)


def _twice(workspace: WorkspaceIndex | None, node: Node, blueprint: Blueprint) -> Iterator[Finding]:
    first: dict[str, ParameterDeclaration] = {}
    for declaration in blueprint.parameters:
        name = declaration.name.text
        if (
            name is None
            or declaration.name.resolution != "exact"
            or declaration.conditional
            or blueprint.caller_unknown
        ):
            continue
        before = first.setdefault(name, declaration)
        related: Iterable[Related] = ()
        if before is not declaration:
            if workspace is None or not surely_run_both(workspace, before, declaration):
                continue
            message = f"parameter '{name}' is declared twice: the second declaration raises an exception"
            related = [Related(before.place, "it is declared here first")]
        elif name == "use_sim_time" and not is_guarded(workspace, declaration):
            message = "rclpy declares 'use_sim_time' for every node: declaring it again raises an exception"
        else:
            continue
        yield finding(
            "PRM008",
            declaration.place,
            message,
            help="declare it once, or check has_parameter() first",
            related=list(related),
            node=node.name,
            identity=(blueprint.class_name, name),
        )
