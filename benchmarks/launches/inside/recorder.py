"""Visits what a launch file returns, as launch's own service does, and notes what would be started."""

from __future__ import annotations

import asyncio
import os
import re
import sys
from collections import deque
from itertools import pairwise
from typing import Any
from unittest.mock import MagicMock

import launch
import launch.actions
import launch_ros.actions
import launch_ros.actions.lifecycle_node
import launch_ros.actions.load_composable_nodes as loading
import launch_ros.actions.node as node_module
import launch_ros.descriptions
import launch_ros.parameter_descriptions as descriptions
from launch.utilities import perform_substitutions
from launch.utilities.type_utils import perform_typed_substitution  # noqa: F401  (has to be there)

from . import asked, stand_ins
from .guard import FROM_OUTSIDE, OUTPUT
from .parameters import Row, rows_of_file, value_of

Entity = Any
_INSTALLED = re.compile(r"\$\(find-pkg-prefix ([\w.-]+)\)/lib/[\w.-]+/([^/]+)$")
LATER = 500
"""How many timers and event handlers one launch may come to."""


class Recorder:
    def __init__(self, places: stand_ins.Places) -> None:
        self.places = places
        self.nodes: list[dict[str, Any]] = []
        self.not_there: list[str] = []
        self.later: deque[tuple[Any, Any, Any]] = deque()
        """What a timer or an event starts: the locals of the context, the entities, and whether it comes to that."""
        self.deferred = False
        self.original: dict[str, str] = {}
        self.includes = 0
        self.started: list[Any] = []
        self.gone: list[Any] = []
        """The event handlers that are not registered any more."""

    # ------------------------------------------------------------------------------------------- visiting

    def run(self, path: str, arguments: dict[str, str]) -> None:
        context = launch.LaunchContext(argv=[], noninteractive=True)
        loop = asyncio.new_event_loop()
        asyncio.set_event_loop(loop)
        context._set_asyncio_loop(loop)
        asked.given_names.update(arguments)
        source = launch.launch_description_sources.AnyLaunchDescriptionSource(path)
        self.visit(launch.actions.IncludeLaunchDescription(source, launch_arguments=arguments.items()), context)
        self.deferred = True
        for _ in range(LATER):
            due = next((row for row in self.later if row[2]()), None)
            if due is None:
                break
            self.later.remove(due)
            known, entities, _ = due
            context._push_locals()
            context.extend_locals(known)
            for entity in entities(context) or ():
                self.visit(entity, context)
            context._pop_locals()

    def visit(self, entity: Entity, context: Any) -> None:
        for below in entity.visit(context) or ():
            self.visit(below, context)

    def put_off(self, timer: Any, context: Any) -> None:
        self.later.append((dict(context.get_locals_as_dict()), lambda _: timer.actions, lambda: True))

    def handler(self, action: Any, context: Any) -> None:
        handler = action.event_handler
        event = MagicMock(returncode=0, text=b"", process_name="process", name="event")

        def entities(context: Any) -> Any:
            found = handler.handle(event, context)
            if isinstance(found, launch.LaunchDescriptionEntity):
                return [found]
            return found if isinstance(found, (list, tuple)) else ()

        if type(handler).__name__ not in ("OnShutdown", "EventHandler"):
            self.later.append(({}, entities, lambda: self.comes(handler)))

    def comes(self, handler: Any) -> bool:
        """Whether there is a process whose event a handler waits for; other events are taken to come."""
        if any(handler is one for one in self.gone):
            return False
        kind = vars(handler).get("_OnActionEventBase__target_event_cls")
        if kind is None or not issubclass(kind, launch.events.process.RunningProcessEvent):
            return True
        return any(handler.matches(_event(kind, action)) for action in self.started)

    # ---------------------------------------------------------------------------------------------- nodes

    def process(self, action: Any, context: Any) -> None:
        """In place of starting a process; launch refuses to start one action a second time."""
        if any(action is started for started in self.started):
            return
        self.started.append(action)
        action.process_description.prepare(context, action)
        words = [str(word) for word in action.process_description.final_cmd]
        if not isinstance(action, launch_ros.actions.Node):
            if len(words) == 1:
                words = words[0].split()
            installed = _INSTALLED.match(self.places.shown(words[0])) if words else None
            if installed is not None:
                words = ["ros2", "run", *installed.groups(), *words[1:]]
            if words[:2] == ["ros2", "run"] and len(words) > 3:
                self.note(context, kind="node", package=words[2], executable=words[3], rows=self.rows(words))
            return
        private = vars(action)
        given = private["_Node__node_name"] is not None
        namespace = action.expanded_node_namespace
        self.note(
            context,
            kind="container" if isinstance(action, launch_ros.actions.ComposableNodeContainer) else "node",
            package=_text(context, action.node_package),
            executable=_text(context, action.node_executable),
            name=private["_Node__expanded_node_name"] if given else None,
            namespace=None if namespace == action.UNSPECIFIED_NODE_NAMESPACE else namespace,
            remaps=[list(pair) for pair in action.expanded_remapping_rules or ()],
            rows=self.rows(words),
            files=[self.original.get(path, path) for path in private.get("#files", ())],
            line=private.get("#line"),
        )

    def components(self, action: Any, context: Any) -> None:
        """In place of asking a container to load."""
        for description in action._LoadComposableNodes__composable_node_descriptions:
            request = loading.get_composable_node_load_request(description, context)
            if request is None:
                continue
            values = [("", one.name, _python(one.value)) for one in request.parameters]
            self.note(
                context,
                kind="component",
                package=request.package_name,
                executable=request.plugin_name,
                name=request.node_name or None,
                namespace=request.node_namespace or None,
                remaps=[rule.split(":=", 1) for rule in request.remap_rules],
                rows=values,
            )

    def note(self, context: Any, rows: list[Row], **fields: Any) -> None:
        empty = {"name": None, "namespace": None, "remaps": [], "files": []}
        parameters = [[key, name, self.places.shown(value)] for key, name, value in rows]
        found = {key: self.places.shown(value) for key, value in {**empty, **fields}.items()}
        self.nodes.append({**found, "parameters": parameters, "later": self.deferred})

    def rows(self, words: list[str]) -> list[Row]:
        """What the command line of a process sets."""
        found: list[Row] = []
        inside = False
        for option, value in pairwise(words):
            if option in ("--ros-args", "--"):
                inside = option == "--ros-args"
            elif inside and option == "--params-file":
                found += rows_of_file(value) if os.path.isfile(value) else []
            elif inside and option in ("-p", "--param") and ":=" in value:
                name, _, text = value.partition(":=")
                found.append(("/**", name, value_of(text)))
        return found

    # ------------------------------------------------------------------------------------------- includes

    def include(self, action: Any, context: Any, kept: Any) -> Any:
        self.includes += 1
        if self.includes > 400:
            raise RecursionError("more includes than are followed")
        source = action.launch_description_source
        location = perform_substitutions(context, source._LaunchDescriptionSource__location)
        if not self.places.is_absent(location):
            return kept(action, context)
        self.not_there.append(self.places.shown(location))
        return [launch.actions.SetLaunchConfiguration(*pair) for pair in action.launch_arguments]


