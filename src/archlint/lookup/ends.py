"""Where topics, services, actions and nodes are mentioned: in create calls, constructors and remappings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.lookup.mentions import Mention, Role, Subject
from archlint.model import NAMED
from archlint.ros import remapping

if TYPE_CHECKING:
    from archlint.launch.started import Remap
    from archlint.model import Text
    from archlint.place import Place
    from archlint.ros.remapping import RemapRule
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node


def mentions_of_ends(system: System, rank: int) -> Iterator[Mention]:
    """What the nodes of a system create, and how its launch file renames that."""
    for node in system.entries:
        yield from _of_node(node, rank)
        for end in node.endpoints:
            yield from _of_end(end, rank)
        yield from _of_external(node, rank)


def subject_of(end: Endpoint) -> Subject | None:
    """The topic, service or action that an endpoint is an end of; None where its name is not known, or is none."""
    if not end.resolved or end.error or end.name is None:
        return None
    return Subject(NAMED[end.kind], end.name)


def _of_node(node: Node, rank: int) -> Iterator[Mention]:
    blueprint = node.blueprint
    if node.name is None or node.error or blueprint is None or node.resolution not in ("exact", "parameter"):
        return
    subject = Subject("node", node.name)
    if blueprint.name.origin is not None:
        yield Mention(blueprint.name.origin, subject, "literal", rank, blueprint.name.text, node=node)


def _of_end(end: Endpoint, rank: int) -> Iterator[Mention]:
    creation, subject = end.creation, subject_of(end)
    if creation.type is not None and creation.type_place is not None:
        yield Mention(creation.type_place, Subject("interface", creation.type), "argument", rank, end=end)
    if subject is None:
        yield Mention(end.place, Subject("unnamed", ""), "call", rank, end=end, node=end.node)
        return

    def mention(place: Place, role: Role, written: str | None = None) -> Mention:
        return Mention(place, subject, role, rank, written, end, end.node)

    text, given = creation.name, creation.name_place
    yield mention(end.place, "call")
    if given is not None:
        yield mention(given, "argument", text.text if given == text.origin else None)
    if text.origin is not None and text.origin != given:
        yield mention(text.origin, "literal", text.text)
    remap = remap_of(end)
    for name, role in ((remap.source, _SOURCE), (remap.target, _TARGET)) if remap is not None else ():
        if name.origin is not None:
            yield mention(name.origin, role, name.text)


_SOURCE: Role = "remap source"
_TARGET: Role = "remap target"


def rule_of(end: Endpoint) -> RemapRule | None:
    """The remap rule that gives an endpoint its final name; None for the name in the code."""
    own, text = end.node.own, end.creation.name.text
    if own is None or own.name.text is None or own.namespace.text is None or text is None:
        return None
    node = (own.name.text, own.namespace.text)
    return remapping.resolve(text, NAMED[end.kind], node, end.node.rules).rule


def remap_of(end: Endpoint) -> Remap | None:
    """The remapping of a launch file that gives an endpoint its final name."""
    rule = rule_of(end)
    if rule is None or end.node.started is None:
        return None
    return next((remap for remap in end.node.started.remaps if _text(remap) == rule.text), None)


def _text(remap: Remap) -> str:
    return f"{remap.source.text}:={remap.target.text}"


def _of_external(node: Node, rank: int) -> Iterator[Mention]:
    """The remappings of a node whose source is not here: of its own names only these are known."""
    if not node.external or node.started is None or node.name is None:
        return
    node_name, namespace = node.name.rpartition("/")[2], node.name.rpartition("/")[0] or "/"
    for remap in node.started.remaps:
        full = remapping.resolve(remap.target.text or "", "topic", (node_name, namespace)).name
        if full is not None and _is_known(remap.target) and remap.target.origin is not None:
            for kind in ("topic", "service", "action"):
                subject = Subject(kind, full)
                yield Mention(remap.target.origin, subject, "remap target", rank, remap.target.text, node=node)


def _is_known(text: Text) -> bool:
    return text.text is not None and text.resolution in ("exact", "parameter")


__all__ = ["mentions_of_ends", "remap_of", "rule_of", "subject_of"]
