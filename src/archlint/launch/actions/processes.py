"""Actions that start something: nodes, containers and their components, commands."""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Holed, Instance, Known, ListValue, OneOf, Unknown, Value, alternatives, reason
from archlint.launch.actions.branches import arms_of, each_alternative, verdict_on
from archlint.launch.actions.included import launch_in_own_process
from archlint.launch.actions.scopes import remap
from archlint.launch.context import absolute, prefix_namespace
from archlint.launch.model import FileKind, OpenParameters, Remap, Started, StartedKind, UnknownAttribute
from archlint.launch.objects import PAIR_PLACE, argument, has_more_arguments, kind_of, places_of
from archlint.launch.parameters import Parameter, file_use, parameters_of
from archlint.launch.tables import SIGNATURES
from archlint.libraries.texts import text_of_value
from archlint.model import Text

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def node(run: LaunchRun, entity: Instance) -> None:
    kind = kind_of(entity)
    started = _started(run, entity, StartedKind.CONTAINER if kind == "ComposableNodeContainer" else StartedKind.NODE)
    started.lifecycle = kind == "LifecycleNode"
    run.start(started)
    if kind == "ComposableNodeContainer":
        _components(run, entity, started.name)


def _text_of(run: LaunchRun, value: Value, missing: str) -> Text:
    """A name, which is no default where the file looks at ``sys.argv``: a word there may replace it."""
    if run.program.reads_command_line and any(isinstance(option, (Unknown, Holed)) for option in alternatives(value)):
        return Text(None, "unknown", reason="a word of the command line may replace it")
    return text_of_value(value, missing)


def _started(run: LaunchRun, entity: Instance, kind: StartedKind) -> Started:
    _check_keywords(run, entity)
    executable = argument(entity, "plugin" if kind == StartedKind.COMPONENT else "executable")
    namespace = argument(entity, "namespace")
    name = argument(entity, "name")
    own = None if namespace is None else run.perform(namespace)
    full = absolute(prefix_namespace(run.launch.namespace, own))
    started = Started(
        kind,
        _package(run, argument(entity, "package")),
        text_of_value(None if executable is None else run.perform(executable), "no executable is given"),
        run.place_now,
        run.file,
        None if name is None else _text_of(run, run.perform(name), "no name"),
        None if full is None else _text_of(run, full, "no namespace"),
        branch_arms=run.current_arms,
        dormant=run.is_dormant,
        places=places_of(entity),
    )
    started.remaps = [*(run.launch.remaps or ()), *_remaps(run, argument(entity, "remappings"))]
    words, whole = _texts(run, argument(entity, "arguments"))
    started.arguments = _known(words)
    started.ros_arguments, whole_ros = _words(run, argument(entity, "ros_arguments"))
    started.whole_arguments = whole and whole_ros
    started.parameters = [
        *_parameter_files(run, [*started.arguments, "--ros-args", *started.ros_arguments], run.place_now),
        *(run.launch.parameters or ()),
        *parameters_of(run, argument(entity, "parameters"), started.places.get("parameters", run.place_now)),
    ]
    if has_more_arguments(entity):
        started.parameters.append(OpenParameters("arguments that are passed by **", run.place_now))
    for word in words:
        if isinstance(word, Known) and str(word.value).endswith(".rviz"):
            run.reference(FileKind.RVIZ, word, started.places.get("arguments", run.place_now))
    return started


def _package(run: LaunchRun, value: Value | None) -> Text:
    if value is None:
        return Text(None, "unknown", reason="no package is given")
    return text_of_value(run.perform(value), "no package is given")


def _remaps(run: LaunchRun, value: Value | None) -> list[Remap]:
    found = []
    for row in run.items(value):
        pair = run.items(row)
        if len(pair) == 2:
            where = run.store.get(getattr(row, "key", 0), PAIR_PLACE)
            origin = pair[0].origin if isinstance(pair[0], Known) else None
            place = where if isinstance(where, Place) else origin or run.place_now
            found.append(remap(run.perform(pair[0]), run.perform(pair[1]), place))
    return found


def _words(run: LaunchRun, value: Value | None) -> tuple[list[str | None], bool]:
    """The words of a command line, None for one that is not known; False where there may be others."""
    words, whole = _texts(run, value)
    return _known(words), whole


def _known(words: Sequence[Value]) -> list[str | None]:
    return [str(word.value) if isinstance(word, Known) else None for word in words]


