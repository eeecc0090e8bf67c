"""What the fields of messages are given, where they do not take it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.libraries.rclpy.message_uses import is_certain, may_be_of_another_type
from archlint.libraries.rclpy.messages import of_value
from archlint.libraries.rclpy.wrong_values import Misfit, misfit, misfit_of_argument
from archlint.model import ValueEffect, WrongValue

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.values import Value
    from archlint.libraries.run import Run
    from archlint.libraries.values import MessageValue
    from archlint.syntax.facts import Span

_BY_POSITION = Misfit("its fields by name", "an argument without a name", ValueEffect.SET, "write the field's name")


def note_value(run: Run, value: Value, name: str, span: Span, content: Value, *, argument: bool = False) -> None:
    """Note that the code gives a field something that it never takes, by assignment or as an argument of the
    constructor."""
    message = of_value(value)
    if message is None or run.interfaces is None or not _is_certain(run):
        return
    kind = run.interfaces.field_type(message.type, message.section_name, name)
    if kind is None:
        return
    judge = misfit_of_argument if argument else misfit
    wrong = None if may_be_of_another_type(run, message) else judge(run, kind, content)
    _keep(run, message, name, span, wrong)


def note_positional(run: Run, message: MessageValue, span: Span) -> None:
    """Note that the code makes a message with an argument by position: its constructor takes keywords alone."""
    if _is_certain(run):
        _keep(run, message, "", span, _BY_POSITION)


def _is_certain(run: Run) -> bool:
    """Whether an exception would be noticed."""
    return is_certain(run) and not any(activation.expecting_refusals for activation in run.activations)


def _keep(run: Run, message: MessageValue, name: str, span: Span, wrong: Misfit | None) -> None:
    """Note it, once a place; what is right in one run of the code is not wrong each time."""
    place = run.place(span)
    key = place, name
    noted = run.messages.values
    if key in noted and wrong is not None:
        return
    before = noted.get(key)
    noted[key] = None if wrong is None else _wrong_value(run, message, name, place, wrong)
    if noted[key] is not before:
        run.program.wrong_values[:] = [value for value in noted.values() if value is not None]


def _wrong_value(run: Run, message: MessageValue, name: str, place: Place, wrong: Misfit) -> WrongValue:
    return WrongValue(
        place,
        message.type,
        message.section_name,
        name,
        wrong.wanted,
        wrong.given,
        wrong.effect,
        wrong.cure,
        run.context.node,
        wrong.checked,
    )


__all__ = ["note_positional", "note_value"]
