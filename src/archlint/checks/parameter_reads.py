"""PRM003 and PRM006: parameters that are read and never declared, and that are declared and never read."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.completeness import declares_all, enclosing_function, facts_at, walk
from archlint.analysis.source_code import source_code
from archlint.checks.parameters import always_declared, declared_by, followed
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.model import Role
from archlint.model.given import Constant
from archlint.suggestions import did_you_mean
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.model import ApiCall, ParameterDeclaration
    from archlint.systems.model import Node, System, WorkspaceIndex


# ------------------------------------------------------------------------------------------------- PRM003


@rule("PRM003", scope=Scope.CODE)
def undeclared_parameter(system: System, options: Options) -> Iterator[Finding]:
    """Parameters that are read and never declared."""
    for node in system.nodes:
        declared = declared_by(node)
        if node.blueprint is None or declared is None or node.program is None or node.program.exhausted:
            continue
        if not declares_all(system.workspace, node.blueprint) or not followed(node):
            continue
        calls = [call for call in node.program.calls if call.node is node.blueprint]
        guarded = {_name_of(call) for call in calls if call.api.endswith(".has_parameter")}
        for call in calls:
            for name, place in _reads(system, call):
                if always_declared(name) or name in declared or name in guarded or call.in_try:
                    continue
                yield _undeclared(node, call, name, place, declared)


def _reads(system: System, call: ApiCall) -> Iterator[tuple[str, Place]]:
    """The names that a call reads and that cannot be others, each with where the code says it."""
    if call.api == "rclpy.node.Node.get_parameter":
        name = _name_of(call)
        if name is not None:
            yield name, _where_named(system, call)
    elif call.api == "rclpy.node.Node.get_parameters":
        names = [given.value for given in source_code(system).arguments(call)[:1]]
        for item in (item for one in names if isinstance(one, facts.Sequence) for item in one.elements):
            if isinstance(item, facts.Literal) and isinstance(item.value, str):
                yield item.value, Place(call.place.file, *item.span)


def _undeclared(
    node: Node, call: ApiCall, name: str, place: Place, declared: dict[str, list[ParameterDeclaration]]
) -> Finding:
    assert node.blueprint is not None
    return finding(
        "PRM003",
        place,
        f"parameter '{name}' is read, but {node.blueprint.class_name} never declares it" + did_you_mean(name, declared),
        help=f"declare it first: self.declare_parameter('{name}', …)",
        related=[] if _encloses(call.place, place) else [Related(call.place, "it is read here")],
        node=node.name,
        identity=(node.blueprint.class_name, name),
    )


def _where_named(system: System, call: ApiCall) -> Place:
    """The read itself, or the call of the helper that does it, whichever says the name."""
    value = call.arguments.get("name")
    origin = value.origin if isinstance(value, Constant) else None
    if origin is not None and not _encloses(call.place, origin):
        for frame in reversed(call.chain):
            if _encloses(frame.place, origin):
                return frame.place
    return call.chain[-1].place if call.chain and _is_passed_on(system, call) else call.place


def _is_passed_on(system: System, call: ApiCall) -> bool:
    """Whether the name that is read is a parameter of the function that reads it."""
    function = None if system.workspace is None else enclosing_function(system.workspace, call.place)
    given = source_code(system).arguments(call)[:1]
    return function is not None and any(one.value.variable in {p.name for p in function.params} for one in given)


def _encloses(outer: Place, inner: Place) -> bool:
    starts = (outer.line, outer.column) <= (inner.line, inner.column)
    ends = (inner.end_line, inner.end_column) <= (outer.end_line, outer.end_column)
    return outer.file == inner.file and starts and ends


def _name_of(call: ApiCall) -> str | None:
    value = call.arguments.get("name")
    if isinstance(value, Constant) and isinstance(value.value, str) and not value.parameters:
        return value.value
    return None


# ------------------------------------------------------------------------------------------------- PRM006


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
        reads = {_name_of(call) for call in calls if call.api.startswith("rclpy.node.Node.get_parameter")}
        if None in reads or any(call.api in ("rclpy.node.Node.get_parameters",) for call in calls):
            continue
        for declaration in blueprint.parameters:
            name = declaration.name.text
            if name is None or declaration.name.resolution != "exact" or name in reads:
                continue
            if _mentioned(system.workspace, declaration, name) or _elsewhere(system.workspace, node, declaration, name):
                continue
            yield finding(
                "PRM006",
                declaration.place,
                f"parameter '{name}' is declared but never read",
                help="read it with get_parameter(), or remove the declaration",
                node=node.name,
                identity=(blueprint.class_name, name),
            )


def _mentioned(workspace: WorkspaceIndex, declaration: ParameterDeclaration, name: str) -> bool:
    """Whether the name stands anywhere else in the file, or the declaration's own result is used."""
    found = facts_at(workspace, declaration.place.file)
    if found is None:
        return True
    texts: list[object] = []
    spelled: str | None = None
    for item in walk(found.body):
        if isinstance(item, facts.Literal):
            texts.append(item.value)
        if isinstance(item, facts.Expression) and isinstance(item.value, facts.Call):
            spelled = spelled or _plainly_declared(item.value, declaration, name)
        if isinstance(item, facts.Attribute) and item.attr in ("get_parameters_by_prefix", "get_parameters"):
            return True
    return spelled is None or sum(text in (name, spelled) for text in texts) != 1


def _plainly_declared(call: facts.Call, declaration: ParameterDeclaration, name: str) -> str | None:
    """The name as a call itself spells it, which no loop does; None where another call declares it, or where its
    default is a value of the running node: such a one is declared for others to see."""
    for at, given in _rows(call):
        here = at[:2] == (declaration.place.line, declaration.place.column)
        text = given[0].value if here and given and isinstance(given[0], facts.Literal) else None
        of_prefix = isinstance(text, str) and text and name.endswith(f".{text}")
        if (text == name or of_prefix) and not any(_of_the_running_node(value) for value in given[1:2]):
            return str(text)
    return None


def _rows(call: facts.Call) -> Iterator[tuple[facts.Span, list[facts.Expr]]]:
    """What a call declares, each with its place, its name and its default: one parameter, or the entries of its
    list."""
    names_first = sorted(call.args, key=lambda argument: argument.keyword not in (None, "name"))
    yield call.span, [argument.value for argument in names_first]
    for argument in call.args:
        if isinstance(argument.value, facts.Sequence):
            for row in argument.value.elements:
                if isinstance(row, facts.Sequence) and row.elements and isinstance(row.elements[0], facts.Literal):
                    yield row.elements[0].span, row.elements


def _of_the_running_node(value: facts.Expr) -> bool:
    if isinstance(value, facts.Attribute):
        return isinstance(value.value, facts.Name) and value.value.id == "self"
    return isinstance(value, facts.Name)


def _elsewhere(workspace: WorkspaceIndex, node: Node, declaration: ParameterDeclaration, name: str) -> bool:
    """Whether a file that knows this one, or that this one knows, speaks of the parameter: a subclass or a
    helper may read it."""
    if node.package is None:
        return False
    here = declaration.place.file
    return any(
        path != here
        and workspace.code.mentions(path, name)
        and (workspace.code.mentions(path, _stem(here)) or workspace.code.mentions(here, _stem(path)))
        for path in workspace.code.files_of(node.package)
    )


def _stem(path: str) -> str:
    return posixpath.splitext(posixpath.basename(path))[0]
