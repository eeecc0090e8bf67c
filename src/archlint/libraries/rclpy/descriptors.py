"""``ParameterDescriptor``: what the code says of a parameter beside its name and default."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import TRUE, Known, Value
from archlint.libraries.values import MessageValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_RANGES = ("floating_point_range", "integer_range")
"""Fields that hold a range or nothing; a parameter has one type, and so at most one of them."""


def description_of(run: Run, descriptor: Value | None) -> model.ParameterDescription | None:
    """What is known of a descriptor; None where there is none, or where it may be one of several."""
    if not isinstance(descriptor, MessageValue):
        return None
    lowest = highest = step = None
    for name in _RANGES:
        if (limits := _range(run, descriptor, name)) is not None:
            lowest, highest = _number(run, limits, "from_value"), _number(run, limits, "to_value")
            step = _number(run, limits, "step") or None  # 0 stands for any step
    return model.ParameterDescription(
        _text(run, descriptor, "description"),
        _text(run, descriptor, "additional_constraints"),
        run.store.get(descriptor.key, "read_only") == TRUE,
        lowest,
        highest,
        step,
    )


def _range(run: Run, descriptor: MessageValue, name: str) -> MessageValue | None:
    value = run.store.get(descriptor.key, name)
    items = None if value is None else value.items(run)
    if items is None or items.open or len(items.values) != 1:
        return None
    [limits] = items.values
    return limits if isinstance(limits, MessageValue) else None


def _text(run: Run, message: MessageValue, name: str) -> str:
    match run.store.get(message.key, name):
        case Known(value=str(text)):
            return text
    return ""


def _number(run: Run, message: MessageValue, name: str) -> float | None:
    match run.store.get(message.key, name):
        case Known(value=bool()):
            return None
        case Known(value=int() | float() as number):
            return number
    return None


__all__ = ["description_of"]
