"""What code of a launch file reads: files of the workspace, and whether they are there."""

from __future__ import annotations

import fnmatch
import json
import posixpath
import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from archlint.interpreter import containers, items
from archlint.interpreter.values import (
    NONE,
    DictValue,
    Known,
    ListValue,
    Unknown,
    Value,
    constants_of,
    reason,
)
from archlint.launch import file_texts, written_files
from archlint.launch.kinds import FileKind, FileStatus
from archlint.launch.mistakes import AbsentKey
from archlint.launch.objects import argument, known_text
from archlint.launch.perform_calls import stops_the_launch
from archlint.launch.shared_paths import note_paths
from archlint.syntax.safe_yaml import YamlError, YamlReader

_FOR_WRITING = ("w", "wt", "w+")
_FOR_READING = ("None", "r", "rb", "rt")

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun
    from archlint.syntax import facts

    Plain = Callable[[LaunchRun, CallSite], Value]


def _open(run: LaunchRun, site: CallSite) -> Value:
    """``open(path)`` in a launch file: the file, for whoever loads YAML from it."""
    mode = known_text(site.args[1] if len(site.args) > 1 else site.keywords.get("mode", NONE))
    path = known_text(site.args[0]) if site.args else None
    if mode in _FOR_WRITING and path is not None:
        return written_files.written_file(run, path)
    if site.args and isinstance(site.args[0], Known):
        if mode in _FOR_READING and not site.keywords.keys() - {"encoding", "mode"}:
            _note_read(run, site)
        return file_texts.opened(run, site.args[0])
    return Unknown(reason(*site.args) if site.args else "a file")


def _processed(run: LaunchRun, site: CallSite) -> Value:
    """``xacro.process_file(path)`` and ``xacro.process(path)``, which read a robot."""
    if site.args:
        _note_read(run, site)
    return Unknown("what xacro makes of a file")


def _note_read(run: LaunchRun, site: CallSite) -> None:
    """Note the file that a call reads, which ends the launch if it is not there."""
    place = run.place_now if site.expression is None else run.place(site.expression.span)
    if stops_the_launch(run):
        note_paths(run, site.args[:1], place, kind=FileKind.READ)
    elif not run.activation.tries:
        note_paths(run, site.args[:1], run.place_now)


def _load_yaml(run: LaunchRun, site: CallSite) -> Value:
    """``yaml.safe_load(file)``: what a YAML file of this workspace holds."""
    return _of_yaml(run, _text_in(run, site.args), _file_of(run, site.args))


def yaml_file(run: LaunchRun, path: Value) -> Value:
    """What the YAML file at a path holds."""
    return _of_yaml(run, file_texts.text_of(run, path), _source_of(run, path))


def _of_yaml(run: LaunchRun, text: str | Unknown, file: str | None = None) -> Value:
    if isinstance(text, Unknown):
        return text
    try:
        reader = YamlReader(text)
        return value_of(run, None if reader.root is None else reader.value(reader.root), file)
    except (YamlError, RecursionError):
        return Unknown("the content of an invalid YAML file")


def _load_json(run: LaunchRun, site: CallSite) -> Value:
    """``json.load(file)`` and ``json.loads(text)``: what a JSON file of this workspace holds, or a text."""
    text = (
        Unknown("the content of a file that is opened in an unusual way") if site.keywords else _text_in(run, site.args)
    )
    if isinstance(text, Unknown):
        return text
    try:
        return value_of(run, json.loads(text), _file_of(run, site.args))
    except (ValueError, RecursionError):
        return Unknown("the content of an invalid JSON file")


def _text_in(run: LaunchRun, args: list[Value]) -> str | Unknown:
    """The text of the file that a loader is given."""
    return file_texts.text_in(run, args[0]) if args else Unknown("the content of a file")


def _file_of(run: LaunchRun, args: list[Value]) -> str | None:
    """The file of the workspace that a loader is given."""
    path = argument(args[0], "path") if args else None
    return None if path is None else _source_of(run, path)


def _source_of(run: LaunchRun, path: Value) -> str | None:
    return run.resolve(FileKind.PARAMETERS, path, run.place_now).source


def value_of(run: LaunchRun, value: object, file: str | None = None) -> Value:
    """What a file of the workspace holds, or a part of it."""
    match value:
        case Mapping():
            rows = {Known(key).entry_key(): (Known(key), value_of(run, item, file)) for key, item in value.items()}
            held = containers.new_dict(run, {key: row for key, row in rows.items() if key is not None})
            if file is not None and None not in rows:
                run.read_dicts[held.key] = file  # so that the file can be named for a key that is not there
            return held
        case list():
            return containers.new_list(run, [value_of(run, item, file) for item in value])
        case None | str() | int() | float():
            return Known(value)
    raise AssertionError(value)


def note_key(run: LaunchRun, held: DictValue, key: Known, expression: facts.Subscript) -> None:
    """Note where what a file holds is asked for what it does not have, which ends the launch with a KeyError."""
    file = run.read_dicts.get(held.key)
    if file is None or not isinstance(key.value, str) or not items.is_absent(run, held, key):
        return
    if stops_the_launch(run):
        known = tuple(str(name.value) for name, _ in run.entries(held) if isinstance(name, Known))
        run.note_absent_key(AbsentKey(key.value, known, file, run.place(expression.span)))


