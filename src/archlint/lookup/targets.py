"""Where a name leads: to its other end, to the file or function that it stands for, and to all its mentions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.lookup.index import PROVIDERS, Index
from archlint.lookup.mentions import Mention, Role, Subject
from archlint.lookup.moved import Moves
from archlint.lookup.starts import main_of
from archlint.lookup.texts import Texts
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.systems.nodes import Endpoint


def definition(index: Index, texts: Texts, file: str, line: int, column: int) -> list[Place]:
    """Where the name at a position leads.

    From a publisher to the subscriptions and back, from a client to its server, from a remapping to the create call,
    from where a parameter is read or set to its declaration and from there to what sets it, from an executable to the
    function that it runs, from an include to the file, from a type to its definition.
    """
    mentions = index.at(texts, file, line, column)
    return _sorted(index, texts, (place for mention in mentions for place in places_meant(index, mention)))


def references(index: Index, texts: Texts, file: str, line: int, column: int) -> list[Place]:
    """All places that mention what is mentioned at a position."""
    subjects = dict.fromkeys(mention.subject for mention in index.at(texts, file, line, column))
    every = (mention for subject in subjects for mention in index.of(subject))
    named = (mention.place for mention in every if mention.role != "call" or _stands_for_name(mention))
    return _sorted(index, texts, named)


def _stands_for_name(mention: Mention) -> bool:
    """Whether no argument of a create call is the name, so that the call itself stands for it."""
    return mention.end is not None and mention.end.creation.name_place is None


def places_meant(index: Index, mention: Mention) -> Iterator[Place]:
    """Where one mention leads."""
    subject = mention.subject
    match subject.kind:
        case "topic" | "service" | "action":
            yield from _ends(index, mention)
        case "parameter":
            yield from _of_parameter(index, mention)
        case "executable":
            main = main_of(index.workspace, subject.owner, subject.name)
            if main is not None:
                yield main
        case "node":
            if mention.node is not None and mention.node.blueprint is not None:
                yield mention.node.blueprint.place
        case "file":
            yield Place(subject.name, 1, 1, 1, 1)
        case "package":
            manifest = index.workspace.packages.get(subject.name)
            if manifest is not None:
                yield Place(manifest.manifest.relative, 1, 1, 1, 1)
        case "interface":
            yield from _of_interface(index, subject)


def _ends(index: Index, mention: Mention) -> Iterator[Place]:
    end = mention.end
    if end is not None and mention.role in ("remap source", "remap target", "value"):
        yield named_at(end)
        return
    providers, users = index.ends_of(mention.subject)
    others = [*providers, *users] if end is None else users if end.kind in PROVIDERS else providers
    yield from (named_at(other.end) for other in others if other.end is not None)


def named_at(end: Endpoint) -> Place:
    """The argument of the create call that is the name, or all of the call."""
    return end.creation.name_place or end.place


def _of_parameter(index: Index, mention: Mention) -> Iterator[Place]:
    """The declarations; of a declaration itself what sets the parameter, or else what reads it."""
    every = index.of(mention.subject)
    wanted: tuple[Role, ...] = ("set", "get") if mention.role in ("declare", "call") else ("declare",)
    rows = [[other.place for other in every if other.role == role] for role in wanted]
    yield from next((places for places in rows if places), [])


def _of_interface(index: Index, subject: Subject) -> Iterator[Place]:
    table = index.workspace.interfaces
    source = None if table is None else table.file(subject.name)
    if source is not None:
        yield Place(source.relative, 1, 1, 1, 1)


def _sorted(index: Index, texts: Texts, places: Iterable[Place]) -> list[Place]:
    return Moves(index.texts, texts).places_now(sorted(set(places)))


__all__ = ["definition", "named_at", "places_meant", "references"]
