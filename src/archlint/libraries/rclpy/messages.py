"""Messages in the symbolic run: what their fields are, and which of them the code uses.

Only what is certain is noted: plain attribute names on a value whose type is known, where no ``except`` may be
there for an attribute that is missing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import EachValue, Known, OneOf, Unknown, Value
from archlint.libraries.values import MessageValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run


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


def nested(run: Run, value: MessageValue, name: str) -> MessageValue | EachValue | None:
    """The message, or array of messages, that a field holds, one and the same at each read; None for others."""
    if run.interfaces is None or not value.key:
        return None
    content = run.messages.fields.get((value.key, name))
    if content is None:
        kind = run.interfaces.field_type(value.type, value.section_name, name)
        if kind is None or kind.is_primitive or run.interfaces.get(kind.name) is None:
            return None
        inner = MessageValue(kind.name, "", run.store.new_key())
        run.messages.inside[inner.key] = value.key
        if value.key in run.messages.made_in:
            run.messages.made_in[inner.key] = run.messages.made_in[value.key]
        if value.key in run.messages.delivered:
            run.messages.delivered[inner.key] = run.messages.delivered[value.key]
        content = run.messages.fields[(value.key, name)] = EachValue(inner) if kind.array else inner
    return content


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
