"""PRM008: parameters that are declared twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.declarations import is_guarded, surely_run_both
from archlint.analysis.doubled_declarations import DoubledDeclaration, doubled_declarations
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.model import Blueprint, ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


@rule("PRM008", scope=Scope.CODE)
def parameter_declared_twice(system: System, options: Options) -> Iterator[Finding]:
    """Parameters that one run of a node declares twice."""
    for node in system.nodes:
        for blueprint in node.blueprints:
            yield from _twice(system.workspace, node, blueprint)
    for rows in () if system.workspace is None else doubled_declarations(system.workspace):
        yield _in_one_function(rows)


def _in_one_function(rows: Sequence[DoubledDeclaration]) -> Finding:
    row, *others = rows
    more = f"; so {'is another one' if len(others) == 1 else f'are {len(others)} more'}" if others else ""
    return finding(
        "PRM008",
        row.place,
        f"the parameter {row.name} is declared twice: the second declaration raises an exception{more}",
        help="declare it once, or check has_parameter() first",
        related=[
            Related(row.first, "it is declared here first"),
            *(Related(other.place, f"{other.name} is declared again here") for other in others),
        ],
        identity=(row.place.file, row.name),
    )


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
