"""Callbacks: what is passed to an executor, a future or a thread, noted to be run later."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from archlint import model
from archlint.branches import ChoiceOfArgument
from archlint.interpreter.identity import Key, kind_key
from archlint.interpreter.values import (
    ApiMethod,
    BoundMethod,
    Instance,
    Known,
    Partial,
    Value,
    alternatives,
)
from archlint.libraries.rclpy import messages
from archlint.libraries.rclpy.callables import describe, without_partials
from archlint.libraries.rclpy.callback_arguments import default_arguments, dropped_by, filters_of
from archlint.libraries.state import Pending

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

REGISTRATIONS = 16
"""For how many values one place registers the same callback: the next ones are taken to be like these."""


def register_row(
    run: Run,
    call: ApiUse,
    node: model.Blueprint | None,
    creation: model.Creation | None,
    group: model.Group | None = None,
) -> dict[model.Role, model.Callback]:
    """Register all callbacks that a call of the table takes."""
    callbacks: dict[model.Role, model.Callback] = {}
    for parameter, role in call.api.callbacks:
        value = call.get(parameter)
        if value is None:
            continue
        callback = register(run, value, role, node, creation, group, call)
        if callback is not None:
            callbacks[role] = callback
    return callbacks


_IN_NO_GROUP = (model.Role.EXECUTE, model.Role.DONE, model.Role.TASK, model.Role.THREAD)


def register(
    run: Run,
    value: Value,
    role: model.Role,
    node: model.Blueprint | None,
    creation: model.Creation | None,
    group: model.Group | None,
    call: ApiUse,
    arguments: tuple[Value, ...] | None = None,
) -> model.Callback | None:
    """Note a callable under its role; the first callable of several alternatives names the callback."""
    first: model.Callback | None = None
    for option in _callables(value):
        callback = describe(run, option, role)
        callback.node = node
        callback.creation = creation
        callback.group = None if role in _IN_NO_GROUP else group
        callback.given_count = _given_by_filters(run, call) if role == model.Role.FILTER else None
        callback.dropped = dropped_by(run, call) if role == model.Role.FILTER else ""
        callback.registered = run.place(call.expression.span) if call.expression is not None else None
        key = (role, callback.registered, callback.name, callback.place, id(creation), _receiver(option))
        if not _is_new(run, key, callback, (option, call.receiver, *(arguments or ()))):
            continue
        run.program.callbacks.append(callback)
        if node is not None:
            node.callbacks.append(callback)
        if callback.function is not None and not callback.dropped:
            given = arguments if arguments is not None else default_arguments(run, role, creation, call)
            if creation is not None and not _is_one_of_several(value, creation):
                messages.deliver(run, given, creation)
            run.callbacks.pending.append(Pending(callback, option, given, run.callbacks.lineage))
        elif isinstance(option, (Partial, ApiMethod)):
            run.library.escaped((option,), "it is bound to a callback that is not followed", call.expression)
        first = first or callback
    return first


def _given_by_filters(run: Run, call: ApiUse) -> int | None:
    """How many arguments message_filters calls a callback with: a message of each filter, and what it is registered
    with."""
    filters = None if call.open else filters_of(run, call.receiver)
    return None if filters is None else len(filters) + len(call.rest)


def _callables(value: Value) -> list[Value]:
    """What a value may be, but for constants: None is no callback."""
    return [option for option in alternatives(value) if not isinstance(option, Known)]


def _is_one_of_several(value: Value, creation: model.Creation) -> bool:
    """Whether it is not known which of several callables, names or types the create call is given: they may belong
    together in pairs."""
    return len(_callables(value)) > 1 or any(isinstance(branch, ChoiceOfArgument) for branch, _ in creation.branch_arms)


def _is_new(run: Run, key: tuple[Any, ...], callback: model.Callback, given: Iterable[Value | None]) -> bool:
    """Whether a callback was not registered in this way before; one place may do it for several futures, names or
    objects.  One that registers itself again is not new, whatever its arguments."""
    registrations = run.callbacks.registered.setdefault(key, set())
    if registrations and callback.function in run.callbacks.lineage:
        return False
    registration = tuple(kind_key(run.store, value) for value in given if value is not None)
    if registration in registrations or len(registrations) >= REGISTRATIONS:
        return False
    registrations.add(registration)
    return True


def _receiver(value: Value) -> int:
    match value:
        case BoundMethod(self_value=Instance(key=key)):
            return key
        case Partial(function=function):
            return _receiver(function)
    return 0


def creation_key(run: Run, base: Key, call: ApiUse) -> Key:
    """What sets a creation apart from others of the same place and name (``base``): the functions that are called, for
    timers with all that they take along.  Where callbacks run once more, the first one there is meant."""
    given = [call.get(parameter) for parameter, _ in call.api.callbacks]
    closely = call.api.effect == "timer"
    options = [option for value in given if value is not None for option in alternatives(value)]
    functions = options if closely else [without_partials(option)[0] for option in options]
    distinct = tuple(kind_key(run.store, function, closely=closely) for function in functions)
    first = run.noted.first_functions.setdefault(base, distinct)
    return (*base, distinct if run.nodes.revisited is None else first)


def task(run: Run, call: ApiUse, node: model.Blueprint | None) -> None:
    """``executor.create_task(self.go, 1, fast=True)``: the executor calls ``self.go(1, fast=True)``."""
    value = call.get("callback")
    if value is None:
        return
    named = tuple((name, given) for name, given in call.keywords.items() if name != "callback")
    value = Partial(value, (), named) if named else value
    callback = register(run, value, model.Role.TASK, node, None, None, call, tuple(call.rest))
    if callback is not None and not call.open:
        callback.given_count = len(call.rest)
