"""``<param>`` and ``param:``: one parameter, a dict of them, or a file."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import External, Known, Unknown, UnknownKey, Value
from archlint.launch.objects import LaunchObject, known_text
from archlint.launch.parameters import TYPES, from_yaml, of_type
from archlint.launch.tables import LaunchClass
from archlint.syntax.launch_elements import Element
from archlint.syntax.parameter_files import NotKnown, ParameterData

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.frontends.objects import Frontend


def read_parameter(frontend: Frontend, element: Element) -> Value | None:
    place = frontend.place(element.span)
    if "from" in element.attributes:
        given = {"param_file": frontend.text(element.attributes["from"])}
        if (element.text("allow_substs") or "").lower() == "true":
            given["allow_substs"] = Known(True)
        return frontend.make(LaunchClass.PARAMETER_FILE, frontend.place(element.attributes["from"].span), given)
    nested = element.of("param")
    name = frontend.get(element, "name") or Known("")
    if nested:
        return _nested(frontend, element, name)
    written = known_text(name)
    key = name if written is None else Known(written, origin=place)
    return containers.new_dict(frontend.run, {UnknownKey(0): (key, _value(frontend, element))})


def _nested(frontend: Frontend, element: Element, name: Value) -> Value | None:
    """A parameter with parameters in it: a dict."""
    entries: dict[Hashable, tuple[Value, Value]] = {}
    for number, child in enumerate(element.of("param")):
        key = frontend.get(child, "name") or Known("")
        written = known_text(key)
        if written is not None:
            key = Known(written, origin=frontend.place(child.span))
        inner = _nested(frontend, child, Known("")) if child.of("param") else _value(frontend, child)
        entries[UnknownKey(number)] = (key, inner or Unknown("a parameter without a value"))
    value = containers.new_dict(frontend.run, entries)
    if isinstance(name, Known) and not name.value:
        return value
    return containers.new_dict(frontend.run, {UnknownKey(0): (name, value)})


def set_parameter(frontend: Frontend, element: Element) -> LaunchObject:
    """``<set_parameter>``: its value is read as that of ``<param>`` is."""
    given, places = frontend.arguments(element, {"name": "name"})
    given["value"] = _value(frontend, element)
    return frontend.make(LaunchClass.SET_PARAMETER, frontend.place(element.span), given, places)


def _value(frontend: Frontend, element: Element) -> Value:
    """The value of a parameter: in XML text that is read as YAML, in YAML what it is."""
    attribute = element.attributes.get("value")
    if attribute is None:
        return Unknown("a parameter without a value")
    match attribute.value:
        case str(text):
            return _value_of_text(frontend, element, text, frontend.place(attribute.span))
    return frontend.text(attribute)


def _value_of_text(frontend: Frontend, element: Element, text: str, place: Place) -> Value:
    kind = element.text("type")
    separator = element.text("value-sep")
    if separator:
        return frontend.list([_scalar(frontend, part.strip(), kind) for part in text.split(separator)])
    quoted_number = frontend.file.endswith((".yaml", ".yml")) and from_yaml(text) != text
    if quoted_number and kind is None:
        return Unknown("a string that looks like a number, which ROS releases read differently")
    if "$(" not in text:
        return _scalar(frontend, text, kind)
    given = {"value": frontend.parse(text, place)}
    if kind is not None:
        given["value_type"] = External(f"builtins.{kind}")
    return frontend.make(LaunchClass.PARAMETER_VALUE, place, given)


def _scalar(frontend: Frontend, text: str, kind: str | None) -> Value:
    if kind == "str":
        return Known(text)
    value = from_yaml(text)
    match of_type(value, kind) if kind in TYPES else value:
        case NotKnown():
            return Unknown(
                f"a value that is not of type {kind}" if kind in TYPES else "a value that a parameter cannot have"
            )
        case list(items):
            return frontend.list([_item(item) for item in items])
        case None | str() | int() | float() as constant:
            return Known(constant)
    raise AssertionError(value)


def _item(item: ParameterData) -> Value:
    match item:
        case None | str() | int() | float():
            return Known(item)
    return Unknown("nested")
