"""The ``parameters=`` of a node: dicts, files and single parameters, with the types that ROS gives them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.values import (
    Builtin,
    DictValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    reason,
)
from archlint.launch.model import FileKind, OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.objects import argument, kind_of
from archlint.launch.tables import SUBSTITUTIONS
from archlint.syntax.parameter_files import NotKnown
from archlint.syntax.safe_yaml import YamlError, YamlReader, plain_scalar

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

Parameter = ParameterSetting | ParameterFileUse | OpenParameters

Within = tuple[tuple[str, Place], ...]
"""The keys of the dicts around an entry: the name that each comes to, and its place."""

CONSTANT_LIMIT = 20_000
NESTED = 10
"""How deep dicts of parameters may be nested: robot_localization and nav2 need four."""
SETTINGS = 4_096
"""How many dicts one dict of parameters may come to."""


def parameters_of(run: LaunchRun, value: Value | None, place: Place) -> list[Parameter]:
    """What a list of parameters sets, in order."""
    if value is None:
        return []
    if isinstance(value, OneOf):
        with run.perhaps():
            options = [found for option in value.values for found in parameters_of(run, option, place)]
        return [OpenParameters("one of several lists of parameters", place, of_several=True), *options]
    items = containers.iterate(run, value) if isinstance(value, ListValue) else None
    if items is None:
        if isinstance(value, (DictValue, Known)) or kind_of(value):
            return list(_one(run, value, place))
        return [OpenParameters(reason(value), place)]
    found: list[Parameter] = []
    for item in items.values:
        found.extend(_one(run, item, place))
    if items.open:
        found.append(OpenParameters("a list of parameters that is not known", place))
    return found


def _one(run: LaunchRun, item: Value, place: Place) -> Iterator[Parameter]:
    kind = kind_of(item)
    if isinstance(item, Instance) and item.place is not None:
        place = item.place
    if isinstance(item, OneOf):
        yield OpenParameters("one of several parameters", place, of_several=True)
        with run.perhaps():
            found = [one for option in item.values for one in _one(run, option, place)]
        yield from found
    elif isinstance(item, DictValue):
        yield from _entries(run, item, (), place, _Room())
    elif kind == "Parameter":
        yield setting(run, run.perform(argument(item, "name")), _given(item, "value"), place)
    elif kind == "ParameterFile":
        substitutions = argument(item, "allow_substs") == Known(True)
        yield file_use(run, argument(item, "param_file"), place, substitutions)
    elif isinstance(item, Known) or kind in SUBSTITUTIONS or isinstance(item, (ListValue, Holed)):
        yield file_use(run, item, place)
    else:
        yield OpenParameters(reason(item), place)


def file_use(run: LaunchRun, value: Value | None, place: Place, substitutions: bool = False) -> ParameterFileUse:
    if isinstance(value, Known) and value.origin is not None and value.kind == "literal":
        place = value.origin
    path = run.perform(value)
    made = run.made_files.get(str(path.value)) if isinstance(path, Known) else None
    if made is not None and isinstance(path, Known):
        path = Known(made.source, origin=path.origin)
    reference = run.reference(FileKind.PARAMETERS, path, place)
    known: tuple[tuple[str, str], ...] = ()
    if substitutions:
        rows = run.launch.configurations.items()
        known = tuple(sorted((name, str(one.value)) for name, one in rows if isinstance(one, Known)))
    changes = () if made is None else made.changes
    return ParameterFileUse(reference, place, substitutions, configurations=known, changes=changes)


def _given(item: Value, name: str) -> Value:
    found = item.arguments.get(name) if isinstance(item, Instance) else None
    return found if found is not None else Known(None)


class _Room:
    """How many more dicts are followed, and how deep: a dict may hold another many times, or itself."""

    def __init__(self) -> None:
        self.left = SETTINGS
        self.depth = 0


def _entries(run: LaunchRun, item: DictValue, within: Within, place: Place, room: _Room) -> Iterator[Parameter]:
    room.left -= 1
    if room.left < 0 or room.depth >= NESTED:
        yield OpenParameters("more parameters than can be followed", place)
        return
    entries = containers.entries_of(run, item)
    for key, value in entries.entries.values():
        name = run.perform(key)
        where = key.origin if isinstance(key, Known) and key.origin is not None else place
        if isinstance(name, Known) and within:
            name = Known(f"{within[-1][0]}.{name.value!s}")
        if isinstance(value, DictValue) and isinstance(name, Known):
            room.depth += 1
            yield from _entries(run, value, (*within, (str(name.value), where)), where, room)
            room.depth -= 1
        else:
            yield replace(setting(run, name, value, where), within=within)
    if entries.open:
        yield OpenParameters("a dict of parameters with entries that are not known", place)


def setting(run: LaunchRun, name: Value, value: Value, place: Place) -> ParameterSetting:
    text = str(name.value) if isinstance(name, Known) else None
    return ParameterSetting(text, python_of(run, value), place)


def python_of(run: LaunchRun, value: Value) -> object:
    """The value of a parameter, or :class:`NotKnown`: constants as they are, the text of a substitution as YAML."""
    if isinstance(value, Known):
        return NotKnown("None is no value of a parameter") if value.value is None else value.value
    kind = kind_of(value)
    if kind == "ParameterValue":
        return _typed(run, value)
    if kind in SUBSTITUTIONS:
        return _of_text(run.perform(value))
    if isinstance(value, ListValue):
        return _list(run, value)
    return NotKnown(reason(value))


def _of_text(text: Value) -> object:
    return from_yaml(str(text.value)) if isinstance(text, Known) else NotKnown(reason(text))


def _list(run: LaunchRun, value: ListValue) -> object:
    """A list of constants is an array; one with substitutions among texts is one text."""
    items = containers.items_of(run, value)
    if items.open:
        return NotKnown("a list that is not known to its end")
    if any(kind_of(item) in SUBSTITUTIONS for item in items.values):
        if all(kind_of(item) in SUBSTITUTIONS for item in items.values) and len(items.values) > 1:
            return NotKnown("a list of substitutions only")
        return _of_text(run.perform(value))
    if any(isinstance(item, ListValue) for item in items.values):
        return NotKnown("no parameter is a list of lists")  # and a list may hold itself
    rows = [python_of(run, item) for item in items.values]
    return next((row for row in rows if isinstance(row, NotKnown)), rows)


_TYPES = {"str": str, "int": int, "float": float, "bool": bool}


def _typed(run: LaunchRun, value: Value) -> object:
    """``ParameterValue(value, value_type=str)``."""
    inner = _given(value, "value")
    kind = argument(value, "value_type")
    name = (
        kind.name if isinstance(kind, Builtin) else kind.path.rpartition(".")[2] if isinstance(kind, External) else ""
    )
    if not name:
        return python_of(run, inner)
    if name not in _TYPES:
        return NotKnown(f"a value of the type '{name}'")
    text = run.perform(inner)
    if not isinstance(text, Known):
        return NotKnown(reason(text))
    if name == "str":
        return str(text.value)
    found = from_yaml(str(text.value))
    if name == "float" and isinstance(found, int) and not isinstance(found, bool):
        return float(found)
    return found if isinstance(found, (_TYPES[name], NotKnown)) else NotKnown(f"a value that is no {name}")


def from_yaml(text: str) -> object:
    """A text as launch_ros reads a parameter without a type: as YAML."""
    if len(text) > CONSTANT_LIMIT:
        return NotKnown("a text too long to follow")
    if not text[:1] or text[0] not in "[{\"'!&*":
        return text if ": " in text or "\n" in text else plain_scalar(text.strip())
    try:
        reader = YamlReader(text)
        found = reader.value(reader.root) if reader.root is not None else None
    except (YamlError, RecursionError):
        return text
    return NotKnown("no parameter is a map") if isinstance(found, dict) else found


__all__ = ["Parameter", "Unknown", "file_use", "from_yaml", "parameters_of", "python_of", "setting"]
