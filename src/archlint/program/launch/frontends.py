"""XML and YAML launch files as the same actions that Python makes."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.facts.launch_model import Attribute, Element
from archlint.finding import Place
from archlint.program.launch.model import UnknownAttribute
from archlint.program.launch.parameters import from_yaml
from archlint.program.values import External, Instance, Known, Unknown, Value

if TYPE_CHECKING:
    from archlint.program.launch.run import LaunchRun


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
        from archlint.program import containers

        return containers.new_list(self.run, values)

    # ------------------------------------------------------------------------------------------ elements

    def actions(self, elements: Sequence[Element]) -> Iterator[Value]:
        for element in elements:
            build = _ELEMENTS.get(element.tag)
            if build is None and element.tag not in _HARMLESS:
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
        known = _ATTRIBUTES.get(element.tag)
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
            if start < 0 or depth > 20:
                yield Known(text[at:], origin=place)
                return
            if start > 0 and text[start - 1] == "\\":
                yield Known(text[at : start - 1] + "$(")
                at = start + 2
                continue
            end = _closing(text, start + 2)
            if end < 0:
                yield Unknown("a substitution that is not closed")
                return
            if start > at:
                yield Known(text[at:start], origin=place)
            yield self._substitution(text[start + 2 : end], place, depth)
            at = end + 1

    def _substitution(self, text: str, place: Place | None, depth: int) -> Value:
        words = list(_words(text))
        if not words:
            return Unknown("an empty substitution")
        name, rest = words[0], words[1:]
        build = _SUBSTITUTIONS.get(name)
        if build is None:
            return Unknown(f"the substitution $({name} …)")
        kind, parameters = build
        if name == "eval":
            rest = [_unquoted(text[text.index("eval") + 4 :].strip())]
        values = [self.list(list(self._parts(_unquoted(word), place, depth + 1))) for word in rest]
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
            pieces = _shell_words(text)
            if not pieces or text[0].isspace():
                words.append([])
            for number, piece in enumerate(pieces):
                words += [[]] if number else []
                words[-1].append(Known(piece, origin=places[parameter]))
            if pieces and text[-1].isspace():
                words.append([])
        given[parameter] = self.list([word[0] if len(word) == 1 else self.list(word) for word in words if word])

    def _described(self, element: Element, given: dict[str, Value]) -> None:
        parameters = [self._parameter(child) for child in element.of("param")]
        remaps = [self._pair(child, "from", "to") for child in element.of("remap")]
        if parameters:
            given["parameters"] = self.list([value for value in parameters if value is not None])
        if remaps:
            given["remappings"] = self.list(remaps)

    def _pair(self, element: Element, first: str, second: str) -> Value:
        from archlint.program import containers

        values = [self.get(element, name) or Known("") for name in (first, second)]
        made = containers.new_list(self.run, values, "tuple")
        self.run.store.set(made.key, "#place", self.place(element.span))
        return made

    def _parameter(self, element: Element, prefix: str = "") -> Value | None:
        place = self.place(element.span)
        if "from" in element.attributes:
            given = {"param_file": self.text(element.attributes["from"])}
            if (element.text("allow_substs") or "").lower() == "true":
                given["allow_substs"] = Known(True)
            return self.make("ParameterFile", self.place(element.attributes["from"].span), given, {})
        nested = element.of("param")
        name = self.get(element, "name") or Known("")
        if nested:
            return self._nested(element, name, prefix)
        value = self._value(element)
        if prefix:
            name = self.list([Known(prefix + "."), name])
        return self.make("Parameter", place, {"name": name, "value": value}, {})

    def _nested(self, element: Element, name: Value, prefix: str) -> Value | None:
        """A parameter with parameters in it: a dict."""
        from archlint.program import containers

        entries: dict[Hashable, tuple[Value, Value]] = {}
        for number, child in enumerate(element.of("param")):
            key = self.get(child, "name") or Known("")
            if isinstance(key, Known):
                key = Known(str(key.value), origin=self.place(child.span))
            inner = self._nested(child, Known(""), "") if child.of("param") else self._value(child)
            entries[("#", number)] = (key, inner or Unknown("a parameter without a value"))
        made = containers.new_dict(self.run, entries)
        if isinstance(name, Known) and not name.value:
            return made
        return containers.new_dict(self.run, {("#", 0): (name, made)})

    def _value(self, element: Element) -> Value:
        """The value of a parameter: in XML text that is read as YAML, in YAML what it is."""
        attribute = element.attributes.get("value")
        if attribute is None:
            return Unknown("a parameter without a value")
        kind = element.text("type")
        place = self.place(attribute.span)
        if isinstance(attribute.value, str):
            separator = element.text("value-sep")
            if separator:
                return self.list([self._scalar(part.strip(), kind) for part in attribute.value.split(separator)])
            quoted_number = self.file.endswith((".yaml", ".yml")) and from_yaml(attribute.value)[0] != attribute.value
            if quoted_number and kind is None:
                return Unknown("a text that looks like a number: releases differ in what they make of it")
            if "$(" not in attribute.value:
                return self._scalar(attribute.value, kind)
            given = {"value": self.parse(attribute.value, place)}
            if kind is not None:
                given["value_type"] = External(f"builtins.{kind}")
            return self.make("ParameterValue", place, given, {})
        return self.text(attribute)

    def _scalar(self, text: str, kind: str | None) -> Value:
        if kind == "str":
            return Known(text)
        found, known = from_yaml(text)
        if not known:
            return Unknown("a value that a parameter cannot have")
        if isinstance(found, list):
            return self.list(
                [Known(item) if not isinstance(item, (list, dict)) else Unknown("nested") for item in found]
            )
        assert found is None or isinstance(found, (str, int, float, bool))
        return Known(found)

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
    "set_parameter": _simple("SetParameter", name="name", value="value"),
    "set_parameters_from_file": _simple("SetParametersFromFile", filename="filename"),
    "set_use_sim_time": _simple("SetUseSimTime", value="value"),
    "set_env": _simple("SetEnvironmentVariable", name="name", value="value"),
    "unset_env": _simple("UnsetEnvironmentVariable", name="name"),
    "executable": Frontend.executable,
}

_HARMLESS = frozenset(
    {"keep", "log", "log_info", "log_debug", "log_warning", "log_error", "shutdown", "set_ros_log_dir", "append_env"}
    | {"reset", "reset_env", "rep_env", "push_env", "pop_env"}
)
"""Elements that start nothing, and whose effect no name depends on."""

_PROCESS = [
    "output",
    "respawn",
    "respawn_delay",
    "respawn_max_retries",
    "launch-prefix",
    "cwd",
    "on_exit",
    "shell",
    "emulate_tty",
    "sigterm_timeout",
    "sigkill_timeout",
    "output_format",
    "exec_name",
]
_NODE = ["pkg", "exec", "name", "namespace", "args", "ros_args", *_PROCESS]

_ATTRIBUTES: dict[str, list[str]] = {
    "node": _NODE,
    "lifecycle_node": [*_NODE, "autostart"],
    "node_container": _NODE,
    "composable_node": ["pkg", "plugin", "name", "namespace"],
    "load_composable_node": ["target"],
    "include": ["file"],
    "group": ["scoped", "forwarding"],
    "arg": ["name", "default", "description"],
    "let": ["name", "value"],
    "push_ros_namespace": ["namespace"],
    "push-ros-namespace": ["namespace"],
    "set_remap": ["from", "to"],
    "timer": ["period"],
}

_SUBSTITUTIONS: dict[str, tuple[str, tuple[str, ...]]] = {
    "var": ("LaunchConfiguration", ("variable_name", "default")),
    "env": ("EnvironmentVariable", ("name", "default_value")),
    "optenv": ("EnvironmentVariable", ("name", "default_value")),
    "find-pkg-share": ("FindPackageShare", ("package",)),
    "find-pkg-prefix": ("FindPackagePrefix", ("package",)),
    "exec-in-pkg": ("ExecutableInPackage", ("executable", "package")),
    "eval": ("PythonExpression", ("expression",)),
    "command": ("Command", ("command", "on_stderr")),
    "dirname": ("ThisLaunchFileDir", ()),
    "filename": ("ThisLaunchFile", ()),
    "anon": ("AnonName", ("name",)),
    "not": ("NotSubstitution", ("value",)),
    "and": ("AndSubstitution", ("left", "right")),
    "or": ("OrSubstitution", ("left", "right")),
    "any": ("AnySubstitution", ()),
    "all": ("AllSubstitution", ()),
    "equals": ("EqualsSubstitution", ("left", "right")),
    "not-equals": ("NotEqualsSubstitution", ("left", "right")),
    "if": ("IfElseSubstitution", ("condition", "if_value", "else_value")),
    "file-content": ("FileContent", ("path",)),
    "find-exec": ("FindExecutable", ("name",)),
    "param": ("ParameterSubstitution", ("name",)),
    "path-join": ("PathJoinSubstitution", ()),
}


def _shell_words(text: str) -> list[str]:
    try:
        return shlex.split(text)
    except ValueError:
        return text.split()


def _closing(text: str, at: int) -> int:
    """Where the parenthesis opened before ``at`` closes; -1 if it does not."""
    depth = 1
    for index in range(at, len(text)):
        if text.startswith("$(", index) or (text[index] == "(" and (index == 0 or text[index - 1] != "$")):
            depth += 1
        elif text[index] == ")":
            depth -= 1
            if depth == 0:
                return index
    return -1


def _words(text: str) -> Iterator[str]:
    """Words of a substitution: split at spaces outside of quotes and of inner substitutions."""
    word, depth, quote = "", 0, ""
    for character in text:
        if quote:
            quote = "" if character == quote else quote
        elif character in "\"'" and depth == 0:
            quote = character
        elif character == "(":
            depth += 1
        elif character == ")":
            depth -= 1
        if character.isspace() and not quote and depth == 0:
            if word:
                yield word
            word = ""
        else:
            word += character
    if word:
        yield word


def _unquoted(word: str) -> str:
    if len(word) > 1 and word[0] == word[-1] and word[0] in "\"'":
        inner = word[1:-1]
        if word[0] not in inner.replace("\\" + word[0], ""):
            return inner.replace("\\" + word[0], word[0])
    return word
