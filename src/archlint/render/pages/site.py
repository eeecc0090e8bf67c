"""Which pages there are, and how they refer to each other and to the sources."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, TypeVar

from archlint.records import dataclass
from archlint.render.markdown import code, link, text
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

INDEX = "README.md"
"""What GitHub shows with a folder."""
_NODES, _SYSTEMS = "nodes", "systems"
"""The folders of the pages."""

_Subject = TypeVar("_Subject", "Node", "System")


@dataclass(frozen=True, eq=False)
class Site:
    """The pages of some systems: what each path, from the folder of all pages, is about."""

    nodes: Mapping[str, Node]
    systems: Mapping[str, System]
    opened: Sequence[System]
    """The systems of all code, one for each workspace."""
    to_sources: str
    """The way from the folder of the pages to the one that the paths of sources start in."""
    pages: Mapping[object, str]
    """The page of a node, by what it is known by (:func:`_keys`)."""

    def page_of(self, node: Node) -> str | None:
        """The page about a node as its code makes it; None of one whose source is not here, and of test code."""
        return next((self.pages[key] for key in _keys(node) if key in self.pages), None)

    def node_link(self, node: Node, page: str) -> str:
        """A node, as the page mentions it."""
        label = code(node.name) if node.name is not None else f"{called(node)} (name not known)"
        target = self.page_of(node)
        return label if target is None else link(label, _between(page, target))

    def node_links(self, nodes: Iterable[Node], page: str) -> str:
        """Several nodes, each once, by their names."""
        return ", ".join(dict.fromkeys(self.node_link(node, page) for node in sorted(nodes, key=_order)))

    def system_link(self, target: str, page: str) -> str:
        """A launch file, as a page mentions it."""
        return link(code(self.systems[target].name or ""), _between(page, target))

    def source_link(self, place: Place, page: str) -> str:
        """A place in the source, by the name of its file."""
        label = text(f"{PurePath(place.file).name}:{place.line}")
        return link(label, self._way_to(place.file, page), place.line)

    def file_link(self, file: str, page: str) -> str:
        """A file of the sources, by its path."""
        return link(code(PurePath(file).as_posix()), self._way_to(file, page))

    def _way_to(self, file: str, page: str) -> str:
        path = PurePath(file).as_posix()
        # From the folder of all pages, which is so deep that no way out of it is cut short.
        return posixpath.normpath(posixpath.join("../" * page.count("/"), self.to_sources, path))


def site_of(opened: Sequence[System], launched: Sequence[System], to_sources: str) -> Site:
    """The pages of the nodes of these systems and of these launch files.

    A node has one page, as its code makes it, however many launch files start it; test code has none.
    """
    ours = [node for system in opened for node in sorted(system.nodes, key=_order) if _has_page(node)]
    known = {key for node in ours for key in _keys(node)}
    for system in launched:
        for node in sorted(system.nodes, key=_order):
            if _has_page(node) and known.isdisjoint(_keys(node)):
                ours.append(node)
                known.update(_keys(node))
    nodes = _named(_NODES, sorted(ours, key=_order), _names_of_node)
    systems = _named(_SYSTEMS, sorted(launched, key=lambda system: system.name or ""), _names_of_system)
    pages: dict[object, str] = {}
    for page, node in nodes.items():
        for key in _keys(node):
            pages.setdefault(key, page)
    return Site(nodes, systems, opened, to_sources, pages)


def _has_page(node: Node) -> bool:
    return node.blueprint is not None and not node.test


def _keys(node: Node) -> Iterator[object]:
    """What a node is known by in all systems: its class, its executable and its name, the closest first."""
    if node.blueprint is None:
        return
    key = key_of(node.blueprint)
    executables = sorted({*node.executables, node.executable or ""})
    yield from ((key, executable, node.name) for executable in executables)
    yield from ((key, executable) for executable in executables)
    yield key


def _order(node: Node) -> tuple[str, str, str, int]:
    place = None if node.blueprint is None else node.blueprint.place
    return (node.package or "", node.name or "", *(("", 0) if place is None else (place.file, place.line)))


def _named(folder: str, subjects: Iterable[_Subject], names: Callable[[_Subject], list[str]]) -> dict[str, _Subject]:
    """The subjects by the paths of their pages: the first of the names that is free, else with a number.

    Paths that differ in their case only are one file on some disks.
    """
    pages: dict[str, _Subject] = {}
    taken: set[str] = set()
    for subject in subjects:
        options = names(subject)
        options += [f"{options[-1]}.{number}" for number in range(2, len(taken) + 3)]
        name = next(option for option in options if option.casefold() not in taken)
        taken.add(name.casefold())
        pages[f"{folder}/{name}.md"] = subject
    return pages


def _names_of_node(node: Node) -> list[str]:
    blueprint = node.blueprint
    assert blueprint is not None
    own = (node.name or "").rpartition("/")[2] or blueprint.class_name
    package = [_slug(node.package)] if node.package else []
    return [".".join([*package, *parts]) for parts in ([_slug(own)], [_slug(own), _slug(blueprint.class_name)])]


def _names_of_system(system: System) -> list[str]:
    path = PurePath(system.name or "")
    short = _slug(path.name)
    return [short, ".".join([*(_slug(part) for part in path.parts[-3:-1] if part != "launch"), short])]


def _slug(words: str) -> str:
    """A part of a file name that every disk takes."""
    return re.sub(r"[^A-Za-z0-9_.-]+", "-", words).strip("-.")[:80] or "unnamed"


def _between(page: str, target: str) -> str:
    """The way from a page to another one."""
    return posixpath.relpath(target, posixpath.dirname(page) or ".")


def called(node: Node) -> str:
    """What a node without a known name is called: its class or executable."""
    return code(node.blueprint.class_name if node.blueprint is not None else node.executable or "?")


__all__ = ["INDEX", "Site", "called", "site_of"]
