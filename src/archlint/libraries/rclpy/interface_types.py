"""Which interfaces the type argument of a create call stands for."""

from __future__ import annotations

from archlint.interpreter.values import NONE, ClassValue, External, Unknown, Value, alternatives
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import names


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
    return None, "the type is not an interface class"


def types_of(call: ApiUse) -> list[tuple[str | None, str | None]]:
    api = call.api
    if api.fixed_type is not None:
        return [(api.fixed_type, None)]
    value = call.get(api.type)
    if value is None and call.open:
        return [(None, "passed by * or **")]
    options = [option for option in alternatives(value) if option != NONE] if value is not None else []
    types = [type_of_value(option) for option in options or (value,)]
    known = [row for row in types if row[0] is not None]
    # What is not known is one more type: nothing that holds for the known ones is certain then.
    return known + [row for row in types if row[0] is None][:1]


__all__ = ["type_of_value", "types_of"]
