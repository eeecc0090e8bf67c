"""Under which branches an action runs: those of the code that makes it, of its condition, of one of several values."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.branches import BranchArms
from archlint.interpreter.heap import Items
from archlint.interpreter.values import BoundMethod, FunctionValue, Instance, OneOf, Partial, Unknown, Value
from archlint.launch import conditions
from archlint.launch.model import NotACondition
from archlint.launch.objects import LaunchObject, argument, kind_of, made_by_base, places_of
from archlint.launch.verdict import ALWAYS, Verdict

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def each_alternative(run: LaunchRun, entity: OneOf) -> Iterator[Value]:
    """The alternatives of a value one by one, each under a branch that excludes the others."""
    apart = _are_apart(run, entity)
    for number, option in enumerate(entity.values):
        with run.under(frozenset() if apart else version(run, entity, number), ALWAYS, run.place_now):
            yield option


def _are_apart(run: LaunchRun, entity: OneOf) -> bool:
    """Whether the alternatives were made in branches of the code that exclude each other: these tell them apart."""
    every = [dict(arms_of(run, option)) for option in entity.values]
    return all(any(one[key] != other.get(key, one[key]) for key in one) for one, other in combinations(every, 2))


def version(run: LaunchRun, entity: OneOf, number: int) -> BranchArms:
    """The branch in which a value is one of its alternatives."""
    return frozenset({(f"one of {run.names.number(entity)}", number)})


def arms_of(run: LaunchRun, value: Value) -> BranchArms:
    """The branches of the launch file's own code that an object was made in."""
    made = made_by_base(run, value) or value
    return made.branch_arms if isinstance(made, LaunchObject) else frozenset()


def verdict_on(run: LaunchRun, entity: Instance) -> Verdict:
    """Whether an action or a component runs, as its ``condition=`` says."""
    condition = argument(entity, "condition")
    what = None if condition is None else conditions.mistaken(run, condition)
    if condition is not None and what is not None:
        place = places_of(entity).get("condition") or entity.place or run.place_now
        run.note_mistake(NotACondition(kind_of(entity), what, callable_value(condition), place))
    return run.judge(condition)


def callable_value(value: Value) -> bool:
    return isinstance(value, (FunctionValue, BoundMethod, Partial))


def visit_items(run: LaunchRun, items: Items) -> None:
    for value in items.values:
        run.visit(value)
    note_open(run, items)


def note_open(run: LaunchRun, items: Items) -> None:
    branches = any(arms_of(run, value) for value in items.values)
    if not items.whole and not branches and not any(isinstance(v, Unknown) for v in items.values):
        run.gap("a list of actions that is not wholly known")
