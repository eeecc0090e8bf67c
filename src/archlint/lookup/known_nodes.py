"""The nodes that a place is about: those of a class, of an executable, of a section of a parameter file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.lookup.index import Index
from archlint.lookup.texts import Texts
from archlint.systems.overrides import key_matches

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.nodes import Node

_CLASS = re.compile(r"class\s+(\w+)")


def nodes_in_file(index: Index, texts: Texts, place: Place) -> list[Node]:
    """The nodes whose class, or a base of it, is in a file: of the class around a place, or else of any."""
    nodes = [node for node in _nodes(index) if any(file == place.file for file, _ in _classes(node))]
    around = _class_around(texts, place)
    own = [node for node in nodes if (place.file, around) in _classes(node)]
    return own or nodes


def _classes(node: Node) -> list[tuple[str, str]]:
    """The files and names of a node's class and its bases."""
    classes = (cls for blueprint in node.blueprints for cls in blueprint.classes)
    own = [(blueprint.place.file, blueprint.class_name) for blueprint in node.blueprints]
    return [*own, *((cls.place.file, cls.name) for cls in classes)]


def _class_around(texts: Texts, place: Place) -> str:
    """The name of the last class above a place that starts at the left margin."""
    for number in range(place.line, 0, -1):
        match = _CLASS.match(texts.line(place.file, number))
        if match is not None:
            return match[1]
    return ""


def nodes_started(index: Index, package: str, executable: str) -> list[Node]:
    """The nodes of an executable; none where it is not known which."""
    if not package or not executable:
        return []
    return [
        node
        for node in _nodes(index)
        if node.package == package and (executable == node.executable or executable in node.executables)
    ]


def nodes_of_key(index: Index, key: str) -> list[Node]:
    """The nodes that a key of a parameter file is for, where their names are known."""
    return [node for node in _nodes(index) if node.name is not None and key_matches(key, node.name)]


def _nodes(index: Index) -> Iterator[Node]:
    return (node for system, _ in index.systems for node in system.nodes)


__all__ = ["nodes_in_file", "nodes_of_key", "nodes_started"]
