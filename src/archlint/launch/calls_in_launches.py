"""Calls of launch's API, and of what reads files, in a launch: its context and the files of the workspace decide."""

from __future__ import annotations

import json
import posixpath
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    External,
    Instance,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)
from archlint.launch import calls
from archlint.launch.kinds import FileKind
from archlint.launch.mistakes import NotAPath
from archlint.launch.objects import LaunchObject, argument, known_text, made_by_base
from archlint.launch.perform_calls import perform_method, stops_the_launch
from archlint.launch.substitutions.paths import package_prefix, package_share
from archlint.launch.tables import CONDITIONS, SUBSTITUTIONS, LaunchClass
from archlint.libraries.python.effects import path_join
from archlint.syntax.safe_yaml import YamlError, YamlReader

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun
    from archlint.libraries.api_use import ApiUse

NODES = frozenset(
    {
        LaunchClass.NODE,
        LaunchClass.LIFECYCLE_NODE,
        LaunchClass.COMPOSABLE_NODE_CONTAINER,
        LaunchClass.COMPOSABLE_NODE,
        LaunchClass.COMPOSABLE_LIFECYCLE_NODE,
    }
)


def _launch_object(run: LaunchRun, call: ApiUse) -> LaunchObject:
    """Note, too, where nodes and declarations are made, whether they then become part of the launch or not."""
    instance = calls.made_object(run, call)
    if instance.place is None:
        return instance
    if instance.kind in NODES:
        run.result.node_actions.add(instance.place)
    name = known_text(instance.arguments.get("name"))
    if instance.kind == LaunchClass.DECLARE_LAUNCH_ARGUMENT and name is not None:
        run.result.written.setdefault((run.file, name), instance.place)
    return instance


def _package_share(run: LaunchRun, call: ApiUse) -> Value:
    """``get_package_share_directory('pkg')``."""
    as_path = call.api.path.endswith("_path")
    return _of_package(run, call, _share_as_path if as_path else package_share)


def _share_as_path(package: str) -> Value:
    return replace(package_share(package), kind="path")


def _package_prefix(run: LaunchRun, call: ApiUse) -> Value:
    """``get_package_prefix('pkg')``."""
    return _of_package(run, call, package_prefix)


def _of_package(run: LaunchRun, call: ApiUse, folder_of: Callable[[str], Value]) -> Value:
    options = alternatives(call.get("package_name") or Unknown("no package is given"))
    names = [run.perform(option) for option in options]
    texts = [(name, known_text(name)) for name in names]
    return one_of(Unknown(reason(name)) if text is None else folder_of(text) for name, text in texts)


def _path_join(run: LaunchRun, call: ApiUse) -> Value:
    """``os.path.join(…)``, which raises a TypeError for a substitution: only launch can make a text of that."""
    if call.expression is not None and stops_the_launch(run):
        place = run.place(call.expression.span)
        for part in (call.get("path"), *call.rest):
            match part:
                case LaunchObject(is_substitution=True, kind=kind):
                    package = known_text(part.argument("package")) if kind == LaunchClass.FIND_PACKAGE_SHARE else None
                    run.note_joined(NotAPath(kind, package, place))
                    break
    return path_join(run, call)


EFFECTS = {
    "launch_object": _launch_object,
    "package_share": _package_share,
    "package_prefix": _package_prefix,
    "path_join": _path_join,
}


