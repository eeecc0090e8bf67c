"""Actions that lead to other actions: descriptions, includes, functions and event handlers."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.heap import Items
from archlint.interpreter.values import Instance, Known, OneOf, Value
from archlint.launch.actions.branches import callable_value, each_alternative, visit_items
from archlint.launch.context import Context
from archlint.launch.model import FileKind, Included, ParameterFileUse
from archlint.launch.objects import ENTITIES, PAIR_PLACE, argument, kind_of
from archlint.launch.substitutions.texts import written_at

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def description(run: LaunchRun, entity: Instance) -> None:
    """A description grows while it is visited, where a function adds to it."""
    done = 0
    while True:
        entities = run.store.get(entity.key, ENTITIES)
        values = entities.values[done:] if isinstance(entities, Items) else ()
        if not isinstance(entities, Items) or not values:
            return
        visit_items(run, Items(values, entities.open))
        done += len(values)


def branch(run: LaunchRun, entity: Instance) -> None:
    run.visit(entity.arguments["action"])


def include(run: LaunchRun, entity: Instance) -> None:
    source = argument(entity, "launch_description_source")
    location = argument(source, "launch_file_path") if kind_of(source).endswith("Source") else source
    place = (source.place if isinstance(source, Instance) else None) or run.place_now
    given = argument(entity, "launch_arguments")
    names = _given(run, given)
    path = run.perform(location)
    for option in each_alternative(run, path) if isinstance(path, OneOf) else (path,):
        reference = run.reference(FileKind.LAUNCH, option, place)
        handed = None if given is not None and run.is_open(given) else _handed(run, [name for name, _ in names])
        run.result.included.append(Included(reference, names, place, run.file, run.is_dormant, handed))
        run.include(reference, plain=not names and option is path)


def _handed(run: LaunchRun, names: Sequence[str]) -> tuple[str, ...] | None:
    """What an included file can read: configurations go down to it, whether they are given as arguments or not.  One
    that is not known counts where it is given by name."""
    values = run.launch.configurations
    if any(not isinstance(values.get(name), Known) for name in names):
        return None
    texts = {str(value.value) for value in values.values() if isinstance(value, Known)}
    uses = [one for one in run.launch.parameters or () if isinstance(one, ParameterFileUse)]
    texts.update(use.reference.source or use.reference.written or "" for use in uses)
    return tuple(sorted(texts))


def _given(run: LaunchRun, arguments: Value | None) -> tuple[tuple[str, Place], ...]:
    """Set the arguments of an include; their names, and where each is written."""
    if arguments is None:
        return ()
    names = []
    with run.perhaps() if isinstance(arguments, OneOf) or run.is_open(arguments) else nullcontext():
        for row in run.items(arguments):
            pair = run.items(row)
            name = run.perform(pair[0]) if len(pair) == 2 else None
            if isinstance(name, Known):
                where = run.store.get(getattr(row, "key", 0), PAIR_PLACE)
                origin = pair[0].origin if isinstance(pair[0], Known) else None
                names.append((str(name.value), where if isinstance(where, Place) else origin or run.place_now))
                run.launch.configurations[str(name.value)] = written_at(run.perform(pair[1]), names[-1][1])
    return tuple(names)


def launch_in_own_process(run: LaunchRun, package: str, name: str, words: Sequence[str | None]) -> None:
    """``ros2 launch package file argument:=value …``: a launch with a context of its own."""
    reference = run.reference(FileKind.LAUNCH, run.paths.launch_file_named(package, name), run.place_now)
    run.result.included.append(Included(reference, (), run.place_now, run.file, run.is_dormant, own_process=True))
    kept, run.launch = run.launch, Context()
    for word in words:
        argument_name, assigned, value = (word or "").partition(":=")
        if assigned:
            run.launch.configurations[argument_name] = Known(value)
    run.include(reference)
    run.launch = kept


def opaque(run: LaunchRun, entity: Instance) -> None:
    function = argument(entity, "function")
    if function is None:
        run.gap("an OpaqueFunction without a function")
        return
    result = run.call_opaque(function, run.items(argument(entity, "args")), argument(entity, "kwargs"))
    run.visit(result)


def event_handler(run: LaunchRun, entity: Instance) -> None:
    handler = argument(entity, "event_handler")
    if handler is None or not isinstance(handler, Instance):
        return
    for name in ("on_exit", "on_start", "on_completion", "on_shutdown", "entities", "on_stdout", "on_stderr"):
        value = argument(handler, name)
        if value is not None:
            before, run.in_handler = run.in_handler, True
            run.visit(run.call_handler(value) if callable_value(value) else value)
            run.in_handler = before
