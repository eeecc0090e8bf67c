"""Which parameters a node declares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.completeness import in_sight
from archlint.analysis.cpp_nodes import CPP_SOURCES
from archlint.analysis.kept import once

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node

_ALWAYS = frozenset({"use_sim_time", "start_type_description_service"})
"""Parameters that rclpy declares for every node."""


def always_declared(name: str) -> bool:
    return name in _ALWAYS or name.startswith("qos_overrides.")


def declared_by(node: Node) -> dict[str, list[ParameterDeclaration]] | None:
    """The declarations of a node by name; None where not all of them can be known."""
    by_name: dict[str, list[ParameterDeclaration]] = {}
    for blueprint in node.blueprints:
        if blueprint.allow_undeclared_parameters or blueprint.automatically_declare_parameters:
            return None
        for declaration in blueprint.parameters:
            name = declaration.name
            if name.text is None or name.resolution not in ("exact", "parameter"):
                return None
            by_name.setdefault(name.text, []).append(declaration)
    return by_name


def followed(node: Node) -> bool:
    """Whether no code from elsewhere has the node, which may declare, read and set what it likes, and what is known
    of it fits what the launch file says."""
    return node.doubt is None and all(in_sight(blueprint) for blueprint in node.blueprints)


def is_judged(system: System, node: Node, name: str) -> bool:
    """Whether it is known that a node has no parameter of a name but those that are seen: it was followed, or only in
    part since it has too much code, and no code of its package, or of those that this one needs, has the word, or a
    part of it that names may be put together of, as in ``stream + "_enable"``."""
    if followed(node):
        return True
    cut_short = node.doubt is None and node.program is not None and node.program.exhausted
    if not cut_short or any(blueprint.escapes or len(blueprint.gaps) > 1 for blueprint in node.blueprints):
        return False  # the one gap is that
    return not any(_stands_in_code(system, node.package, word) for word in parts_of_name(name.rpartition(".")[2]))


def parts_of_name(word: str) -> list[str]:
    """A name, and its beginnings and ends at each underscore, with which code may put it together."""
    at = [number for number, letter in enumerate(word) if letter == "_" and 0 < number < len(word) - 1]
    return [word, *(part for number in at for part in (word[: number + 1], word[number:]))]


def _stands_in_code(system: System, package: str | None, word: str) -> bool:
    workspace = system.workspace
    if workspace is None or package is None:
        return True
    return any(
        workspace.code.mentions(path, word) for name in _needed(system, package) for path in _code(workspace, name)
    )


def _needed(system: System, package: str) -> list[str]:
    return [package, *sorted(system.package_dependencies.get(package, ()))]


def _code(workspace: WorkspaceIndex, package: str) -> Iterator[str]:
    """The sources of a package, but for launch files."""
    yield from workspace.code.files_of(package)
    if package in workspace.packages:
        below = workspace.tree.files_below(workspace.packages[package].relative)
        yield from (path for path in below if path.endswith((".h", ".hh", ".hxx", *CPP_SOURCES)))


def names_in_package(workspace: WorkspaceIndex | None, package: str | None) -> set[str]:
    """The names that the nodes of a package declare."""
    return set() if workspace is None else _names_by_package(workspace).get(package, set())


@once
def _names_by_package(workspace: WorkspaceIndex) -> Mapping[str | None, set[str]]:
    names: dict[str | None, set[str]] = {}
    for node in (node for system in workspace.systems if system.launched is None for node in system.nodes):
        names.setdefault(node.package, set()).update(declared_by(node) or ())
    return names
