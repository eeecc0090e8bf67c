"""The functions that a launch file passes to launch, which calls them with its context: of an OpaqueFunction, of an
event handler, of a predicate."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.roots import module_of
from archlint.interpreter.values import DictValue, Known, Unknown, Value
from archlint.launch.objects import known_text, launch_object
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


PROCESS_END = "how a process ends"
PROCESS_OUTPUT = "what a process prints"


def call_handler(run: LaunchRun, function: Value, handler: str) -> Value:
    """Call the function of an event handler of a class (its name) with an event and the launch context."""
    known: dict[str, str] = {LaunchClass.ON_PROCESS_EXIT: PROCESS_END, LaunchClass.ON_PROCESS_IO: PROCESS_OUTPUT}
    unknown = Unknown(known.get(handler, "the argument of an event handler"))
    return call_opaque(run, function, [], None, before=[unknown])


def call_opaque(
    run: LaunchRun, function: Value, args: list[Value], kwargs: Value | None, before: Sequence[Value] = ()
) -> Value:
    """Call the function of an OpaqueFunction with a launch context; what it sets there stays set."""
    context, configurations = _context(run)
    result = _call(run, function, [*before, context, *args], _by_name(run, kwargs))
    run.launch.configurations.update(_by_name(run, configurations))
    return result


def ask(run: LaunchRun, function: Value) -> Value:
    """What a predicate or a ``perform`` of the workspace says of the launch context."""
    return _call(run, function, [_context(run)[0]], {})


def _by_name(run: LaunchRun, entries: Value | None) -> dict[str, Value]:
    """The entries of a dict whose keys are known."""
    rows = ((known_text(key), value) for key, value in run.entries(entries))
    return {name: value for name, value in rows if name is not None}


def _context(run: LaunchRun) -> tuple[Value, DictValue]:
    """The launch context as code sees it, and the dict of its configurations."""
    context = launch_object(run.store.new_key(), LaunchClass.LAUNCH_CONTEXT, None, {})
    entries = {Known(n).entry_key(): (Known(n), v) for n, v in run.launch.configurations.items()}
    configurations = containers.new_dict(run, {key: row for key, row in entries.items() if key is not None})
    run.store.set(context.key, "launch_configurations", configurations)
    return context, configurations


def _call(run: LaunchRun, function: Value, args: list[Value], keywords: dict[str, Value]) -> Value:
    module = module_of(function)
    if module is None:
        return Unknown("a function that launch calls, and that is not followed")
    if run.activations:
        return run.call(function, CallSite(args, keywords))
    with run.root(module):
        return run.call(function, CallSite(args, keywords))
