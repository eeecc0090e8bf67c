"""PRM002: parameters that are set to a value of another type than the declared one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.declarations import is_of_variable, may_be_dynamic
from archlint.analysis.pinned import is_from_before_galactic
from archlint.checks.folding import all_sites, folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.moveit_limits import mistyped_limits
from archlint.launch_files.plugin_parameters import Mistyped, mistyped_values
from archlint.launch_files.set_parameters import set_nodes
from archlint.launch_files.unloaded_parameter_files import has_no_reader, loaded_files
from archlint.ros.parameter_types import ParameterType, type_of
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting


@rule("PRM002", scope=Scope.SYSTEM)
def parameter_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Values from outside whose type is not the declared one."""
    workspace = system.workspace
    if system.launched is None and workspace is not None:
        for row in (*mistyped_values(workspace), *mistyped_limits(workspace)):
            yield _of_a_plugin(workspace, row)
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
            if given == "double" and rows[0].type == "integer" and is_of_variable(system.workspace, rows[0]):
                continue
            if is_from_before_galactic(system.workspace):
                if rows[0].type == "bool" and str(setting.value).lower() == "false":
                    yield replace(_of_another_type(node, setting, rows[0], given), help=_NOT_FALSE)
                continue
            template = _placeholder(setting)
            if template is None:
                yield _of_another_type(node, setting, rows[0], given)
            else:
                yield _not_filled_in(node, setting, template)


def _of_a_plugin(workspace: WorkspaceIndex, row: Mistyped) -> Finding:
    """What a plugin or node from elsewhere refuses: less certain to happen where nothing here loads the file."""
    file = row.place.file
    told = finding(
        "PRM002",
        row.place,
        f"{row.owner} declares '{row.name}' as {row.wanted}, and this sets {_shown(row.value)}, of type {row.given}",
        help=_help(row.value, row.wanted, "rclcpp"),
        identity=(row.owner, row.name),
        group=(file, row.wanted, row.given),
    )
    if file in loaded_files(workspace):
        return told
    return replace(told, severity=Severity.INFO if has_no_reader(workspace, file) else Severity.WARNING)


_NOT_FALSE = "set a bool: a text is true, whatever it says"
"""What is wrong before Galactic, where an override may be of any type and changes that of the parameter."""


def _of_another_type(node: Node, setting: Setting, declared: ParameterDeclaration, given: ParameterType) -> Finding:
    place = setting.value_place or setting.place
    return finding(
        "PRM002",
        place,
        f"parameter '{setting.name}' of {node.shown} is declared {_as(declared)} and set to "
        f"{_shown(setting.value)}, of type {given}{_for_want_of_quotes(setting.unquoted)}",
        help=_write(setting.value, declared) if setting.unquoted is None else _IN_A_FILE,
        related=[Related(declared.place, "it is declared here")],
        node=node.name,
        identity=(node.name or "", setting.name),
        group=(place.file, str(declared.type), given),
    )


_PLACEHOLDER = re.compile(r"__[A-Z][A-Z0-9_]*__|@[A-Z][A-Z0-9_]*@|<[A-Z][A-Z0-9_]*>|\$\{[A-Z][A-Z0-9_]*\}|\{\{.*\}\}")
"""How the templates of usual tools (sed, CMake, a shell, Jinja) write what is to be filled in."""


def _is_in_a_file(setting: Setting) -> bool:
    """Whether a value stands in a parameter file."""
    return setting.written is not None and setting.value_place is None


def _placeholder(setting: Setting) -> str | None:
    """The value of a parameter file that is nothing but a placeholder."""
    match setting.value:
        case str(text) if _is_in_a_file(setting) and _PLACEHOLDER.fullmatch(text.strip()):
            return text.strip()
    return None


def _not_filled_in(node: Node, setting: Setting, template: str) -> Finding:
    said = finding(
        "PRM002",
        setting.place,
        f"'{template}' is a placeholder, and a launch file loads this file as it is",
        help="load the file in which the placeholders are filled in",
        node=node.name,
        identity=(node.name or "", setting.name),
        group=(setting.place.file, "", ""),
    )
    return replace(said, severity=Severity.INFO)


@folds("PRM002", across_systems=True)
def _of_one_cause(several: Sequence[Finding]) -> Finding:
    """One finding for the values of a parameter file or launch file that are wrong in the same way."""
    first = several[0]
    others = {other.place: other for other in several if other.place != first.place}.values()
    related = (*first.related, *(Related(other.place, other.message) for other in others))
    if not others:
        return first
    _, wanted, given = first.group
    another = "another value is" if len(others) == 1 else f"{len(others)} more values are"
    placeholders = "one" if len(others) == 1 else "placeholders"
    rest = f"{another} {f'of type {given} instead of {wanted}' if wanted else placeholders}, too"
    return replace(first, message=f"{first.message}; {rest}", related=related, sites=all_sites(several))


_IN_A_FILE = "set it in a parameter file, where quotes keep it a string"


def _for_want_of_quotes(text: str | None) -> str:
    return "" if text is None else f": launch passes '{text}' on without quotes"


def _as(declared: ParameterDeclaration) -> str:
    if _is_of_nothing(declared):
        return "with an empty list, which rclpy takes for a byte_array,"
    return f"as {declared.type}"


def _is_of_nothing(declared: ParameterDeclaration) -> bool:
    """Whether its type is that of an empty list, and not written."""
    return declared.type == "byte_array" and not declared.without_default


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "…"


def _write(value: object, declared: ParameterDeclaration) -> str:
    if _is_of_nothing(declared) and (given := type_of(value)) is not None:
        return f"declare it with rclpy.Parameter.Type.{given.upper()} instead of a value"
    return _help(value, declared.type, "rclcpp" if is_cpp(declared.place.file) else "rclpy")


def _help(value: object, wanted: ParameterType | None, library: str) -> str:
    if wanted == "double" and isinstance(value, int):
        return f"write {float(value)}: {library} does not convert an integer to a double"
    if wanted == "double_array" and isinstance(value, list):
        return f"write each number with a decimal point: {library} does not convert integers to doubles"
    if wanted == "string" and isinstance(value, list):
        return f"write one text, without brackets: {library} takes no list for it"
    if wanted == "string":
        return "put it in quotes, or in a launch file wrap it: ParameterValue(…, value_type=str)"
    return f"set a value of type {wanted}: the node raises an exception when it declares the parameter"
