"""Which interfaces the type argument of a create call stands for."""

from __future__ import annotations

from archlint.interpreter.values import NONE, ClassValue, External, Known, Unknown, Value, alternatives, reason
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import names
from archlint.libraries.tables import Api


def may_be_type(api: Api, value: Value | None) -> bool:
    """Whether a call takes a value for a type: a class, or a text where the row says so."""
    match value:
        case Known(value=str(text)) if api.type_as_text:
            return names.is_interface(text)
        case Known():
            return False
    return True


def type_of_value(value: Value | None) -> tuple[str | None, str | None]:
    """The ROS type that a class stands for, or why it is not known."""
    if value is None:
        return None, "no type is given"
    match value:
        case External(path=path):
            interface, section = names.interface_and_section(names.canonical(path))
            known = interface is not None and not section
            return (interface, None) if known else (None, f"'{path}' is not an interface")
        case ClassValue(qualified=name):
            return None, f"'{name}' is a class of the workspace, not an interface"
        case Unknown(interface=str(missing)):
            return missing, None
        case Unknown(reason=why):
            return None, why
        case Known(value=constant) if constant is not None:
            return None, f"{constant!r} is not an interface class"
    return None, "the type is not an interface class"


def type_of_text(value: Value | None) -> tuple[str | None, str | None]:
    """The ROS type that a text names, or why it is not known."""
    match value:
        case Known(value=str(text)) if names.is_interface(text):
            return text, None
        case Known(value=constant):
            return None, f"{constant!r} is not the name of an interface"
        case None:
            return None, "no type is given"
    return None, reason(value)


def types_of(call: ApiUse) -> list[tuple[str | None, str | None]]:
    api = call.api
    if api.fixed_type is not None:
        return [(api.fixed_type, None)]
    value = call.get(api.type)
    if value is None and call.open:
        return [(None, "passed by * or **")]
    options = [option for option in alternatives(value) if option != NONE] if value is not None else []
    type_of = type_of_text if api.type_as_text else type_of_value
    types = [type_of(option) for option in options or (value,)]
    known = [row for row in types if row[0] is not None]
    # What is not known is one more type: nothing that holds for the known ones is certain then.
    return known + [row for row in types if row[0] is None][:1]


__all__ = ["may_be_type", "type_of_text", "type_of_value", "types_of"]
