"""Values of a launch file in Python that launch refuses where it wants texts, or pairs of them.

Source: launch's ``normalize_to_list_of_substitutions``, which takes a string, a substitution, or a list of both, and
raises a TypeError for anything else; ``IncludeLaunchDescription``, which goes through ``launch_arguments`` as pairs;
``Executable``, which makes texts of each word of a command line; launch_ros's ``normalize_parameter_dict``, which
raises a TypeError for None and, unlike launch, for a path of pathlib.  All of them are so from humble to rolling.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.interpreter.values import NONE, DictValue, Known, ListValue, Value, alternatives
from archlint.launch.actions.pairs import pairs_of
from archlint.launch.mistakes import RefusedValue
from archlint.launch.objects import LaunchObject
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

_TEXTS: Mapping[LaunchClass, tuple[str, ...]] = {
    LaunchClass.DECLARE_LAUNCH_ARGUMENT: ("default_value",),
    LaunchClass.SET_LAUNCH_CONFIGURATION: ("value",),
    LaunchClass.SET_ENVIRONMENT_VARIABLE: ("value",),
}
"""The parameters that are one text."""
_WORDS: Mapping[LaunchClass, tuple[str, ...]] = {
    LaunchClass.NODE: ("arguments", "ros_arguments"),
    LaunchClass.LIFECYCLE_NODE: ("arguments", "ros_arguments"),
    LaunchClass.COMPOSABLE_NODE_CONTAINER: ("arguments", "ros_arguments"),
    LaunchClass.EXECUTE_PROCESS: ("cmd",),
}
"""The parameters that are a list of texts."""
_NODES = frozenset({LaunchClass.NODE, LaunchClass.LIFECYCLE_NODE, LaunchClass.COMPOSABLE_NODE_CONTAINER})
_DEPTH = 4
"""How deep dicts of parameters are looked into."""


def note_refused_values(run: LaunchRun, action: LaunchObject) -> None:
    """Note each argument of an action that launch refuses for what it is."""
    for mistake in _refused(run, action):
        run.note_refused_value(mistake)


def _refused(run: LaunchRun, action: LaunchObject) -> Iterator[RefusedValue]:
    for name in _TEXTS.get(action.kind, ()):
        value = action.argument(name)
        if value is not None and name in action.places:
            what = _no_text(run, value)
            if what is not None:
                yield RefusedValue(action.kind, name, what, action.places[name])
    for name in _WORDS.get(action.kind, ()):
        words = action.argument(name)
        if isinstance(words, ListValue) and name in action.places:
            refused = (_no_text(run, word) for word in run.items(words))
            what = next((what for what in refused if what is not None), None)
            if what is not None:
                yield RefusedValue(action.kind, name, what, action.places[name], in_list=True)
    given = action.argument("parameters") if action.kind in _NODES else None
    for parameters in run.items(given) if isinstance(given, ListValue) else ():
        if isinstance(parameters, DictValue):
            yield from _of_parameters(run, action, parameters)
    if action.kind is LaunchClass.INCLUDE_LAUNCH_DESCRIPTION and "launch_arguments" in action.places:
        yield from _of_include(run, action)


def _of_parameters(
    run: LaunchRun, action: LaunchObject, parameters: DictValue, within: str = "", depth: int = _DEPTH
) -> Iterator[RefusedValue]:
    entries = parameters.entries(run)
    for key, value in () if entries.open else entries.entries.values():
        own = run.text_of(key)
        name = None if own is None else f"{within}{own}"
        what = _no_parameter(value)
        place = key.origin if isinstance(key, Known) else None
        if name is not None and isinstance(value, DictValue) and depth:
            yield from _of_parameters(run, action, value, f"{name}.", depth - 1)
        elif name is not None and what is not None and (place or "parameters" in action.places):
            yield RefusedValue(action.kind, name, what, place or action.places["parameters"], as_parameter=True)


def _no_parameter(value: Value) -> str | None:
    """What a value certainly is that no parameter can be; None where it may be one."""
    kinds = {_kind_of_no_parameter(option) for option in alternatives(value)}
    return kinds.pop() if len(kinds) == 1 else None


def _kind_of_no_parameter(value: Value) -> str | None:
    match value:
        case Known(value=None):
            return "None"
        case Known(value=str(), kind="path"):
            return _PATH
    return None


_PATH = "a pathlib.Path"


def _of_include(run: LaunchRun, action: LaunchObject) -> Iterator[RefusedValue]:
    arguments = action.argument("launch_arguments")
    if isinstance(arguments, DictValue) and run.entries(arguments):
        yield RefusedValue(action.kind, "launch_arguments", "a dict", action.places["launch_arguments"], pairs=True)
    for pair in pairs_of(run, arguments):
        name, what = run.text_of(pair.first), _no_text(run, pair.second, or_none=True)
        if name is not None and what is not None:
            yield RefusedValue(action.kind, name, what, pair.place, argument=True)


def _no_text(run: LaunchRun, value: Value, *, or_none: bool = False) -> str | None:
    """What a value certainly is that launch makes no text of; None where it may be one."""
    several = [_what(run, option) for option in alternatives(value)]
    if not or_none and NONE in alternatives(value):
        return None
    return None if None in several else next(iter(several), None)


def _what(run: LaunchRun, value: Value) -> str | None:
    match value:
        case Known(value=bool() | int() | float() | None as constant):
            return repr(constant)
        case ListValue():
            return next((f"a list with {what}" for item in run.items(value) if (what := _what(run, item))), None)
    return None


__all__ = ["note_refused_values"]
