"""Actions: what each of them does to the launch context, and what it starts."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.program.launch import conditions
from archlint.program.launch.context import Context, absolute, prefix_namespace
from archlint.program.launch.model import (
    DeclaredArgument,
    Gap,
    Included,
    OpenParameters,
    Remap,
    Started,
    UnknownAttribute,
)
from archlint.program.launch.parameters import file_use, parameters_of, setting
from archlint.program.launch.substitutions import argument, kind_of, perform
from archlint.program.model import Text
from archlint.program.store import Items
from archlint.program.texts import text_of_value
from archlint.program.values import (
    DictValue,
    External,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    reason,
)

if TYPE_CHECKING:
    from archlint.program.launch.run import LaunchRun

VISITS = 20_000
"""How many actions one launch may visit."""


NESTING = 100
"""How deep actions may stand in each other, includes and functions counted."""


def visit(run: LaunchRun, entity: Value) -> None:
    """Run one entity, or a list of them."""
    run.visits += 1
    if run.visits > VISITS or run.nesting >= NESTING:
        run.gap("more actions than can be followed")
        return
    run.nesting += 1
    try:
        _visit(run, entity)
    finally:
        run.nesting -= 1


def _visit(run: LaunchRun, entity: Value) -> None:
    if isinstance(entity, (ListValue, OneOf)):
        _visit_several(run, entity)
    elif isinstance(entity, Known) and entity.value is None:
        return
    elif isinstance(entity, Instance):
        _visit_one(run, entity)
    else:
        run.gap(reason(entity))


def _visit_several(run: LaunchRun, entity: ListValue | OneOf) -> None:
    from archlint.program import containers

    if isinstance(entity, OneOf):
        for option in entity.values:
            visit(run, option)
        return
    visit_items(run, containers.items_of(run, entity))


def visit_items(run: LaunchRun, items: Items) -> None:
    for value in items.values:
        visit(run, value)
    branches = any(isinstance(v, Instance) and run.store.get(v.key, "#arms") for v in items.values)
    if not items.whole and not branches and not any(isinstance(v, Unknown) for v in items.values):
        run.gap("a list of actions that is not wholly known")


def _visit_one(run: LaunchRun, entity: Instance) -> None:
    made = run.store.get(entity.key, "#action")  # of a class that derives from an action
    entity = _known_by_name(made if isinstance(made, Instance) else entity)
    kind = kind_of(entity)
    arms = run.store.get(entity.key, "#arms")
    own = frozenset(arms) - run.code_arms if isinstance(arms, frozenset) else frozenset()
    verdict = conditions.judge(run, argument(entity, "condition"))
    place = entity.place or run.place_now
    kept = run.place_now
    run.place_now = place
    try:
        with run.under(own, verdict, place):
            act = _ACTIONS.get(kind)
            if act is not None:
                act(run, entity)
            elif kind not in _IGNORED:
                run.gap(f"{entity.note or kind or 'an object'} is no action that is followed")
    finally:
        run.place_now = kept


def _known_by_name(entity: Instance) -> Instance:
    """Another library's ``DeclareBooleanLaunchArgument`` and the like declare an argument as launch's own do."""
    path = entity.cls.path if isinstance(entity.cls, External) else ""
    name = path.rpartition(".")[2]
    if path.startswith("launch.") or not (name.startswith("Declare") and name.endswith("LaunchArgument")):
        return entity
    arguments = {{"0": "name"}.get(key, key): value for key, value in entity.arguments.items()}
    return Instance(External("launch.DeclareLaunchArgument"), entity.key, entity.place, arguments)


def _actions(name: str) -> Callable[[LaunchRun, Instance], None]:
    """Visits the actions in one argument."""

    def act(run: LaunchRun, entity: Instance) -> None:
        value = argument(entity, name)
        if value is not None and not callable_value(value):
            visit(run, value)

    return act


def callable_value(value: Value) -> bool:
    from archlint.program.values import BoundMethod, FunctionValue, Partial

    return isinstance(value, (FunctionValue, BoundMethod, Partial))


def _description(run: LaunchRun, entity: Instance) -> None:
    """A description grows while it is visited, where a function adds to it."""
    done = 0
    while True:
        entities = run.store.get(entity.key, "#entities")
        values = entities.values[done:] if isinstance(entities, Items) else ()
        if not isinstance(entities, Items) or not values:
            return
        visit_items(run, Items(values, entities.open))
        done += len(values)


def _branch(run: LaunchRun, entity: Instance) -> None:
    visit(run, entity.arguments["action"])


def _group(run: LaunchRun, entity: Instance) -> None:
    """``GroupAction``: configurations and environment come back after it, if it is scoped."""
    if argument(entity, "scoped") == Known(False):
        _actions("actions")(run, entity)
        return
    kept = run.launch.copy()
    if argument(entity, "forwarding") == Known(False):
        run.launch.configurations = {}
        run.launch.namespace = run.launch.remaps = run.launch.parameters = None
    _set_configurations(run, argument(entity, "launch_configurations"))
    _actions("actions")(run, entity)
    run.launch.restore(kept)


def _set_configurations(run: LaunchRun, value: Value | None) -> None:
    from archlint.program import containers

    if isinstance(value, DictValue):
        for key, item in containers.entries_of(run, value).entries.values():
            name = perform(run, key)
            if isinstance(name, Known):
                run.launch.configurations[str(name.value)] = perform(run, item)


def _declare(run: LaunchRun, entity: Instance) -> None:
    name = perform(run, argument(entity, "name"))
    if not isinstance(name, Known):
        run.gap(f"the name of a launch argument: {reason(name)}")
        return
    text = str(name.value)
    default = entity.arguments.get("default_value")
    given = default is not None and default != Known(None)
    value = perform(run, default) if given else None
    if not run.is_dormant or text not in run.launch.configurations:
        missing = Unknown(f"the launch argument '{text}' has no default")
        run.launch.configurations.setdefault(text, value if value is not None else missing)
    choices = argument(entity, "choices")
    allowed = [str(c.value) for c in run.items(choices) if isinstance(c, Known)] if choices is not None else []
    shown = None if value is None else text_of_value(value, "no default")
    run.result.declared.append(DeclaredArgument(text, shown, run.place_now, run.file, tuple(allowed), run.is_dormant))


def _let(run: LaunchRun, entity: Instance) -> None:
    name = perform(run, argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.configurations[str(name.value)] = perform(run, argument(entity, "value"))
    else:
        run.gap(f"the name of a launch configuration: {reason(name)}")


def _unset(run: LaunchRun, entity: Instance) -> None:
    name = perform(run, argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.configurations.pop(str(name.value), None)


def _environment(run: LaunchRun, entity: Instance) -> None:
    name = perform(run, argument(entity, "name"))
    if isinstance(name, Known):
        run.launch.environment[str(name.value)] = perform(run, argument(entity, "value"))


def _push_namespace(run: LaunchRun, entity: Instance) -> None:
    pushed = perform(run, argument(entity, "namespace"))
    run.launch.namespace = absolute(prefix_namespace(run.launch.namespace or Known(""), pushed))


def _set_remap(run: LaunchRun, entity: Instance) -> None:
    source, target = perform(run, argument(entity, "src")), perform(run, argument(entity, "dst"))
    run.launch.add_remap(_remap(source, target, run.place_now, group=True))


def _remap(source: Value, target: Value, place: Place, group: bool = False) -> Remap:
    return Remap(text_of_value(source, "no name"), text_of_value(target, "no name"), place, group)


def _set_parameter(run: LaunchRun, entity: Instance) -> None:
    from dataclasses import replace

    name = Known("use_sim_time") if kind_of(entity) == "SetUseSimTime" else perform(run, argument(entity, "name"))
    made = setting(run, name, entity.arguments.get("value", Known(None)), run.place_now)
    run.launch.add_parameter(replace(made, shared=True))


def _set_parameters_from_file(run: LaunchRun, entity: Instance) -> None:
    from dataclasses import replace

    made = file_use(run, argument(entity, "filename"), run.place_now)
    run.launch.add_parameter(replace(made, shared=True))


def _include(run: LaunchRun, entity: Instance) -> None:
    source = argument(entity, "launch_description_source")
    location = argument(source, "launch_file_path") if kind_of(source).endswith("Source") else source
    place = (source.place if isinstance(source, Instance) else None) or run.place_now
    names = []
    for row in run.items(argument(entity, "launch_arguments")):
        pair = run.items(row)
        if len(pair) == 2:
            name = perform(run, pair[0])
            if isinstance(name, Known):
                where = run.store.get(getattr(row, "key", 0), "#place")
                origin = pair[0].origin if isinstance(pair[0], Known) else None
                names.append((str(name.value), where if isinstance(where, Place) else origin or run.place_now))
                run.launch.configurations[str(name.value)] = perform(run, pair[1])
    path = perform(run, location)
    options = path.values if isinstance(path, OneOf) else (path,)
    for option in options:
        reference = run.reference("launch", option, place)
        run.result.included.append(Included(reference, tuple(names), place, run.file, run.is_dormant))
        run.loader.include(run, reference)


def _opaque(run: LaunchRun, entity: Instance) -> None:
    function = argument(entity, "function")
    if function is None:
        run.gap("an OpaqueFunction without a function")
        return
    result = run.call_opaque(function, run.items(argument(entity, "args")), argument(entity, "kwargs"))
    visit(run, result)


def _event_handler(run: LaunchRun, entity: Instance) -> None:
    handler = argument(entity, "event_handler")
    if handler is None or not isinstance(handler, Instance):
        return
    for name in ("on_exit", "on_start", "on_completion", "on_shutdown", "entities", "on_stdout", "on_stderr"):
        value = argument(handler, name)
        if value is not None and callable_value(value):
            visit(run, run.call_handler(value))
        elif value is not None:
            visit(run, value)


# ------------------------------------------------------------------------------------------------ processes


def _node(run: LaunchRun, entity: Instance) -> None:
    kind = kind_of(entity)
    started = _started(run, entity, "container" if kind == "ComposableNodeContainer" else "node")
    started.lifecycle = kind == "LifecycleNode"
    run.result.started.append(started)
    if kind == "ComposableNodeContainer":
        _components(run, entity, started.name)


def _started(run: LaunchRun, entity: Instance, kind: str) -> Started:
    _check_keywords(run, entity)
    executable = argument(entity, "plugin" if kind == "component" else "executable")
    namespace = argument(entity, "namespace")
    name = argument(entity, "name")
    own = None if namespace is None else perform(run, namespace)
    full = absolute(prefix_namespace(run.launch.namespace, own))
    started = Started(
        kind,
        _package(run, argument(entity, "package")),
        text_of_value(None if executable is None else perform(run, executable), "no executable is given"),
        run.place_now,
        run.file,
        None if name is None else text_of_value(perform(run, name), "no name"),
        None if full is None else text_of_value(full, "no namespace"),
        arms=run.current_arms,
        dormant=run.is_dormant,
        places=run.places_of(entity),
    )
    started.remaps = [*(run.launch.remaps or ()), *_remaps(run, argument(entity, "remappings"))]
    started.parameters = [
        *(run.launch.parameters or ()),
        *parameters_of(run, argument(entity, "parameters"), started.places.get("parameters", run.place_now)),
    ]
    started.arguments, whole = _words(run, argument(entity, "arguments"))
    started.ros_arguments, whole_ros = _words(run, argument(entity, "ros_arguments"))
    started.whole_arguments = whole and whole_ros
    if run.store.get(entity.key, "#open"):
        started.parameters.append(OpenParameters("arguments that are passed by **", run.place_now))
    for word in started.arguments:
        if word is not None and word.endswith(".rviz"):
            run.reference("rviz", Known(word), started.places.get("arguments", run.place_now))
    return started


def _package(run: LaunchRun, value: Value | None) -> Text:
    if value is None:
        return Text(None, "unknown", reason="no package is given")
    return text_of_value(perform(run, value), "no package is given")


def _remaps(run: LaunchRun, value: Value | None) -> list[Remap]:
    found = []
    for row in run.items(value):
        pair = run.items(row)
        if len(pair) == 2:
            where = run.store.get(getattr(row, "key", 0), "#place")
            origin = pair[0].origin if isinstance(pair[0], Known) else None
            place = where if isinstance(where, Place) else origin or run.place_now
            found.append(_remap(perform(run, pair[0]), perform(run, pair[1]), place))
    return found


def _words(run: LaunchRun, value: Value | None) -> tuple[list[str | None], bool]:
    """The words of a command line, None for one that is not known; False where there may be others."""
    if value is None:
        return [], True
    if isinstance(value, Known) or kind_of(value):
        text = perform(run, value)
        return (_split(str(text.value)), True) if isinstance(text, Known) else ([None], False)
    found: list[str | None] = []
    for item in run.items(value):
        text = perform(run, item)
        found.append(str(text.value) if isinstance(text, Known) else None)
    return found, isinstance(value, ListValue) and run.is_closed(value)


def _split(text: str) -> list[str | None]:
    """The words of a text as a shell divides it."""
    try:
        return [*shlex.split(text)]
    except ValueError:
        return [*text.split()]


_KEYWORDS_OF_ALL = frozenset({"condition", "sigterm_timeout", "sigkill_timeout", "log_cmd"})


def _check_keywords(run: LaunchRun, entity: Instance) -> None:
    from archlint.program.api.launch_tables import SIGNATURES

    kind = kind_of(entity)
    known = SIGNATURES[kind].replace("*", "").split()
    places = run.places_of(entity)
    for name in entity.arguments:
        if name not in known and name not in _KEYWORDS_OF_ALL and not name.isdigit() and name in places:
            run.note_unknown_attribute(UnknownAttribute(kind, name, tuple(known), places[name]))


def _components(run: LaunchRun, entity: Instance, container: Text | None) -> None:
    value = argument(entity, "composable_node_descriptions")
    for item in run.items(value):
        options = item.values if isinstance(item, OneOf) else (item,)
        for option in options:
            if kind_of(option) not in ("ComposableNode", "ComposableLifecycleNode"):
                run.gap(f"a component: {reason(option)}")
                continue
            assert isinstance(option, Instance)
            verdict = conditions.judge(run, argument(option, "condition"))
            arms = run.store.get(option.key, "#arms")
            own = frozenset(arms) - run.code_arms if isinstance(arms, frozenset) else frozenset()
            kept, run.place_now = run.place_now, option.place or run.place_now
            with run.under(own, verdict, run.place_now):
                made = _started(run, option, "component")
                made.container = container
                run.result.started.append(made)
            run.place_now = kept
    if isinstance(value, Unknown) or (isinstance(value, ListValue) and run.is_open(value)):
        run.gap("a list of components that is not wholly known")


def _load(run: LaunchRun, entity: Instance) -> None:
    target = argument(entity, "target_container")
    if kind_of(target):
        target = argument(target, "name") if kind_of(target).endswith("Container") else target
    text = None if target is None else text_of_value(perform(run, target), "no container")
    _components(run, entity, text)


def _process(run: LaunchRun, entity: Instance) -> None:
    """``ros2 run package executable arguments…`` and the path of an executable are nodes like any other."""
    words, whole = _words(run, argument(entity, "cmd"))
    if len(words) == 1 and words[0] and " " in words[0]:
        words = _split(words[0])
    installed = _INSTALLED.match(words[0]) if words and words[0] else None
    if installed:
        words = ["ros2", "run", installed[1], installed[2], *words[1:]]
    if words[:2] == ["ros2", "run"] and len(words) > 3 and words[2] and words[3]:
        started = Started(
            "node",
            Text(words[2], "exact"),
            Text(words[3], "exact"),
            run.place_now,
            run.file,
            arms=run.current_arms,
            dormant=run.is_dormant,
            arguments=words[4:],
            whole_arguments=whole,
            bare=True,
        )
    elif words[:2] == ["ros2", "launch"] and len(words) > 3 and words[2] and words[3]:
        _launch_apart(run, words[2], words[3], words[4:])
        return
    else:
        name = Text(words[0], "exact") if words and words[0] else Text(None, "unknown", reason="a command")
        started = Started(
            "process",
            Text(None, "unknown", reason="a process, not a node"),
            name,
            run.place_now,
            run.file,
            arms=run.current_arms,
            dormant=run.is_dormant,
            arguments=words[1:],
        )
    run.result.started.append(started)


def _launch_apart(run: LaunchRun, package: str, name: str, words: Sequence[str | None]) -> None:
    """``ros2 launch package file argument:=value …``: a launch with a context of its own."""
    path = Known(f"$(find-pkg-share {package})/launch/{name}")
    reference = run.reference("launch", path, run.place_now)
    run.result.included.append(Included(reference, (), run.place_now, run.file, run.is_dormant))
    kept, run.launch = run.launch, Context()
    for word in words:
        argument_name, assigned, value = (word or "").partition(":=")
        if assigned:
            run.launch.configurations[argument_name] = Known(value)
    run.loader.include(run, reference)
    run.launch = kept


_INSTALLED = re.compile(r"^\$\(find-pkg-prefix ([\w.-]+)\)/lib/[\w.-]+/([^/]+)$")

_IGNORED = frozenset(
    {
        "LogInfo",
        "Shutdown",
        "EmitEvent",
        "UnregisterEventHandler",
        "PushEnvironment",
        "PopEnvironment",
        "AppendEnvironmentVariable",
        "UnsetEnvironmentVariable",
        "LifecycleTransition",
        "SetROSLogDir",
        "OpaqueCoroutine",
    }
)

_ACTIONS: dict[str, Callable[[LaunchRun, Instance], None]] = {
    "LaunchDescription": _description,
    "Branch": _branch,
    "GroupAction": _group,
    "TimerAction": _actions("actions"),
    "RosTimer": _actions("actions"),
    "DeclareLaunchArgument": _declare,
    "DeclareBooleanLaunchArgument": _declare,
    "SetLaunchConfiguration": _let,
    "UnsetLaunchConfiguration": _unset,
    "SetEnvironmentVariable": _environment,
    "PushRosNamespace": _push_namespace,
    "SetRemap": _set_remap,
    "SetParameter": _set_parameter,
    "SetUseSimTime": _set_parameter,
    "SetParametersFromFile": _set_parameters_from_file,
    "IncludeLaunchDescription": _include,
    "PythonLaunchDescriptionSource": _include,
    "OpaqueFunction": _opaque,
    "RegisterEventHandler": _event_handler,
    "Node": _node,
    "LifecycleNode": _node,
    "ComposableNodeContainer": _node,
    "LoadComposableNodes": _load,
    "ExecuteProcess": _process,
}

__all__ = ["Gap", "visit", "visit_items"]
