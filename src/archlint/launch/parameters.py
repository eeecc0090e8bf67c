"""The ``parameters=`` of a node: dicts, files and single parameters, with the types that ROS gives them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import (
    Builtin,
    DictValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Value,
    reason,
)
from archlint.launch import file_texts, written_files
from archlint.launch.kinds import FileKind
from archlint.launch.named_files import FileReference, Written
from archlint.launch.objects import LaunchObject, class_name, kind_of, known_text, place_of
from archlint.launch.parameter_sources import CURRENT_FOLDER, OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.tables import SUBSTITUTIONS, LaunchClass
from archlint.syntax.parameter_files import NotKnown, ParameterData
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
    match value:
        case None:
            return []
        case OneOf(values=options):
            with run.perhaps():
                rows = [row for option in options for row in parameters_of(run, option, place)]
            return [_one_of_several("lists of parameters", value, place), *rows]
        case ListValue():
            items = value.items(run)
            rows = [row for item in items.values for row in _of_item(run, item, place)]
            return [*rows, OpenParameters("a list of parameters that is not known", place)] if items.open else rows
        case DictValue() | Known():
            return list(_of_item(run, value, place))
    return list(_of_item(run, value, place)) if class_name(value) else [OpenParameters(reason(value), place)]


def _one_of_several(what: str, value: Value, place: Place) -> OpenParameters:
    why = f": {value.why_open}" if value.why_open is not None else ""
    return OpenParameters(f"one of several {what}{why}", place, of_several=True)


def _of_item(run: LaunchRun, item: Value, place: Place) -> Iterator[Parameter]:
    place = place_of(item) or place
    match item:
        case OneOf(values=options):
            yield _one_of_several("parameters", item, place)
            with run.perhaps():
                rows = [row for option in options for row in _of_item(run, option, place)]
            yield from rows
        case DictValue():
            rows = list(_entries(run, item, (), place, _Room()))
            # What a dict writes out is taken to stand behind ``**others``, which is not known.
            yield from sorted(rows, key=lambda row: not row.is_open)
        case LaunchObject(kind=LaunchClass.PARAMETER):
            alone = setting(run, run.perform(item.argument("name")), item.given("value"), place)
            yield replace(alone, in_file=False)
        case LaunchObject(kind=LaunchClass.PARAMETER_FILE):
            substitutions = item.argument("allow_substs") not in (None, Known(False), Known(None))
            yield file_use(run, item.argument("param_file"), place, substitutions)
        case Known() | ListValue() | Holed() | LaunchObject(is_substitution=True):
            yield file_use(run, item, place)
        case _:
            yield OpenParameters(reason(item), place)


def file_use(run: LaunchRun, value: Value | None, place: Place, substitutions: bool = False) -> ParameterFileUse:
    match value:
        case Known(kind="literal", origin=origin) if origin is not None:
            place = origin
    path = run.perform(value)
    made_file = run.made_files.get(known_text(path) or "")
    match path:
        case Known(origin=origin) if made_file is not None:
            path = Known(made_file.source, origin=origin)
    changes = () if made_file is None else made_file.changes
    reference, written = _of_launch(run, _as_launch_has_it(path), place)
    known = sorted(run.launch.known_configurations().items()) if substitutions else ()
    return ParameterFileUse(reference, place, substitutions, configurations=tuple(known), changes=(*written, *changes))


def _as_launch_has_it(path: Value) -> Value:
    match path:
        case Known(value="", origin=origin):
            return Known(CURRENT_FOLDER, origin=origin)
    return path


def _of_launch(run: LaunchRun, path: Value, place: Place) -> tuple[FileReference, tuple[Written, ...]]:
    """The file at a path; where the code of the launch file writes it, what is in it."""
    text = written_files.content(run, known_text(path) or "")
    if text is None:
        return run.reference(FileKind.PARAMETERS, path, place), ()
    reference = run.resolve(FileKind.PARAMETERS, path, place)
    if text.text is None:
        return replace(reference, written=None, reason=reason(text)), ()
    return replace(reference, reason=None), (Written(text.text),)


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
    entries = item.entries(run)
    for key, value in entries.entries.values():
        name, where = run.perform(key), _written_at(key) or place
        text = known_text(name)
        if text is not None and within:
            text = f"{within[-1][0]}.{text}"
        match value:
            case DictValue() if text is not None:
                room.depth += 1
                yield from _entries(run, value, (*within, (text, where)), where, room)
                room.depth -= 1
            case _:
                data = python_of(run, value)
                yield ParameterSetting(text, data, where, within=within, given=_given_at(run, value, data))
    if entries.open:
        yield OpenParameters("a dict of parameters with entries that are not known", place)


def _written_at(key: Value) -> Place | None:
    return key.origin if isinstance(key, Known) else None


def setting(run: LaunchRun, name: Value, value: Value, place: Place) -> ParameterSetting:
    data = python_of(run, value)
    return ParameterSetting(known_text(name), data, place, given=_given_at(run, value, data))


def _given_at(run: LaunchRun, value: Value, data: ParameterData) -> Place | None:
    """Where the text is written that a parameter is set to."""
    text = run.perform(value) if isinstance(data, str) else None
    return text.origin if isinstance(text, Known) else None


def python_of(run: LaunchRun, value: Value) -> ParameterData:
    """The value of a parameter, or :class:`NotKnown`: constants as they are, the text of a substitution as YAML."""
    match value:
        case Known(value=None):
            return NotKnown("None is not a parameter value")
        case Known(value=constant):
            return constant
        case LaunchObject(kind=LaunchClass.PARAMETER_VALUE):
            return _typed(run, value)
        case LaunchObject(is_substitution=True):
            return _of_text(run.perform(value))
        case ListValue():
            return _list(run, value)
        case Instance(cls=External(path=file_texts.FILE)):
            return NotKnown("the text of a file")
    return NotKnown(reason(value))


def _of_text(text: Value) -> ParameterData:
    known = known_text(text)
    return NotKnown(reason(text)) if known is None else from_yaml(known)


def _list(run: LaunchRun, value: ListValue) -> ParameterData:
    """A list of constants is an array; one with substitutions among texts is one text."""
    items = value.items(run)
    if items.open:
        return NotKnown("a list that is only partly known")
    if any(isinstance(item, ListValue) for item in items.values):
        return _texts(run, items.values)
    if any(kind_of(item) in SUBSTITUTIONS for item in items.values):
        return _of_text(run.perform(value))
    rows = [python_of(run, item) for item in items.values]
    return next((row for row in rows if isinstance(row, NotKnown)), rows)


def _texts(run: LaunchRun, items: Sequence[Value]) -> ParameterData:
    """``[[a, 'b'], [c, 'd']]``: each list is one text, and all of them are read as YAML where that gives one type.

    Source: launch_ros, ``_normalize_parameter_array_value`` and ``evaluate_parameter_dict``.
    """
    lists = [item for item in items if isinstance(item, ListValue)]
    if any(isinstance(inner, ListValue) for item in lists for inner in item.items(run).values):
        return NotKnown("a parameter cannot be a list of lists")  # and a list may hold itself
    if len(lists) + sum(kind_of(item) in SUBSTITUTIONS for item in items) < len(items):
        return NotKnown("a list of texts and of lists")
    texts = [run.perform(item) for item in items]
    known = [text for text in map(known_text, texts) if text is not None]
    if len(known) < len(texts):
        return NotKnown(reason(*texts))
    rows = [from_yaml(text) for text in known]
    alike = len({type(row) for row in rows}) == 1 and isinstance(rows[0], (bool, int, float, str))
    return rows if alike else [*known]


TYPES = {"str": str, "int": int, "float": float, "bool": bool}


def _typed(run: LaunchRun, value: LaunchObject) -> ParameterData:
    """``ParameterValue(value, value_type=str)``."""
    inner, name = value.given("value"), _name_of_type(value.argument("value_type"))
    if not name:
        return python_of(run, inner)
    if name not in TYPES:
        return NotKnown(f"a value of the type '{name}'")
    text = run.perform(inner)
    known = known_text(text)
    if known is None:
        return NotKnown(reason(text))
    return known if name == "str" else of_type(from_yaml(known), name)


def _name_of_type(kind: Value | None) -> str:
    match kind:
        case Builtin(name=name):
            return name
        case External(path=path):
            return path.rpartition(".")[2]
    return ""


def of_type(value: ParameterData, name: str) -> ParameterData:
    """A value that was read as YAML, where it has the type of this name; an ``int`` is a ``float``, too."""
    match value:
        case NotKnown():
            return value
        case int() if name == "float" and value is not True and value is not False:
            return float(value)
    return value if isinstance(value, TYPES[name]) else NotKnown(f"a value that is not of type {name}")


def from_yaml(text: str) -> ParameterData:
    """A text as launch_ros reads a parameter without a type: as YAML."""
    if len(text) > CONSTANT_LIMIT:
        return NotKnown("a string too long to follow")
    if not text[:1] or text[0] not in "[{\"'!&*":
        return text if ": " in text or "\n" in text else plain_scalar(text.strip())
    try:
        reader = YamlReader(text)
        data = reader.value(reader.root) if reader.root is not None else None
    except (YamlError, RecursionError):
        return text
    return NotKnown("a parameter cannot be a map") if isinstance(data, dict) else data


__all__ = ["TYPES", "Parameter", "file_use", "from_yaml", "of_type", "parameters_of", "python_of", "setting"]
