"""Parameters that a node declares."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    TRUE,
    DictValue,
    Items,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    join_texts,
    one_of,
)
from archlint.libraries.rclpy import nodes
from archlint.libraries.rclpy.descriptors import description_of
from archlint.libraries.rclpy.fields import OVERRIDES, PARAMETERS
from archlint.libraries.rclpy.parameter_values import (
    from_parameter,
    is_type,
    new_parameter,
    to_python,
    type_name,
    value_from_python,
)
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import MessageValue

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.ros.parameter_types import ParameterType


def _of_nothing(run: Run, default: Value | None) -> ParameterType | None:
    """What rclpy makes of an empty list: all of its items, none, are bytes (seen on jazzy).  In C++ lists have one."""
    match default:
        case ListValue() if run.activation.module.file.kind != "cpp":
            items = default.items(run)
            return None if items.open or items.values else "byte_array"
    return None


def declare_one(
    run: Run,
    call: ApiUse,
    name: Value,
    default: Value | None,
    ignore_override: bool = False,
    span_place: Place | None = None,
    descriptor: Value | None = None,
    description: model.ParameterDescription | None = None,
    of_type: ParameterType | None = None,
) -> Value:
    """Declare a parameter on the node of a call; returns the Parameter object.  ``of_type`` says more than a default
    can, such as what an empty list holds."""
    place = span_place or (run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1))
    parameters = []
    known = nodes.known_node(run, call.receiver)
    for option in alternatives(name):
        text = text_of_value(option, "no name is given")
        dynamic = _is_dynamic(run, descriptor)
        kind = None if dynamic else of_type or type_name(run, default) or _of_nothing(run, default)
        typed = is_type(default)
        has_default = default is not None and not typed and default != NONE
        from_outside = () if text.text is None or ignore_override else run.overrides.value(known, text.text)
        override = run.store.get(nodes.node_key(run, call.receiver), OVERRIDES[text.text or ""])
        given = override if override is not None and not ignore_override else None
        said = description or description_of(run, descriptor)
        value_there = default if has_default else None
        for blueprint in nodes.nodes_of(run, call.receiver):
            _note_declaration(run, blueprint, text, kind, value_there, place, ignore_override, dynamic, given, said)
        value: Value
        if override is not None and text.text is not None and not ignore_override:
            value = from_parameter(run, override, text.text)
        elif text.text is None or text.resolution not in ("exact", "parameter"):
            value = Unknown("the parameter's name is not known")
        elif from_outside:
            value = value_from_python(run, from_outside[0], run.overrides.look_at_value(known, text.text))
            if value.is_text and not dynamic and _is_of_lists(default, kind):
                value = Unknown("it is set to a text, and declared as a list: the node stops there")
            value = from_parameter(run, value, text.text)
        elif has_default:
            assert default is not None
            value = from_parameter(run, default, text.text)
        else:
            value = Unknown(f"the parameter '{text.text}' has no default", text.text)
        if text.text is not None:
            run.store.set(nodes.node_key(run, call.receiver), PARAMETERS[text.text], value)
        parameters.append(new_parameter(run, option, value))
    return one_of(parameters)


def _is_of_lists(default: Value | None, kind: ParameterType | None) -> bool:
    return isinstance(default, ListValue) or (kind or "").endswith("_array")


def _is_dynamic(run: Run, descriptor: Value | None) -> bool:
    """``ParameterDescriptor(dynamic_typing=True)``: any type will do."""
    return isinstance(descriptor, MessageValue) and run.store.get(descriptor.key, "dynamic_typing") == TRUE


def _note_declaration(
    run: Run,
    blueprint: model.Blueprint,
    name: model.Text,
    kind: ParameterType | None,
    default: Value | None,
    place: Place,
    ignore_override: bool,
    dynamic: bool,
    given: Value | None,
    description: model.ParameterDescription | None,
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
            without_default=default is None,
            description=description,
        )
    )


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
    given = call.get("parameters") or Unknown("no parameters")
    rows = _pairs_of_map(run, given) or given.items(run)
    parameters: list[Value] = []
    if rows is None:
        return Unknown("the parameters that are declared are not known")
    for row in rows.values:
        parts = row.items(run)
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
        parameters.append(declare_one(run, call, name, default, ignore, place, descriptor))
    return containers.new_list(run, parameters, "list", rows.open)


def _pairs_of_map(run: Run, given: Value) -> Items | None:
    """The entries of a ``std::map``, each a name with its default: going through one of C++ gives pairs."""
    if not isinstance(given, DictValue) or run.activation.module.file.kind != "cpp":
        return None
    entries = given.entries(run)
    pairs = [containers.new_list(run, [name, default], "tuple") for name, default in entries.entries.values()]
    return Items(tuple(pairs), entries.open)


def _entry_place(run: Run, call: ApiUse, name: Value) -> Place | None:
    """Where the call spells the name of one of the parameters that it declares; None where something else does."""
    origin = name.origin if isinstance(name, Known) else None
    if origin is None or call.expression is None:
        return None
    call_place = run.place(call.expression.span)
    starts = (call_place.line, call_place.column) <= (origin.line, origin.column)
    ends = (origin.end_line, origin.end_column) <= (call_place.end_line, call_place.end_column)
    return origin if origin.file == call_place.file and starts and ends else None
