"""Actions that lead to other actions: descriptions, includes, functions and event handlers."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Items, Known, Value, alternatives
from archlint.launch.actions.branches import callable_value, each_alternative, visit_items
from archlint.launch.actions.domains import environment_of
from archlint.launch.actions.pairs import pairs_of
from archlint.launch.actions.scopes import later
from archlint.launch.context import Context
from archlint.launch.functions import call_handler, call_opaque
from archlint.launch.kinds import FileKind
from archlint.launch.model import Included
from archlint.launch.objects import LaunchObject, argument, class_name, entities_of, kind_of, made_by_base, place_of
from archlint.launch.parameter_sources import files_among
from archlint.launch.shared_paths import note_argument
from archlint.launch.substitutions.texts import written_at
from archlint.launch.tables import SOURCES, LaunchClass

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
    names = _given(run, given)
    path = run.perform(location)
    for option in each_alternative(run, path):
        reference = run.reference(FileKind.LAUNCH, option, place)
        visible = None if given is not None and run.is_open(given) else _visible_texts(run, [name for name, _ in names])
        row = Included(reference, names, place, run.file, run.is_dormant, visible, source_class=_class_of(source))
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


def _given(run: LaunchRun, arguments: Value | None) -> tuple[tuple[str, Place], ...]:
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
                if not _is_configuration(run, pair.second, name):
                    note_argument(run, name, value, pair.place)
                    run.given.note(name, value, pair.place, run.file, run.place_now, before)
    return tuple(names)


def _is_configuration(run: LaunchRun, value: Value, name: str) -> bool:
    """Whether an argument is passed to an include as it is here."""
    return kind_of(value) == LaunchClass.LAUNCH_CONFIGURATION and run.text_of(argument(value, "variable_name")) == name


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