def is_there(run: LaunchRun, path: str) -> bool | None:
    """Whether a file or folder is installed; None where that is not known, as of other packages."""
    if not path.startswith("$(find-pkg-share "):
        return None
    match run.resolve(FileKind.PARAMETERS, Known(path), run.place_now).status:
        case FileStatus.INSTALLED:
            return True
        case FileStatus.MISSING if posixpath.splitext(path)[1]:  # a folder may have no file yet
            return False
    return None


FILE_OF_THE_MACHINE = "which files the machine has"
_NO_LISTING = Unknown("the files of a folder")
_WILD = re.compile(r"[*?\[]")


def _list_folder(run: LaunchRun, site: CallSite) -> Value:
    """``os.listdir(folder)``: the names, in the order of the alphabet for want of the file system's own."""
    folder = known_text(site.args[0]) if site.args else None
    names = None if folder is None else run.paths.entries_in(folder)
    return _NO_LISTING if names is None else containers.new_list(run, [Known(name) for name in names])


def _glob(run: LaunchRun, site: CallSite) -> Value:
    """``glob.glob('folder/*.yaml')``."""
    pattern = known_text(site.args[0]) if len(site.args) == 1 and not site.keywords else None
    folder, _, last = (pattern or "").rpartition("/")
    paths = None if not folder or _WILD.search(folder) else matches(run, folder, last)
    return _NO_LISTING if paths is None else containers.new_list(run, [Known(path) for path in paths])


def matches(run: LaunchRun, folder: str, pattern: str) -> list[str] | None:
    """The paths of what is installed in a folder under a name that matches; None where that is not known."""
    names = run.paths.entries_in(folder)
    if names is None or "/" in pattern or "**" in pattern:
        return None
    shown = [name for name in names if pattern.startswith(".") or not name.startswith(".")]
    return [f"{folder}/{name}" for name in fnmatch.filter(shown, pattern)]


def _written(write: Callable[..., str], name: str, options: frozenset[str]) -> Plain:
    """``yaml.dump(data)`` or ``json.dumps(data)``: the text.  Into a file these make none."""

    def written(run: LaunchRun, site: CallSite) -> Value:
        keywords = {key: value for key, value in site.keywords.items() if key not in ("stream", "fp")}
        data, *streams = [*site.args, *(site.keywords[key] for key in ("stream", "fp") if key in site.keywords)] or [
            NONE
        ]
        given = constants_of(keywords.values())
        if not site.args or len(streams) > 1 or given is None or not options.issuperset(keywords):
            text: Value = Unknown(f"what {name}() writes")
        else:
            text = _as_text(run, data, write, dict(zip(keywords, given, strict=True)))
        for stream in streams:
            written_files.write(run, stream, text)
        return NONE if streams else text

    return written


def _as_text(run: LaunchRun, data: Value, write: Callable[..., str], options: dict[str, Any]) -> Value:
    try:
        return Known(write(_plain(run, data, 0), **options))
    except _NotKnownError as error:
        return Unknown(str(error))
    except (TypeError, ValueError, RecursionError):
        return Unknown("an operation that fails")


def _dumped(data: object, **options: Any) -> str:
    import yaml

    return str(yaml.safe_dump(data, **options))


class _NotKnownError(Exception):
    """Why a part of a value is not known."""


def _plain(run: LaunchRun, value: Value, depth: int) -> object:
    """The object of Python that a value stands for."""
    if depth > NESTED:
        raise _NotKnownError("data that is nested too deeply")
    match value:
        case Known(kind="path"):
            raise _NotKnownError("a path in YAML")
        case Known(value=constant):
            return constant
        case ListValue(kind="list") if run.is_closed(value):
            return [_plain(run, item, depth + 1) for item in run.items(value)]
        case DictValue() if not value.entries(run).open:
            rows = value.entries(run).entries.values()
            return {_key(key): _plain(run, item, depth + 1) for key, item in rows}
    raise _NotKnownError(reason(value))


def _key(key: Value) -> object:
    if not isinstance(key, Known):
        raise _NotKnownError(reason(key))
    return key.value


NESTED = 20
"""How deep data may be nested that is written as a text."""
_YAML_OPTIONS = frozenset({"default_flow_style", "sort_keys", "indent", "width", "allow_unicode"})
_JSON_OPTIONS = frozenset({"indent", "sort_keys", "ensure_ascii"})

PLAIN: dict[str, Plain] = {
    "open": _open,
    "os.listdir": _list_folder,
    "glob.glob": _glob,
    "glob.iglob": _glob,
    "json.load": _load_json,
    "json.loads": _load_json,
    "yaml.safe_load": _load_yaml,
    "yaml.load": _load_yaml,
    "yaml.full_load": _load_yaml,
    "xacro.process": _processed,
    "xacro.process_file": _processed,
    "yaml.dump": _written(_dumped, "yaml.dump", _YAML_OPTIONS),
    "yaml.safe_dump": _written(_dumped, "yaml.safe_dump", _YAML_OPTIONS),
    "json.dump": _written(json.dumps, "json.dump", _JSON_OPTIONS),
    "json.dumps": _written(json.dumps, "json.dumps", _JSON_OPTIONS),
}

__all__ = ["FILE_OF_THE_MACHINE", "PLAIN", "is_there", "matches", "note_key", "value_of", "yaml_file"]
