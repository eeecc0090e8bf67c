"""The arguments that an include is given."""

from __future__ import annotations

from contextlib import nullcontext
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Known, Value, alternatives
from archlint.launch.actions.pairs import pairs_of
from archlint.launch.objects import argument, kind_of
from archlint.launch.shared_paths import note_argument
from archlint.launch.substitutions.texts import written_at
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def given_arguments(run: LaunchRun, arguments: Value | None) -> tuple[tuple[str, Place], ...]:
    """Set the arguments of an include; their names, and where each is written."""
    if arguments is None:
        return ()
    names = []
    several = len(alternatives(arguments)) > 1
    with run.perhaps() if several or run.is_open(arguments) else nullcontext():
        for pair in pairs_of(run, arguments):
            name = run.text_of(pair.first)
            if name is not None:
                names.append((name, pair.place))
                value = written_at(run.perform(pair.second), pair.place)
                before = run.launch.configurations.get(name)
                run.launch.configurations[name] = value
                if isinstance(pair.second, Known):
                    run.given.note_literal(name, value, pair.place)
                if not _is_configuration(run, pair.second, name, before):
                    note_argument(run, name, value, pair.place)
                    run.given.note(name, value, pair.place, run.file, run.place_now, before)
    return tuple(names)


def _is_configuration(run: LaunchRun, value: Value, name: str, before: Value | None) -> bool:
    """Whether an argument is passed to an include as it is here, be it as what code has read from the context."""
    if before is not None and any(option is before for option in alternatives(value)):
        return True
    return kind_of(value) == LaunchClass.LAUNCH_CONFIGURATION and run.text_of(argument(value, "variable_name")) == name
