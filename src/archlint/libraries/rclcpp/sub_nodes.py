"""``node->create_sub_node("arm")``: the same node, under which relative names begin with ``arm/``.

Source: ``extend_name_with_sub_namespace`` of ``rclcpp/node_impl.hpp``, which leaves names with ``/`` or ``~`` in front.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import External, Instance, Known, Unknown, Value, join_texts
from archlint.libraries.tables import NODE_ROWS

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method
    from archlint.libraries.run import Run

SUB_NODE = "rclcpp.SubNode"
_NODE, _PREFIX = "node", "prefix"


def _of_node(run: Run, node: Value, site: CallSite) -> Value:
    return _new(run, node, site.args[0] if site.args else Unknown("no name is given"))


def _of_sub_node(run: Run, outer: Value, site: CallSite) -> Value:
    node, name = _parts(run, outer)
    inner = site.args[0] if site.args else Unknown("no name is given")
    return _new(run, node, join_texts((name, Known("/"), inner)))


def _new(run: Run, node: Value, prefix: Value) -> Value:
    sub_node = Instance(External(SUB_NODE), run.store.new_key())
    run.store.set(sub_node.key, _NODE, node)
    run.store.set(sub_node.key, _PREFIX, prefix)
    return sub_node


def _parts(run: Run, sub_node: Value) -> tuple[Value, Value]:
    """The node, and what its relative names begin with."""
    unknown = Unknown("a sub-node that is not known")
    if not isinstance(sub_node, Instance):
        return unknown, unknown
    return run.store.get(sub_node.key, _NODE) or unknown, run.store.get(sub_node.key, _PREFIX) or unknown


def _on_node(name: str, of_name: str | None) -> Method:
    """A method of the node; ``of_name`` is the parameter with a name that may be relative."""

    def call(run: Run, sub_node: Value, site: CallSite) -> Value:
        node, prefix = _parts(run, sub_node)
        keywords = dict(site.keywords)
        given = keywords.get(of_name) if of_name is not None else None
        if of_name is not None and given is not None and not (given.text or "").startswith(("/", "~")):
            keywords[of_name] = join_texts((prefix, Known("/"), given))
        return run.call(get_attribute(run, node, name), replace(site, keywords=keywords))

    return call


METHODS: dict[str, Method] = {
    **{
        f"{SUB_NODE}.{name}": _on_node(name, row.name if row.kind is not None else None)
        for name, row in NODE_ROWS.items()
    },
    "rclpy.node.Node.create_sub_node": _of_node,
    f"{SUB_NODE}.create_sub_node": _of_sub_node,
}

__all__ = ["METHODS"]
