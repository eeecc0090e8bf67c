"""Calls of launch's API in a launch file's own code."""

from __future__ import annotations

import posixpath
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.heap import Items
from archlint.interpreter.values import (
    NONE,
    ClassValue,
    External,
    Instance,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)
from archlint.launch.performing import perform_method
from archlint.launch.substitutions import SUBSTITUTIONS, made_by_base, package_share, perform
from archlint.libraries.api_use import argument_places
from archlint.syntax import facts

CONDITIONS = ("IfCondition", "UnlessCondition", "LaunchConfigurationEquals", "LaunchConfigurationNotEquals")

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


def launch_object(run: Run, call: ApiUse) -> Value:
    """An action, substitution, condition … with its arguments by name, where each is written, and the branches
    of the launch file's own code that it is made in."""
    place = run.place(call.expression.span) if call.expression is not None and run.activations else None
    made = Instance(External(call.api.path), run.store.new_key(), place, dict(call.arguments))
    note_made(run, call.api.variant, place)
    if call.api.variant == "DeclareLaunchArgument":
        note_declaration(run, made)
    if isinstance(call.receiver, Instance):
        run.store.set(call.receiver.key, "#action", made)  # super().__init__(…) of a class derived from an action
    run.store.set(made.key, "#arms", frozenset(run.branch_arms))
    run.store.set(made.key, "#places", argument_places(run, call.api, call.expression))
    run.store.set(made.key, "#rest", tuple(call.rest))
    run.store.set(made.key, "#open", call.open)
    if call.api.variant == "LaunchDescription":
        entities = call.arguments.get("initial_entities")
        run.store.set(made.key, "#entities", _items(run, entities))
    return made


NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "ComposableNode", "ComposableLifecycleNode"})


def note_made(run: Run, kind: str, place: Place | None) -> None:
    from archlint.launch.run import LaunchRun

    if kind in NODES and place is not None and isinstance(run, LaunchRun):
        run.result.made.add(place)


def note_declaration(run: Run, made: Instance) -> None:
    from archlint.launch.run import LaunchRun

    name = made.arguments.get("name")
    if isinstance(run, LaunchRun) and isinstance(name, Known) and made.place is not None:
        run.result.written.setdefault((run.file, str(name.value)), made.place)


def _items(run: Run, value: Value | None) -> Items:
    if value is None or value == NONE:
        return Items(())
    if isinstance(value, OneOf):
        return Items((value,))
    found = containers.iterate(run, value)
    return Items((value,), True) if found is None else found


def package_path(run: Run, call: ApiUse) -> Value:
    """``get_package_share_directory('pkg')``."""
    from archlint.launch.run import LaunchRun

    if call.api.variant == "search paths":
        return Unknown("the environment variable AMENT_PREFIX_PATH")
    if not isinstance(run, LaunchRun):
        return Unknown("the path of an installed package")
    rows: list[Value] = []
    for option in alternatives(call.get("package_name") or Unknown("no package is given")):
        name = perform(run, option)
        if not isinstance(name, Known):
            rows.append(Unknown(reason(name)))
        elif call.api.variant == "share":
            share = package_share(str(name.value))
            rows.append(replace(share, kind="path") if call.api.path.endswith("_path") else share)
        else:
            rows.append(Known(f"$(find-pkg-prefix {name.value!s})"))
    return one_of(rows)


