"""Where the name of a create call can be taken from a parameter instead."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.surrounding_code import (
    as_code,
    is_constant,
    is_method,
    node_class_around,
    own_node,
    runs_once,
    statement_before,
    tree_of,
)
from archlint.edit_sites import NamedCall, Sites
from archlint.libraries import tables
from archlint.model import NAMED
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.tree import Tree, span_of
from archlint.syntax.walk import called_name, parts_of

if TYPE_CHECKING:
    from archlint.model import NodeClass
    from archlint.systems.model import WorkspaceIndex

_OWNERS = ("rclpy.node.Node", "rclpy.lifecycle.node.LifecycleNode", "rclpy.action.client", "rclpy.action.server")
_INTERFACES = {
    name: NAMED[row.kind]
    for row in tables.ROWS
    for owner, _, name in [row.path.rpartition(".")]
    if row.creates and row.name is not None and owner in _OWNERS
}
"""What the name that a call takes is a name of."""


def sites_of_name(workspace: WorkspaceIndex | None, given: Place, written: str, *, stays: bool) -> Sites | None:
    """For ``declare_parameter()`` in front of the create call that is given a name at a place, and the parameter in
    place of the name."""
    tree = None if workspace is None else tree_of(workspace, given.file)
    call, name = (None, None) if tree is None else _argument_at(tree, given)
    if workspace is None or tree is None or call is None or name is None:
        return None
    node = _node_of(call)
    statement = statement_before(tree, call)
    same_name = as_code(name)
    if node is None or statement is None or same_name is None:
        return None
    is_self = node.dotted == "self"
    cls = node_class_around(workspace, given.file, tree, statement) if is_self else None
    if is_self and (cls is None or not _is_of_package(workspace, cls)):
        return None
    function = tree.function_around(statement)
    if _is_parameter(function, name):
        return None
    own = own_node(tree, node, statement)
    once = own and runs_once(tree, function)
    if (not once or _is_other_method(tree, function)) and not is_constant(tree, name, statement):
        return None
    interface = _INTERFACES[called_name(call)]
    place = Place.of(given.file, span_of(statement))
    *_, last_line, last_column = span_of(tree.last_of_block(statement))
    site = NamedCall(
        name=given,
        node=Place.of(given.file, node.span),
        statement=place,
        block=Place(given.file, place.line, place.column, last_line, last_column),
        function=None if function is None else Place.of(given.file, function.span),
        interface=interface,
        written=written,
        same_as=(interface, node.dotted, same_name),
        runs_once=once,
        method=function.name if function is not None and _is_other_method(tree, function) else None,
        shares_node=not own or (cls is not None and any(base.file != given.file for base, _ in cls.bases)),
        stays=stays,
    )
    return Sites(names=(site,))


def _is_of_package(workspace: WorkspaceIndex, cls: NodeClass) -> bool:
    """Whether a class and its bases are in one package, in whose files fixes look for the parameters that there are."""
    return {workspace.package_of(place.file) for place, _ in cls.bases} <= {workspace.package_of(cls.place.file)}


def _argument_at(tree: Tree, place: Place) -> tuple[facts.Call | None, facts.Expr | None]:
    """The call that is given the expression at a place, and that."""
    return tree.given.get((place.line, place.column, place.end_line, place.end_column), (None, None))


def _node_of(call: facts.Call) -> facts.Name | facts.Attribute | None:
    """The node that a create call is made on, where it is a plain name such as ``self`` or ``self.node``."""
    interface = _INTERFACES.get(called_name(call))
    node: facts.Expr | None = None
    if interface == "action":
        node = next((arg.value for arg in call.args if arg.keyword is None and not arg.star), None)
    elif interface is not None:
        match call.func:
            case facts.Attribute(value=value):
                node = value
    match node:
        case facts.Name() | facts.Attribute(value=facts.Name()):
            return node
    return None


def _is_parameter(function: facts.Function | None, name: facts.Expr) -> bool:
    """Whether the caller gives (a part of) a name: another call may give another one."""
    if function is None or function.name == "__init__":
        return False
    own = {param.name for param in function.params if param.kind in ("positional_only", "normal", "keyword_only")}
    return not _variables_in(name).isdisjoint(own - {"self"})


def _variables_in(expression: facts.Expr) -> set[str]:
    variables: set[str] = set()
    for part in parts_of(expression):
        match part:
            case facts.Name(id=name):
                variables.add(name)
    return variables


def _is_other_method(tree: Tree, function: facts.Function | None) -> bool:
    """Whether a function is a method that a derived class may call with other arguments."""
    return function is not None and is_method(tree, function) and function.name != "__init__"
