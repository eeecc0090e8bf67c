"""Spins that a run does not come to, as it follows one round of a loop: what a later round does may lead there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.execution.spins import METHODS_THAT_SPIN
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.model import Blueprint, Program
    from archlint.systems.model import System

_SET_BEFORE = frozenset({"__init__", "__fields__"})


def may_be_spun_later(system: System, program: Program, node: Blueprint) -> bool:
    """Whether a loop near a node spins in a branch that no round which was followed takes."""
    if system.workspace is None:
        return False
    files = sorted({program.file, node.place.file, (node.made_at or node.place).file})
    rows = {Place.of(file, span) for file in files for span in _spins_of_later_rounds(system.workspace, file) or ()}
    return not rows <= {call.place for call in program.calls}


@once_for_each_file
def _spins_of_later_rounds(code: facts.Facts) -> tuple[facts.Span, ...]:
    """Where a file spins in a branch of a loop whose test asks for something that is changed as the program runs."""
    changed = _changed_names(code)
    loops: list[facts.While | facts.For] = [*everything_in(code.body, facts.While)]
    loops += everything_in(code.body, facts.For)
    return tuple(
        call.span
        for loop in loops
        for branch in everything_in(loop.body, facts.If)
        if not changed.isdisjoint(names_in(branch.test))
        for call in everything_in((*branch.body, *branch.orelse), facts.Call)
        if called_name(call) in METHODS_THAT_SPIN
    )


def _changed_names(code: facts.Facts) -> frozenset[str]:
    """The variables and attributes that functions other than constructors assign."""
    functions = (each for each in everything_in(code.body, facts.Function) if each.name not in _SET_BEFORE)
    return frozenset(
        target.last_name
        for function in functions
        for statement in everything_in(function.body, facts.Statement)
        for target in statement.assigned
        if target.last_name
    )


__all__ = ["may_be_spun_later"]
