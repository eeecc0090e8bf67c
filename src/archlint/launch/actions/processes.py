"""Actions that start something: nodes, containers and their components, commands."""

from __future__ import annotations

import posixpath
import re
import shlex
from collections.abc import Sequence
from contextlib import nullcontext
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import (
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)
from archlint.launch.actions.branches import arms_of, each_alternative, verdict_on
from archlint.launch.actions.domains import domain_of
from archlint.launch.actions.included import launch_in_own_process
from archlint.launch.actions.missing_arguments import note_missing_arguments
from archlint.launch.actions.pairs import pairs_of
from archlint.launch.actions.scopes import remap
from archlint.launch.bridges import bridged_in_file
from archlint.launch.kinds import FileKind, StartedKind
from archlint.launch.named_files import FileReference
from archlint.launch.namespaces import absolute, prefix_namespace
from archlint.launch.objects import LaunchObject, argument, class_name, kind_of, known_text
from archlint.launch.old_keywords import under_present_names
from archlint.launch.parameter_sources import OpenParameters, ParameterFileUse, ParameterSetting
from archlint.launch.parameters import Parameter, file_use, parameters_of
from archlint.launch.shared_paths import is_written, note_paths, note_value
from archlint.launch.started import Remap, Started
from archlint.launch.tables import LaunchClass
from archlint.launch.unknown_keywords import note_of_process
from archlint.libraries.texts import text_of_value
from archlint.model import Text

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def node(run: LaunchRun, entity: LaunchObject) -> None:
    is_container = entity.kind == LaunchClass.COMPOSABLE_NODE_CONTAINER
    started = _started(run, entity, StartedKind.CONTAINER if is_container else StartedKind.NODE)
    started.lifecycle = entity.kind == LaunchClass.LIFECYCLE_NODE
    run.start(started)
    if is_container:
        _components(run, entity, started)


def _text_of(run: LaunchRun, value: Value, missing: str) -> Text:
    """A name, which is no default where the file looks at ``sys.argv``: a word there may replace it."""
    if run.program.reads_command_line and any(isinstance(option, (Unknown, Holed)) for option in alternatives(value)):
        return Text(None, "unknown", reason="a command-line argument may replace it")
    return _certain_text(value, missing)


def _certain_text(value: Value | None, missing: str) -> Text:
    """A text that nothing unknown may take the place of, but for what a user may give instead of a default."""
    options = () if value is None else alternatives(value)
    unknown = next((option for option in options if isinstance(option, Unknown)), None)
    if unknown is not None and any(
        isinstance(option, Known) and option.kind != "argument_default" for option in options
    ):
        return text_of_value(unknown, missing)
    return text_of_value(value, missing)


def _started(run: LaunchRun, entity: LaunchObject, kind: StartedKind) -> Started:
    note_of_process(run, entity)
    entity = under_present_names(entity)
    executable = entity.argument("plugin" if kind == StartedKind.COMPONENT else "executable")
    namespace = entity.argument("namespace")
    name = entity.argument("name")
    own = None if namespace is None else run.perform(namespace)
    full = absolute(prefix_namespace(run.launch.namespace, own))
    started = Started(
        kind,
        _package(run, entity.argument("package")),
        _certain_text(None if executable is None else run.perform(executable), "no executable is given"),
        run.place_now,
        run.file,
        None if name is None else _text_of(run, run.perform(name), "no name"),
        None if full is None else _text_of(run, full, "no namespace"),
        branch_arms=run.current_arms,
        dormant=run.is_dormant,
        places=entity.places,
        without_namespace=run.without_namespace,
        domain=domain_of(run, entity),
        after=run.ended,
    )
    started.remaps = [*(run.launch.remaps or ()), *_remaps(run, entity.argument("remappings"))]
    words, all_known = _texts(run, entity.argument("arguments"))
    started.arguments = list(map(known_text, words))
    started.ros_arguments, all_ros_known = _words(run, entity.argument("ros_arguments"))
    started.knows_all_arguments = all_known and all_ros_known
    started.parameters = [
        *_parameter_files(run, [*started.arguments, "--ros-args", *started.ros_arguments], run.place_now),
        *(run.launch.parameters or ()),
        *parameters_of(run, entity.argument("parameters"), started.places.get("parameters", run.place_now)),
    ]
    if entity.open:
        started.parameters.append(OpenParameters("arguments that are passed by **", run.place_now))
    started.bridged = bridged_in_file(run, started)
    of_several = isinstance(entity.argument("arguments"), OneOf)
    with run.perhaps() if of_several else nullcontext():
        _note_files(run, started, words)
    return started


def _note_files(run: LaunchRun, started: Started, words: Sequence[Value]) -> None:
    """Note the files that the command line and the parameters of a node name."""
    place = started.places.get("arguments", run.place_now)
    for word in words:
        if (known_text(word) or "").endswith(".rviz") and not _is_of_another_value(run, word):
            run.reference(FileKind.RVIZ, word, place)
    note_paths(run, words, place)
    for parameter in started.parameters:
        match parameter:
            case ParameterSetting(name, str(text), place, shared=False) if not is_written(name):
                note_value(run, name, text, place, parameter.given)
            case ParameterFileUse(reference=FileReference(source=str(file)), changes=()):
                _note_values_in_file(run, file, parameter.substitutions)


def _note_values_in_file(run: LaunchRun, file: str, substitutions: bool) -> None:
    """Note the files that the values of a parameter file name; a ``$(…)`` is one with ``allow_substs`` alone."""
    for section in run.files.parameters(file).sections:
        for entry in section.entries:
            text = entry.value
            is_text = isinstance(text, str) and (substitutions or "$(" not in text)
            if is_text and not is_written(entry.name):
                note_value(run, entry.name, text, Place(file, *entry.span))


