"""The names of topics, services and actions that somebody may be about to write."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.lookup.answers import Completion
from archlint.lookup.index import PROVIDERS, Index
from archlint.lookup.known_nodes import nodes_started
from archlint.lookup.texts import Texts
from archlint.lookup.wanted import Wanted
from archlint.model import NAMED
from archlint.systems.nodes import Endpoint, Node


def names_wanted(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names of the same kind and type: as the code of a node in no namespace writes them, or in full where a slash
    is typed."""
    if wanted.entity is None:
        return
    kind, offers = NAMED[wanted.entity], wanted.entity in PROVIDERS
    in_full = wanted.typed.startswith("/")
    rows: dict[str, tuple[int, str]] = {}
    for end, is_open in _ends(index):
        name = end.name if in_full else _relative(end) if is_open else None
        if name is None or NAMED[end.kind] != kind or not _fits(end, wanted) or _is_here(end, wanted):
            continue
        rank = 0 if (end.kind in PROVIDERS) != offers else 1
        rows[name] = min(rows.get(name, (rank, end.type or "")), (rank, end.type or ""))
    for name, (rank, type_name) in rows.items():
        yield Completion(name, kind, type_name, wanted.replaces, rank)


def _relative(end: Endpoint) -> str | None:
    """The name as another node writes it: a private one is private to its own."""
    written = end.written
    return end.name.removeprefix("/") if end.name and written and written.startswith("~") else written


def _ends(index: Index) -> Iterator[tuple[Endpoint, bool]]:
    """The endpoints with known names, and whether each is one of the code alone."""
    for system, _ in index.systems:
        for end in system.endpoints:
            if end.resolved and not end.error and not end.node.test:
                yield end, system.name is None


def _fits(end: Endpoint, wanted: Wanted) -> bool:
    """Whether an endpoint may be of the type that is wanted: the whole of it, or its last part, is known."""
    if not wanted.type or end.type is None:
        return True
    return end.type == wanted.type if "/" in wanted.type else end.type.rpartition("/")[2] == wanted.type


def _is_here(end: Endpoint, wanted: Wanted) -> bool:
    """Whether an endpoint is that of the half-typed name itself."""
    at, place = wanted.replaces, end.place
    return place.file == at.file and place.line <= at.line <= place.end_line


def names_to_remap(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names that the node itself gives to what it creates."""
    for node in nodes_started(index, wanted.package, wanted.executable):
        for end in _resolved(node):
            if end.written is not None:
                yield Completion(end.written, NAMED[end.kind], end.type or "", wanted.replaces)


def names_to_remap_to(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The names that there are."""
    for end, _ in _ends(index):
        if end.name is not None:
            yield Completion(end.name, NAMED[end.kind], end.type or "", wanted.replaces)


def _resolved(node: Node) -> Iterator[Endpoint]:
    return (end for end in node.endpoints if end.resolved and not end.error)


__all__ = ["names_to_remap", "names_to_remap_to", "names_wanted"]
