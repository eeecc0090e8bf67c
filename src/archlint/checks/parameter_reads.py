"""PRM003: parameters that are read and never declared."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.cpp_parameter_reads import keeps_variable
from archlint.analysis.declared_parameters import always_declared, declared_by, followed
from archlint.analysis.parameter_uses import is_passed_on, names_listed
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.unset_parameters import UNSET, unset_parameter
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch_files.unset_parameters import unset_parameters
from archlint.model import Role
from archlint.model.given import Constant
from archlint.suggestions import did_you_mean, listed, meant

if TYPE_CHECKING:
    from archlint.model import ApiCall, ParameterDeclaration
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


@rule("PRM003", scope=Scope.CODE, by_program=True)
def undeclared_parameter(system: System, options: Options) -> Iterator[Finding]:
    """Parameters that are read and never declared."""
    for node in system.nodes:
        declared = declared_by(node)
        for call, name, place in undeclared_reads(system, node):
            keeps = _KEEPS if keeps_variable(system, call.place) else ""
            diagnostic = _undeclared(node, call, name, place, declared or {}, keeps)
            if keeps:
                diagnostic = replace(diagnostic, severity=Severity.WARNING, group=(*diagnostic.group, keeps))
            used = call.context.role != Role.METHOD  # what nothing calls raises nothing
            yield diagnostic if used else replace(diagnostic, severity=Severity.INFO)
    yield from map(unset_parameter, unset_parameters(system))


_KEEPS = "get_parameter() returns false, and the variable keeps its value whatever is set"
"""What becomes of a read in C++ that writes into a variable."""


def undeclared_reads(system: System, node: Node) -> Iterator[tuple[ApiCall, str, Place]]:
    """The reads of parameters that a node never declares, each with the name and where the code says it."""
    declared = declared_by(node)
    if node.blueprint is None or declared is None or node.program is None or node.program.exhausted:
        return
    if not node.blueprint.just_rclpy or not followed(node) or _is_of_gtest(system, node.blueprint.place):
        return
    calls = [call for call in node.program.calls if call.node is node.blueprint]
    guarded = {name_asked_for(call) for call in calls if call.api.endswith(".has_parameter")}
    for call in calls:
        for name, place in _reads(system, call):
            if not (always_declared(name) or name in declared or name in guarded or call.in_try):
                yield call, name, place


def _is_of_gtest(system: System, place: Place) -> bool:
    """Whether a node is made in a test of C++, which may well ask what a read does."""
    if place.file.endswith(".py") or system.workspace is None:
        return False
    return system.workspace.roles.is_test(place.file) or system.workspace.code.mentions(place.file, "gtest")


def _reads(system: System, call: ApiCall) -> Iterator[tuple[str, Place]]:
    """The names that a call reads and that cannot be others, each with where the code says it."""
    if call.api == "rclpy.node.Node.get_parameter":
        name = name_asked_for(call)
        if name is not None:
            yield name, _where_named(system, call)
    elif call.api == "rclpy.node.Node.get_parameters":
        yield from names_listed(system, call)


def _undeclared(
    node: Node, call: ApiCall, name: str, place: Place, declared: dict[str, list[ParameterDeclaration]], keeps: str
) -> Finding:
    assert node.blueprint is not None
    hint = did_you_mean(name, declared)
    bare = _without_tilde(name, declared)
    if bare:
        hint = meant(f"'{bare}'")
    return finding(
        "PRM003",
        place,
        f"parameter '{name}' is read, but {node.blueprint.class_name} never declares it{keeps and f': {keeps}'}{hint}",
        help=f"take the ~ out: write '{bare}'" if bare else f"declare it first: {_declaration(name, place)}",
        related=[] if _encloses(call.place, place) else [Related(call.place, "it is read here")],
        node=node.name,
        identity=(node.blueprint.class_name, name),
        group=(place.file, node.blueprint.class_name, _TILDE if bare else name if hint else ""),
    )


_TILDE = "~"
"""What ROS 1 wrote before the name of a parameter of the node itself, and is a part of the name in ROS 2."""


def _without_tilde(name: str, declared: Collection[str]) -> str:
    """The declared parameter that a name of ROS 1 means; empty for any other."""
    bare = name.removeprefix(_TILDE).lstrip("/")
    return bare if name.startswith(_TILDE) and bare in declared else ""


@folds("PRM003")
def _of_one_node(findings: Sequence[Finding]) -> Finding:
    """The finding for all parameters that a node reads and does not declare, at the first."""
    first, *others = findings
    cls, _ = first.identity
    names = list(dict.fromkeys(other.identity[1] for other in findings))
    if len(names) > 1 and first.group[2] == _TILDE:
        return replace(
            with_others(findings, "another name has", "more names have", "a ~, too", beside="this name has a ~, too"),
            identity=(cls, *names),
        )
    if len(names) > 1 and UNSET in first.group:
        return replace(
            with_others(findings, "another one has", "more have", "no value, either"), identity=(cls, *names)
        )
    if len(names) == 1:
        return replace(first, related=(*first.related, *(Related(other.place, "and here") for other in others)))
    keeps = f": {_KEEPS}" if _KEEPS in first.group else ""
    return replace(
        first,
        message=f"{cls} reads {len(names)} parameters that it never declares, {listed(names)}{keeps}"
        if keeps
        else f"{cls} reads {len(names)} parameters that it never declares: {listed(names)}",
        help=f"declare each first: {_declaration(names[0], first.place)}",
        related=(*first.related, *(Related(other.place, f"'{other.identity[1]}' is read here") for other in others)),
        identity=(cls, *names),
    )


def _declaration(name: str, place: Place) -> str:
    return f"self.declare_parameter('{name}', …)" if place.file.endswith(".py") else f'declare_parameter("{name}", …)'


def _where_named(system: System, call: ApiCall) -> Place:
    """The read itself, or the call of the helper that does it, whichever says the name."""
    value = call.arguments.get("name")
    origin = value.origin if isinstance(value, Constant) else None
    if origin is not None and not _encloses(call.place, origin):
        for frame in reversed(call.chain):
            if _encloses(frame.place, origin):
                return frame.place
    return call.chain[-1].place if call.chain and is_passed_on(system, call) else call.place


def _encloses(outer: Place, inner: Place) -> bool:
    starts = (outer.line, outer.column) <= (inner.line, inner.column)
    ends = (inner.end_line, inner.end_column) <= (outer.end_line, outer.end_column)
    return outer.file == inner.file and starts and ends


def name_asked_for(call: ApiCall) -> str | None:
    value = call.arguments.get("name")
    if isinstance(value, Constant) and isinstance(value.value, str) and not value.parameters:
        return value.value
    return None