def _add(run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``LaunchDescription.add_action``."""
    if not isinstance(receiver, Instance):
        return NONE
    known = run.store.get(receiver.key, "#entities")
    items = known if isinstance(known, Items) else Items(())
    for value in [*args, *keywords.values()]:
        items = Items((*items.values, _in_branch(run, value)), items.open)
    run.store.set(receiver.key, "#entities", items)
    return NONE


def _in_branch(run: Run, value: Value) -> Value:
    """An action that is added in a branch of the code is conditional, wherever it was made."""
    if not run.branch_arms:
        return value
    made = Instance(External("launch.Branch"), run.store.new_key(), None, {"action": value})
    run.store.set(made.key, "#arms", frozenset(run.branch_arms))
    return made


def _perform_argument(
    run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None
) -> Value:
    from archlint.launch.run import LaunchRun

    if not isinstance(run, LaunchRun):
        return Unknown("a substitution outside of a launch")
    values = [*args, *keywords.values()]
    asked = values[-1] if values else NONE
    return perform(run, made_by_base(run, asked) or asked)  # a class of the workspace asks its base


def _find(run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``FindPackageShare('pkg').find('pkg')``."""
    given = [*args, *keywords.values()]
    rows = alternatives(given[0]) if given else ()
    return one_of(package_share(str(row.value)) if isinstance(row, Known) else Unknown(reason(row)) for row in rows)


def _evaluate(run: Run, receiver: Value, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``IfCondition(…).evaluate(context)``."""
    from archlint.launch import conditions
    from archlint.launch.run import LaunchRun

    verdict = conditions.judge(run, receiver) if isinstance(run, LaunchRun) else None
    if verdict is None or verdict.holds is None:
        return Unknown("a condition that the launch arguments do not decide")
    return Known(verdict.holds)


METHODS = {
    "launch.LaunchDescription.add_action": _add,
    "launch.LaunchDescription.add_entity": _add,
    "launch.LaunchContext.perform_substitution": _perform_argument,
    "launch.FindPackageShare.find": _find,
    "launch.FindPackagePrefix.find": _find,
    **{f"launch.{name}.perform": perform_method for name in SUBSTITUTIONS},
    **{f"launch.{name}.evaluate": _evaluate for name in CONDITIONS},
}


def _perform_all(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    return _perform_argument(run, NONE, args, keywords, e)


def _same(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    return args[0] if args else Unknown("no argument")


def _path(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``Path(a, b)`` in a launch file is a text for us: launch takes both."""
    from archlint.launch.run import LaunchRun

    if not isinstance(run, LaunchRun):
        return Instance(External("pathlib.Path"), run.store.new_key(), None, {str(i): a for i, a in enumerate(args)})
    texts = [part.value for part in args if isinstance(part, Known)]
    if len(texts) != len(args) or not args:
        return Unknown(reason(*args))
    return Known(posixpath.join(*map(str, texts)), kind="path")


def _same_path(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    from archlint.launch.run import LaunchRun

    if isinstance(run, LaunchRun) and args and isinstance(args[0], Known):
        return Known(posixpath.normpath(str(args[0].value)))
    return Unknown("a path of this machine")


def open_file(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``open(path)`` in a launch file: the file, for whoever loads YAML from it."""
    from archlint.launch.run import LaunchRun

    if isinstance(run, LaunchRun) and args and isinstance(args[0], Known):
        return Instance(External("io.TextIOWrapper"), run.store.new_key(), None, {"path": args[0]})
    return Unknown(reason(*args) if args else "a file")


def _load_yaml(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    """``yaml.safe_load(file)``: what a YAML file of this workspace holds."""
    from archlint.launch.run import LaunchRun
    from archlint.syntax.safe_yaml import YamlError, YamlReader

    given = args[0] if args else Unknown("no file")
    path = given.arguments.get("path") if isinstance(given, Instance) else None
    if not isinstance(run, LaunchRun) or path is None:
        return Unknown("the content of a YAML file")
    reference = run.loader.resolve(run, "parameters", path, run.place_now)
    text = None if reference.source is None else run.loader.tree.text(reference.source)
    if text is None:
        return Unknown("the content of a file that is not here")
    try:
        reader = YamlReader(text)
        return _value_of(run, None if reader.root is None else reader.value(reader.root))
    except (YamlError, RecursionError):
        return Unknown("the content of a YAML file that is broken")


def _value_of(run: Run, value: object) -> Value:
    if isinstance(value, dict):
        rows = {containers.hashable(Known(key)): (Known(key), _value_of(run, item)) for key, item in value.items()}
        return containers.new_dict(run, {key: row for key, row in rows.items() if key is not None})
    if isinstance(value, list):
        return containers.new_list(run, [_value_of(run, item) for item in value])
    assert value is None or isinstance(value, (str, int, float, bool))
    return Known(value)


def _nothing(run: Run, args: list[Value], keywords: dict[str, Value], e: facts.Call | None) -> Value:
    return NONE


PLAIN = {
    **dict.fromkeys(("os.remove", "os.unlink", "os.mkdir", "os.makedirs", "shutil.rmtree", "time.sleep"), _nothing),
    "open": open_file,
    "yaml.safe_load": _load_yaml,
    "yaml.load": _load_yaml,
    "yaml.full_load": _load_yaml,
    "launch.utilities.perform_substitutions": _perform_all,
    "launch.utilities.normalize_to_list_of_substitutions": _same,
    "launch.some_substitutions_type.SomeSubstitutionsType": _same,
    "pathlib.Path": _path,
    "pathlib.PurePath": _path,
    "os.path.abspath": _same_path,
    "os.path.realpath": _same_path,
    "os.path.normpath": _same_path,
}


def note_given(run: Run, made: Instance, cls: ClassValue, site: CallSite) -> None:
    """Keep what the constructor of a class that derives from one of launch's is given, by name or position."""
    if site.open or not any(path.startswith("launch") for path in cls.external_bases()):
        return
    named = sorted(site.keywords.items(), key=lambda row: row[0])
    rows = [*((str(number), value) for number, value in enumerate(site.args)), *named]
    run.store.set(made.key, GIVEN, tuple(rows))


GIVEN = "#given"
"""The slot of what :func:`note_given` keeps."""


def entities(run: Run, description: Instance) -> Value | None:
    """``LaunchDescription.entities``."""
    actions = run.store.get(description.key, "#entities")
    return containers.new_list(run, actions.values, "list", actions.open) if isinstance(actions, Items) else None


EFFECTS = {"launch_object": launch_object, "package_path": package_path}
"""By the names that the rows of launch's table have."""

__all__ = ["EFFECTS", "GIVEN", "METHODS", "PLAIN", "entities", "note_given"]
