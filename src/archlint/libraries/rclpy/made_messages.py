"""Messages that code makes."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

from archlint.interpreter.values import Value
from archlint.libraries.rclpy.field_values import note_positional, note_value
from archlint.libraries.rclpy.message_uses import note_use
from archlint.libraries.values import MessageValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.ros.interfaces import MessageClass


_NOTHING: Mapping[str, Value] = MappingProxyType({})


_CHECKS = "check_fields"
"""Whether the setters check what they are given: no field, but the constructors that Jazzy generates take it.  Source:
rosidl_generator_py, ``_msg.py.em``."""


def note_made(
    run: Run, message: MessageValue, expression: facts.Call | None, keywords: Mapping[str, Value] = _NOTHING
) -> None:
    """Note that the code makes a message here, the fields that the constructor call names, and what it gives them."""
    if run.activations:
        run.messages.made_in[message.key] = run.activation
    for argument in expression.args if expression is not None else ():
        span = getattr(argument.value, "span", None)
        if argument.keyword == _CHECKS:
            continue
        if argument.keyword is not None and not argument.star and span is not None:
            note_use(run, message, argument.keyword, span, "keyword")
            if argument.keyword in keywords:
                note_value(run, message, argument.keyword, span, keywords[argument.keyword], argument=True)
        elif not argument.star and argument.keyword is None and span is not None:
            note_positional(run, message, span)


def make(
    run: Run, interface: str, section_name: MessageClass, keywords: dict[str, Value], expression: facts.Call | None
) -> Value:
    """An object of an interface class, as its constructor is called."""
    message = MessageValue(interface, section_name, run.store.new_key())
    note_made(run, message, expression, keywords)
    for name, value in keywords.items():
        run.store.set(message.key, name, value)
    return message
