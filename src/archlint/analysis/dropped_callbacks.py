"""Callbacks of synchronizers that drop all that they get, for a message of theirs has no header."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.model import Role
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import System


def is_in_a_dropped_callback(system: System, place: Place) -> bool:
    """Whether a place is in a callback that only such synchronizers are given, and that the file does not call."""
    dropped = _dropped(system)
    function = source_code(system).function_at(place) if dropped else None
    return function is not None and Place.of(place.file, function.name_span) in dropped


@once
def _dropped(system: System) -> frozenset[Place]:
    dropped = {callback.place: callback.name.rpartition(".")[2] for callback in system.callbacks if callback.dropped}
    called = [callback for callback in system.callbacks if not callback.dropped and callback.role is not Role.METHOD]
    others = {callback.place for callback in called}
    return frozenset(place for place in dropped.keys() - others if not _calls(system, place, dropped[place]))


def _calls(system: System, place: Place, name: str) -> bool:
    code = source_code(system).facts_at(place.file)
    calls = everything_in([] if code is None else code.body, facts.Call)
    return any(called_name(call) == name for call in calls)


__all__ = ["is_in_a_dropped_callback"]
