"""What the drawn formats share: colours that hold up on paper and in grey, and the words on a picture."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any, Literal

from archlint.counted import counted
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros.qos import Qos
from archlint.systems.graph import NODE
from archlint.systems.nodes import Endpoint, Node
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable

    import networkx

    from archlint.observed.model import Status

FONT = "Helvetica,Arial,sans-serif"


@dataclass(frozen=True)
class Colours:
    fill: str
    line: str
    text: str


PALETTE = {
    "node": Colours("#dbeafe", "#1d4ed8", "#172554"),
    "topic": Colours("#f1f5f9", "#64748b", "#1e293b"),
    "service": Colours("#fef3c7", "#b45309", "#451a03"),
    "action": Colours("#f3e8ff", "#7e22ce", "#3b0764"),
    "group": Colours("#e0e7ff", "#4338ca", "#1e1b4b"),
    "note": Colours("#ffffff", "#ffffff", "#475569"),
    "wrong": Colours("#fee2e2", "#b91c1c", "#450a0a"),
    "aside": Colours("#ffffff", "#94a3b8", "#475569"),
    "missing": Colours("#fff1f2", "#e11d48", "#881337"),
    "unexpected": Colours("#dcfce7", "#15803d", "#052e16"),
    "different": Colours("#cffafe", "#0e7490", "#083344"),
}
"""``wrong`` marks types that differ and rejected names; ``aside`` neighbours, and what :func:`is_aside` holds for;
the last three what a running system has otherwise."""


UNOWNED = "used by an unknown node"
"""Title of what stands apart: classes and functions that are no nodes."""


def node_label(node: Node) -> str:
    """A node's name, or its class where the name is not known, and when it is started."""
    if node.name is not None:
        return _lines([node.name, condition_words(node)])
    called = node.blueprint.class_name if node.blueprint else node.executable or "?"
    if not node.is_node:
        return _lines([called, condition_words(node)])
    return _lines([called, "name not known", condition_words(node)])


def condition_words(node: Node) -> str:
    """Under which launch arguments a node is started; empty for always."""
    return f"with {node.condition}" if node.condition else ""


def node_details(node: Node) -> str:
    """Class, package and place of a node, for a tooltip."""
    if node.blueprint is None:
        return ", ".join(filter(None, [_started_as(node), "not in this workspace"]))
    place = node.blueprint.place
    executables = ", ".join(node.executables)
    started_by = f"{node.package or 'no package'}{': ' if executables else ''}{executables}"
    where = f"{place.file}:{place.line}"
    return _lines([node.blueprint.class_name, started_by, where, "test code" if node.test else ""])


def _started_as(node: Node) -> str:
    """``package/executable``, empty for a node that only runs."""
    return f"{node.package}/{node.executable}" if node.package or node.executable else ""


def vertex_label(data: dict[str, Any]) -> str:
    """The text in a shape: the label of a node or an interface, and how the running system differs there."""
    label = node_label(data["node"]) if data["kind"] == NODE else interface_label(data)
    return _lines([*label.split("\n"), data.get("observed", "")])


def interface_label(data: dict[str, Any]) -> str:
    """Name and short type of a topic, service or action; several types are all shown."""
    types = [type_.rpartition("/")[2] for type_ in data["types"]]
    if len(set(types)) < len(types):
        types = data["types"]
    return _lines([data["name"] or "?", " ≠ ".join(types) or "type not known"])


def interface_details(data: dict[str, Any]) -> str:
    """Kind, full types and what is to be said of the name, for a tooltip."""
    lines = [data["kind"], *data["types"]]
    if data["error"]:
        lines.append(data["error"])
    if data["resolution"] != "exact":
        lines.append(f"name: {data['resolution']}")
    return _lines(lines)


def _lines(parts: Iterable[str]) -> str:
    """The parts that are not empty, made safe to show, each on a line of its own."""
    return "\n".join(visible(part) for part in parts if part)


def endpoint_details(endpoint: Endpoint, broken: str = "") -> str:
    """Kind, place, quality of service and callback of an endpoint, and why it is ``broken``, for a tooltip."""
    parts = [endpoint.kind.replace("_", " "), f"{endpoint.place.file}:{endpoint.place.line}"]
    if endpoint.qos is not None and endpoint.kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER):
        parts.append(qos_words(endpoint.qos))
    parts += sorted(callback.name for callback in endpoint.creation.callbacks.values())
    if endpoint.conditional:
        parts.append("only under a condition")
    if broken:
        parts.append(f"nothing gets through: {broken}")
    return ", ".join(parts)


