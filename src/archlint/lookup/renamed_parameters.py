"""What has to change with the name of a parameter: its declaration, what reads it and what sets it, or nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import always_declared
from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention, Subject
from archlint.lookup.renamed_names import CannotRename
from archlint.lookup.values import READING, owner_of
from archlint.lookup.words import code, where
from archlint.model.given import Constant
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.systems.overrides import key_matches

if TYPE_CHECKING:
    from archlint.systems.nodes import Node

_BY_OTHER_MEANS = frozenset({"get_parameters_by_prefix", "SetParameters", "AsyncParameterClient", "ParameterValue"})
"""What names parameters in ways that are not followed."""


def parameter_texts(index: Index, start: Mention, new: str) -> dict[Place, str]:
    """The new texts by their places, without quotes.  Raises :class:`CannotRename`."""
    name = start.subject.name
    if not new or any(character.isspace() for character in new) or new.startswith(".") or new.endswith("."):
        raise CannotRename(f"{code(new)} is no name of a parameter")
    if always_declared(name):
        raise CannotRename(f"rclpy itself declares {code(name)}")
    mentions = _related(index, start.subject)
    owners = {mention.subject.owner for mention in mentions}
    nodes = [node for node in _nodes(index) if any(owner_of(b) in owners for b in node.blueprints)]
    if not any(mention.role == "declare" for mention in mentions):
        raise CannotRename(f"nothing in this workspace declares {code(name)}", start.place)
    _refuse_taken(nodes, new)
    _refuse_unknown(index, nodes)
    texts = {}
    for mention in mentions:
        if mention.role not in ("call", "argument"):
            place, text = _edit(index, mention, new)
            texts[place] = text
    _refuse_other_uses(index, nodes, name, {mention.place for mention in mentions})
    lines = {(mention.place.file, mention.place.line) for mention in mentions}
    for place in _of_other_files(index, nodes, name):
        if (place.file, place.line) not in lines:
            raise CannotRename(
                f"{code(name)} is set at {where(place)}, too, in a file that no launch file loads", place
            )
    return texts


def _related(index: Index, subject: Subject) -> list[Mention]:
    """The mentions of a parameter, and of the same parameter of classes with the same declaration."""
    seen: dict[Subject, None] = {subject: None}
    mentions: list[Mention] = []
    for each in _in_turn(seen):
        for mention in index.of(each):
            mentions.append(mention)
            here = index.in_file(mention.place.file)
            for other in here:
                if other.place == mention.place and other.subject.kind == "parameter":
                    seen.setdefault(other.subject)
    return mentions


def _in_turn(seen: dict[Subject, None]) -> Iterator[Subject]:
    """What a dict has and gets on the way, each once."""
    number = 0
    while number < len(seen):
        yield list(seen)[number]
        number += 1


def _edit(index: Index, mention: Mention, new: str) -> tuple[Place, str]:
    name, written = mention.subject.name, mention.written
    place = None if written is None else index.texts.name_at(mention.place, written)
    if place is None or written is None:
        raise CannotRename(f"{code(name)} is not written at {where(mention.place)} as a plain text", mention.place)
    if written == name:
        return place, new
    above = name.removesuffix(written)
    if not new.startswith(above) or "." in new.removeprefix(above):
        raise CannotRename(f"{code(new)} cannot be written at {where(place)}, below {code(above.rstrip('.'))}", place)
    return place, new.removeprefix(above)


def _nodes(index: Index) -> Iterator[Node]:
    return (node for system, _ in index.systems for node in system.entries)


def _refuse_taken(nodes: Iterable[Node], new: str) -> None:
    for declaration in (declaration for node in nodes for declaration in node.parameters):
        if declaration.name.text == new:
            raise CannotRename(f"{code(new)} is declared already, at {where(declaration.place)}", declaration.place)


def _refuse_unknown(index: Index, nodes: Sequence[Node]) -> None:
    """Parameters of the same nodes whose names are not known, or are texts that the code computes."""
    for declaration in (declaration for node in nodes for declaration in node.parameters):
        if declaration.name.text is None or declaration.name.resolution not in ("exact", "parameter"):
            raise CannotRename(
                f"the name that is declared at {where(declaration.place)} is not known", declaration.place
            )
    blueprints = {id(blueprint) for node in nodes for blueprint in node.blueprints}
    for system, _ in index.systems:
        for call in system.calls:
            if call.api in READING and id(call.node) in blueprints:
                match call.arguments.get("name"):
                    case Constant(value=str()):
                        pass
                    case _:
                        raise CannotRename(f"the name that is read at {where(call.place)} is not known", call.place)


def _refuse_other_uses(index: Index, nodes: Sequence[Node], name: str, known: set[Place]) -> None:
    """The text in the files of the nodes, where nothing says that it is not the parameter, and in code that reaches
    parameters of other nodes."""
    blueprints = [blueprint for node in nodes for blueprint in node.blueprints]
    files = {blueprint.place.file for blueprint in blueprints}
    files.update(cls.place.file for blueprint in blueprints for cls in blueprint.classes)
    others = index.workspace.code.files_that_mention(name.rpartition(".")[2])
    for file in sorted({*files, *others}):
        read = index.workspace.facts_at(file)
        if read is None or (file not in files and _BY_OTHER_MEANS.isdisjoint(read.names)):
            continue
        for literal in everything_in(read.body, facts.Literal):
            place = Place.of(file, literal.span)
            if literal.text == name and place not in known:
                raise CannotRename(
                    f"{code(name)} stands at {where(place)}, too, and what that means is not known", place
                )
        if file in files and "." in name and "get_parameters_by_prefix" in read.names:
            raise CannotRename(f"{file} reads parameters by their prefixes", Place(file, 1, 1, 1, 1))


def _of_other_files(index: Index, nodes: Sequence[Node], name: str) -> Iterator[Place]:
    """Where parameter files that no launch file loads set a parameter of these nodes."""
    tree, mentions = index.workspace.tree, index.workspace.code.mentions
    names = sorted({node.name for node in nodes if node.name is not None})
    for file in sorted({path for folder in index.workspace.manifests for path in tree.files_below(folder)}):
        if not file.endswith((".yaml", ".yml")) or not mentions(file, name.rpartition(".")[2]):
            continue
        for section in index.workspace.parameters_of(file).sections:
            if any(key_matches(section.key, node) for node in names):
                yield from (Place.of(file, entry.span) for entry in section.entries if entry.name == name)


__all__ = ["parameter_texts"]
