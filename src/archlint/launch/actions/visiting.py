"""Going through what a launch file returns: which action is visited when, and under which condition."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.branches import BranchArms
from archlint.interpreter.values import External, Instance, Items, Known, ListValue, OneOf, Value, reason
from archlint.launch.actions import handlers, included, processes, scopes
from archlint.launch.actions.branches import (
    arms_of,
    choice,
    each_alternative,
    note_open,
    verdict_on,
    version,
    visit_items,
)
from archlint.launch.actions.missing_arguments import note_missing_arguments
from archlint.launch.actions.refused_values import note_refused_values
from archlint.launch.objects import MADE_BY_BASE, OWN, LaunchObject, class_name, kind_of, launch_object, place_of
from archlint.launch.tables import LaunchClass
from archlint.launch.verdict import ALWAYS

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

VISITS = 20_000
"""How many actions one launch may visit."""


NESTING = 100
"""How deep actions may be nested in each other, includes and functions counted."""


Act = Callable[["LaunchRun", LaunchObject], None]

ACTIONS: dict[LaunchClass, Act] = {
    LaunchClass.LAUNCH_DESCRIPTION: included.description,
    LaunchClass.BRANCH: included.branch,
    LaunchClass.GROUP_ACTION: scopes.group,
    LaunchClass.TIMER_ACTION: scopes.timer,
    LaunchClass.ROS_TIMER: scopes.timer,
    LaunchClass.DECLARE_LAUNCH_ARGUMENT: scopes.declare,
    LaunchClass.DECLARE_BOOLEAN_LAUNCH_ARGUMENT: scopes.declare,
    LaunchClass.SET_LAUNCH_CONFIGURATION: scopes.let,
    LaunchClass.UNSET_LAUNCH_CONFIGURATION: scopes.unset,
    LaunchClass.SET_ENVIRONMENT_VARIABLE: scopes.environment,
    LaunchClass.UNSET_ENVIRONMENT_VARIABLE: scopes.forget_environment,
    LaunchClass.PUSH_ROS_NAMESPACE: scopes.push_namespace,
    LaunchClass.SET_REMAP: scopes.set_remap,
    LaunchClass.SET_PARAMETER: scopes.set_parameter,
    LaunchClass.SET_USE_SIM_TIME: scopes.set_parameter,
    LaunchClass.SET_PARAMETERS_FROM_FILE: scopes.set_parameters_from_file,
    LaunchClass.INCLUDE_LAUNCH_DESCRIPTION: included.include,
    LaunchClass.PYTHON_LAUNCH_DESCRIPTION_SOURCE: included.include,
    LaunchClass.OPAQUE_FUNCTION: handlers.opaque,
    LaunchClass.REGISTER_EVENT_HANDLER: handlers.event_handler,
    LaunchClass.NODE: processes.node,
    LaunchClass.LIFECYCLE_NODE: processes.node,
    LaunchClass.COMPOSABLE_NODE_CONTAINER: processes.node,
    LaunchClass.LOAD_COMPOSABLE_NODES: processes.load,
    LaunchClass.EXECUTE_PROCESS: processes.process,
}
"""What each action does to the launch context, and what it starts."""

_IGNORED = frozenset(
    {
        LaunchClass.LOG_INFO,
        LaunchClass.SHUTDOWN,
        LaunchClass.EMIT_EVENT,
        LaunchClass.UNREGISTER_EVENT_HANDLER,
        LaunchClass.PUSH_ENVIRONMENT,
        LaunchClass.POP_ENVIRONMENT,
        LaunchClass.APPEND_ENVIRONMENT_VARIABLE,
        LaunchClass.LIFECYCLE_TRANSITION,
        LaunchClass.SET_ROS_LOG_DIR,
        LaunchClass.OPAQUE_COROUTINE,
    }
)


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
        run.note_fault("following this action", error, place_of(entity) or run.place_now)
    finally:
        run.nesting -= 1


def _visit(run: LaunchRun, entity: Value) -> None:
    match entity:
        case ListValue():
            visit_items(run, entity.items(run))
        case OneOf(values=options):
            rows = [option.items(run) for option in options if isinstance(option, ListValue)]
            if len(rows) == len(options):
                _visit_versions(run, entity, rows)
            else:
                _visit_alternatives(run, entity)
        case Known(value=None):
            pass
        case Instance():
            _visit_one(run, entity)
        case _:
            run.gap(reason(entity))


def _visit_alternatives(run: LaunchRun, entity: OneOf) -> None:
    for option in each_alternative(run, entity):
        run.visit(option)


def _visit_versions(run: LaunchRun, entity: OneOf, rows: list[Items]) -> None:
    """One of several lists: what is in all of them runs, the rest only where its list is the one."""
    for value in dict.fromkeys(value for row in rows for value in row.values):
        holding = [number for number, row in enumerate(rows) if value in row.values]
        own: BranchArms = frozenset()
        if len(holding) == 1:
            own = version(run, entity, holding[0])
        elif len(holding) < len(rows):
            own = choice(run, entity, tuple(holding), 0)
        with run.under(own, ALWAYS, run.place_now):
            run.visit(value)
    for row in rows:
        note_open(run, row)


def _visit_one(run: LaunchRun, entity: Instance) -> None:
    base_action = run.store.get(entity.key, MADE_BY_BASE)  # of a class that derives from an action
    match base_action:
        case OneOf():
            run.visit(base_action)
            return
        case Instance():
            entity = base_action
    entity = _known_by_name(entity)
    own = arms_of(run, entity) - run.code_arms
    verdict = verdict_on(run, entity)
    place = entity.place or run.place_now
    kept = run.place_now
    run.place_now = place
    run.visiting.append((entity.key, run.visits))
    try:
        with run.under(own, verdict, place):
            _act(run, entity)
    finally:
        run.visiting.pop()
        run.place_now = kept


def _act(run: LaunchRun, entity: Instance) -> None:
    match entity:
        case LaunchObject(kind=kind) if kind in ACTIONS:
            if run.file.endswith(".py"):
                note_refused_values(run, entity)
                note_missing_arguments(run, entity)
            ACTIONS[kind](run, entity)
        case _ if kind_of(entity) not in _IGNORED:
            run.gap(f"{entity.note or class_name(entity) or 'an object'} is not an action that is followed")


def _known_by_name(entity: Instance) -> Instance:
    """Another library's ``DeclareBooleanLaunchArgument`` and the like declare an argument as launch's own do."""
    match entity.cls:
        case External(path=path) if not path.startswith(OWN) and _DECLARES.search(path):
            arguments = {{"0": "name"}.get(key, key): value for key, value in entity.arguments.items()}
            return launch_object(entity.key, LaunchClass.DECLARE_LAUNCH_ARGUMENT, entity.place, arguments)
    return entity


_DECLARES = re.compile(r"(?:^|\.)Declare[^.]*LaunchArgument$")
