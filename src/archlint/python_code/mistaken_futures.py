"""Futures of requests that code uses as if they were the answers: those of which it is certain."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.own_names import is_defined_somewhere
from archlint.analysis.reach import judged_notes
from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.model import Misuse
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.model import MistakenFuture
    from archlint.systems.model import System


def mistaken_futures(system: System) -> list[MistakenFuture]:
    """The futures that are used as answers, outside of test code, in the order of the source."""
    refused = judged_notes(system, lambda program: program.refused_calls)
    absent = {_start(call.place) for call in refused if call.misuse is Misuse.ABSENT}
    uses = {
        (use.place, use.attribute): use
        for use in judged_notes(system, lambda program: program.mistaken_futures)
        # Of methods that a future has not, API002 tells.
        if _start(use.place) not in absent and not _may_be_set(system, use)
    }
    return [uses[key] for key in sorted(uses)]


def _start(place: Place) -> tuple[str, int, int]:
    return place.file, place.line, place.column


def _may_be_set(system: System, use: MistakenFuture) -> bool:
    """Whether code may have given the future the attribute itself: not one that its answer has."""
    if not use.attribute or use.has_attribute:
        return False
    return is_defined_somewhere(system, use.place.file, use.attribute)


def returned_at(system: System, use: MistakenFuture) -> Place:
    """Where a handler returns a future; the call that gives it where that is not found."""
    code = source_code(system)
    sent = use.place
    names = {
        target.dotted
        for statement in statements_of(code.body_at(sent), facts.Assign)
        if Place.of(sent.file, getattr(statement.value, "span", (0, 0, 0, 0))) == sent
        for target in statement.targets
    } - {""}
    for end in statements_of(code.body_at(sent), facts.Return):
        if end.value is not None and end.value.dotted in names:
            return Place.of(sent.file, end.span)
    return sent


def function_of(system: System, place: Place) -> str:
    """The name of the function that holds a place; empty for none."""
    function = source_code(system).function_at(place)
    return "" if function is None else function.name


__all__ = ["function_of", "mistaken_futures", "returned_at"]