def qos_words(qos: Qos) -> str:
    """``reliable, volatile, keep last 10``, with ``?`` for what is not known."""
    if qos.history is None and qos.reliability is None and qos.durability is None:
        return "QoS not known"
    history = (qos.history or "?").replace("_", " ")
    if qos.history == "keep_last":
        history += f" {'?' if qos.depth is None else qos.depth}"
    words = [qos.reliability or "?", qos.durability or "?"]
    return ", ".join([*(word.replace("_", " ") for word in words), history])


def groups(graph: networkx.MultiDiGraph) -> dict[tuple[str, str], str]:
    """Vertex → title of the group it is drawn in: its namespace where nodes have several, else its package.

    An interface belongs to a group if all its nodes do.  What is no node has a group of its own.
    """
    entries = {key: data["node"] for key, data in graph.nodes(data=True) if data["kind"] == NODE}
    nodes = {key: node for key, node in entries.items() if node.is_node}
    by = _namespace if len({_namespace(node) for node in nodes.values()}) > 1 else _package
    several = len({by(node) for node in nodes.values()}) > 1
    titles = {key: (by(node) if several else "") if node.is_node else UNOWNED for key, node in entries.items()}
    if not any(titles.values()):
        return {}
    for key in graph.nodes:
        if key not in entries:
            around = {titles[other] for other in (*graph.predecessors(key), *graph.successors(key))}
            titles[key] = around.pop() if len(around) == 1 else ""
    return {key: title for key, title in titles.items() if title}


def _namespace(node: Node) -> str:
    return (node.name or "").rpartition("/")[0]


def _package(node: Node) -> str:
    return node.package or ""


def counts(graph: networkx.MultiDiGraph) -> str:
    """``3 nodes, 1 topic, 2 services``."""
    kinds = Counter(
        "neighbour" if data.get("neighbour") else data["kind"]
        for _, data in graph.nodes(data=True)
        if not is_unowned(data)
    )
    words = [counted(kinds[kind], kind) for kind in ("node", "neighbour", "topic", "service", "action") if kinds[kind]]
    return ", ".join(words) or "no nodes"


def is_unowned(data: dict[str, Any]) -> bool:
    """Whether the data of a vertex are those of an entry that is no node."""
    return data["kind"] == NODE and not data["node"].is_node


def is_aside(node: Node) -> bool:
    """Whether it is drawn in grey: test code, nodes whose source is not here, and what is no node."""
    return node.test or node.external or not node.is_node


@dataclass(frozen=True)
class Bundle:
    """All endpoints of one node on one interface in one direction, drawn as one line.

    ``conditional`` is set where all of them are; ``broken`` says why nothing gets through, empty where something does,
    and ``held_back`` what does not.
    """

    tail: tuple[str, str]
    head: tuple[str, str]
    conditional: bool
    broken: str
    details: str
    observed: Status | Literal[""] = ""
    """How the running system differs there, and ``remark`` the same in words; empty where it does not."""
    remark: str = ""
    held_back: tuple[str, ...] = ()


def bundles(graph: networkx.MultiDiGraph) -> list[Bundle]:
    """The lines of a drawing, in the order of the graph's edges."""
    edges: dict[tuple[tuple[str, str], tuple[str, str]], list[dict[str, Any]]] = {}
    for tail, head, attributes in graph.edges(data=True):
        edges.setdefault((tail, head), []).append(attributes)
    return [_bundle(tail, head, bundled) for (tail, head), bundled in edges.items()]


def _bundle(tail: tuple[str, str], head: tuple[str, str], edges: list[dict[str, Any]]) -> Bundle:
    conditional = all(edge["endpoint"].conditional for edge in edges)
    broken = edges[0]["broken"] if all(edge["broken"] for edge in edges) else ""
    details = _lines([*(endpoint_details(e["endpoint"], e["broken"]) for e in edges), *remarks(edges)])
    marked = next((edge for edge in edges if edge.get("observed")), {})
    held_back = tuple(dict.fromkeys(visible(words) for edge in edges for words in edge.get("held_back", ())))
    observed, remark = marked.get("observed", ""), marked.get("remark", "")
    return Bundle(tail, head, conditional, visible(broken), details, observed, visible(remark), held_back)


def remarks(edges: list[dict[str, Any]]) -> list[str]:
    """What edges are otherwise when the system runs."""
    return [f"when it runs: {edge['remark']}" for edge in edges if edge.get("remark")]
