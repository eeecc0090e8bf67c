"""Going through what a launch file returns: which action is visited when, and under which condition."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.branches import BranchArms
from archlint.interpreter.heap import Items
from archlint.interpreter.values import External, Instance, Known, ListValue, OneOf, Unknown, Value, reason
from archlint.launch import conditions
from archlint.launch.model import (
    NotACondition,
)
from archlint.launch.substitutions import argument, kind_of, made_by_base

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

Act = Callable[["LaunchRun", Instance], None]

ACTIONS: dict[str, Act] = {}
"""What each action does; :mod:`archlint.launch.actions` fills it."""

VISITS = 20_000
"""How many actions one launch may visit."""


NESTING = 100
"""How deep actions may stand in each other, includes and functions counted."""


def visit(run: LaunchRun, entity: Value) -> None:
    """Run one entity, or a list of them."""
    run.visits += 1
    if run.visits > VISITS or run.nesting >= NESTING:
        run.gap("more actions than can be followed")
        return
    run.nesting += 1
    try:
        _visit(run, entity)
    except (RecursionError, MemoryError):
        raise  # not for the innermost action, which was only the last straw
    except Exception as error:
        place = entity.place if isinstance(entity, Instance) else None
        run.note_fault("following this action", error, place or run.place_now)
    finally:
        run.nesting -= 1


def _visit(run: LaunchRun, entity: Value) -> None:
    if isinstance(entity, (ListValue, OneOf)):
        _visit_several(run, entity)
    elif isinstance(entity, Known) and entity.value is None:
        return
    elif isinstance(entity, Instance):
        _visit_one(run, entity)
    else:
        run.gap(reason(entity))


def _visit_several(run: LaunchRun, entity: ListValue | OneOf) -> None:
    from archlint.interpreter import containers

    if isinstance(entity, ListValue):
        visit_items(run, containers.items_of(run, entity))
    elif all(isinstance(option, ListValue) for option in entity.values):
        _visit_versions(run, entity)
    else:
        for option in each_alternative(run, entity):
            visit(run, option)


def each_alternative(run: LaunchRun, entity: OneOf) -> Iterator[Value]:
    """The alternatives of a value one by one, each under a branch that excludes the others."""
    apart = _are_apart(run, entity)
    for number, option in enumerate(entity.values):
        with run.under(frozenset() if apart else _version(run, entity, number), conditions.ALWAYS, run.place_now):
            yield option


def _are_apart(run: LaunchRun, entity: OneOf) -> bool:
    """Whether the alternatives were made in branches of the code that exclude each other: these tell them apart."""
    every = [dict(arms_of(run, option)) for option in entity.values]
    return all(any(one[key] != other.get(key, one[key]) for key in one) for one, other in combinations(every, 2))


def _version(run: LaunchRun, entity: OneOf, number: int) -> BranchArms:
    return frozenset({(f"one of {run.names.number(entity)}", number)})


def _visit_versions(run: LaunchRun, entity: OneOf) -> None:
    """One of several lists: what is in all of them runs, the rest only where its list is the one."""
    from archlint.interpreter import containers

    rows = [containers.items_of(run, option) for option in entity.values if isinstance(option, ListValue)]
    for value in dict.fromkeys(value for row in rows for value in row.values):
        holding = [number for number, row in enumerate(rows) if value in row.values]
        own: BranchArms = frozenset()
        if len(holding) == 1:
            own = _version(run, entity, holding[0])
        elif len(holding) < len(rows):
            own = frozenset({(f"some of {run.names.number(entity)}: {holding}", 0)})
        with run.under(own, conditions.ALWAYS, run.place_now):
            visit(run, value)
    for row in rows:
        _note_open(run, row)


def visit_items(run: LaunchRun, items: Items) -> None:
    for value in items.values:
        visit(run, value)
    _note_open(run, items)


def _note_open(run: LaunchRun, items: Items) -> None:
    branches = any(arms_of(run, value) for value in items.values)
    if not items.whole and not branches and not any(isinstance(v, Unknown) for v in items.values):
        run.gap("a list of actions that is not wholly known")


def arms_of(run: LaunchRun, value: Value) -> BranchArms:
    """The branches of the launch file's own code that an object was made in."""
    made = made_by_base(run, value)
    arms = run.store.get(getattr(made or value, "key", 0), "#arms")
    return frozenset(arms) if isinstance(arms, frozenset) else frozenset()


def _visit_one(run: LaunchRun, entity: Instance) -> None:
    made = run.store.get(entity.key, "#action")  # of a class that derives from an action
    if isinstance(made, OneOf):
        visit(run, made)
        return
    entity = _known_by_name(made if isinstance(made, Instance) else entity)
    kind = kind_of(entity)
    own = arms_of(run, entity) - run.code_arms
    verdict = verdict_on(run, entity)
    place = entity.place or run.place_now
    kept = run.place_now
    run.place_now = place
    run.visiting.append((entity.key, run.visits))
    try:
        with run.under(own, verdict, place):
            act = ACTIONS.get(kind)
            if act is not None:
                act(run, entity)
            elif kind not in _IGNORED:
                run.gap(f"{entity.note or kind or 'an object'} is no action that is followed")
    finally:
        run.visiting.pop()
        run.place_now = kept


def verdict_on(run: LaunchRun, entity: Instance) -> conditions.Verdict:
    """Whether an action or a component runs, as its ``condition=`` says."""
    condition = argument(entity, "condition")
    what = None if condition is None else conditions.mistaken(run, condition)
    if condition is not None and what is not None:
        place = run.places_of(entity).get("condition") or entity.place or run.place_now
        run.note_mistake(NotACondition(kind_of(entity), what, callable_value(condition), place))
    return conditions.judge(run, condition)


def _known_by_name(entity: Instance) -> Instance:
    """Another library's ``DeclareBooleanLaunchArgument`` and the like declare an argument as launch's own do."""
    path = entity.cls.path if isinstance(entity.cls, External) else ""
    name = path.rpartition(".")[2]
    if path.startswith("launch.") or not (name.startswith("Declare") and name.endswith("LaunchArgument")):
        return entity
    arguments = {{"0": "name"}.get(key, key): value for key, value in entity.arguments.items()}
    return Instance(External("launch.DeclareLaunchArgument"), entity.key, entity.place, arguments)


def visit_argument(name: str) -> Act:
    """Visits the actions in one argument."""

    def act(run: LaunchRun, entity: Instance) -> None:
        value = argument(entity, name)
        if value is not None and not callable_value(value):
            visit(run, value)

    return act


def callable_value(value: Value) -> bool:
    from archlint.interpreter.values import BoundMethod, FunctionValue, Partial

    return isinstance(value, (FunctionValue, BoundMethod, Partial))


_IGNORED = frozenset(
    {
        "LogInfo",
        "Shutdown",
        "EmitEvent",
        "UnregisterEventHandler",
        "PushEnvironment",
        "PopEnvironment",
        "AppendEnvironmentVariable",
        "UnsetEnvironmentVariable",
        "LifecycleTransition",
        "SetROSLogDir",
        "OpaqueCoroutine",
    }
)
