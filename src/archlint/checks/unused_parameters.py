"""PRM006: parameters that are declared and never read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import followed
from archlint.analysis.parameter_uses import is_named_again, is_named_elsewhere
from archlint.checks.parameter_reads import name_asked_for
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("PRM006", scope=Scope.CODE)
def unused_parameter(system: System, options: Options) -> Iterator[Finding]:
    """Parameters that are declared and never read."""
    if system.launched is not None or system.workspace is None:
        return
    for node in system.nodes:
        blueprint = node.blueprint
        if blueprint is None or node.program is None or blueprint.test or not followed(node):
            continue
        if any(callback.role == Role.PARAMETER for callback in node.program.callbacks):
            continue
        calls = [call for b in node.program.nodes for call in node.program.calls if call.node is b]
        reads = {name_asked_for(call) for call in calls if call.api.startswith("rclpy.node.Node.get_parameter")}
        if None in reads or any(call.api in ("rclpy.node.Node.get_parameters",) for call in calls):
            continue
        for declaration in blueprint.parameters:
            name = declaration.name.text
            if name is None or declaration.name.resolution != "exact" or name in reads:
                continue
            if declaration.place.file.endswith((".yaml", ".yml")):  # its code reads all of them into one object
                continue
            if is_named_again(system.workspace, declaration, name):
                continue
            if is_named_elsewhere(system.workspace, node, declaration, name):
                continue
            yield finding(
                "PRM006",
                declaration.place,
                f"parameter '{name}' is declared but never read",
                help="read it with get_parameter(), or remove the declaration",
                node=node.name,
                identity=(blueprint.class_name, name),
            )
