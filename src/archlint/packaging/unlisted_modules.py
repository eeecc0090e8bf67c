"""Modules that could be programs as all others beside them are, if an entry point named them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed, starts_ros
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable


@dataclass(frozen=True)
class Unlisted:
    """A module of a package whose ``main`` is at a place; ``beside`` is the entry point of another module."""

    package: str
    module: str
    place: Place
    beside: Executable


def unlisted_modules(workspace: WorkspaceIndex) -> Iterator[Unlisted]:
    """The one module of a folder that no entry point names, where one does name each other with a ``main``."""
    for package in sorted(workspace.installs):
        installs = workspace.installs[package]
        entries = {row.module: row for row in installs.executables.values() if row.module and row.function == "main"}
        if entries and not installs.open_executables and package in workspace.packages:
            yield from _of_package(workspace, package, entries)


def _of_package(workspace: WorkspaceIndex, package: str, entries: dict[str, Executable]) -> Iterator[Unlisted]:
    folders: dict[str, dict[str, Place]] = {}
    for module, file in sorted(workspace.code.modules_of(package).items()):
        place = None if workspace.roles.is_test(file) else main_of(workspace, file)
        if place is not None and "." in module:
            folders.setdefault(posixpath.dirname(file), {})[module] = place
    for modules in folders.values():
        beside = [module for module in modules if module in entries]
        unlisted = [module for module in modules if module not in entries]
        if beside and len(unlisted) == 1:
            place = modules[unlisted[0]]
            if is_not_installed(workspace, place.file) and starts_ros(workspace, place.file):
                yield Unlisted(package, unlisted[0], place, entries[beside[0]])


def main_of(workspace: WorkspaceIndex, file: str) -> Place | None:
    """Where a module defines its function ``main``; None where it does not."""
    file_facts = workspace.facts_at(file)
    for statement in [] if file_facts is None else file_facts.body:
        if isinstance(statement, facts.Function) and statement.name == "main":
            return Place.of(file, statement.name_span)
    return None


__all__ = ["Unlisted", "main_of", "unlisted_modules"]
