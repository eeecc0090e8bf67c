"""What callbacks are, in words, and which of them an executor runs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.deadlock import related_executor
from archlint.analysis.reach import endpoint_words, related_chain, related_creation
from archlint.finding import Related

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Creation, Program

_WORDS = {
    "subscription": "the callback of a subscription",
    "timer": "a timer callback",
    "execute": "the execute callback",
    "goal": "the goal callback",
    "cancel": "the cancel callback",
    "accepted": "the callback for accepted goals",
    "feedback": "a feedback callback",
    "done": "a done callback",
    "parameter": "a parameter callback",
    "event": "an event callback",
    "guard": "the callback of a guard condition",
    "task": "a task of the executor",
    "filter": "the callback of a message filter",
    "lifecycle": "a lifecycle callback",
}

AFTER_A_SPIN = frozenset(_WORDS) | {"service"}
"""Roles of what an executor runs while it spins."""


def runs_in_executor(callback: Callback) -> bool:
    """Whether an executor runs this; a method called ``on_configure`` does so in lifecycle nodes only."""
    if callback.role == "lifecycle":
        return callback.node is not None and callback.node.lifecycle
    return callback.role in AFTER_A_SPIN


def callback_words(callback: Callback) -> str:
    """``the timer callback Robot.tick``."""
    if callback.role == "service":
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
        yield Related(callback.registered, "the callback is handed over here")
    yield from related_chain(call)
    yield from related_creation(client)
    yield from related_executor(callback.node, program)


def _plain(callback: Callback) -> str:
    if callback.role == "service":
        return f"the handler of {endpoint_words(callback.creation)}"
    return _WORDS.get(callback.role, "a callback")
