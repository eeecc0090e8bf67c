"""Actions that functions and event handlers of a launch file lead to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Value
from archlint.launch.actions.branches import callable_value
from archlint.launch.actions.scopes import later
from archlint.launch.functions import call_handler, call_opaque
from archlint.launch.objects import LaunchObject, argument, class_name, kind_of, made_by_base
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def opaque(run: LaunchRun, entity: LaunchObject) -> None:
    function = entity.argument("function")
    if function is None:
        run.gap("an OpaqueFunction without a function")
        return
    result = call_opaque(run, function, run.items(entity.argument("args")), entity.argument("kwargs"))
    run.visit(result)


def event_handler(run: LaunchRun, entity: LaunchObject) -> None:
    handler = entity.argument("event_handler")
    for name in ("on_exit", "on_start", "on_completion", "on_shutdown", "entities", "on_stdout", "on_stderr"):
        value = argument(handler, name)
        if value is not None:
            before = run.in_handler, run.ended
            run.in_handler, run.ended = True, run.ended | _ended(run, handler)
            with later(run):
                run.visit(call_handler(run, value, class_name(handler)) if callable_value(value) else value)
            run.in_handler, run.ended = before


def _ended(run: LaunchRun, handler: Value | None) -> frozenset[int]:
    """The action whose process has ended when a handler acts, unless launch starts that process again."""
    target = argument(handler, "target_action")
    action = made_by_base(run, target) or target
    if kind_of(handler) != LaunchClass.ON_PROCESS_EXIT or not isinstance(action, LaunchObject):
        return frozenset()
    return frozenset({action.key}) if action.argument("respawn") in (None, Known(False)) else frozenset()
