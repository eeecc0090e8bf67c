"""Nodes of one name in one picture, told apart by what they do not have in common."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from archlint.render.diagram.model import Key, Shape
    from archlint.systems.nodes import Node


def told_apart(shapes: Mapping[Key, Shape], nodes: Mapping[Key, Node]) -> dict[Key, Shape]:
    """The nodes that share their name with others, each with a line of what it alone has: its package, its class
    or its file.  What has nothing of the kind, or shares all of it, stays as it is."""
    namesakes: dict[str, list[Key]] = {}
    for key in nodes:
        namesakes.setdefault(shapes[key].title, []).append(key)
    told: dict[Key, Shape] = {}
    for keys in namesakes.values():
        if len(keys) > 1:
            words = _words([nodes[key] for key in keys])
            told |= {
                key: replace(shapes[key], lines=(*shapes[key].lines, visible(word)))
                for key, word in zip(keys, words, strict=True)
                if word
            }
    return told


def _words(nodes: Sequence[Node]) -> list[str]:
    """What tells all of them apart, or else what tells most; nothing where they have all of it in common."""
    ways = [[way(node) for node in nodes] for way in _WAYS]
    best = max(ways, key=lambda words: len({*words}))
    return best if len({*best}) > 1 else [""] * len(nodes)


def _package(node: Node) -> str:
    return node.package or ""


def _class(node: Node) -> str:
    return node.blueprint.class_name if node.blueprint is not None else node.executable or ""


def _file(node: Node) -> str:
    return node.blueprint.place.file.rpartition("/")[2] if node.blueprint is not None else ""


def _file_in_package(node: Node) -> str:
    return f"{_package(node)}: {_file(node)}".strip(": ")


def _line(node: Node) -> str:
    """The last of all: the line of the class or the call that makes the node."""
    return f"{_file_in_package(node)}:{node.blueprint.place.line}" if node.blueprint is not None else ""


_WAYS: Sequence[Callable[[Node], str]] = (_package, _class, _file, _file_in_package, _line)

__all__ = ["told_apart"]
