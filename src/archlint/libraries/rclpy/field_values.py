"""What the fields of messages are given, where they do not take it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.values import Instance, Known
from archlint.libraries.rclpy.message_uses import is_certain, may_be_of_another_type
from archlint.libraries.rclpy.messages import content as content_of
from archlint.libraries.rclpy.messages import known_content, of_value
from archlint.libraries.rclpy.wrong_values import Misfit, misfit, misfit_of_argument, misfit_of_item
from archlint.libraries.values import MessageValue
from archlint.model import ValueEffect, WrongValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.values import Value
    from archlint.libraries.run import Run
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
    _keep(run, message, name, span, wrong, by_call=wrong is not None and _is_argument(run, content))


def _is_argument(run: Run, content: Value) -> bool:
    """Whether a value is a number that the function is called with: this call is wrong, whatever others give it."""
    activation = run.activation
    function = None if activation.function is None else activation.function.ir
    if activation.call_place is None or not isinstance(function, facts.Function):
        return False
    if not isinstance(content, Known) or content.via or not isinstance(content.value, (int, float)):
        return False
    return any(run.lookup(param.name) is content for param in function.params)


_PUT_AT = {"append": 0, "insert": 1}
"""Methods that put one value into a list, and which argument that is."""


def note_put(run: Run, container: facts.Attribute, method: str, site: CallSite) -> None:
    """Note that the code puts into the array of a field what this never takes: ``path.poses.append(Pose())``.
    No setter runs, so that humble's messages check nothing here."""
    message = _named(run, container.value)
    if not isinstance(message, MessageValue) or site.expression is None or run.interfaces is None:
        return
    kind = run.interfaces.field_type(message.type, message.section_name, container.attr)
    if kind is None or not kind.array or kind.array == "fixed" or site.keywords or site.open or not _is_certain(run):
        return
    at = _PUT_AT.get(method)
    if at is not None and len(site.args) == at + 1:
        wrong = misfit_of_item(run, kind, site.args[at])
    elif method == "extend" and len(site.args) == 1:
        wrong = misfit(run, kind, site.args[0])
        wrong = wrong if wrong is not None and wrong.of_items else None
    else:
        return
    wrong = None if wrong is None or may_be_of_another_type(run, message) else replace(wrong, checked=False)
    _keep(run, message, container.attr, site.expression.span, wrong)


def _named(run: Run, e: facts.Expr) -> Value | None:
    """What is known of a variable, of an attribute of an object in one, or of a field of a message: without running
    anything."""
    match e:
        case facts.Name(id=name):
            held = run.lookup(name)
        case facts.Attribute(value=inner, attr=name):
            owner = _named(run, inner)
            if isinstance(owner, MessageValue):
                held = known_content(run, owner, name) or content_of(run, owner, name)
            else:
                held = run.store.get(owner.key, name) if isinstance(owner, Instance) else None
        case _:
            return None
    return None if held is None else of_value(held) or (held if isinstance(held, Instance) else None)


def note_positional(run: Run, message: MessageValue, span: Span) -> None:
    """Note that the code makes a message with an argument by position: its constructor takes keywords alone."""
    if _is_certain(run):
        _keep(run, message, "", span, _BY_POSITION)


def _is_certain(run: Run) -> bool:
    """Whether an exception would be noticed."""
    return is_certain(run) and not any(activation.expecting_refusals for activation in run.activations)


def _keep(
    run: Run, message: MessageValue, name: str, span: Span, wrong: Misfit | None, *, by_call: bool = False
) -> None:
    """Note it, once a place; what is right in one run of the code is not wrong each time, unless it is given by the
    call."""
    place = run.place(span)
    key = place, name
    noted = run.messages.values
    if key in run.messages.wrong_arguments or (key in noted and wrong is not None and not by_call):
        return
    if by_call:
        run.messages.wrong_arguments.add(key)
    before = noted.get(key)
    called_at = run.activation.call_place if by_call else None
    noted[key] = None if wrong is None else _wrong_value(run, message, name, place, wrong, called_at)
    if noted[key] is not before:
        run.program.wrong_values[:] = [value for value in noted.values() if value is not None]


def _wrong_value(
    run: Run, message: MessageValue, name: str, place: Place, wrong: Misfit, called_at: Place | None
) -> WrongValue:
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
        called_at,
    )


__all__ = ["note_positional", "note_put", "note_value"]
