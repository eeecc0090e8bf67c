"""Messages in the symbolic run: what their fields are, and which of them the code uses.

Only what is certain is noted: plain attribute names on a value whose type is known, where no ``except`` may be
there for an attribute that is missing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import EachValue, Known, OneOf, Unknown, Value
from archlint.libraries.values import MessageValue
from archlint.syntax.interface_values import INTEGER_RANGES

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.syntax.interfaces import FieldType

_CLASSES: Mapping[str, str] = {
    "bool": "bool",
    "float32": "float",
    "float64": "float",
    "string": "str",
    "wstring": "str",
    **dict.fromkeys(INTEGER_RANGES.keys() - {"byte", "char"}, "int"),
}
"""The classes of Python that primitive fields are of."""


def of_value(value: Value) -> MessageValue | None:
    """The message that a value certainly is when an attribute of it can be read: None is no other choice, for
    it has no attributes."""
    match value:
        case MessageValue():
            return value
        case OneOf(values=options):
            match [option for option in options if not option.is_none]:
                case [MessageValue() as message]:
                    return message
    return None


def known_content(run: Run, value: MessageValue, name: str) -> Value | None:
    """What a field of a message holds that the code has set, or else read; None for one that it has not."""
    return run.store.get(value.key, name) or run.messages.fields.get((value.key, name)) if value.key else None


def content(run: Run, value: MessageValue, name: str) -> Value:
    """What a field of a message holds that the code has not set, one and the same at each read."""
    known = run.messages.fields.get((value.key, name)) if value.key else None
    if known is not None:
        return known
    kind = None if run.interfaces is None else run.interfaces.field_type(value.type, value.section_name, name)
    inner = None if kind is None else _nested(run, value, kind)
    held = inner or _plain(kind, f"the field '{name}' of a message")
    if value.key:
        run.messages.fields[(value.key, name)] = held
    return held


def _nested(run: Run, value: MessageValue, kind: FieldType) -> MessageValue | EachValue | None:
    """The message, or the array of messages, in a field of this type."""
    if not value.key or kind.is_primitive or run.interfaces is None or run.interfaces.get(kind.name) is None:
        return None
    inner = MessageValue(kind.name, "", run.store.new_key())
    run.messages.inside[inner.key] = value.key
    if value.key in run.messages.made_in:
        run.messages.made_in[inner.key] = run.messages.made_in[value.key]
    if value.key in run.messages.delivered:
        run.messages.delivered[inner.key] = run.messages.delivered[value.key]
    return EachValue(inner) if kind.array else inner


def _plain(kind: FieldType | None, why: str) -> Value:
    """What is known of a field without a message in it: an array of numbers has items of their class, unless it is of
    fixed size; then it is numpy's."""
    cls = None if kind is None else _CLASSES.get(kind.name)
    if kind is None or not kind.array:
        return Unknown(why, never_none=True, of_class=cls)
    if kind.array == "fixed" or cls not in ("int", "float"):
        return Unknown(why, never_none=True)
    return EachValue(Unknown(why, never_none=True, of_class=cls))


def deliver(run: Run, arguments: Sequence[Value], creation: model.Creation) -> None:
    """Note which subscription, server or client calls a callback with these messages."""
    for value in arguments:
        if isinstance(value, MessageValue):
            run.messages.delivered[value.key] = creation


def has_field(run: Run, message: MessageValue, name: str) -> Value | None:
    """``hasattr(message, name)``; None where the definitions of messages are not known."""
    if run.interfaces is None:
        return None
    known = run.interfaces.has(message.type, message.section_name, name)
    return Unknown("hasattr() of a message that is not known") if known is None else Known(known)