def _event(kind: Any, action: Any) -> Any:
    event = MagicMock(spec=kind)
    event.action = action
    return event


def _text(context: Any, value: Any) -> str | None:
    from launch.utilities import normalize_to_list_of_substitutions

    return None if value is None else perform_substitutions(context, normalize_to_list_of_substitutions(value))


def _python(value: Any) -> Any:
    from rclpy.parameter import parameter_value_to_python

    found = parameter_value_to_python(value)
    if isinstance(found, bytes):
        return list(found)
    return found if found is None or isinstance(found, (bool, int, float, str)) else list(found)


def _line() -> str | None:
    """Where in a launch file the action is made that is being made now."""
    frame = sys._getframe(2)
    while frame is not None:
        name = frame.f_code.co_filename
        if "/install/" in name and "/site-packages/" not in name:
            return f"{name.partition('/install/')[2]}:{frame.f_lineno}"
        frame = frame.f_back  # type: ignore[assignment]
    return None


def follow(recorder: Recorder) -> None:
    """Put the recorder in the place of what would start, wait or load."""
    actions, ros = launch.actions, launch_ros.actions

    actions.ExecuteLocal.execute = lambda self, context: recorder.process(self, context)  # noqa: PLW0108
    ros.LoadComposableNodes.execute = lambda self, context: recorder.components(self, context)  # noqa: PLW0108
    actions.TimerAction.execute = lambda self, context: recorder.put_off(self, context)  # noqa: PLW0108
    ros.ROSTimer.execute = lambda self, context: recorder.put_off(self, context)  # noqa: PLW0108
    launch.LaunchContext.unregister_event_handler = lambda self, handler: recorder.gone.append(handler)
    actions.RegisterEventHandler.execute = lambda self, context: recorder.handler(self, context)  # noqa: PLW0108
    kept = actions.IncludeLaunchDescription.execute
    actions.IncludeLaunchDescription.execute = lambda self, context: recorder.include(self, context, kept)
    ros.LifecycleNode.execute = ros.Node.execute
    ros.LifecycleTransition.execute = lambda self, context: None
    for module in (loading, launch_ros.actions.lifecycle_node):
        module.get_ros_node = lambda context: MagicMock()
    launch.substitutions.Command.perform = lambda self, context: perform_substitutions(context, self.command) and OUTPUT
    launch.substitutions.FindExecutable.perform = lambda self, context: (
        f"/usr/bin/{perform_substitutions(context, self.name)}"
    )
    launch.substitutions.AnonName.perform = lambda self, context: (
        f"{perform_substitutions(context, self.name)}_{FROM_OUTSIDE}"
    )
    launch_ros.substitutions.ExecutableInPackage.perform = _executable(recorder.places)
    _follow_parameters(recorder)

    def made(self: Any, *args: Any, kept: Any = ros.Node.__init__, **options: Any) -> None:
        vars(self)["#line"] = _line()
        kept(self, *args, **options)

    ros.Node.__init__ = made


def _executable(places: stand_ins.Places) -> Any:
    def perform(self: Any, context: Any) -> str:
        package = perform_substitutions(context, self.package)
        name = perform_substitutions(context, self.executable)
        return os.path.join(places.prefix(package), "lib", package, name)

    return perform


def _follow_parameters(recorder: Recorder) -> None:
    """Note which files are given, also where launch_ros puts another in their place or leaves them out."""

    def evaluate(context: Any, parameters: Any, kept: Any = node_module.evaluate_parameters) -> Any:
        found = kept(context, parameters)
        action = sys._getframe(1).f_locals.get("self")
        if isinstance(action, launch_ros.actions.Node):
            vars(action)["#files"] = [str(one) for one in found if isinstance(one, os.PathLike)]
        return found

    def file(self: Any, context: Any, kept: Any = descriptions.ParameterFile.evaluate) -> Any:
        given = vars(self)["_ParameterFile__param_file"]
        found = kept(self, context)
        if re.match(r"launch_params_", os.path.basename(str(found))):
            path = perform_substitutions(context, given) if isinstance(given, list) else str(given)
            recorder.original[str(found)] = path
        return found

    node_module.evaluate_parameters = evaluate
    descriptions.ParameterFile.evaluate = file