def _texts(run: LaunchRun, value: Value | None) -> tuple[list[Value], bool]:
    """The words of a command line as values; False where there may be others."""
    if value is None:
        return [], True
    if isinstance(value, Known) or kind_of(value):
        text = run.perform(value)
        if not isinstance(text, Known):
            return [text], False
        return [Known(word, text.via, text.origin) for word in _split(str(text.value))], True
    found = [run.perform(item) for item in run.items(value)]
    return found, isinstance(value, ListValue) and run.is_closed(value)


def _parameter_files(run: LaunchRun, words: list[str | None], place: Place) -> list[Parameter]:
    """``--params-file path`` between ``--ros-args`` and ``--``."""
    found: list[Parameter] = []
    inside = False
    for option, path in pairwise(words):
        if option in ("--ros-args", "--"):
            inside = option == "--ros-args"
        elif inside and option == "--params-file":
            unknown = OpenParameters("a parameter file on the command line that is not known", place)
            found.append(unknown if path is None else file_use(run, Known(path), place))
    return found


def _split(text: str) -> list[str]:
    """The words of a text as a shell divides it."""
    try:
        return shlex.split(text)
    except ValueError:
        return text.split()


_KEYWORDS_OF_ALL = frozenset({"condition", "sigterm_timeout", "sigkill_timeout", "log_cmd"})


def _check_keywords(run: LaunchRun, entity: Instance) -> None:
    kind = kind_of(entity)
    known = SIGNATURES[kind].replace("*", "").split()
    places = places_of(entity)
    for name in entity.arguments:
        if name not in known and name not in _KEYWORDS_OF_ALL and not name.isdigit() and name in places:
            run.note_unknown_attribute(UnknownAttribute(kind, name, tuple(known), places[name]))


def _components(run: LaunchRun, entity: Instance, container: Text | None) -> None:
    value = argument(entity, "composable_node_descriptions")
    for item in run.items(value):
        for option in each_alternative(run, item) if isinstance(item, OneOf) else (item,):
            if kind_of(option) not in ("ComposableNode", "ComposableLifecycleNode"):
                run.gap(f"a component: {reason(option)}")
                continue
            assert isinstance(option, Instance)
            verdict, own = verdict_on(run, option), arms_of(run, option) - run.code_arms
            kept, run.place_now = run.place_now, option.place or run.place_now
            with run.under(own, verdict, run.place_now):
                made = _started(run, option, StartedKind.COMPONENT)
                made.container = container
                run.start(made)
            run.place_now = kept
    if isinstance(value, Unknown) or (isinstance(value, ListValue) and run.is_open(value)):
        run.gap("a list of components that is not wholly known")


def load(run: LaunchRun, entity: Instance) -> None:
    target = argument(entity, "target_container")
    if kind_of(target):
        target = argument(target, "name") if kind_of(target).endswith("Container") else target
    text = None if target is None else text_of_value(run.perform(target), "no container")
    _components(run, entity, text)


def process(run: LaunchRun, entity: Instance) -> None:
    """``ros2 run package executable arguments…`` and the path of an executable are nodes like any other."""
    words, whole = _words(run, argument(entity, "cmd"))
    if len(words) == 1 and words[0] and " " in words[0]:
        words = [*_split(words[0])]
    installed = _INSTALLED.match(words[0]) if words and words[0] else None
    if installed:
        words = ["ros2", "run", installed[1], installed[2], *words[1:]]
    if words[:2] == ["ros2", "run"] and len(words) > 3 and words[2] and words[3]:
        started = Started(
            StartedKind.NODE,
            Text(words[2], "exact"),
            Text(words[3], "exact"),
            run.place_now,
            run.file,
            branch_arms=run.current_arms,
            dormant=run.is_dormant,
            arguments=words[4:],
            whole_arguments=whole,
            bare=True,
        )
        started.parameters = _parameter_files(run, words[4:], run.place_now)
    elif words[:2] == ["ros2", "launch"] and len(words) > 3 and words[2] and words[3]:
        launch_in_own_process(run, words[2], words[3], words[4:])
        return
    else:
        name = Text(words[0], "exact") if words and words[0] else Text(None, "unknown", reason="a command")
        started = Started(
            StartedKind.PROCESS,
            Text(None, "unknown", reason="a process, not a node"),
            name,
            run.place_now,
            run.file,
            branch_arms=run.current_arms,
            dormant=run.is_dormant,
            arguments=words[1:],
        )
    run.start(started)


_INSTALLED = re.compile(r"^\$\(find-pkg-prefix ([\w.-]+)\)/lib/[\w.-]+/([^/]+)$")
