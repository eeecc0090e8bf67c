"""What a ``LogInfo`` shows.  Nothing that runs depends on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter.values import ListValue
from archlint.launch.objects import LaunchObject
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.launch.run import LaunchRun


def note_shown(run: LaunchRun, action: LaunchObject) -> None:
    """Note which launch configurations a message shows."""
    for name in sorted(set(_configurations(run, action.argument("msg")))):
        run.given.note_shown(name, run.launch.configurations.get(name))


def _configurations(run: LaunchRun, value: Value | None) -> Iterator[str]:
    match value:
        case ListValue():
            for item in value.items(run).values:
                yield from _configurations(run, item)
        case LaunchObject(kind=LaunchClass.LAUNCH_CONFIGURATION):
            name = run.text_of(value.argument("variable_name"))
            if name is not None:
                yield name


__all__ = ["note_shown"]
