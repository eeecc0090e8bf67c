"""What a launch file in Python puts among actions that is none, and an action where a condition wants a text.

Source: launch's ``LaunchDescription``, which takes any list, and ``LaunchService``, which calls ``visit()`` of each
item; ``IfCondition``, whose ``normalize_to_list_of_substitutions`` raises a TypeError for an action.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.launch.mistakes import NoAction
from archlint.launch.objects import LaunchObject
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.launch.run import LaunchRun

_COMPONENTS = frozenset({LaunchClass.COMPOSABLE_NODE, LaunchClass.COMPOSABLE_LIFECYCLE_NODE})
_DECLARATIONS = frozenset({LaunchClass.DECLARE_LAUNCH_ARGUMENT, LaunchClass.DECLARE_BOOLEAN_LAUNCH_ARGUMENT})


def note_no_action(run: LaunchRun, value: Value) -> None:
    """Note an item of a list of actions that has no ``visit()``."""
    match value:
        case LaunchObject(place=place) if place is not None and place.file.endswith(".py"):
            if value.is_substitution or value.kind in _COMPONENTS:
                name = run.text_of(value.argument("variable_name")) if value.is_substitution else None
                _note(run, NoAction(value.kind, True, name or "", place))


def note_action_as_predicate(run: LaunchRun, condition: Value) -> None:
    """Note a condition that asks the declaration of an argument instead of its value."""
    match condition:
        case LaunchObject(kind=LaunchClass.IF_CONDITION | LaunchClass.UNLESS_CONDITION, place=place) if (
            place is not None
        ):
            predicate = condition.argument("predicate_expression")
            if isinstance(predicate, LaunchObject) and predicate.kind in _DECLARATIONS:
                name = run.text_of(predicate.argument("name"))
                _note(run, NoAction(condition.kind, False, name or "", place))


def _note(run: LaunchRun, mistake: NoAction) -> None:
    if mistake not in run.result.no_actions:
        run.result.no_actions.append(mistake)


__all__ = ["note_action_as_predicate", "note_no_action"]
