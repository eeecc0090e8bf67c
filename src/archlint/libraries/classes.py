"""Which foreign classes values are of."""

from __future__ import annotations

from archlint.interpreter.values import ClassValue, External, ForeignValue, Value
from archlint.libraries.rclpy.names import interface_and_section
from archlint.libraries.values import MessageValue


def class_of(value: ForeignValue) -> Value | None:
    """``type(value)``: of a message the class of its interface."""
    match value:
        case MessageValue(type=interface, section_name=""):
            return External(interface.replace("/", "."))
    return None


def is_instance(value: ForeignValue, cls: Value, python: type | None) -> bool | None:
    """Whether a message is of a class; None where that is not known, and of all other values."""
    if not isinstance(value, MessageValue):
        return None
    if isinstance(cls, ClassValue) or (python is not None and python.__module__ == "builtins"):
        return False
    interface, section_name = interface_and_section(cls.dotted)
    return None if interface is None else (interface, section_name) == (value.type, value.section_name)


def is_ordinary(path: str) -> bool:
    """Whether a class of another package is one that no constant or collection is ever an object of."""
    if path.startswith("rclpy."):
        return not path.rpartition(".")[2].startswith(("Some", "Allowable"))  # aliases for several types
    return interface_and_section(path)[0] is not None


__all__ = ["class_of", "is_instance", "is_ordinary"]
