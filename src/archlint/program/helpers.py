"""Helpers: classes and functions that work on a node which they are handed.

Each is also tried alone, with a node that is not known, so that no create call is missed.  Where other code hands it
a node, that node has its endpoints, and what was tried says nothing more.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

from archlint.finding import Place
from archlint.program import model

_Made = TypeVar("_Made", model.Creation, model.ParameterDeclaration)


def settle_helpers(programs: Sequence[model.Program]) -> None:
    """Drop what helpers create on nodes that are not known, where a known node has it; then the empty ones."""
    nodes = [node for program in programs for node in program.nodes]
    owned = _names_by_place(creation for node in nodes if not node.held for creation in node.creations)
    declared = _names_by_place(parameter for node in nodes if not node.held for parameter in node.parameters)
    for node in nodes:
        if node.held:
            node.creations = [one for one in node.creations if not _is_known(one, owned)]
            node.parameters = [one for one in node.parameters if not _is_known(one, declared)]
    for program in programs:
        program.nodes[:] = [node for node in program.nodes if not _is_nothing(node, program)]


def _is_nothing(node: model.Blueprint, program: model.Program) -> bool:
    """Whether there is nothing to say of it: no endpoint or parameter, of a helper or of an object that runs its
    own constructor and never that of its base, rclpy's Node."""
    unmade = node.name.reason == model.NEVER_CONSTRUCTED and not program.exhausted and node.complete
    return (node.held or unmade) and not node.creations and not node.parameters


def _names_by_place(made: Iterable[_Made]) -> dict[Place, set[str | None]]:
    found: dict[Place, set[str | None]] = {}
    for one in made:
        found.setdefault(one.place, set()).add(one.name.text)
    return found


def _is_known(made: _Made, owned: dict[Place, set[str | None]]) -> bool:
    """Whether a known node has what one line creates: under this name, or where the name is that of a caller."""
    names = owned.get(made.place)
    return names is not None and (made.name.text in names or made.name.resolution in ("partial", "unknown"))


__all__ = ["settle_helpers"]
