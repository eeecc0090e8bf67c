"""Attributes that one callback reads and changes in a step, and another changes at the same time, without a lock.

Python switches threads between any two bytecodes: what another thread has written between the read and the write of
``self.count += 1`` is lost.  A single assignment, or ``append()``, is one step.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.own_methods import Method, methods_reached, statements_with_guards
from archlint.analysis.source_code import source_code
from archlint.execution.blocking import OTHER, REENTRANT, SEVERAL
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import group_relation, threads_of
from archlint.finding import Place
from archlint.model import Role
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System

_LIFE = frozenset({Role.LIFECYCLE, Role.PARAMETER, Role.DONE})
"""Roles of callbacks whose place among the others is not known well enough."""


@dataclass(frozen=True)
class Change:
    """A statement of a callback that changes an attribute; one of two steps reads what it changes."""

    callback: Callback
    attribute: str
    place: Place
    two_steps: bool


@dataclass(frozen=True)
class Race:
    """What is read and changed at ``first`` may be changed at ``second`` in between."""

    first: Change
    second: Change


def races(system: System) -> Iterator[Race]:
    """The first such pair of each attribute of a node."""
    for program in system.programs:
        if system.roles.is_test(program.file):
            continue
        for node in program.nodes:
            if threads_of(node, program) == SEVERAL and not node.test:
                callbacks = [callback for callback in node.callbacks if _is_judged(callback)]
                yield from _of_node(system, program, callbacks)


def _is_judged(callback: Callback) -> bool:
    return runs_in_executor(callback) and callback.role not in _LIFE and callback.bound_arguments == 1


def _of_node(system: System, program: Program, callbacks: list[Callback]) -> Iterator[Race]:
    by_attribute: dict[str, list[Change]] = {}
    for callback in callbacks:
        for change in _changes(system, callback):
            by_attribute.setdefault(change.attribute, []).append(change)
    for changes in by_attribute.values():
        pairs = (
            Race(first, second)
            for first in changes
            if first.two_steps
            for second in changes
            if _may_overlap(first.callback, second.callback)
        )
        race = next(pairs, None)
        if race is not None:
            yield race


def _may_overlap(first: Callback, second: Callback) -> bool:
    """Whether two threads may run both at once: one of an exclusive group never runs beside itself."""
    if first is second or first.place == second.place:
        return first.group is not None and group_relation(first.group, first.group) == REENTRANT
    if first.group is None or second.group is None:
        return False
    return group_relation(first.group, second.group) in (OTHER, REENTRANT)


def _changes(system: System, callback: Callback) -> Iterator[Change]:
    code = source_code(system)
    function, file = code.definition(callback), code.facts_at(callback.file)
    if function is None or file is None:
        return
    for method in methods_reached(function, file):
        for statement, guarded in statements_with_guards(method.code.body):
            if not guarded:
                for attribute, span, two_steps in _changed(statement, method):
                    yield Change(callback, attribute, Place.of(callback.file, span), two_steps)


def _changed(statement: facts.Stmt, method: Method) -> Iterator[tuple[str, facts.Span, bool]]:
    """The attributes that a statement changes, where, and whether it reads each before it does."""
    match statement:
        case facts.Augmented(target=target) if method.is_own(target):
            yield target.attribute, statement.span, True
        case facts.Assign(targets=targets, value=value):
            read = {part.attribute for part in everything_in(value) if method.is_own(part)}
            for target in targets:
                if method.is_own(target):
                    yield target.attribute, statement.span, target.attribute in read


__all__ = ["Change", "Race", "races"]