def _is_of_another_value(run: LaunchRun, word: Value) -> bool:
    """Whether a file of a node that does not start by default has its name from the default of an argument: the node
    starts with another value, and so with another file."""
    stem = posixpath.basename(known_text(word) or "").removesuffix(".rviz")
    return run.is_dormant and stem in map(known_text, run.launch.configurations.values())


def _package(run: LaunchRun, value: Value | None) -> Text:
    if value is None:
        return Text(None, "unknown", reason="no package is given")
    return _certain_text(run.perform(value), "no package is given")


def _remaps(run: LaunchRun, value: Value | None) -> list[Remap]:
    return [remap(_side(run, pair.first), _side(run, pair.second), pair.place) for pair in pairs_of(run, value)]


def _side(run: LaunchRun, value: Value) -> Value:
    """The text on one side of a remapping.  A None among its values is none of it: launch refuses that, and gives ROS
    no empty text for it."""
    options = alternatives(value)
    texts = [option for option in options if not (isinstance(option, Known) and option.value is None)]
    return run.perform(value if len(texts) == len(options) else one_of(texts))


def _words(run: LaunchRun, value: Value | None) -> tuple[list[str | None], bool]:
    """The words of a command line, None for one that is not known; False where there may be others."""
    words, all_known = _texts(run, value)
    return list(map(known_text, words)), all_known


def _texts(run: LaunchRun, value: Value | None) -> tuple[list[Value], bool]:
    """The words of a command line as values; False where there may be others."""
    match value:
        case None:
            return [], True
        case Known():
            return _words_of_text(run.perform(value))
        case Instance() if class_name(value):
            return _words_of_text(run.perform(value))
        case ListValue():
            return [run.perform(item) for item in run.items(value)], run.is_closed(value)
    return [run.perform(item) for item in run.items(value)], False


def _words_of_text(text: Value) -> tuple[list[Value], bool]:
    match text:
        case Known(value=value, via=via, origin=origin):
            return [Known(word, via, origin) for word in _split(str(value))], True
    return [text], False


def _parameter_files(run: LaunchRun, words: list[str | None], place: Place) -> list[Parameter]:
    """``--params-file path`` between ``--ros-args`` and ``--``."""
    parameters: list[Parameter] = []
    inside = False
    for option, path in pairwise(words):
        if option in ("--ros-args", "--"):
            inside = option == "--ros-args"
        elif inside and option == "--params-file":
            unknown = OpenParameters("a parameter file on the command line that is not known", place)
            parameters.append(unknown if path is None else file_use(run, Known(path), place))
    return parameters


def _split(text: str) -> list[str]:
    """The words of a text as a shell divides it."""
    try:
        return shlex.split(text)
    except ValueError:
        return text.split()


def _components(run: LaunchRun, entity: LaunchObject, container: Started | Text | None) -> None:
    value = entity.argument("composable_node_descriptions")
    for item in run.items(value):
        for option in each_alternative(run, item):
            match option:
                case LaunchObject(kind=LaunchClass.COMPOSABLE_NODE | LaunchClass.COMPOSABLE_LIFECYCLE_NODE):
                    _component(run, option, container)
                case _:
                    run.gap(f"a component: {reason(option)}")
    match value:
        case ListValue() | Unknown() if run.is_open(value):
            run.gap("a list of components that is only partly known")


def _component(run: LaunchRun, entity: LaunchObject, container: Started | Text | None) -> None:
    note_missing_arguments(run, entity)
    verdict, own = verdict_on(run, entity), arms_of(run, entity) - run.code_arms
    kept, run.place_now = run.place_now, entity.place or run.place_now
    with run.under(own, verdict, run.place_now):
        started = _started(run, entity, StartedKind.COMPONENT)
        if started.name is not None and started.name.text == "" and started.name.resolution == "exact":
            started.name = None  # a container takes an empty name for none
        match container:
            case Started():
                started.container, started.domain = container.name, container.domain
            case _:
                started.container, started.domain = container, _domain_of_container(run, container)
        run.start(started)
    run.place_now = kept


def _domain_of_container(run: LaunchRun, name: Text | None) -> str | None:
    """The domain of a container that is started elsewhere: its components are in that of its process."""
    containers = (other for other in run.result.started if other.kind == StartedKind.CONTAINER)
    return next((other.domain for other in containers if other.name == name), None)


def load(run: LaunchRun, entity: LaunchObject) -> None:
    target = entity.argument("target_container")
    if kind_of(target) is LaunchClass.COMPOSABLE_NODE_CONTAINER:
        target = argument(target, "name")
    text = None if target is None else text_of_value(run.perform(target), "no container")
    _components(run, entity, text)


def process(run: LaunchRun, entity: LaunchObject) -> None:
    """``ros2 run package executable arguments…`` and the path of an executable are nodes like any other."""
    words, all_known = _words(run, entity.argument("cmd"))
    note_paths(run, [Known(word) for word in words[1:] if word is not None], run.place_now)
    if len(words) == 1 and words[0] and " " in words[0]:
        words = [*_split(words[0])]
    if len(words) > 1 and words[0] in _PYTHON and words[1] and _INSTALLED.match(words[1]):
        words = words[1:]
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
            knows_all_arguments=all_known,
            bare=True,
            domain=domain_of(run, entity),
        )
        started.parameters = _parameter_files(run, words[4:], run.place_now)
    elif words[:2] == ["ros2", "launch"] and len(words) > 3 and words[2] and words[3]:
        launch_in_own_process(run, entity, (words[2], words[3]), words[4:])
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


_PYTHON = frozenset({"python", "python3"})
_INSTALLED = re.compile(r"^\$\(find-pkg-prefix ([\w.-]+)\)/lib/[\w.-]+/([^/]+)$")
