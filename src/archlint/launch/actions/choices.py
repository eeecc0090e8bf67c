"""Values of launch arguments that are none of the choices of their declarations.

Source: launch's ``DeclareLaunchArgument``, which raises a RuntimeError in its constructor for a text as default that
is no choice, and for any other value when it is visited.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, ListValue
from archlint.launch.mistakes import NotAChoice
from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.launch.objects import LaunchObject
    from archlint.launch.run import LaunchRun


def choices_of(run: LaunchRun, declaration: LaunchObject) -> tuple[str, ...] | None:
    """What an argument may be; None where it may be anything, or not all choices are known."""
    value = declaration.argument("choices")
    if not isinstance(value, ListValue) or run.is_open(value):
        return None
    choices = [known_text(choice) for choice in run.items(value)]
    allowed = tuple(choice for choice in choices if choice is not None)
    return allowed if allowed and len(allowed) == len(choices) else None


def note_no_choice(run: LaunchRun, declaration: LaunchObject, name: str, default: Value | None) -> None:
    """Note the value that stops the launch at a declaration: its default, or what an include in front passes."""
    choices = choices_of(run, declaration)
    if choices is None or run.is_dormant or run.is_conditional:
        return
    declared = run.place_now
    held = run.launch.configurations.get(name)
    literal = isinstance(declaration.argument("default_value"), Known)
    judged = literal and isinstance(default, Known) and (run.file.endswith(".py") or held is default)
    if judged and known_text(default) not in choices:
        place = declaration.places.get("default_value", declared)
        run.note_no_choice(NotAChoice(name, known_text(default) or "", choices, place, declared, default=True))
        return
    place_given = run.given.written(name, held)
    if isinstance(held, Known) and place_given is not None and known_text(held) not in choices:
        run.note_no_choice(NotAChoice(name, known_text(held) or "", choices, place_given, declared))


__all__ = ["note_no_choice"]
