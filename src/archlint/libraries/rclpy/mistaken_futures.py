"""Futures of requests that code uses as if they were the answers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import ApiMethod, Value, alternatives
from archlint.libraries.api_signatures import attributes_of
from archlint.libraries.rclpy.agreement import note_if_same
from archlint.libraries.rclpy.effects import answer
from archlint.libraries.rclpy.message_uses import is_certain
from archlint.libraries.values import EntityValue, FutureValue, MessageValue
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.syntax.facts import Span

_FUTURE = "rclpy.task.Future"
_RESULT = f"{_FUTURE}.result"
_OF_FUTURES = attributes_of(_FUTURE) or frozenset()
_OF_FUNCTIONS = frozenset(dir(attributes_of))
_OF_HANDLES = frozenset({"accepted", "goal_id", "stamp", "status"})
"""What a client reads of the handle of a goal, besides its methods."""
_ASK = frozenset({"hasattr", "getattr", "isinstance", "type", "callable"})
"""With one of these, code finds out what it has got."""


def note_read(run: Run, value: Value, name: str, span: Span) -> None:
    """Note that the code reads an attribute of a future that only its result can have."""
    if not run.noted.futures and not any(
        isinstance(option, (FutureValue, ApiMethod)) for option in alternatives(value)
    ):
        return  # as nearly always
    options = [option for option in alternatives(value) if not option.is_none]
    futures = [future for option in options if (future := _future_in(option, name)) is not None]
    key = run.place(span), name
    certain = len(futures) == len(options) and not any(future.creations != futures[0].creations for future in futures)
    if certain and futures and is_certain(run) and not _asks(run):
        _keep(run, _mistaken(run, futures[0], options[0], name, span))
    elif key in run.noted.futures and note_if_same(run.noted.futures, key, None):
        _show(run)


def note_set(run: Run, target: Value, name: str) -> None:
    """Note that the code gives a future an attribute."""
    known = run.noted.set_on_futures
    if name not in known and any(isinstance(option, FutureValue) for option in alternatives(target)):
        known.add(name)
        _show(run)


def note_response(run: Run, callback: model.Callback, given: Value) -> None:
    """Note that a service handler returns a future."""
    if callback.role != model.Role.SERVICE:
        return
    for future in alternatives(given):
        if isinstance(future, FutureValue) and future.creations and future.place is not None:
            client = future.creations[0]
            _keep(run, model.MistakenFuture(future.place, "", future.api, client, callback, future.place))


def _future_in(value: Value, name: str) -> FutureValue | None:
    """The future that a value is, or whose method ``result`` it is, and that has nothing of this name."""
    match value:
        case FutureValue(creations=[_, *_]) if name not in _OF_FUTURES:
            return value
        case ApiMethod(path=path, self_value=FutureValue(creations=[_, *_]) as future) if path == _RESULT:
            return None if name in _OF_FUNCTIONS else future
    return None


def _asks(run: Run) -> bool:
    """Whether the function that runs may know that it has a future."""
    function = run.activation.function
    return function is not None and not _ASK.isdisjoint(names_in(function.ir))


def _mistaken(run: Run, future: FutureValue, value: Value, name: str, span: Span) -> model.MistakenFuture:
    return model.MistakenFuture(
        run.place(span),
        name,
        future.api,
        future.creations[0],
        run.context,
        future.place,
        uncalled=isinstance(value, ApiMethod),
        has_attribute=_has(run, alternatives(answer(run, future)), name),
    )


def _has(run: Run, answers: Sequence[Value], name: str) -> bool | None:
    """Whether what a future holds has an attribute; None where that is not known."""
    match answers:
        case [EntityValue()]:
            return name in _OF_HANDLES
        case [MessageValue(type=type_, section_name=section)] if run.interfaces is not None:
            return run.interfaces.has(type_, section, name)
    return None


def _keep(run: Run, mistaken: model.MistakenFuture) -> None:
    """Note it; what differs from one run of the code to another is not always so."""
    if note_if_same(run.noted.futures, (mistaken.place, mistaken.attribute), mistaken):
        _show(run)


def _show(run: Run) -> None:
    run.program.mistaken_futures[:] = [
        mistaken
        for mistaken in run.noted.futures.values()
        if mistaken is not None and mistaken.attribute not in run.noted.set_on_futures
    ]


__all__ = ["note_read", "note_response", "note_set"]
