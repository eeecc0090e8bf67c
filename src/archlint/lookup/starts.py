"""Where launch files mention executables, packages, nodes and other files, and where packages install programs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.parameter_sources import files_among
from archlint.lookup.mentions import Mention, Role, Subject
from archlint.place import Place
from archlint.syntax import facts
from archlint.systems.overrides import key_matches

if TYPE_CHECKING:
    from archlint.launch.model import Launched
    from archlint.launch.named_files import FileReference
    from archlint.launch.started import Started
    from archlint.model import Text
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


def mentions_of_starts(system: System, rank: int, workspace: WorkspaceIndex) -> Iterator[Mention]:
    """What a launch file starts, and which files it names."""
    launched = system.launched
    if launched is None:
        return
    nodes: dict[int, list[Node]] = {}
    for node in system.nodes:
        if node.started is not None:
            nodes.setdefault(id(node.started), []).append(node)
    for started in launched.started:
        yield from _of_started(started, nodes.get(id(started), []), rank)
    yield from _of_files(launched, rank)
    for node in system.nodes:
        yield from _of_sections(node, rank, workspace)


def _of_started(started: Started, nodes: list[Node], rank: int) -> Iterator[Mention]:
    package, executable = started.package.text, started.executable.text
    several: list[Node | None] = [*nodes]
    for node in several or [None]:
        if package is not None:
            yield from _at(started, "package", started.package, Subject("package", package), rank, node)
        if package is not None and executable is not None:
            program = Subject("executable", executable, package)
            yield from _at(started, "executable", started.executable, program, rank, node)
            yield Mention(started.place, program, "call", rank, node=node)
        if node is not None and node.name is not None and started.name is not None:
            yield from _at(started, "name", started.name, Subject("node", node.name), rank, node)


def _at(
    started: Started, argument: str, text: Text, subject: Subject, rank: int, node: Node | None
) -> Iterator[Mention]:
    role: Role = "start"
    for place in dict.fromkeys((started.places.get(argument), text.origin)):
        if place is not None:
            yield Mention(place, subject, role, rank, text.text if place == text.origin else None, node=node)


def _of_sections(node: Node, rank: int, workspace: WorkspaceIndex) -> Iterator[Mention]:
    """The keys of parameter files that name a node."""
    if node.started is None or node.name is None:
        return
    for use in files_among(node.started.parameters):
        sections = workspace.parameters_of(use.reference.source).sections if use.reference.source else ()
        for section in sections:
            if use.reference.source and "*" not in section.key and key_matches(section.key, node.name):
                place = Place.of(use.reference.source, section.span)
                yield Mention(place, Subject("node", node.name), "start", rank, section.written, node=node)


def references_of(launched: Launched) -> list[FileReference]:
    """The files that a launch names."""
    return list(dict.fromkeys([*launched.references, *(include.reference for include in launched.included)]))


def _of_files(launched: Launched, rank: int) -> Iterator[Mention]:
    for reference in references_of(launched):
        if reference.source is not None:
            subject = Subject("file", reference.source)
            for place in dict.fromkeys((reference.place, reference.given)):
                if place is not None:
                    yield Mention(place, subject, "start", rank)


def mentions_of_entries(workspace: WorkspaceIndex) -> Iterator[Mention]:
    """Where packages install their executables."""
    for package in sorted(workspace.installs):
        for name, executable in sorted(workspace.installs[package].executables.items()):
            if not executable.wrong:
                yield Mention(executable.place, Subject("executable", name, package), "entry", 0)


def main_of(workspace: WorkspaceIndex, package: str, name: str) -> Place | None:
    """The function that an executable runs, or the start of its script; None for one that is not here."""
    installs = workspace.installs.get(package)
    executable = None if installs is None else installs.executables.get(name)
    if executable is None:
        return None
    if executable.script is not None:
        return Place(executable.script, 1, 1, 1, 1)
    files = workspace.code.files_named(package, executable.module) if executable.module else []
    for file in files[:1]:
        read = workspace.facts_at(file)
        for statement in [] if read is None else read.body:
            match statement:
                case facts.Function(name=defined, name_span=span) if defined == executable.function:
                    return Place.of(file, span)
        return Place(file, 1, 1, 1, 1)
    return None


__all__ = ["main_of", "mentions_of_entries", "mentions_of_starts", "references_of"]