def _perform_argument(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    values = site.values
    asked = values[-1] if values else NONE
    return run.perform(made_by_base(run, asked) or asked)  # a class of the workspace asks its base


def _evaluate(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``IfCondition(…).evaluate(context)``."""
    verdict = run.judge(receiver)
    return Unknown(calls.UNDECIDED) if verdict.holds is None else Known(verdict.holds)


METHODS = {
    "launch.LaunchContext.perform_substitution": _perform_argument,
    **{f"launch.{name}.perform": perform_method for name in SUBSTITUTIONS},
    **{f"launch.{name}.evaluate": _evaluate for name in CONDITIONS},
}


def _perform_all(run: LaunchRun, site: CallSite) -> Value:
    return _perform_argument(run, NONE, site)


def _path(run: LaunchRun, site: CallSite) -> Value:
    """``Path(a, b)`` in a launch file is a text for us: launch takes both."""
    texts = [text for text in map(known_text, site.args) if text is not None]
    if len(texts) != len(site.args) or not site.args:
        return Unknown(reason(*site.args))
    return Known(posixpath.join(*texts), kind="path")


def _same_path(run: LaunchRun, site: CallSite) -> Value:
    path = known_text(site.args[0]) if site.args else None
    return Unknown("a path of this machine") if path is None else Known(posixpath.normpath(path))


def _open(run: LaunchRun, site: CallSite) -> Value:
    """``open(path)`` in a launch file: the file, for whoever loads YAML from it."""
    if site.args and isinstance(site.args[0], Known):
        return opened(run, site.args[0])
    return Unknown(reason(*site.args) if site.args else "a file")


def opened(run: LaunchRun, path: Known) -> Instance:
    """A file that is open for reading."""
    return Instance(External("io.TextIOWrapper"), run.store.new_key(), None, {"path": path})


def _load_yaml(run: LaunchRun, site: CallSite) -> Value:
    """``yaml.safe_load(file)``: what a YAML file of this workspace holds."""
    text = _text_in(run, site.args)
    if isinstance(text, Unknown):
        return text
    try:
        reader = YamlReader(text)
        return _value_of(run, None if reader.root is None else reader.value(reader.root))
    except (YamlError, RecursionError):
        return Unknown("the content of a YAML file that is broken")


def _load_json(run: LaunchRun, site: CallSite) -> Value:
    """``json.load(file)``: what a JSON file of this workspace holds."""
    text = (
        Unknown("the content of a file that is read in a way of its own") if site.keywords else _text_in(run, site.args)
    )
    if isinstance(text, Unknown):
        return text
    try:
        return _value_of(run, json.loads(text))
    except (ValueError, RecursionError):
        return Unknown("the content of a JSON file that is broken")


def _text_in(run: LaunchRun, args: list[Value]) -> str | Unknown:
    """The text of the file that a loader is given."""
    path = argument(args[0], "path") if args else None
    if path is None:
        return Unknown("the content of a file")
    text = run.paths.text(run.resolve(FileKind.PARAMETERS, path, run.place_now))
    return Unknown("the content of a file that is not in this workspace") if text is None else text


def _value_of(run: LaunchRun, value: object) -> Value:
    match value:
        case dict():
            rows = {Known(key).entry_key(): (Known(key), _value_of(run, item)) for key, item in value.items()}
            return containers.new_dict(run, {key: row for key, row in rows.items() if key is not None})
        case list():
            return containers.new_list(run, [_value_of(run, item) for item in value])
        case None | str() | int() | float():
            return Known(value)
    raise AssertionError(value)


def _run_path(run: LaunchRun, site: CallSite) -> Value:
    """``runpy.run_path(path)``: the variables of a file of this workspace, once it has run."""
    if len(site.args) != 1 or site.keywords:
        return Unknown("what a file makes of the variables that it is given")
    source = run.resolve(FileKind.LAUNCH, run.perform(site.args[0]), run.place_now).source
    file = None if source is None else run.files.source_file(source)
    module = None if file is None else run.index.module(file)
    if module is None or module.state == "running":
        return Unknown("what a file makes that is not followed")
    run.import_module(module)
    assert module.scope is not None
    variables = dict(run.store.variables(module.scope.key))
    return containers.dict_of_names(run, variables, open_=bool(module.star_externals))


PLAIN = {
    "runpy.run_path": _run_path,
    "open": _open,
    "json.load": _load_json,
    "yaml.safe_load": _load_yaml,
    "yaml.load": _load_yaml,
    "yaml.full_load": _load_yaml,
    "launch.utilities.perform_substitutions": _perform_all,
    "pathlib.Path": _path,
    "pathlib.PurePath": _path,
    "os.path.abspath": _same_path,
    "os.path.realpath": _same_path,
    "os.path.normpath": _same_path,
}
