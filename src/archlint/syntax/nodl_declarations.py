"""NoDL: what a ``*.nodl.xml`` declares of nodes, each entry with its place.

Source: ``nodl_python`` 0.3.1, ``_schemas/v1.xsd``.  It says nothing of quality of service and of defaults.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from xml.parsers import expat

from archlint.records import dataclass
from archlint.syntax.facts import Span
from archlint.syntax.interface_declarations import EndEntry, EndKey, InterfaceDocument, ParameterEntry

SUFFIX = ".nodl.xml"

_KEYS: Mapping[tuple[str, str], tuple[EndKey, ...]] = {
    ("topic", "publisher"): ("publishers",),
    ("topic", "subscription"): ("subscribers",),
    ("topic", "both"): ("publishers", "subscribers"),
    ("service", "server"): ("services",),
    ("service", "client"): ("service_clients",),
    ("service", "both"): ("services", "service_clients"),
    ("action", "server"): ("actions",),
    ("action", "client"): ("action_clients",),
    ("action", "both"): ("actions", "action_clients"),
}
_TYPES = {"integer": "int", "integer_array": "int_array"}
"""Types of parameters that ``interface.yaml`` calls otherwise."""


class _Refused(Exception):
    """A document that nobody needs, and that can do harm."""


@dataclass
class _Node:
    name: str
    span: Span
    ends: list[EndEntry] = field(default_factory=list)
    parameters: list[ParameterEntry] = field(default_factory=list)

    def document(self) -> InterfaceDocument:
        unsaid = frozenset() if self.parameters else frozenset({"parameters"})
        name = self.name.rpartition("/")[2]
        return InterfaceDocument(name, None, self.span, tuple(self.ends), tuple(self.parameters), unsaid, False)


def read_nodl(text: str) -> tuple[InterfaceDocument, ...]:
    """A document for each node; the first where several executables start it.  Nothing of what is no NoDL, and of nodes
    that have a name in common and nothing else: which of them is meant is not known."""
    nodes: list[_Node] = []
    tags: list[str] = []
    parser = expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        line, column = parser.CurrentLineNumber, parser.CurrentColumnNumber + 1
        span = (line, column, line, column + len(tag) + 1)
        if tags == ["interface"] and tag == "node":
            nodes.append(_Node(attributes.get("name", ""), span))
        elif tags == ["interface", "node"]:
            _note(nodes[-1], tag, attributes, span)
        tags.append(tag)

    def end(_: str) -> None:
        tags.pop()

    def refuse(*_: object) -> None:
        raise _Refused

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(text, True)
    except (expat.ExpatError, _Refused):
        return ()
    of_name: dict[str, list[InterfaceDocument]] = {}
    for document in (node.document() for node in nodes if node.name):
        of_name.setdefault(document.name, []).append(document)
    return tuple(alike[0] for alike in of_name.values() if len({*map(_content, alike)}) == 1)


def _content(document: InterfaceDocument) -> tuple[object, ...]:
    """What a document declares, without its place."""
    ends = frozenset((end.key, end.name, end.type) for end in document.ends)
    return ends, frozenset((parameter.name, parameter.type) for parameter in document.parameters)


def _note(node: _Node, tag: str, attributes: Mapping[str, str], span: Span) -> None:
    name, type_ = attributes.get("name"), attributes.get("type")
    if not name:
        return
    if tag == "parameter":
        node.parameters.append(ParameterEntry(name, type_ and _TYPES.get(type_, type_), (), span))
    for key in _KEYS.get((tag, attributes.get("role", "")), ()):
        node.ends.append(EndEntry(key, name, type_, {}, span))


__all__ = ["SUFFIX", "read_nodl"]
