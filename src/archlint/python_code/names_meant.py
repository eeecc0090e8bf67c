"""What an undefined name stands for, by where it stands, such as a node that is spun or an exception that is caught."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.source_code import code_of
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_TAKE_A_NODE = frozenset({"add_node", "spin", "spin_once", "spin_until_future_complete"})
_NODES = frozenset({"LifecycleNode", "Node"})
_USUAL = frozenset({"error", "errors", "excep", "exception"})
_SHORT = 3
"""Names of so few letters, ``e`` and ``exc``, are variables."""


EVERYDAY = frozenset({"close", "init", "loop", "main", "run", "setup", "shutdown", "spin", "start", "stop", "update"})
"""Names of functions that any module may have: that another one has it says nothing."""


def functions_to_call(workspace: WorkspaceIndex, file: str) -> list[str]:
    """The functions of a file, outside of its classes, that can be called without a word."""
    code = workspace.facts_at(file)
    own = [row for row in (() if code is None else code.body) if isinstance(row, facts.Function)]
    return [row.name for row in own if all(param.kind in _NOT_NEEDED or param.default for param in row.params)]


_NOT_NEEDED = frozenset({"star", "double_star"})


def node_class_meant(workspace: WorkspaceIndex, place: Place) -> str | None:
    """The only class of nodes of a file, where a name is called there to make the node that is spun; empty where the
    file has none or several, None for any other name."""
    code = workspace.facts_at(place.file)
    if code is None or place.span not in _nodes_made(code):
        return None
    classes = [cls.name for cls in everything_in(code.body, facts.Class) if _is_of_nodes(cls)]
    return classes[0] if len(classes) == 1 else ""


def node_spun(workspace: WorkspaceIndex, place: Place) -> str:
    """The variable of the only node that a function spins, where a name is asked there for its logger, or to be
    destroyed; empty for any other name."""
    function = code_of(workspace).function_at(place)
    body = () if function is None else function.body
    is_node = any(
        call.func.attribute in ("destroy_node", "get_logger") and getattr(call.func.root, "span", None) == place.span
        for call in parts_of(body, facts.Call)
    )
    spun = {call.args[0].value.variable for call in parts_of(body, facts.Call) if _takes_a_node(call)}
    return spun.pop() if is_node and len(spun) == 1 else ""


def node_made(workspace: WorkspaceIndex, place: Place, classes: Collection[str | None]) -> str:
    """The variable of the only node that a function has made before a place, of some classes or by ``create_node()``;
    empty where there is none, or several."""
    nodes = {
        (statement.targets[0].variable, statement.span < place.span)
        for statement in parts_of(code_of(workspace).body_at(place), facts.Assign)
        if isinstance(statement.value, facts.Call)
        and (called_name(statement.value) in classes or called_name(statement.value) == "create_node")
    }
    name, is_before = nodes.pop() if len(nodes) == 1 else ("", False)
    return name if is_before else ""


def _is_of_nodes(cls: facts.Class) -> bool:
    return any(base.value.last_name in _NODES for base in cls.bases)


@once_for
def _nodes_made(code: facts.Facts) -> frozenset[facts.Span]:
    """Where the names stand that a file calls for a node: ``rclpy.spin(Talker())``, or into a variable that is spun."""
    given = [call.args[0].value for call in everything_in(code.body, facts.Call) if _takes_a_node(call)]
    spun = {value.variable for value in given if value.variable}
    assigned = (
        statement.value
        for statement in everything_in(code.body, facts.Assign)
        if any(target.variable in spun for target in statement.targets)
    )
    return frozenset(_names_called([*given, *assigned]))


def _takes_a_node(call: facts.Call) -> bool:
    return called_name(call) in _TAKE_A_NODE and bool(call.args) and not call.args[0].keyword


def _names_called(values: list[facts.Expr]) -> Iterator[facts.Span]:
    for value in values:
        match value:
            case facts.Call(func=facts.Name(span=span)):
                yield span


def exception_meant(workspace: WorkspaceIndex, file: str, name: str) -> str:
    """What is advised for the name behind ``except``, where nothing defines it: most mean a variable, ``except e:``,
    and some a class that they have not imported."""
    if name == "timeout":
        code = workspace.facts_at(file)
        imports = everything_in(() if code is None else code.body, facts.Import)
        has_socket = any(each.module == "socket" and each.alias is None for each in imports)
        return f"write `except {'socket.timeout' if has_socket else 'TimeoutError'}:`"
    if len(name) <= _SHORT or name in _USUAL:
        return f"write `except Exception as {name}:`"
    return "name the class of the exception that is meant"


def first_use(workspace: WorkspaceIndex, place: Place, name: str) -> Place:
    """Where the function around a place has a name first: there it fails, if nothing gives it a value."""
    function = code_of(workspace).function_at(place)
    uses = () if function is None else parts_of(function.body, facts.Name)
    return Place.of(place.file, min([place.span, *(use.span for use in uses if use.id == name)]))


__all__ = ["exception_meant", "first_use", "node_class_meant", "node_spun"]
