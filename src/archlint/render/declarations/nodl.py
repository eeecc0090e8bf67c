"""NoDL, the Node Definition Language of ``ros2nodl``, version 1.

Source: ``nodl_python`` 0.3.1, ``_schemas/v1.xsd``: an ``interface`` of at least one ``node`` with at least one
``action``, ``parameter``, ``topic`` or ``service``; each end has a name, a type and a role, which is ``both`` where a
node has both.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.model import EntityKind
from archlint.render.declarations.rendered import MADE, Rendered
from archlint.render.declarations.xml_text import attribute, comment

if TYPE_CHECKING:
    from archlint.render.declarations.interface import Declarations, DeclaredEnd, NodeInterface

_ROLES = {
    EntityKind.ACTION_SERVER: ("action", "server"),
    EntityKind.ACTION_CLIENT: ("action", "client"),
    EntityKind.PUBLISHER: ("topic", "publisher"),
    EntityKind.SUBSCRIBER: ("topic", "subscription"),
    EntityKind.SERVICE: ("service", "server"),
    EntityKind.CLIENT: ("service", "client"),
}


def render(declarations: Declarations) -> Rendered:
    """One document for all nodes."""
    left_out = [item.words for item in declarations.left_out]
    nodes = [line for node in declarations.nodes for line in _node(node, left_out)]
    notes = [comment(f"left out: {words}", 2) for words in left_out]
    head = ['<?xml version="1.0" encoding="UTF-8"?>', comment(MADE), '<interface version="1">']
    return Rendered("\n".join([*head, *notes, *nodes, "</interface>\n"]), tuple(left_out))


def _node(node: NodeInterface, left_out: list[str]) -> Iterator[str]:
    left_out += [f"{node.name}: {item.words}" for item in node.left_out]
    dynamic = [parameter.name for parameter in node.parameters if parameter.type is None]
    left_out += [f"{node.name}: the parameter {name}, which takes values of any type" for name in dynamic]
    content = [*_parameters(node), *_ends(node)]
    if not content or not node.executables:
        why = "no executable starts it" if content else "nothing of it can be declared"
        left_out.append(f"the node {node.name}: {why}")
        return
    # One element an executable: NoDL has no other way to say that several start the same node.
    for executable in node.executables:
        yield f"  <node name={attribute(node.name)} executable={attribute(executable)}>"
        yield from content
        yield "  </node>"


def _parameters(node: NodeInterface) -> Iterator[str]:
    for parameter in node.parameters:
        if parameter.type is not None:
            yield f"    <parameter name={attribute(parameter.name)} type={attribute(parameter.type)} />"


def _ends(node: NodeInterface) -> Iterator[str]:
    roles: dict[tuple[str, str, str], list[str]] = {}
    for end in sorted(node.ends, key=_order):
        element, role = _ROLES[end.kind]
        known = roles.setdefault((element, end.name, end.type), [])
        if role not in known:
            known.append(role)
    for (element, name, type_), known in roles.items():
        role = known[0] if len(known) == 1 else "both"
        yield f"    <{element} name={attribute(name)} type={attribute(type_)} role={attribute(role)} />"


def _order(end: DeclaredEnd) -> tuple[str, str, str]:
    return (_ROLES[end.kind][0], end.name, end.type)


__all__ = ["render"]
