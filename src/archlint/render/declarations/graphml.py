"""The communication graph as GraphML, which Gephi, yEd, Cytoscape and NetworkX read; written by NetworkX."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from archlint.render.look import qos_words
from archlint.render.picture import broken_ends
from archlint.systems.graph import NODE, Key, to_networkx
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


def render(system: System) -> str:
    """Vertices are nodes and topics, services and actions; edges go with the data or the request."""
    import networkx

    graph = to_networkx(system)
    broken = broken_ends(system)
    ids = {key: _id(key) for key in graph.nodes}
    plain = networkx.MultiDiGraph()
    for key, data in graph.nodes(data=True):
        plain.add_node(ids[key], **_known(_vertex(data)))
    for tail, head, data in graph.edges(data=True):
        plain.add_edge(ids[tail], ids[head], **_known(_edge(data["endpoint"], broken.get(id(data["endpoint"]), ""))))
    return "\n".join(networkx.generate_graphml(plain)) + "\n"


def _id(key: Key) -> str:
    kind, name = key
    return visible(f"{kind}:{name}")


def _vertex(data: dict[str, Any]) -> dict[str, str | bool | int | None]:
    common = {"kind": data["kind"], "name": data["name"], "resolution": data["resolution"]}
    if data["kind"] != NODE:
        return {**common, "types": ", ".join(data["types"]), "matched": data["matched"], "error": data["error"]}
    node = data["node"]
    place = node.blueprint.place if node.blueprint is not None else node.launch_place
    return {
        **common,
        "class": None if node.blueprint is None else node.blueprint.class_name,
        "package": node.package,
        "executable": node.executable,
        "external": node.external,
        "file": None if place is None else PurePath(place.file).as_posix(),
        "line": None if place is None else place.line,
    }


def _edge(end: Endpoint, broken: str) -> dict[str, str | bool | int | None]:
    return {
        "kind": str(end.kind),
        "type": end.type,
        "qos": None if end.qos is None else qos_words(end.qos),
        "conditional": end.conditional,
        "broken": broken or None,
        "file": PurePath(end.place.file).as_posix(),
        "line": end.place.line,
    }


def _known(attributes: dict[str, str | bool | int | None]) -> dict[str, str | int]:
    """The attributes that have a value: GraphML has no word for none.  Truth values are texts: NetworkX writes them as
    Python does, which is not how XML does."""
    return {name: _value(value) for name, value in attributes.items() if value is not None}


def _value(value: str | bool | int) -> str | int:
    match value:
        case bool():
            return str(value).lower()
        case str():
            return visible(value)
    return value


__all__ = ["render"]
