"""Access control for SROS 2: what each node of a system may publish, hear, serve and call, and nothing else.

Source: sros2 ``policy/schemas/policy.xsd``, version 0.2.0: ``policy`` > ``enclaves`` > ``enclave`` > ``profiles`` >
``profile`` > lists of ``topic``, ``service`` and ``action``.  A list has names as DDS permissions see them: full, and
remapped.  An enclave is one process (design.ros2.org, ROS 2 security enclaves).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.model import EntityKind
from archlint.render.declarations.rendered import MADE, Rendered
from archlint.render.declarations.xml_text import attribute, comment, content

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

VERSION = "0.2.0"
_LISTS: Mapping[EntityKind, tuple[str, str]] = {
    EntityKind.ACTION_CLIENT: ("action", "call"),
    EntityKind.ACTION_SERVER: ("action", "execute"),
    EntityKind.SERVICE: ("service", "reply"),
    EntityKind.CLIENT: ("service", "request"),
    EntityKind.PUBLISHER: ("topic", "publish"),
    EntityKind.SUBSCRIBER: ("topic", "subscribe"),
}
"""What a list holds, and what it allows."""


def render(system: System) -> Rendered:
    """The policy of a system whose nodes have their implicit endpoints
    (:func:`archlint.systems.implicit.with_implicit`)."""
    left_out: list[str] = []
    enclaves: dict[str, list[str]] = {}
    for path, nodes in _processes(system, left_out):
        for node in nodes:
            enclaves.setdefault(path, []).extend(_profile(node, left_out))
    gaps = [] if system.launched is None else system.launched.not_followed()
    left_out += [f"perhaps more: {gap.reason} at {gap.place.file}:{gap.place.line}" for gap in gaps]
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', comment(MADE)]
    lines += [comment(f"left out, and so denied: {words}") for words in left_out]
    lines += [f'<policy version="{VERSION}">', "  <enclaves>"]
    for path, profiles in sorted(enclaves.items()):
        lines += [f"    <enclave path={attribute(path)}>", "      <profiles>", *profiles]
        lines += ["      </profiles>", "    </enclave>"]
    return Rendered("\n".join([*lines, "  </enclaves>", "</policy>\n"]), tuple(left_out))


def _processes(system: System, left_out: list[str]) -> Iterator[tuple[str, list[Node]]]:
    """The nodes whose names are known, by the process that they are in, with the path of its enclave: the one that it
    is started with, else the name of its first node."""
    processes: dict[object, list[Node]] = {}
    for node in system.nodes:
        if node.test:
            continue
        started_as = "/".join(filter(None, (node.package, node.executable)))
        if node.blueprint is None:
            left_out.append(f"{node.name or started_as}: {node.unfollowed or 'its source is not in this workspace'}")
        elif node.name is None or node.resolution == "partial" or node.error is not None:
            called = node.blueprint.class_name
            left_out.append(f"a node of {called}: {node.error or 'its name is known only at run time'}")
        else:
            processes.setdefault(_process(node), []).append(node)
    for nodes in processes.values():
        nodes.sort(key=lambda node: node.name or "")
        yield _enclave(nodes[0]), nodes


def _process(node: Node) -> object:
    if node.started is not None:
        return id(node.started)
    return (node.package, node.executable) if node.executable is not None else id(node)


def _enclave(node: Node) -> str:
    words = [] if node.started is None else [*node.started.arguments, *node.started.ros_arguments]
    for option, value in pairwise(words):
        if option in ("--enclave", "-e") and value is not None:
            return value
    return node.name or "/"


def _profile(node: Node, left_out: list[str]) -> Iterator[str]:
    assert node.name is not None
    namespace, _, name = node.name.rpartition("/")
    lists = [*_lists(node, left_out)]
    for blueprint in node.blueprints:
        left_out += [f"{node.name}, perhaps more: {why} at {at.file}:{at.line}" for at, why in sorted(blueprint.gaps)]
    start = f"        <profile ns={attribute(namespace or '/')} node={attribute(name)}"
    yield from [f"{start}>", *lists, "        </profile>"] if lists else [f"{start} />"]


def _lists(node: Node, left_out: list[str]) -> Iterator[str]:
    for kind, (element, allowed) in _LISTS.items():
        names: Sequence[str] = sorted(
            {end.name for end in node.of_kind(kind) if end.name is not None and end.resolved and not end.error}
        )
        for end in node.of_kind(kind):
            if not end.resolved or end.error:
                reason = end.error or end.reason or "its name is known only at run time"
                what = f"{node.name}: a {kind.replace('_', ' ')}"
                left_out.append(f"{what} at {end.place.file}:{end.place.line}: {reason}")
        if names:
            yield f'          <{element}s {allowed}="ALLOW">'
            yield from (f"            <{element}>{content(name)}</{element}>" for name in names)
            yield f"          </{element}s>"


__all__ = ["VERSION", "render"]
