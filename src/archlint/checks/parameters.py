"""PRM002, PRM005 and PRM008: parameters that are declared and set, and how these fit together."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight
from archlint.analysis.declarations import is_guarded, may_be_dynamic, surely_run_both
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch.model import ParameterFileUse, Started
from archlint.systems.overrides import Setting, applied

if TYPE_CHECKING:
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


def others_are_not_run(workspace: WorkspaceIndex) -> bool:
    """Whether only one of several launch files was asked for: the others may load the same files."""
    return workspace.explicit and len(workspace.launch_files.all()) > 1


def files_of(system: System) -> list[str]:
    files: dict[str, None] = {}
    for started in system.launched.started if system.launched is not None else ():
        files.update(dict.fromkeys(files_of_process(started)))
    return list(files)


def files_of_process(started: Started) -> list[str]:
    uses = [parameter for parameter in started.parameters if isinstance(parameter, ParameterFileUse)]
    return [use.reference.source for use in uses if use.reference.source is not None]


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
