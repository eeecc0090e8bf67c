"""``interface.yaml``: one node a document, as the ROSGraph working group's proposal and ``jig`` read it.

Sources: ros-tooling/rosgraph, ``docs/ROSGRAPH.md`` 3.2, layer 1; nineyards-robotics/jig,
``schemas/interface.schema.yaml`` (keys, and what a profile needs: a history of 1 or more messages or ``ALL``, and a
reliability); parameters as ``generate_parameter_library`` has them.  Keys that one of the two refuses are left out.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import yaml

from archlint.model import EntityKind
from archlint.render.declarations.interface import OF_MESSAGES
from archlint.render.declarations.rendered import MADE, Rendered
from archlint.ros.interface_profiles import profile_of
from archlint.ros.parameter_types import OF_PARAMETER_LIBRARY
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.render.declarations.interface import Declarations, DeclaredEnd, DeclaredParameter, NodeInterface

KEYS: Mapping[EntityKind, str] = {
    EntityKind.PUBLISHER: "publishers",
    EntityKind.SUBSCRIBER: "subscribers",
    EntityKind.SERVICE: "services",
    EntityKind.CLIENT: "service_clients",
    EntityKind.ACTION_SERVER: "actions",
    EntityKind.ACTION_CLIENT: "action_clients",
}
_NAME = re.compile(r"[A-Za-z]\w*", re.ASCII)


def render(declarations: Declarations) -> Rendered:
    """A document for each node."""
    documents = [document(node) for node in declarations.nodes]
    left_out = [item.words for item in declarations.left_out]
    head = "".join(_comment(words) for words in (*([] if documents else [MADE]), *map(_left_out, left_out)))
    rows = [
        f"{node.name}: {words}"
        for node, each in zip(declarations.nodes, documents, strict=True)
        for words in each.left_out
    ]
    return Rendered(head + "---\n".join(each.text for each in documents), (*left_out, *rows))


def document(node: NodeInterface) -> Rendered:
    """The document about one node."""
    notes = [item.words for item in node.left_out]
    content: dict[str, Any] = {"node": _node(node, notes)}
    parameters = {p.name: _parameter(p) for p in node.parameters if _can_be_declared(p, notes)}
    if parameters:
        content["parameters"] = parameters
    for kind, key in KEYS.items():
        entries = [entry for end in node.of_kind(kind) if (entry := _entry(end, notes)) is not None]
        if entries:
            content[key] = entries
    about = [MADE, *(["A lifecycle node."] if node.lifecycle else []), *filter(None, [node.description])]
    head = "".join(map(_comment, (*about, *map(_left_out, notes))))
    return Rendered(head + yaml.safe_dump(_safe(content), sort_keys=False, allow_unicode=True, width=120), tuple(notes))


def _left_out(words: str) -> str:
    return f"left out: {words}"


def _comment(words: str) -> str:
    return "".join(f"# {visible(line)}".rstrip() + "\n" for line in words.split("\n"))


def _node(node: NodeInterface, notes: list[str]) -> dict[str, str]:
    known = {"name": node.name} if _NAME.fullmatch(node.name) else {}
    if not known:
        notes.append(f"the name of the node, {node.name}, which the format does not take")
    return known | ({"package": node.package} if node.package is not None else {})


def _entry(end: DeclaredEnd, notes: list[str]) -> dict[str, Any] | None:
    of_messages = end.kind in OF_MESSAGES
    entry: dict[str, Any] = {"topic" if of_messages else "name": end.name, "type": end.type}
    if of_messages:
        profile = None if end.qos is None else profile_of(end.qos)
        if profile is None:
            where = f"{end.place.file}:{end.place.line}"
            notes.append(
                f"the {end.kind} {end.name} at {where}: its QoS is not known, or the format has no words for it"
            )
            return None
        entry["qos"] = profile
    return entry


def _can_be_declared(parameter: DeclaredParameter, notes: list[str]) -> bool:
    known = parameter.type in OF_PARAMETER_LIBRARY
    if not known:
        notes.append(f"the parameter {parameter.name}, for whose type the format has no word")
    return known


def _parameter(parameter: DeclaredParameter) -> dict[str, Any]:
    assert parameter.type is not None
    declared: dict[str, Any] = {"type": OF_PARAMETER_LIBRARY[parameter.type]}
    if parameter.has_default:
        declared["default_value"] = (
            list(parameter.default) if isinstance(parameter.default, tuple) else parameter.default
        )
    described = parameter.description
    if described is None:
        return declared
    words = {"description": described.text, "additional_constraints": described.constraints}
    declared |= {key: text for key, text in words.items() if text}
    if described.read_only:
        declared["read_only"] = True
    if described.lowest is not None and described.highest is not None:
        declared["validation"] = {"bounds<>": [described.lowest, described.highest]}
    return declared


def _safe(value: Any) -> Any:
    """The same with all texts safe to show."""
    match value:
        case str():
            return visible(value) if "\n" not in value else "\n".join(map(visible, value.split("\n")))
        case dict():
            return {_safe(key): _safe(item) for key, item in value.items()}
        case list():
            return [_safe(item) for item in value]
    return value


__all__ = ["KEYS", "document", "render"]
