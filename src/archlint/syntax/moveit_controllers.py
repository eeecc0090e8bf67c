"""The controllers that a file names for MoveIt's simple controller manager.

Source: ``MoveItSimpleControllerManager::initialize`` of moveit_simple_controller_manager, branches humble to main: it
passes over a controller of ``controller_names`` that lacks one of three parameters, and says so in the log.
"""

from __future__ import annotations

from typing import NamedTuple

from archlint.syntax.facts import Span
from archlint.syntax.safe_yaml import YamlError, YamlReader, span_of

MANAGER = "moveit_simple_controller_manager"
_NAMES = "controller_names"
_NEEDED = ("action_ns", "type", "joints")


class PassedOver(NamedTuple):
    """A listed controller, what its entry lacks, and where that stands."""

    name: str
    lacking: tuple[str, ...]
    span: Span


def passed_over(text: str) -> list[PassedOver]:
    """Those of a file that have an entry with something in it; none where the file cannot be read."""
    try:
        reader = YamlReader(text)
        rows: list[PassedOver] = []
        for key, _, manager in [] if reader.root is None else reader.pairs(reader.root, 0):
            entries = {} if key != MANAGER else {name: (at, node) for name, at, node in reader.pairs(manager, 1)}
            names = reader.value(entries[_NAMES][1]) if _NAMES in entries else []
            for name in (name for name in names if name in entries):
                at, node = entries[name]
                given = {parameter for parameter, _, _ in reader.pairs(node, 2)}
                lacking = tuple(parameter for parameter in _NEEDED if parameter not in given)
                rows += [PassedOver(name, lacking, span_of(at))] if given and lacking else []
        return rows
    except (YamlError, RecursionError, TypeError):
        return []


__all__ = ["MANAGER", "PassedOver", "passed_over"]
