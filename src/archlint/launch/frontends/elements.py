"""The elements of XML and YAML launch files as the actions that Python makes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import Known, Unknown, Value
from archlint.launch.frontends.objects import Frontend
from archlint.launch.frontends.parameters import read_parameter, set_parameter
from archlint.launch.frontends.tables import ATTRIBUTES, HARMLESS, NEEDED, NEEDED_BELOW, NEEDED_BY_INCLUDES, NESTED
from archlint.launch.frontends.texts import shell_words
from archlint.launch.mistakes import MissingArguments, UnknownAttribute
from archlint.launch.objects import PAIR_PLACE, LaunchObject
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun
    from archlint.syntax.launch_elements import Element


def actions_of(run: LaunchRun, file: str, root: Element) -> Iterator[Value]:
    """The actions of a launch file, each when the one before it has run."""
    yield from _actions(Frontend(run, file), root.children)


def _actions(frontend: Frontend, elements: Sequence[Element]) -> Iterator[Value]:
    for element in elements:
        build = _ELEMENTS.get(element.tag)
        if build is None and element.tag not in HARMLESS:
            yield frontend.unknown(element)
        if build is not None:
            action = build(frontend, element)
            if action is not None:
                _condition(frontend, element, action)
                _check(frontend, element)
                yield action


def _condition(frontend: Frontend, element: Element, entity: LaunchObject) -> None:
    for name, kind in (("if", LaunchClass.IF_CONDITION), ("unless", LaunchClass.UNLESS_CONDITION)):
        attribute = element.attributes.get(name)
        if attribute is not None:
            place = frontend.place(attribute.span)
            given = {"predicate_expression": frontend.text(attribute)}
            entity.arguments["condition"] = frontend.make(kind, place, given)


def _check(frontend: Frontend, element: Element) -> None:
    _check_needed(frontend, element, NEEDED)
    for child in element.children:
        _check_needed(frontend, child, NEEDED_BY_INCLUDES if element.tag == "include" else NEEDED_BELOW)
    action, nested = f"<{element.tag}>", NESTED.get(element.tag)
    for child in element.children:
        if nested is not None and child.tag not in nested:
            wrong = UnknownAttribute(action, child.tag, nested, frontend.place(child.span), True, nested=True)
            frontend.run.note_unknown_attribute(wrong)
    known = ATTRIBUTES.get(element.tag)
    if known is None:
        return
    for name, attribute in element.attributes.items():
        if name not in known and name not in ("if", "unless"):
            frontend.run.note_unknown_attribute(
                UnknownAttribute(action, name, tuple(known), frontend.place(attribute.span), True)
            )


def _check_needed(frontend: Frontend, element: Element, needed: Mapping[str, tuple[str, ...]]) -> None:
    """Note what an element lacks; where it has something that launch does not know, that is what was meant for it."""
    names, known = needed.get(element.tag, ()), ATTRIBUTES.get(element.tag, ())
    given = {*element.attributes, *(child.tag for child in element.children)}
    missing = tuple(name for name in names if name not in given)
    if missing and not any(name not in (*known, *names, "if", "unless") for name in element.attributes):
        place = frontend.place(element.span)
        frontend.run.note_incomplete(MissingArguments(f"<{element.tag}>", missing, place, of_element=True))


def _node(frontend: Frontend, element: Element, kind: LaunchClass = LaunchClass.NODE) -> LaunchObject:
    given, places = frontend.arguments(
        element,
        {
            "pkg": "package",
            "exec": "executable",
            "executable": "executable",
            "name": "name",
            "namespace": "namespace",
        },
    )
    for name, parameter in (("args", "arguments"), ("ros_args", "ros_arguments")):
        _command_line(frontend, element, name, parameter, given, places)
    _described(frontend, element, given)
    _environment(frontend, element, given)
    return frontend.make(kind, frontend.place(element.span), given, places)


def _command_line(
    frontend: Frontend, element: Element, name: str, parameter: str, given: dict[str, Value], places: dict[str, Place]
) -> None:
    """An attribute that holds the words of a command line: text is split as a shell does, what a substitution
    gives is not."""
    attribute = element.attributes.get(name)
    if attribute is None:
        return
    places[parameter] = frontend.place(attribute.span)
    if not isinstance(attribute.value, str):
        given[parameter] = frontend.text(attribute)
        return
    words: list[list[Value]] = [[]]
    for part in frontend.parts(attribute.value, places[parameter], 0):
        if not isinstance(part, Known):
            words[-1].append(part)
            continue
        text = str(part.value)
        pieces = shell_words(text)
        if not pieces or text[0].isspace():
            words.append([])
        for number, piece in enumerate(pieces):
            words += [[]] if number else []
            words[-1].append(Known(piece, origin=places[parameter]))
        if pieces and text[-1].isspace():
            words.append([])
    given[parameter] = frontend.list([word[0] if len(word) == 1 else frontend.list(word) for word in words if word])


def _described(frontend: Frontend, element: Element, given: dict[str, Value]) -> None:
    parameters = [read_parameter(frontend, child) for child in element.of("param")]
    remaps = [_pair(frontend, child, "from", "to") for child in element.of("remap")]
    if parameters:
        given["parameters"] = frontend.list([value for value in parameters if value is not None])
    if remaps:
        given["remappings"] = frontend.list(remaps)


def _environment(frontend: Frontend, element: Element, given: dict[str, Value]) -> None:
    pairs = [_pair(frontend, child, "name", "value") for child in element.of("env")]
    if pairs:
        given["additional_env"] = frontend.dict_of(pairs)


def _pair(frontend: Frontend, element: Element, first: str, second: str) -> Value:
    values = [frontend.get(element, name) or Known("") for name in (first, second)]
    value = containers.new_list(frontend.run, values, "tuple")
    frontend.run.store.set(value.key, PAIR_PLACE, frontend.place(element.span))
    return value


def _container(frontend: Frontend, element: Element) -> LaunchObject:
    container = _node(frontend, element, LaunchClass.COMPOSABLE_NODE_CONTAINER)
    container.arguments["composable_node_descriptions"] = _components(frontend, element)
    return container


def _load(frontend: Frontend, element: Element) -> LaunchObject:
    given, places = frontend.arguments(element, {"target": "target_container"})
    given["composable_node_descriptions"] = _components(frontend, element)
    return frontend.make(LaunchClass.LOAD_COMPOSABLE_NODES, frontend.place(element.span), given, places)


def _components(frontend: Frontend, element: Element) -> Value:
    values: list[Value] = []
    for child in element.of("composable_node", "composable_lifecycle_node"):
        names = {"pkg": "package", "plugin": "plugin", "name": "name", "namespace": "namespace"}
        given, places = frontend.arguments(child, names)
        _described(frontend, child, given)
        component = frontend.make(LaunchClass.COMPOSABLE_NODE, frontend.place(child.span), given, places)
        _condition(frontend, child, component)
        _check(frontend, child)
        values.append(component)
    return frontend.list(values)


def _include(frontend: Frontend, element: Element) -> LaunchObject:
    file = element.attributes.get("file")
    place = frontend.place(file.span if file is not None else element.span)
    location = frontend.text(file) if file is not None else Unknown("an include without a file")
    source = frontend.make(LaunchClass.ANY_LAUNCH_DESCRIPTION_SOURCE, place, {"launch_file_path": location})
    rows = [_pair(frontend, child, "name", "value") for child in element.of(*NESTED["include"])]
    given = {"launch_description_source": source, "launch_arguments": frontend.list(rows)}
    return frontend.make(LaunchClass.INCLUDE_LAUNCH_DESCRIPTION, place, given, {"launch_description_source": place})


def _group(frontend: Frontend, element: Element) -> LaunchObject:
    given: dict[str, Value] = {"actions": frontend.list(list(_actions(frontend, element.children)))}
    for name in ("scoped", "forwarding"):
        text = element.text(name)
        if text is not None:
            given[name] = Known(text.lower() not in ("false", "0"))
    kept = [_pair(frontend, child, "name", "value") for child in element.of("keep")]
    if kept:
        given["launch_configurations"] = frontend.dict_of(kept)
    return frontend.make(LaunchClass.GROUP_ACTION, frontend.place(element.span), given)


def _timer(frontend: Frontend, element: Element) -> LaunchObject:
    given: dict[str, Value] = {"actions": frontend.list(list(_actions(frontend, element.children)))}
    return frontend.make(LaunchClass.TIMER_ACTION, frontend.place(element.span), given)


def _argument(frontend: Frontend, element: Element) -> LaunchObject:
    given, places = frontend.arguments(element, {"name": "name", "default": "default_value"})
    choices = [frontend.get(child, "value") or Known("") for child in element.of("choice")]
    if choices:
        given["choices"] = frontend.list(choices)
    return frontend.make(LaunchClass.DECLARE_LAUNCH_ARGUMENT, frontend.place(element.span), given, places)


def _executable(frontend: Frontend, element: Element) -> LaunchObject:
    given, places = frontend.arguments(element, {"name": "name"})
    _command_line(frontend, element, "cmd", "cmd", given, places)
    _environment(frontend, element, given)
    return frontend.make(LaunchClass.EXECUTE_PROCESS, frontend.place(element.span), given, places)


def _simple(kind: LaunchClass, **names: str) -> Callable[[Frontend, Element], LaunchObject]:
    def build(frontend: Frontend, element: Element) -> LaunchObject:
        given, places = frontend.arguments(element, names)
        return frontend.make(kind, frontend.place(element.span), given, places)

    return build


_LET = _simple(LaunchClass.SET_LAUNCH_CONFIGURATION, name="name", value="value")
_PUSH = _simple(LaunchClass.PUSH_ROS_NAMESPACE, namespace="namespace")

_ELEMENTS: dict[str, Callable[[Frontend, Element], LaunchObject | None]] = {
    "node": _node,
    "lifecycle_node": lambda frontend, element: _node(frontend, element, LaunchClass.LIFECYCLE_NODE),
    "node_container": _container,
    "load_composable_node": _load,
    "include": _include,
    "group": _group,
    "timer": _timer,
    "ros_timer": _timer,
    "arg": _argument,
    "bool_arg": _argument,
    "let": _LET,
    "push_ros_namespace": _PUSH,
    "push-ros-namespace": _PUSH,
    "set_remap": _simple(LaunchClass.SET_REMAP, **{"from": "src", "to": "dst"}),
    "set_parameter": set_parameter,
    "set_parameters_from_file": _simple(LaunchClass.SET_PARAMETERS_FROM_FILE, filename="filename"),
    "set_use_sim_time": _simple(LaunchClass.SET_USE_SIM_TIME, value="value"),
    "set_env": _simple(LaunchClass.SET_ENVIRONMENT_VARIABLE, name="name", value="value"),
    "unset_env": _simple(LaunchClass.UNSET_ENVIRONMENT_VARIABLE, name="name"),
    "executable": _executable,
}
