"""Actions that lead to other actions: descriptions, includes, functions and event handlers."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from contextlib import nullcontext
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.heap import Items
from archlint.interpreter.values import Instance, Known, OneOf, Unknown, Value
from archlint.launch.context import Context
from archlint.launch.model import Included, ParameterFileUse
from archlint.launch.substitutions import argument, kind_of, perform, written_at
from archlint.launch.visiting import callable_value, each_alternative, visit, visit_items

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def description(run: LaunchRun, entity: Instance) -> None:
    """A description grows while it is visited, where a function adds to it."""
    done = 0
    while True:
        entities = run.store.get(entity.key, "#entities")
        values = entities.values[done:] if isinstance(entities, Items) else ()
        if not isinstance(entities, Items) or not values:
            return
        visit_items(run, Items(values, entities.open))
        done += len(values)


def branch(run: LaunchRun, entity: Instance) -> None:
    visit(run, entity.arguments["action"])


def include(run: LaunchRun, entity: Instance) -> None:
    source = argument(entity, "launch_description_source")
    location = argument(source, "launch_file_path") if kind_of(source).endswith("Source") else source
    place = (source.place if isinstance(source, Instance) else None) or run.place_now
    given = argument(entity, "launch_arguments")
    names = _given(run, given)
    path = perform(run, location)
    for option in each_alternative(run, path) if isinstance(path, OneOf) else (path,):
        reference = run.reference("launch", option, place)
        handed = None if given is not None and run.is_open(given) else _handed(run, [name for name, _ in names])
        run.result.included.append(Included(reference, names, place, run.file, run.is_dormant, handed))
        run.loader.include(run, reference, plain=not names and option is path)


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
            name = perform(run, pair[0]) if len(pair) == 2 else None
            if isinstance(name, Known):
                where = run.store.get(getattr(row, "key", 0), "#place")
                origin = pair[0].origin if isinstance(pair[0], Known) else None
                names.append((str(name.value), where if isinstance(where, Place) else origin or run.place_now))
                run.launch.configurations[str(name.value)] = written_at(perform(run, pair[1]), names[-1][1])
    return tuple(names)


def launch_in_own_process(run: LaunchRun, package: str, name: str, words: Sequence[str | None]) -> None:
    """``ros2 launch package file argument:=value …``: a launch with a context of its own."""
    reference = run.reference("launch", _found_by_name(run, package, name), run.place_now)
    run.result.included.append(Included(reference, (), run.place_now, run.file, run.is_dormant, own_process=True))
    kept, run.launch = run.launch, Context()
    for word in words:
        argument_name, assigned, value = (word or "").partition(":=")
        if assigned:
            run.launch.configurations[argument_name] = Known(value)
    run.loader.include(run, reference)
    run.launch = kept


def _found_by_name(run: LaunchRun, package: str, name: str) -> Value:
    """The path of the launch file that ``ros2 launch`` finds: it walks the whole share folder of the package and goes
    by the name of the file alone; where two have it, it starts neither."""
    share = f"share/{package}/"
    installs = run.loader.installs.get(package)
    if installs is None:
        return Known(f"$(find-pkg-share {package})/launch/{name}")
    sources = [path for path in run.loader.tree.files_below(installs.folder) if posixpath.basename(path) == name]
    there = {place for path in sources for place in installs.places_of(path) if place.startswith(share)}
    if len(there) > 1:
        return Unknown(f"{package} installs several files {name}")
    if not there and len(sources) == 1:  # not installed, or in a way that is not known
        there = {share + posixpath.relpath(sources[0], installs.folder)}
    return Known(f"$(find-pkg-share {package})/" + (there.pop().removeprefix(share) if there else f"launch/{name}"))


def opaque(run: LaunchRun, entity: Instance) -> None:
    function = argument(entity, "function")
    if function is None:
        run.gap("an OpaqueFunction without a function")
        return
    result = run.call_opaque(function, run.items(argument(entity, "args")), argument(entity, "kwargs"))
    visit(run, result)


def event_handler(run: LaunchRun, entity: Instance) -> None:
    handler = argument(entity, "event_handler")
    if handler is None or not isinstance(handler, Instance):
        return
    for name in ("on_exit", "on_start", "on_completion", "on_shutdown", "entities", "on_stdout", "on_stderr"):
        value = argument(handler, name)
        if value is not None:
            before, run.in_handler = run.in_handler, True
            visit(run, run.call_handler(value) if callable_value(value) else value)
            run.in_handler = before
