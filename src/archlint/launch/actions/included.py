"""Actions that lead to other actions: descriptions and includes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import Items, Known, Value
from archlint.launch.actions.branches import each_alternative, visit_items
from archlint.launch.actions.domains import environment_of
from archlint.launch.actions.include_arguments import given_arguments
from archlint.launch.context import Context
from archlint.launch.kinds import FileKind
from archlint.launch.model import Included
from archlint.launch.objects import LaunchObject, argument, entities_of, kind_of, place_of
from archlint.launch.parameter_sources import files_among
from archlint.launch.tables import SOURCES

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def description(run: LaunchRun, entity: LaunchObject) -> None:
    """A description grows while it is visited, where a function adds to it."""
    done = 0
    while True:
        entities = entities_of(run, entity) or Items(())
        values = entities.values[done:]
        if not values:
            return
        visit_items(run, Items(values, entities.open))
        done += len(values)


def branch(run: LaunchRun, entity: LaunchObject) -> None:
    run.visit(entity.arguments["action"])


def include(run: LaunchRun, entity: LaunchObject) -> None:
    source = entity.argument("launch_description_source")
    location = argument(source, "launch_file_path") if kind_of(source) in SOURCES else source
    place = place_of(source) or run.place_now
    given = entity.argument("launch_arguments")
    names = given_arguments(run, given)
    path = run.perform(location)
    for option in each_alternative(run, path):
        reference = run.reference(FileKind.LAUNCH, option, place)
        visible = None if given is not None and run.is_open(given) else _visible_texts(run, [name for name, _ in names])
        row = Included(
            reference,
            names,
            place,
            run.file,
            run.is_dormant,
            visible,
            source_class=_class_of(source),
            called_at=entity.called_at,
        )
        run.result.included.append(row)
        if reference.source is None:
            run.given.note_unread_include(run.launch.configurations)
        with run.given.passing([name for name, _ in names]):
            run.include(reference, plain=not names and option is path, called_at=entity.called_at)


def _class_of(source: Value | None) -> str:
    kind = kind_of(source)
    return kind.value if kind is not None and kind in SOURCES else ""


def _visible_texts(run: LaunchRun, names: Sequence[str]) -> tuple[str, ...] | None:
    """What an included file can read: configurations go down to it, whether they are given as arguments or not.  One
    that is not known counts where it is given by name."""
    known = run.launch.known_configurations()
    if any(name not in known for name in names):
        return None
    texts = set(known.values())
    uses = files_among(run.launch.parameters or ())
    texts.update(use.reference.source or use.reference.written or "" for use in uses)
    return tuple(sorted(texts))


def launch_in_own_process(
    run: LaunchRun, entity: LaunchObject, what: tuple[str, str], words: Sequence[str | None]
) -> None:
    """``ros2 launch package file argument:=value …``: a launch with a context of its own."""
    reference = run.reference(FileKind.LAUNCH, run.paths.launch_file_named(*what), run.place_now)
    run.result.included.append(Included(reference, (), run.place_now, run.file, run.is_dormant, own_process=True))
    kept, run.launch = run.launch, Context(environment=environment_of(run, entity))
    for word in words:
        argument_name, assigned, value = (word or "").partition(":=")
        if assigned:
            run.launch.configurations[argument_name] = Known(value)
    run.include(reference)
    run.launch = kept
