"""XML and YAML launch files as the same actions that Python makes."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import External, Instance, Known, Unknown, Value
from archlint.launch.frontend_parameters import read_parameter, set_parameter
from archlint.launch.frontend_tables import ATTRIBUTES, HARMLESS, SUBSTITUTIONS
from archlint.launch.frontend_texts import closing, shell_words, unquoted, words_of
from archlint.launch.model import UnknownAttribute
from archlint.syntax.launch_elements import Attribute, Element

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


NESTING = 20
"""How deep substitutions are followed into each other."""


class Frontend:
    """Turns the elements of one file into launch's objects."""

    def __init__(self, run: LaunchRun, file: str) -> None:
        self.run = run
        self.file = file

    def place(self, span: tuple[int, int, int, int]) -> Place:
        return Place(self.file, *span)

    def make(self, kind: str, place: Place, arguments: dict[str, Value], places: dict[str, Place]) -> Instance:
        made = Instance(External(f"launch.{kind}"), self.run.store.new_key(), place, arguments)
        self.run.store.set(made.key, "#places", places)
        return made

    def list(self, values: Sequence[Value]) -> Value:
        from archlint.interpreter import containers

        return containers.new_list(self.run, values)

    def dict_of(self, pairs: Sequence[Value]) -> Value:
        from archlint.interpreter import containers
        from archlint.interpreter.value_methods import update_entries

        entries: dict[Hashable, tuple[Value, Value]] = {}
        known = all(update_entries(self.run, entries, self.list([pair])) for pair in pairs)
        return containers.new_dict(self.run, entries, not known)

    # ------------------------------------------------------------------------------------------ elements

    def actions(self, elements: Sequence[Element]) -> Iterator[Value]:
        for element in elements:
            build = _ELEMENTS.get(element.tag)
            if build is None and element.tag not in HARMLESS:
                yield self.make(f"<{element.tag}>", self.place(element.span), {}, {})
            if build is not None:
                made = build(self, element)
                if made is not None:
                    self._condition(element, made)
                    self._check(element)
                    yield made

    def _condition(self, element: Element, made: Instance) -> None:
        for name, kind in (("if", "IfCondition"), ("unless", "UnlessCondition")):
            attribute = element.attributes.get(name)
            if attribute is not None:
                place = self.place(attribute.span)
                given = {"predicate_expression": self.text(attribute)}
                made.arguments["condition"] = self.make(kind, place, given, {})

    def _check(self, element: Element) -> None:
        known = ATTRIBUTES.get(element.tag)
        if known is None:
            return
        for name, attribute in element.attributes.items():
            if name not in known and name not in ("if", "unless"):
                self.run.note_unknown_attribute(
                    UnknownAttribute(f"<{element.tag}>", name, tuple(known), self.place(attribute.span))
                )

    def text(self, attribute: Attribute) -> Value:
        """The value of an attribute, with its substitutions."""
        if isinstance(attribute.value, list):
            parts = [Known(item) if not isinstance(item, str) else self.parse(item) for item in attribute.value]
            return self.list(parts)
        if isinstance(attribute.value, str):
            return self.parse(attribute.value, self.place(attribute.span))
        return Known(attribute.value, origin=self.place(attribute.span))

    def get(self, element: Element, *names: str) -> Value | None:
        for name in names:
            if name in element.attributes:
                return self.text(element.attributes[name])
        return None

    def arguments(self, element: Element, names: dict[str, str]) -> tuple[dict[str, Value], dict[str, Place]]:
        """Constructor arguments from attributes: ``names`` maps attributes to parameters."""
        found: dict[str, Value] = {}
        places: dict[str, Place] = {}
        for name, parameter in names.items():
            attribute = element.attributes.get(name)
            if attribute is not None:
                found[parameter] = self.text(attribute)
                places[parameter] = self.place(attribute.span)
        return found, places

    # ------------------------------------------------------------------------------------ substitutions

    def parse(self, text: str, place: Place | None = None) -> Value:
        """A text with ``$(…)`` in it."""
        if "$(" not in text:
            return Known(text, origin=place, kind="literal")
        parts = list(self._parts(text, place, 0))
        return parts[0] if len(parts) == 1 else self.list(parts)

    def _parts(self, text: str, place: Place | None, depth: int) -> Iterator[Value]:
        at = 0
        while at < len(text):
            start = text.find("$(", at)
            if start < 0:
                yield Known(text[at:], origin=place)
                return
            if depth > NESTING:
                yield Unknown("substitutions nested too deeply")
                return
            if start > 0 and text[start - 1] == "\\":
                yield Known(text[at : start - 1] + "$(")
                at = start + 2
                continue
            end = closing(text, start + 2)
            if end < 0:
                yield Unknown("a substitution that is not closed")
                return
            if start > at:
                yield Known(text[at:start], origin=place)
            yield self._substitution(text[start + 2 : end], place, depth)
            at = end + 1

    def _substitution(self, text: str, place: Place | None, depth: int) -> Value:
        words = list(words_of(text))
        if not words:
            return Unknown("an empty substitution")
        name, rest = words[0], words[1:]
        build = SUBSTITUTIONS.get(name)
        if build is None:
            return Unknown(f"the substitution $({name} …)")
        kind, parameters = build
        if name == "eval":
            rest = [unquoted(text[text.index("eval") + 4 :].strip())]
        values = [self.list(list(self._parts(unquoted(word), place, depth + 1))) for word in rest]
        made = self.make(kind, place or Place(self.file, 1, 1, 1, 1), dict(zip(parameters, values, strict=False)), {})
        self.run.store.set(made.key, "#rest", tuple(values[len(parameters) :]))
        return made

    # ------------------------------------------------------------------------------------- the elements

    def node(self, element: Element, kind: str = "Node") -> Instance:
        given, places = self.arguments(
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
            self._command_line(element, name, parameter, given, places)
        self._described(element, given)
        return self.make(kind, self.place(element.span), given, places)

    def _command_line(
        self, element: Element, name: str, parameter: str, given: dict[str, Value], places: dict[str, Place]
    ) -> None:
        """An attribute that holds the words of a command line: text is split as a shell does, what a substitution
        gives is not."""
        attribute = element.attributes.get(name)
        if attribute is None:
            return
        places[parameter] = self.place(attribute.span)
        if not isinstance(attribute.value, str):
            given[parameter] = self.text(attribute)
            return
        words: list[list[Value]] = [[]]
        for part in self._parts(attribute.value, places[parameter], 0):
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
        given[parameter] = self.list([word[0] if len(word) == 1 else self.list(word) for word in words if word])

    def _described(self, element: Element, given: dict[str, Value]) -> None:
        parameters = [read_parameter(self, child) for child in element.of("param")]
        remaps = [self._pair(child, "from", "to") for child in element.of("remap")]
        if parameters:
            given["parameters"] = self.list([value for value in parameters if value is not None])
        if remaps:
            given["remappings"] = self.list(remaps)

    def _pair(self, element: Element, first: str, second: str) -> Value:
        from archlint.interpreter import containers

        values = [self.get(element, name) or Known("") for name in (first, second)]
        made = containers.new_list(self.run, values, "tuple")
        self.run.store.set(made.key, "#place", self.place(element.span))
        return made

    def container(self, element: Element) -> Instance:
        made = self.node(element, "ComposableNodeContainer")
        made.arguments["composable_node_descriptions"] = self._components(element)
        return made

    def load(self, element: Element) -> Instance:
        given, places = self.arguments(element, {"target": "target_container"})
        given["composable_node_descriptions"] = self._components(element)
        return self.make("LoadComposableNodes", self.place(element.span), given, places)

    def _components(self, element: Element) -> Value:
        found: list[Value] = []
        for child in element.of("composable_node", "composable_lifecycle_node"):
            names = {"pkg": "package", "plugin": "plugin", "name": "name", "namespace": "namespace"}
            given, places = self.arguments(child, names)
            self._described(child, given)
            made = self.make("ComposableNode", self.place(child.span), given, places)
            self._condition(child, made)
            self._check(child)
            found.append(made)
        return self.list(found)

    def include(self, element: Element) -> Instance:
        file = element.attributes.get("file")
        place = self.place(file.span if file is not None else element.span)
        location = self.text(file) if file is not None else Unknown("an include without a file")
        source = self.make("AnyLaunchDescriptionSource", place, {"launch_file_path": location}, {})
        rows = [self._pair(child, "name", "value") for child in element.of("arg", "let")]
        given = {"launch_description_source": source, "launch_arguments": self.list(rows)}
        return self.make("IncludeLaunchDescription", place, given, {"launch_description_source": place})

    def group(self, element: Element) -> Instance:
        given: dict[str, Value] = {"actions": self.list(list(self.actions(element.children)))}
        for name in ("scoped", "forwarding"):
            text = element.text(name)
            if text is not None:
                given[name] = Known(text.lower() not in ("false", "0"))
        kept = [self._pair(child, "name", "value") for child in element.of("keep")]
        if kept:
            given["launch_configurations"] = self.dict_of(kept)
        return self.make("GroupAction", self.place(element.span), given, {})

    def timer(self, element: Element) -> Instance:
        given: dict[str, Value] = {"actions": self.list(list(self.actions(element.children)))}
        return self.make("TimerAction", self.place(element.span), given, {})

    def argument(self, element: Element) -> Instance:
        given, places = self.arguments(element, {"name": "name", "default": "default_value"})
        choices = [self.get(child, "value") or Known("") for child in element.of("choice")]
        if choices:
            given["choices"] = self.list(choices)
        return self.make("DeclareLaunchArgument", self.place(element.span), given, places)

    def executable(self, element: Element) -> Instance:
        given, places = self.arguments(element, {"name": "name"})
        self._command_line(element, "cmd", "cmd", given, places)
        return self.make("ExecuteProcess", self.place(element.span), given, places)


def _simple(kind: str, **names: str) -> Callable[[Frontend, Element], Instance]:
    def build(frontend: Frontend, element: Element) -> Instance:
        given, places = frontend.arguments(element, names)
        return frontend.make(kind, frontend.place(element.span), given, places)

    return build


_LET = _simple("SetLaunchConfiguration", name="name", value="value")
_PUSH = _simple("PushRosNamespace", namespace="namespace")

_ELEMENTS: dict[str, Callable[[Frontend, Element], Instance | None]] = {
    "node": Frontend.node,
    "lifecycle_node": lambda frontend, element: frontend.node(element, "LifecycleNode"),
    "node_container": Frontend.container,
    "load_composable_node": Frontend.load,
    "include": Frontend.include,
    "group": Frontend.group,
    "timer": Frontend.timer,
    "ros_timer": Frontend.timer,
    "arg": Frontend.argument,
    "bool_arg": Frontend.argument,
    "let": _LET,
    "push_ros_namespace": _PUSH,
    "push-ros-namespace": _PUSH,
    "set_remap": _simple("SetRemap", **{"from": "src", "to": "dst"}),
    "set_parameter": set_parameter,
    "set_parameters_from_file": _simple("SetParametersFromFile", filename="filename"),
    "set_use_sim_time": _simple("SetUseSimTime", value="value"),
    "set_env": _simple("SetEnvironmentVariable", name="name", value="value"),
    "unset_env": _simple("UnsetEnvironmentVariable", name="name"),
    "executable": Frontend.executable,
}
