"""Going through what a launch file returns: which action is visited when, and under which condition."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.program.launch import conditions
from archlint.program.launch.substitutions import argument, kind_of
from archlint.program.store import Items
from archlint.program.values import (
    External,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    reason,
)

if TYPE_CHECKING:
    from archlint.program.launch.run import LaunchRun

Act = Callable[["LaunchRun", Instance], None]

ACTIONS: dict[str, Act] = {}
"""What each action does; :mod:`archlint.program.launch.actions` fills it."""

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
    from archlint.program import containers

    if isinstance(entity, OneOf):
        for option in entity.values:
            visit(run, option)
        return
    visit_items(run, containers.items_of(run, entity))


def visit_items(run: LaunchRun, items: Items) -> None:
    for value in items.values:
        visit(run, value)
    branches = any(isinstance(v, Instance) and run.store.get(v.key, "#arms") for v in items.values)
    if not items.whole and not branches and not any(isinstance(v, Unknown) for v in items.values):
        run.gap("a list of actions that is not wholly known")


def _visit_one(run: LaunchRun, entity: Instance) -> None:
    made = run.store.get(entity.key, "#action")  # of a class that derives from an action
    if isinstance(made, OneOf):
        visit(run, made)
        return
    entity = _known_by_name(made if isinstance(made, Instance) else entity)
    kind = kind_of(entity)
    arms = run.store.get(entity.key, "#arms")
    own = frozenset(arms) - run.code_arms if isinstance(arms, frozenset) else frozenset()
    verdict = conditions.judge(run, argument(entity, "condition"))
    place = entity.place or run.place_now
    kept = run.place_now
    run.place_now = place
    try:
        with run.under(own, verdict, place):
            act = ACTIONS.get(kind)
            if act is not None:
                act(run, entity)
            elif kind not in _IGNORED:
                run.gap(f"{entity.note or kind or 'an object'} is no action that is followed")
    finally:
        run.place_now = kept


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
    from archlint.program.values import BoundMethod, FunctionValue, Partial

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
