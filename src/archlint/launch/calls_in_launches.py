"""Calls of launch's API, and of what reads files, in a launch: its context and the files of the workspace decide."""

from __future__ import annotations

import posixpath
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter import path_parts
from archlint.interpreter.values import (
    NONE,
    External,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    one_of,
    reason,
)
from archlint.launch import (
    calls,
    expressions,
    file_texts,
    loaded_modules,
    mathematics,
    read_files,
    robot_poses,
    written_files,
)
from archlint.launch.frontends.objects import Frontend
from archlint.launch.mistakes import NotAPath
from archlint.launch.moveit_configs import actions as moveit_actions
from archlint.launch.moveit_configs import descriptions
from archlint.launch.moveit_configs import methods as moveit_methods
from archlint.launch.objects import LaunchObject, argument, known_text, made_by_base
from archlint.launch.perform_calls import is_without_context, perform_method, stops_the_launch
from archlint.launch.substitutions.paths import package_prefix, package_share
from archlint.launch.tables import CONDITIONS, SUBSTITUTIONS, LaunchClass
from archlint.launch.unknown_keywords import note_of_constructor
from archlint.libraries.python.effects import path_join

if TYPE_CHECKING:
    from archlint.finding import Place
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
    note_of_constructor(run, instance)
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
    folders = [Unknown(reason(name)) if text is None else folder_of(text) for name, text in texts]
    return chosen_with(one_of(folders), call.get("package_name") or NONE)


def _path_join(run: LaunchRun, call: ApiUse) -> Value:
    """``os.path.join(…)``, which raises a TypeError for a substitution, of which only launch can make a text, and for a
    tuple, which a comma too many makes."""
    if call.expression is not None and stops_the_launch(run):
        place = run.place(call.expression.span)
        for part in (call.get("path"), *call.rest):
            match part:
                case LaunchObject(is_substitution=True, kind=kind):
                    package = known_text(part.argument("package")) if kind == LaunchClass.FIND_PACKAGE_SHARE else None
                    run.note_joined(NotAPath(kind, package, place))
                    break
                case ListValue(kind="tuple"):
                    run.note_joined(NotAPath("", None, place))
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
    """``IfCondition(…).evaluate(context)``, also by the name of what it calls."""
    if is_without_context(run, argument(receiver, "predicate_expression"), site):
        return Unknown(calls.UNDECIDED)
    verdict = run.judge(receiver)
    return Unknown(calls.UNDECIDED) if verdict.holds is None else Known(verdict.holds)


def _logger(run: LaunchRun, site: CallSite) -> Value:
    """``logging.getLogger(name)``."""
    return Instance(External(_LOGGER), run.store.new_key(), None, {})


def _said(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    return NONE


def _logged(run: LaunchRun, site: CallSite) -> Value:
    return NONE


_SETTERS = (LaunchClass.SET_LAUNCH_CONFIGURATION, LaunchClass.SET_ENVIRONMENT_VARIABLE)
"""Actions that do something to the context and return nothing."""
_LOGGER = "logging.Logger"
_LOGS = ("critical", "debug", "error", "exception", "info", "log", "warn", "warning")


def _execute(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``SetLaunchConfiguration(name, value).execute(context)``, which does not ask for the condition."""
    match receiver:
        case LaunchObject(arguments=arguments):
            given = {name: value for name, value in arguments.items() if name != "condition"}
            run.visit(replace(receiver, arguments=given))
            return NONE
    return Unknown("an action of a class of its own")


METHODS = {
    **{f"{_LOGGER}.{name}": _said for name in (*_LOGS, "setLevel")},
    **moveit_methods.METHODS,
    **robot_poses.METHODS,
    **expressions.METHODS,
    **file_texts.METHODS,
    **loaded_modules.METHODS,
    **written_files.METHODS,
    "launch.LaunchContext.perform_substitution": _perform_argument,
    **{f"launch.{name}.execute": _execute for name in _SETTERS},
    **{f"launch.{name}.perform": perform_method for name in SUBSTITUTIONS},
    **{f"launch.{name}.{method}": _evaluate for name in CONDITIONS for method in ("evaluate", "_predicate_func")},
}


def _perform_all(run: LaunchRun, site: CallSite) -> Value:
    return _perform_argument(run, NONE, site)


def _parse(run: LaunchRun, site: CallSite) -> Value:
    """``parse_substitution('$(var robot)/base')``: a list of substitutions, as XML and YAML have them."""
    text = known_text(site.values[0]) if site.values else None
    if text is None:
        return Unknown(reason(*site.values))
    frontend = Frontend(run, run.file)
    place = run.place_now
    parts = list(frontend.parts(text, place, 0))
    return frontend.list([_as_substitution(frontend, part, place) for part in parts])


def _as_substitution(frontend: Frontend, part: Value, place: Place) -> Value:
    is_text = known_text(part) is not None
    return frontend.make(LaunchClass.TEXT_SUBSTITUTION, place, {"text": part}) if is_text else part


def _path(run: LaunchRun, site: CallSite) -> Value:
    """``Path(a, b)`` in a launch file is a text for us: launch takes both."""
    texts = [text for text in map(known_text, site.args) if text is not None]
    if len(texts) != len(site.args) or not site.args:
        return Unknown(reason(*site.args))
    return Known(posixpath.join(*texts), kind="path")


def _same_path(run: LaunchRun, site: CallSite) -> Value:
    path = known_text(site.args[0]) if site.args else None
    return Unknown("a path of this machine") if path is None else path_parts.shortest(run, Known(path))


def _is_absolute(run: LaunchRun, site: CallSite) -> Value:
    """``os.path.isabs(path)``: so is what launch and ament give for a folder of a package, or of the launch file."""
    path = known_text(site.args[0]) if site.args else None
    if path is None:
        return Unknown(reason(*site.args))
    return Known(path.startswith(("/", "$(")))


def _of_home(run: LaunchRun, site: CallSite) -> Value:
    """``os.path.expanduser(path)``."""
    path = known_text(site.args[0]) if site.args else None
    if path is None:
        return Unknown(reason(*site.args))
    return Unknown("the environment variable HOME") if path.startswith("~") else Known(path)


def _has_resource(run: LaunchRun, site: CallSite) -> Value:
    """``has_resource('packages', 'pkg')``: where the package is installed to, which a package of the workspace is."""
    kind, name = (known_text(value) for value in (*site.args, NONE, NONE)[:2])
    if kind == "packages" and name is not None and run.paths.has(name):
        return package_prefix(name)
    return Unknown(calls.PACKAGES_OF_THE_MACHINE)


PLAIN = {
    **mathematics.PLAIN,
    **moveit_methods.PLAIN,
    **moveit_actions.PLAIN,
    **descriptions.PLAIN,
    **loaded_modules.PLAIN,
    **read_files.PLAIN,
    **written_files.PLAIN,
    **expressions.PLAIN,
    **{f"logging.{name}": _logged for name in (*_LOGS, "basicConfig")},
    "logging.getLogger": _logger,
    "launch.logging.get_logger": _logger,
    "ament_index_python.has_resource": _has_resource,
    "ament_index_python.resources.has_resource": _has_resource,
    "launch.frontend.parse_substitution.parse_substitution": _parse,
    "launch.utilities.perform_substitutions": _perform_all,
    "pathlib.Path": _path,
    "pathlib.PurePath": _path,
    "os.path.abspath": _same_path,
    "os.path.expanduser": _of_home,
    "os.path.isabs": _is_absolute,
    "os.path.realpath": _same_path,
    "os.path.normpath": _same_path,
}
