"""The node that a call is to be made on or given, by a name that there is where the call stands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.completeness import enclosing_class
from archlint.analysis.source_code import source_code
from archlint.model import Misuse, RefusedCall
from archlint.python_code.names_meant import node_made

if TYPE_CHECKING:
    from archlint.systems.model import System


def cure_of_spin(system: System, name: str, call: RefusedCall) -> str:
    """What to write for ``rclpy.spin_once(timeout_sec=0.1)``, and for a spin that is given its future in place of the
    node; empty for other mistakes."""
    if call.misuse is not Misuse.MISSING or not call.api.startswith("rclpy.spin"):
        return ""
    if call.parameters not in (("node",), ("future",)):
        return ""
    written, cls = source_code(system).call_at(call.place), enclosing_class(system.workspace, call.place)
    node = "self" if cls is not None and node_around(system, call) == "self" else _variable_of_node(system, call)
    arguments = () if written is None else written.args
    futures = [argument.value.dotted for argument in arguments if not argument.keyword]
    if call.parameters == ("future",) and (len(futures) != 1 or not futures[0] or futures[0] == node):
        return ""  # it may well be the node that is given
    rest = "".join(f", {name}" for name in futures) if call.parameters == ("future",) else ""
    rest += "".join(f", {argument.keyword}=…" for argument in arguments if argument.keyword)
    return f"write {name}({node}{rest})" if node else f"pass the node that it is to spin: {name}(…{rest})"


def _variable_of_node(system: System, call: RefusedCall) -> str:
    classes = {blueprint.class_name for node in system.nodes for blueprint in node.blueprints}
    return "" if system.workspace is None else node_made(system.workspace, call.place, classes - {None})


def node_around(system: System, call: RefusedCall) -> str:
    """What the code at a call has for its node: itself in the class of one."""
    cls = enclosing_class(system.workspace, call.place)
    blueprints = (blueprint for node in system.nodes for blueprint in node.blueprints)
    is_node = any((row.place.file, row.class_name) == (call.place.file, cls) for row in blueprints)
    return "self" if is_node else "node"


__all__ = ["cure_of_spin", "node_around"]
