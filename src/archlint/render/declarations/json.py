"""The declarations as JSON: what ``interface.yaml`` says of each node and more, with places."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text
from archlint.render.declarations.interface import OF_MESSAGES
from archlint.render.declarations.interface_yaml import KEYS
from archlint.render.declarations.rendered import Rendered
from archlint.render.json import plain, qos_data

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.render.declarations.interface import (
        Declarations,
        DeclaredEnd,
        DeclaredParameter,
        LeftOut,
        NodeInterface,
    )

VERSION = 1


def render(declarations: Declarations) -> Rendered:
    """All nodes, with what had to be left out of each."""
    nodes, left_out = map(_node, declarations.nodes), map(_left_out, declarations.left_out)
    document = {"version": VERSION, "nodes": [*nodes], "left_out": [*left_out]}
    return Rendered(json_text(document, indent=2) + "\n", tuple(item.words for item in declarations.all_left_out))


def _left_out(item: LeftOut) -> dict[str, Any]:
    return {"what": item.what, "reason": item.reason, **_where(item.place)}


def _node(node: NodeInterface) -> dict[str, Any]:
    return {
        "name": node.name,
        "package": node.package,
        "executables": list(node.executables),
        "lifecycle": node.lifecycle,
        "description": node.description,
        **_where(node.place),
        **{key: [_end(end) for end in node.of_kind(kind)] for kind, key in KEYS.items()},
        "parameters": [_parameter(parameter) for parameter in node.parameters],
        "left_out": [_left_out(item) for item in node.left_out],
    }


def _end(end: DeclaredEnd) -> dict[str, Any]:
    profile = {"qos": qos_data(end.qos)} if end.kind in OF_MESSAGES else {}
    return {"name": end.name, "type": end.type, **profile, "description": end.description, **_where(end.place)}


def _parameter(parameter: DeclaredParameter) -> dict[str, Any]:
    described = parameter.description
    return {
        "name": parameter.name,
        "type": parameter.type,
        "default": plain(parameter.default) if parameter.has_default else None,
        "has_default": parameter.has_default,
        "description": "" if described is None else described.text,
        "additional_constraints": "" if described is None else described.constraints,
        "read_only": described is not None and described.read_only,
        "range": None if described is None or described.lowest is None else _range(described.lowest, described.highest),
        "step": None if described is None else described.step,
        **_where(parameter.place),
    }


def _range(lowest: float, highest: float | None) -> list[float | None]:
    return [lowest, highest]


def _where(place: Place) -> dict[str, Any]:
    return {"file": PurePath(place.file).as_posix(), "line": place.line}


__all__ = ["render"]
