"""The ends of connections as they run, each with the places whose texts give it its name."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.lookup.ends import remap_of, rule_of
from archlint.lookup.index import Index
from archlint.lookup.mentions import Subject
from archlint.lookup.texts import Texts
from archlint.model import NAMED
from archlint.records import dataclass
from archlint.ros import names
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.model import Text
    from archlint.place import Place
    from archlint.systems.nodes import Endpoint, Node


@dataclass(frozen=True)
class Written:
    """A name as a file has it; ``place`` is without the quotes."""

    place: Place
    text: str


@dataclass(frozen=True, eq=False)
class Instance:
    """One end of a topic, service or action in one system.

    ``node`` is the name and the namespace that its relative names are below; None where they are not known.  The
    ``literals`` say the same name, each for a case: a parameter's value and its default.  Where a launch file renames
    it, it has a ``source`` and a ``target``.  They are None, and the literals none, where the text does not stand
    anywhere as it is.
    """

    kind: ConnectionKind
    name: str
    place: Place
    node: tuple[str, str] | None
    end: Endpoint | None
    literals: tuple[Written, ...] = ()
    is_remapped: bool = False
    source: Written | None = None
    target: Written | None = None

    def expand(self, text: str) -> str | None:
        """The full name that a text has there; None for a relative one of a node that is not known."""
        if self.node is None:
            return text if text.startswith("/") and names.validate_topic_name(text) is None else None
        full = names.expand(text, *self.node)
        return full if isinstance(full, str) and names.validate_full_name(full) is None else None

    def spelled(self, full: str, as_before: str, wish: str | None) -> str | None:
        """A text that means a full name there: the one that was wished for, or one of the form that it had before."""
        own = None if self.node is None else names.join(self.node[1], self.node[0])
        namespace = "/" if self.node is None else self.node[1].rstrip("/") + "/"
        private = f"~{full.removeprefix(own)}" if own is not None and full.startswith(f"{own}/") else full
        relative = full.removeprefix(namespace) if full.startswith(namespace) else full
        form = full if as_before.startswith("/") else private if as_before.startswith("~") else relative
        return next((text for text in (wish, form, full) if text is not None and self.expand(text) == full), None)


@once
def instances(index: Index) -> list[Instance]:
    """The ends with known names: those of a node in the systems that count most for it."""
    best: dict[object, int] = {}
    for system, rank in index.systems:
        for node in system.entries:
            best[_key(node)] = min(rank, best.get(_key(node), rank))
    rows: list[Instance] = []
    for system, rank in index.systems:
        for node in system.entries:
            if best[_key(node)] == rank:
                rows += (_instance(index, end) for end in node.endpoints if _is_named(end))
                rows += _of_external(index.texts, node)
    return rows


def _is_named(end: Endpoint) -> bool:
    """Whether an end has a known name; the remappings of nodes whose source is not here are instances themselves."""
    return end.resolved and not end.error and not (end.external and rule_of(end) is not None)


def unknown_ends(index: Index) -> Iterator[Endpoint]:
    """The ends whose names are not known, or only in part."""
    for system, _ in index.systems:
        yield from (end for end in system.endpoints if not end.resolved and not end.error)


def _key(node: Node) -> object:
    return node.name if node.blueprint is None else key_of(node.blueprint)


def _instance(index: Index, end: Endpoint) -> Instance:
    remap = remap_of(end)
    return Instance(
        NAMED[end.kind],
        end.name or "",
        end.place,
        _own(end.node),
        end,
        tuple(_literals(index, end)),
        rule_of(end) is not None,
        None if remap is None else _written(index.texts, remap.source),
        None if remap is None else _written(index.texts, remap.target),
    )


def _own(node: Node) -> tuple[str, str] | None:
    own = node.own
    if own is None or own.resolution not in ("exact", "parameter") or not node.is_node:
        return None
    return (own.name.text or "", own.namespace.text or "/")


def _written(texts: Texts, text: Text) -> Written | None:
    if text.origin is None or text.text is None:
        return None
    place = texts.name_at(text.origin, text.text)
    return None if place is None else Written(place, text.text)


def _literals(index: Index, end: Endpoint) -> Iterable[Written]:
    own = _written(index.texts, end.creation.name)
    if end.parameter is None or end.parameter not in end.node.overrides:
        return [] if own is None else [own]
    rows = index.of(Subject(NAMED[end.kind], end.name or ""))
    values = [row for row in rows if row.role == "value" and row.end is end and row.written is not None]
    if not values:
        return []
    return [*(Written(row.place, row.written or "") for row in values), *([] if own is None else [own])]


def _of_external(texts: Texts, node: Node) -> Iterator[Instance]:
    """What a launch file renames on a node whose source is not here: of any kind."""
    if not node.external or node.started is None or node.name is None:
        return
    namespace, _, own = node.name.rpartition("/")
    for remap in node.started.remaps:
        target = _written(texts, remap.target)
        if target is not None:
            for kind in ("topic", "service", "action"):
                unnamed = Instance(kind, "", remap.place, (own, namespace or "/"), None, (), True, None, target)
                full = unnamed.expand(target.text)
                if full is not None:
                    yield replace(unnamed, name=full)


__all__ = ["Instance", "Written", "instances", "unknown_ends"]
