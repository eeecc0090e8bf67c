"""What callbacks are, in words, and which of them an executor runs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, related_chain, related_creation
from archlint.execution.deadlock import related_executor
from archlint.finding import Related
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Creation, Program

_WORDS = {
    Role.SUBSCRIPTION: "the callback of a subscription",
    Role.TIMER: "a timer callback",
    Role.EXECUTE: "the execute callback",
    Role.GOAL: "the goal callback",
    Role.CANCEL: "the cancel callback",
    Role.ACCEPTED: "the callback for accepted goals",
    Role.FEEDBACK: "a feedback callback",
    Role.DONE: "a done callback",
    Role.PARAMETER: "a parameter callback",
    Role.EVENT: "an event callback",
    Role.GUARD: "the callback of a guard condition",
    Role.TASK: "a task of the executor",
    Role.FILTER: "the callback of a message filter",
    Role.LIFECYCLE: "a lifecycle callback",
}

AFTER_A_SPIN = frozenset(_WORDS) | {Role.SERVICE}
"""Roles of what an executor runs while it spins."""


def runs_in_executor(callback: Callback) -> bool:
    """Whether an executor runs this; a method called ``on_configure`` does so in lifecycle nodes only."""
    if callback.role == Role.LIFECYCLE:
        return callback.node is not None and callback.node.lifecycle
    return callback.role in AFTER_A_SPIN


def may_run_in_executor(callback: Callback) -> bool:
    """Whether an executor runs this, or it is a method of which nobody knows who calls it."""
    return callback.role == Role.METHOD or runs_in_executor(callback)


def callback_words(callback: Callback) -> str:
    """``the timer callback Robot.tick``."""
    if callback.role == Role.SERVICE:
        return f"the handler of {endpoint_words(callback.creation)}"
    what = _WORDS[callback.role]
    if callback.name in ("?", "<lambda>"):
        return what
    return f"{what.replace('a ', 'the ', 1) if what.startswith('a ') else what}, {callback.name},"


def related_to(call: ApiCall, program: Program, client: Creation | None = None) -> Iterator[Related]:
    """The way of a finding: the callback, each call that leads on, the client, the executor."""
    callback = call.context
    yield Related(callback.place, f"{callback.name} is {_plain(callback)}")
    if callback.registered is not None:
        yield Related(callback.registered, "the callback is registered here")
    yield from related_chain(call)
    yield from related_creation(client)
    yield from related_executor(callback.node, program)


def _plain(callback: Callback) -> str:
    if callback.role == Role.SERVICE:
        return f"the handler of {endpoint_words(callback.creation)}"
    return _WORDS.get(callback.role, "a callback")
