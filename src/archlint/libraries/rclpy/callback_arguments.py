"""What rclpy calls a callback with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import ChoiceOfArgument
from archlint.interpreter.values import (
    External,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
)
from archlint.libraries.rclpy.interface_types import types_of
from archlint.libraries.tables.noted import SYNCHRONIZERS
from archlint.libraries.values import EntityValue, FutureValue, MessageValue

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.ros.interfaces import MessageClass
GOAL_HANDLE = External("rclpy.action.server.ServerGoalHandle")
_PASSED = Unknown("an argument that rclpy passes to the callback")


def default_arguments(run: Run, role: model.Role, creation: model.Creation | None, call: ApiUse) -> tuple[Value, ...]:
    """What rclpy calls a callback of this role with."""
    type_ = creation.type if creation is not None and not _may_be_another_type(call) else None

    def message(part: MessageClass) -> Value:
        if type_ is None:
            return Unknown("a message of unknown type")
        return MessageValue(type_, part, run.store.new_key())

    if role == model.Role.SUBSCRIPTION:
        return (message(""),)
    if role == model.Role.SERVICE:
        return (message("Request"), message("Response"))
    if role in (model.Role.EXECUTE, model.Role.CANCEL, model.Role.ACCEPTED):
        goal = message("Goal")
        instance = Instance(GOAL_HANDLE, run.store.new_key(), None, {"request": goal})
        run.store.set(instance.key, "request", goal)
        return (instance,)
    if role == model.Role.GOAL:
        return (message("Goal"),)
    if role == model.Role.DONE:
        return (call.receiver,) if isinstance(call.receiver, FutureValue) else (Unknown("a future"),)
    if role == model.Role.FEEDBACK:
        return (_feedback(run, call),)
    if role == model.Role.FILTER:
        filters = filters_of(run, call.receiver)
        messages = [_PASSED] if filters is None else [_from_filter(run, each) for each in filters]
        return (*messages, *call.rest)
    if role in (model.Role.PARAMETER, model.Role.EVENT):
        return (_PASSED,)
    return ()


def filters_of(run: Run, filter_: Value | None) -> tuple[Value, ...] | None:
    """The filters of message_filters each of which gives a callback one of its arguments: those of a synchronizer in
    their order, or a subscriber itself; None where that is not known."""
    match filter_:
        case EntityValue():
            return (filter_,)
        case Instance(cls=External(path=path), arguments=arguments) if path in SYNCHRONIZERS:
            given = arguments.get("0", arguments.get("fs"))
            items = given.items(run) if isinstance(given, ListValue) and given.kind in ("list", "tuple") else None
            return items.values if items is not None and not items.open and items.values else None
    return None


_APPROXIMATE = "message_filters.ApproximateTimeSynchronizer"
_ALLOWS = "allow_headerless"


def dropped_by(run: Run, call: ApiUse) -> str:
    """The type of a message that a synchronizer is to take by the time in its header, and that has none; empty where
    there is none for certain, or where the synchronizer may take the time of arrival instead.

    Source: message_filters/__init__.py, ``ApproximateTimeSynchronizer.add``.
    """
    match call.receiver:
        case Instance(cls=External(path=path), arguments=arguments) if path == _APPROXIMATE:
            by_position = any(name.isdigit() and int(name) > 2 for name in arguments)
            allows = arguments.get(_ALLOWS)
            if by_position or (allows is not None and allows != Known(False)):  # a parameter may set it
                return ""
            if _ALLOWS in run.activation.module.facts.names:  # set on the synchronizer later on
                return ""
            for each in filters_of(run, call.receiver) or ():
                message = _from_filter(run, each)
                if isinstance(message, MessageValue) and _has_no_header(run, message.type):
                    return message.type
    return ""


def _has_no_header(run: Run, type_: str) -> bool:
    section = None if run.interfaces is None else run.interfaces.section(type_, "")
    return section is not None and section.field("header") is None


def _from_filter(run: Run, filter_: Value) -> Value:
    """The message that a filter passes on: what a subscriber gets."""
    match filter_:
        case EntityValue(creations=[model.Creation(type=str(type_)) as creation]) if not any(
            isinstance(branch, ChoiceOfArgument) for branch, _ in creation.branch_arms
        ):
            message = MessageValue(type_, "", run.store.new_key())
            run.messages.delivered[message.key] = creation
            return message
    return _PASSED


def _may_be_another_type(call: ApiUse) -> bool:
    """Whether the create call is given one of several types, not all of which are known: the callback may be for
    those alone."""
    types = types_of(call)
    return len(types) > 1 and any(type_ is None for type_, _ in types)


def _feedback(run: Run, call: ApiUse) -> Value:
    """What a feedback callback is called with: the feedback and the goal it is for."""
    creations = call.receiver.creations if isinstance(call.receiver, EntityValue) else ()
    type_ = creations[0].type if len(creations) == 1 else None
    if type_ is None:
        return Unknown("the feedback of an action of unknown type")
    value = MessageValue(type_, "FeedbackMessage", run.store.new_key())
    run.store.set(value.key, "feedback", MessageValue(type_, "Feedback", run.store.new_key()))
    return value
