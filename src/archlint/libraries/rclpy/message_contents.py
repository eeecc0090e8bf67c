"""What the code has set in a message by the time that it sends it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

from archlint.interpreter.values import Known, OneOf, Unknown, Value
from archlint.libraries.rclpy import messages
from archlint.libraries.values import MessageValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.model.given import Content
    from archlint.syntax.interfaces import FieldType

_FLOATS = frozenset({"float", "double", "float32", "float64"})
_Held = Literal["constant", "measure", "other"]


def content_of(run: Run, message: MessageValue) -> Content | None:
    """Constants and nothing else, or a measure among the rest; None where neither is certain."""
    held = set(_held(run, message))
    if "measure" in held:
        return "measures"
    return "constants" if held <= {"constant"} else None


def both(first: Content | None, other: Content | None) -> Content | None:
    """What a call sends that was met twice: in another round of a loop, or with what others have left meanwhile."""
    if "measures" in (first, other):
        return "measures"
    return first if first == other else None


def _held(run: Run, message: MessageValue) -> Iterator[_Held]:
    """What each field holds that the code has set, also in the messages inside."""
    section = None if run.interfaces is None else run.interfaces.section(message.type, message.section_name)
    if section is None or not message.key:
        yield "other"
        return
    for field in section.fields:
        value = messages.known_content(run, message, field.name)
        if isinstance(value, MessageValue):
            yield from _held(run, value)
        elif value is not None and run.store.get(message.key, field.name) is not None:
            yield _kind_of(value, field.type)


def _kind_of(value: Value, kind: FieldType) -> _Held:
    if isinstance(value, Known):
        return "constant"
    is_open = isinstance(value, Unknown) or (isinstance(value, OneOf) and all(map(_is_number, value.values)))
    return "measure" if is_open and kind.name in _FLOATS and not kind.array and not value.via else "other"


def _is_number(value: Value) -> bool:
    return isinstance(value, Unknown) or value.number_class is not None


__all__ = ["both", "content_of"]
