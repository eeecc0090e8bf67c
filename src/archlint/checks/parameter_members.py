"""PRM010: the wrong member of a parameter's value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.parameter_members import EMPTY, WrongMember, wrong_members
from archlint.analysis.refused_values import raises_by_truth
from archlint.checks.folding import folds, with_others, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.set_parameters import set_nodes
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex


@rule("PRM010", scope=Scope.CODE, by_program=True, in_use=True)
def wrong_parameter_member(system: System, options: Options) -> Iterator[Finding]:
    """Members of a ParameterValue that a parameter's type does not set."""
    by_place: dict[tuple[Place, str], list[WrongMember]] = {}
    for read in wrong_members(system):
        by_place.setdefault((read.place, read.member), []).append(read)
    for read, *others in by_place.values():  # code that several parameters share
        rest = {row.name: row for row in others if row.name != read.name}.values()
        kind = read.type.replace("_", " ")
        article = "an" if kind[0] in "aeiou" else "a"
        effect = f"is always {EMPTY.get(read.member)} here" if not read.right else "throws an exception here"
        yield finding(
            "PRM010",
            read.place,
            f"'{read.member}' {effect}: the parameter '{read.name}' is {article} {kind}",
            help=_for_cpp(read) if read.right else _for_python(system, read),
            related=[
                Related(read.declared_at, "it is declared here"),
                *(Related(row.declared_at, f"it reads '{row.name}', too, which is declared here") for row in rest),
            ],
            node=read.node.name,
            identity=(read.name, read.member),
            group=(read.place.file, read.member, read.type, read.name),
        )


def _for_python(system: System, read: WrongMember) -> str:
    """Read the member of the type, or, where the default is what is wrong, declare the parameter with a double."""
    if read.member == "double_value" and isinstance(read.default, int):
        line = raises_by_truth(system.workspace, read.place)
        if line is not None and read.default:
            return (
                f"declare it with 0.0, which the code has so far: line {line} may raise an exception for {read.default}"
            )
        if _is_set_to_double(system, read):
            return f"declare it with {float(read.default)}: what is set from outside is a double, too"
    return f"read {read.type}_value, or get_parameter('{read.name}').value, which has the right type"


def _is_set_to_double(system: System, read: WrongMember) -> bool:
    """Whether a launch file or a parameter file sets the parameter to a double."""
    blueprint = read.node.blueprint
    if system.workspace is None or blueprint is None:
        return False
    return (key_of(blueprint), read.name) in _doubles(system.workspace)


@once
def _doubles(workspace: WorkspaceIndex) -> frozenset[tuple[object, str]]:
    """The parameters that something sets to a double, with the keys of their nodes."""
    return frozenset(
        (key_of(node.blueprint), setting.name)
        for system in workspace.systems
        for node, settings in set_nodes(system)
        for setting in settings
        if isinstance(setting.value, float) and node.blueprint is not None
    )


def _for_cpp(read: WrongMember) -> str:
    """Where the value is read in C++: as what it is, or what is read may be what is meant."""
    meant = _RETURNED.get(read.member.removesuffix("()"))
    return f"write {read.right}, or declare it with {meant}" if meant else f"write {read.right}"


_RETURNED = {
    **{"as_bool": "a bool", "as_double": "a double", "as_int": "an integer", "as_string": "a string"},
    **{"get_value<double>": "a double", "get_value<bool>": "a bool", "get_value<int>": "an integer"},
    "get_value<std::string>": "a string",
}


@folds("PRM010", common=3)
def _of_one_member(findings: Sequence[Finding]) -> Finding:
    """One finding for all lines of a file that read a member of parameters of another type."""
    name = findings[0].group[-1]
    same = [finding for finding in findings if finding.group[-1] == name]
    others = [finding for finding in findings if finding.group[-1] != name]
    first = with_places(same, "it is read here, too")
    rest = "it where their parameters do not set it, too"
    return with_others([first, *others], "another line reads", "more lines read", rest) if others else first


__all__ = ["wrong_parameter_member"]
