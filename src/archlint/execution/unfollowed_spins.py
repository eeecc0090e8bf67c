"""Spins that a run does not come to: it follows one round of a loop, and what a later round does may lead there, or a
branch that is not taken, as yet, spins the node that an attribute holds."""

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
    """Whether a loop near a node spins in a branch that no round which was followed takes, or a line that no run comes
    to spins what has the name that the node is given where it is made."""
    if system.workspace is None:
        return False
    made_at = node.made_at or node.place
    files = sorted({program.file, node.place.file, made_at.file})
    rows = {Place.of(file, span) for file in files for span in _spins_of_later_rounds(system.workspace, file) or ()}
    code = system.workspace.facts_at(made_at.file)
    names = frozenset[str]() if code is None else _names_given(code, made_at.span)
    rows |= {
        Place.of(made_at.file, span)
        for name, span in _spins_by_name(system.workspace, made_at.file) or ()
        if name in names
    }
    return not rows <= {call.place for call in program.calls}


def _names_given(code: facts.Facts, made_at: facts.Span) -> frozenset[str]:
    """The names of the variables or attributes that the statement with a call assigns."""
    return frozenset(
        target.last_name
        for statement in everything_in(code.body, facts.Assign)
        if any(call.span == made_at for call in everything_in([statement], facts.Call))
        for target in statement.assigned
        if target.last_name
    )


@once_for_each_file
def _spins_by_name(code: facts.Facts) -> tuple[tuple[str, facts.Span], ...]:
    """Each ``rclpy.spin_once(self.client)`` and the like of a file, with the name of what it spins."""
    return tuple(
        (call.args[0].value.last_name, call.span)
        for call in everything_in(code.body, facts.Call)
        if called_name(call) in METHODS_THAT_SPIN and call.args
    )


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
