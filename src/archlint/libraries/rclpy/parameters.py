"""ROS parameters: declared with a default, overridden from outside, read in every spelling."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.values import (
    FALSE,
    NONE,
    TRUE,
    DictValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    join_texts,
    one_of,
)
from archlint.libraries.rclpy import nodes, profiles
from archlint.libraries.rclpy.fields import OVERRIDES, PARAMETERS
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import MessageValue
from archlint.syntax.parameter_files import NotKnown

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

_PARAMETER = External("rclpy.parameter.Parameter")

BY_NAME = frozenset(f"rclpy.node.Node.{name}" for name in ("get_parameter", "get_parameter_or", "has_parameter"))
"""Calls that name one parameter."""

_TYPES: dict[type, str] = {bool: "bool", int: "integer", float: "double", str: "string"}
_TYPE_NAMES = {
    "BOOL": "bool",
    "INTEGER": "integer",
    "DOUBLE": "double",
    "STRING": "string",
    "BYTE_ARRAY": "byte_array",
    "BOOL_ARRAY": "bool_array",
    "INTEGER_ARRAY": "integer_array",
    "DOUBLE_ARRAY": "double_array",
    "STRING_ARRAY": "string_array",
}


def new_parameter(run: Run, name: Value, value: Value) -> Instance:
    made = Instance(_PARAMETER, run.store.new_key())
    run.store.set(made.key, "name", name)
    run.store.set(made.key, "value", value)
    return made


def make_parameter(run: Run, call: ApiUse) -> Value:
    """``Parameter('name', Parameter.Type.STRING, 'value')``."""
    return new_parameter(run, call.get("name") or Unknown("no name"), call.get("value") or NONE)


def type_name(run: Run, value: Value | None) -> str | None:
    """The ROS type of a default, or of a ``Parameter.Type``."""
    match value:
        case Known(value=constant):
            return _TYPES.get(type(constant))
        case External(path=path) if profiles.policy_number(path) is not None:
            return "integer"
        case External(path=path) if ".Type." in path:
            return _TYPE_NAMES.get(path.rpartition(".")[2])
        case ListValue():
            items = containers.items_of(run, value)
            kinds = {type_name(run, item) for item in items.values}
            kind = kinds.pop() if len(kinds) == 1 and not items.open else None
            return None if kind is None else f"{kind}_array"
    return None


def _is_type(value: Value | None) -> bool:
    return value is not None and (".Type." in value.dotted or ".ParameterType." in value.dotted)


def from_parameter(run: Run, value: Value, name: str) -> Value:
    """A default as the value of a parameter: known, but by way of the parameter."""
    match value:
        case External(path=path) if (number := profiles.policy_number(path)) is not None:
            return Known(number, frozenset({name}))
        case Known():
            return Known(value.value, value.via | {name}, value.origin, value.kind)
        case Holed():
            return Holed(value.parts, value.reason, value.via | {name}, value.origin)
        case ListValue():
            items = containers.items_of(run, value)
            # An empty default waits for somebody to fill it, unless a launch file is seen to leave it so.
            open_ = items.open or not (items.values or name in run.overrides.settled)
            filled = [from_parameter(run, item, name) for item in items.values]
            return containers.new_list(run, filled, value.kind, open_)
        case Unknown(reason=why):
            return Unknown(f"the parameter '{name}' has a default that is not known: {why}", name)
        case OneOf(values=options):
            return one_of(from_parameter(run, option, name) for option in options)
    return Unknown(f"the parameter '{name}' decides it", name)


def value_from_python(run: Run, value: object) -> Value:
    """A value of a parameter file or launch file."""
    why = "not known here"
    match value:
        case list() | tuple():
            return containers.new_list(run, [value_from_python(run, item) for item in value])
        case str() | int() | float():
            return Known(value)
        case NotKnown(reason=why):
            pass
    return Unknown(f"it is set to an unknown value: {why}")


def declare_one(
    run: Run,
    call: ApiUse,
    name: Value,
    default: Value | None,
    ignore_override: bool = False,
    span_place: Place | None = None,
    descriptor: Value | None = None,
) -> Value:
    """Declare a parameter on the node of a call; returns the Parameter object."""
    place = span_place or (run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1))
    found = []
    overrides = run.overrides.of(nodes.known_node(run, call.receiver))
    for option in alternatives(name):
        text = text_of_value(option, "no name is given")
        dynamic = _is_dynamic(run, descriptor)
        kind = None if dynamic else type_name(run, default)
        typed = _is_type(default)
        has_default = default is not None and not typed and default != NONE
        override = run.store.get(nodes.node_key(run, call.receiver), OVERRIDES[text.text or ""])
        given = override if override is not None and not ignore_override else None
        for blueprint in nodes.nodes_of(run, call.receiver):
            _note(run, blueprint, text, kind, default if has_default else None, place, ignore_override, dynamic, given)
        value: Value
        if override is not None and text.text is not None and not ignore_override:
            value = from_parameter(run, override, text.text)
        elif text.text is None or text.resolution not in ("exact", "parameter"):
            value = Unknown("the parameter's name is not known")
        elif text.text in overrides and not ignore_override:
            value = from_parameter(run, value_from_python(run, overrides[text.text]), text.text)
        elif has_default:
            assert default is not None
            value = from_parameter(run, default, text.text)
        else:
            value = Unknown(f"the parameter '{text.text}' has no default", text.text)
        if text.text is not None:
            run.store.set(nodes.node_key(run, call.receiver), PARAMETERS[text.text], value)
        found.append(new_parameter(run, option, value))
    return one_of(found)


def _is_dynamic(run: Run, descriptor: Value | None) -> bool:
    """``ParameterDescriptor(dynamic_typing=True)``: any type will do."""
    return isinstance(descriptor, MessageValue) and run.store.get(descriptor.key, "dynamic_typing") == TRUE


def _note(
    run: Run,
    blueprint: model.Blueprint,
    name: model.Text,
    kind: str | None,
    default: Value | None,
    place: Place,
    ignore_override: bool,
    dynamic: bool,
    given: Value | None,
) -> None:
    for known in blueprint.parameters:
        if known.place == place and known.name.text == name.text:
            known.conditional = known.conditional and bool(run.branch_arms)
            return
    python, is_known = to_python(run, default)
    in_code, in_code_known = to_python(run, given)
    blueprint.parameters.append(
        model.ParameterDeclaration(
            name,
            kind,
            python,
            is_known,
            place,
            blueprint,
            bool(run.branch_arms),
            ignore_override,
            dynamic,
            chain=run.chain(),
            given=(in_code,) if given is not None and in_code_known else (),
            uncalled=run.context.role == model.Role.METHOD,
        )
    )


def to_python(run: Run, value: Value | None) -> tuple[object, bool]:
    """The Python value of a constant, and whether it is known."""
    match value:
        case Known(value=constant):
            return constant, True
        case ListValue():
            items = containers.items_of(run, value)
            rows = [to_python(run, item) for item in items.values]
            if not items.open and all(known for _, known in rows):
                return [item for item, _ in rows], True
    return None, False


def declare_parameter(run: Run, call: ApiUse) -> Value:
    return declare_one(
        run,
        call,
        call.get("name") or Unknown("no name is given"),
        call.get("value"),
        call.get("ignore_override") == TRUE,
        descriptor=call.get("descriptor"),
    )


def declare_parameters(run: Run, call: ApiUse) -> Value:
    namespace = call.get("namespace")
    rows = containers.iterate(run, call.get("parameters") or Unknown("no parameters"))
    made: list[Value] = []
    if rows is None:
        return Unknown("the parameters that are declared are not known")
    for row in rows.values:
        parts = containers.iterate(run, row)
        if parts is None or not parts.values:
            continue
        name = parts.values[0]
        place = _entry_place(run, call, name)
        if namespace is not None and namespace.constant:
            name = one_of(join_texts((namespace, Known("."), option)) for option in alternatives(name))
        elif namespace is not None and not isinstance(namespace, Known):
            name = Unknown("the namespace of the parameters is not known")
        default, descriptor = [*parts.values[1:3], None, None][:2]
        ignore = call.get("ignore_override") == TRUE
        made.append(declare_one(run, call, name, default, ignore, place, descriptor))
    return containers.new_list(run, made, "list", rows.open)


def _entry_place(run: Run, call: ApiUse, name: Value) -> Place | None:
    """Where the call spells the name of one of the parameters that it declares; None where something else does."""
    origin = name.origin if isinstance(name, Known) else None
    if origin is None or call.expression is None:
        return None
    whole = run.place(call.expression.span)
    starts = (whole.line, whole.column) <= (origin.line, origin.column)
    ends = (origin.end_line, origin.end_column) <= (whole.end_line, whole.end_column)
    return origin if origin.file == whole.file and starts and ends else None


def read(run: Run, call: ApiUse, name: Value) -> Value:
    """The value of a parameter by name."""
    return one_of(_read_option(run, call, option.text) for option in alternatives(name))


def _read_option(run: Run, call: ApiUse, name: str | None) -> Value:
    if name is None:
        return Unknown("the parameter's name is not known")
    undeclared = Unknown(f"the parameter '{name}' is not declared in the code that was followed", name)
    return _value_in_reach(run, call, name) or undeclared


def _value_in_reach(run: Run, call: ApiUse, name: str) -> Value | None:
    """The value of a parameter that is declared, or set from outside; None of others."""
    value = run.store.get(nodes.node_key(run, call.receiver), PARAMETERS[name])
    if value is not None:
        return value
    overrides = run.overrides.of(nodes.known_node(run, call.receiver))
    if name in overrides:
        return from_parameter(run, value_from_python(run, overrides[name]), name)
    return Known(False, frozenset({name})) if name == "use_sim_time" else None


def get_parameter(run: Run, call: ApiUse) -> Value:
    name = call.get("name") or Unknown("no name is given")
    return new_parameter(run, name, read(run, call, name))


def get_parameters(run: Run, call: ApiUse) -> Value:
    names = containers.iterate(run, call.get("names") or Unknown("no names"))
    if names is None:
        return Unknown("the parameters that are read are not known")
    made: list[Value] = [new_parameter(run, name, read(run, call, name)) for name in names.values]
    return containers.new_list(run, made, "list", names.open)


def get_parameter_or(run: Run, call: ApiUse) -> Value:
    name = call.get("name") or Unknown("no name is given")
    value = read(run, call, name)
    alternative = call.get("alternative_value")
    text = name.text
    if text is not None and isinstance(alternative, Instance) and _value_in_reach(run, call, text) is None:
        held = run.store.get(alternative.key, "value")
        if held is not None:
            value = from_parameter(run, held, text)
    return new_parameter(run, name, value)


def get_parameters_by_prefix(run: Run, call: ApiUse) -> Value:
    prefix = call.get("prefix")
    node = nodes.known_node(run, call.receiver)
    if not isinstance(prefix, Known) or node is None:
        return Unknown("the parameters that are read are not known")
    start = f"{prefix.value!s}." if prefix.value else ""
    entries: dict[Hashable, tuple[Value, Value]] = {}
    for declared in node.parameters:
        text = declared.name.text
        if text is not None and text.startswith(start):
            key = Known(text[len(start) :])
            at = containers.hashable(key)
            if at is not None:
                entries[at] = (key, new_parameter(run, Known(text), read(run, call, Known(text))))
    made: DictValue = containers.new_dict(run, entries, True)
    return made


def has_parameter(run: Run, call: ApiUse) -> Value:
    name = call.get("name")
    if isinstance(name, Known):
        value = run.store.get(nodes.node_key(run, call.receiver), PARAMETERS[str(name.value)])
        if value is not None:
            return TRUE
        if run.context.role == model.Role.INIT and not run.branch_arms and run.overrides == model.Overrides():
            return FALSE
    return Unknown("whether the parameter is declared")


def set_parameters(run: Run, call: ApiUse) -> Value:
    rows = containers.iterate(run, call.get("parameter_list") or Unknown("no parameters"))
    key = nodes.node_key(run, call.receiver)
    for row in rows.values if rows is not None else ():
        if isinstance(row, Instance):
            name, value = run.store.get(row.key, "name"), run.store.get(row.key, "value")
            if isinstance(name, Known) and value is not None:
                run.store.set(key, PARAMETERS[str(name.value)], from_parameter(run, value, str(name.value)))
    return Unknown("the result of setting parameters")
