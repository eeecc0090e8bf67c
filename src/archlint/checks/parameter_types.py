"""PRM002: parameters that are set to a value of another type than the declared one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.declarations import may_be_dynamic
from archlint.analysis.set_parameters import called, set_nodes
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.ros.parameter_types import ParameterType, type_of

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.systems.model import System


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
            given = type_of(setting.value)
            if len(rows) != 1 or given is None or rows[0].type in (None, given) or rows[0].dynamic:
                continue
            if rows[0].ignore_override or rows[0].conditional or rows[0].name.resolution != "exact":
                continue
            yield finding(
                "PRM002",
                setting.value_place or setting.place,
                f"parameter '{setting.name}' of {called(node)} is declared as {rows[0].type} and set to "
                f"{_shown(setting.value)}, of type {given}{_for_want_of_quotes(setting.unquoted)}",
                help=_write(setting.value, rows[0].type) if setting.unquoted is None else _IN_A_FILE,
                related=[Related(rows[0].place, "it is declared here")],
                node=node.name,
                identity=(node.name or "", setting.name),
            )


_IN_A_FILE = "set it in a parameter file, where quotes keep it a string"


def _for_want_of_quotes(text: str | None) -> str:
    return "" if text is None else f": launch passes '{text}' on without quotes"


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "…"


def _write(value: object, wanted: ParameterType | None) -> str:
    if wanted == "double" and isinstance(value, int):
        return f"write {float(value)}: rclpy does not convert an integer to a double"
    if wanted == "double_array" and isinstance(value, list):
        return "write each number with a decimal point: rclpy does not convert integers to doubles"
    if wanted == "string":
        return "put it in quotes, or in a launch file wrap it: ParameterValue(…, value_type=str)"
    return f"set a value of type {wanted}: the node raises an exception when it declares the parameter"
