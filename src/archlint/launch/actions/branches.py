"""Under which branches an action runs: those of the code that makes it, of its condition, of one of several values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.branches import BranchArms, ChoiceOfValue
from archlint.interpreter.values import (
    BoundMethod,
    FunctionValue,
    Instance,
    Items,
    Partial,
    Unknown,
    Value,
    alternatives,
)
from archlint.launch import conditions
from archlint.launch.actions.no_actions import note_action_as_predicate, note_no_action
from archlint.launch.mistakes import NotACondition
from archlint.launch.objects import LaunchObject, argument, class_name, made_by_base
from archlint.launch.verdict import ALWAYS, Verdict

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun


def each_alternative(run: LaunchRun, entity: Value) -> Iterator[Value]:
    """The alternatives of a value one by one, each under a branch that excludes the others; of one value itself."""
    options = alternatives(entity)
    exclusive = _exclude_each_other(run, options)
    for number, option in enumerate(options):
        with run.under(frozenset() if exclusive else version(run, entity, number), ALWAYS, run.place_now):
            yield option


def _exclude_each_other(run: LaunchRun, options: Sequence[Value]) -> bool:
    """Whether the alternatives were made in branches of the code that exclude each other: these distinguish them."""
    every = [dict(arms_of(run, option)) for option in options]
    return all(
        any(first[key] != second.get(key, first[key]) for key in first) for first, second in combinations(every, 2)
    )


def version(run: LaunchRun, entity: Value, number: int) -> BranchArms:
    """The branch in which a value is one of its alternatives."""
    return choice(run, entity, (), number)


def choice(run: LaunchRun, entity: Value, holding: tuple[int, ...], arm: int) -> BranchArms:
    """The branch in which a value is one of some of its alternatives."""
    branch = ChoiceOfValue(run.names.number(entity), holding)
    if entity.why_open is not None:
        run.result.why_open.setdefault(branch, entity.why_open)
    return frozenset({(branch, arm)})


def arms_of(run: LaunchRun, value: Value) -> BranchArms:
    """The branches of the launch file's own code that an object was made in."""
    match made_by_base(run, value) or value:
        case LaunchObject(branch_arms=arms):
            return arms
    return frozenset()


def verdict_on(run: LaunchRun, entity: Instance) -> Verdict:
    """Whether an action or a component runs, as its ``condition=`` says."""
    condition = argument(entity, "condition")
    what = None if condition is None else conditions.mistaken(run, condition)
    if condition is not None and what is not None:
        place = _place_of_condition(entity) or entity.place or run.place_now
        run.note_mistake(NotACondition(class_name(entity), what, callable_value(condition), place))
    if condition is not None:
        note_action_as_predicate(run, condition)
    return run.judge(condition)


def _place_of_condition(entity: Instance) -> Place | None:
    return entity.places.get("condition") if isinstance(entity, LaunchObject) else None


def callable_value(value: Value) -> bool:
    return isinstance(value, (FunctionValue, BoundMethod, Partial))


def visit_items(run: LaunchRun, items: Items) -> None:
    for value in items.values:
        note_no_action(run, value)
        run.visit(value)
    note_open(run, items)


def note_open(run: LaunchRun, items: Items) -> None:
    branches = any(arms_of(run, value) for value in items.values)
    if not items.exhaustive and not branches and not any(isinstance(v, Unknown) for v in items.values):
        run.gap("a list of actions that is only partly known")
