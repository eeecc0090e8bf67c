"""Coroutines that a call passes to an event loop: ``asyncio.create_task(self.go())`` waits for nothing."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import ApiMethod, External, FunctionValue, Unknown, Value
from archlint.libraries.rclpy import callables
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.libraries.run import Run

STARTERS = frozenset({"create_task", "ensure_future", "run_coroutine_threadsafe"})
"""Calls of asyncio, its loops and task groups that start a coroutine and return at once."""
_OF_AN_EXECUTOR = "rclpy.executors.Executor.create_task"
"""It starts a coroutine, too: as a task of the executor's own threads, in no callback group."""


def note_started(run: Run, e: facts.Call, starter: Value) -> None:
    """Remember the calls among the arguments of ``e`` whose coroutines it starts, and what runs these."""
    match starter:
        case External() | Unknown() if called_name(e) in STARTERS:
            role = Role.THREAD
        case ApiMethod(path=path) if path == _OF_AN_EXECUTOR:
            role = Role.TASK
        case _:
            return
    calls = (argument.value for argument in e.args if isinstance(argument.value, facts.Call))
    run.callbacks.coroutines.update((id(call), role) for call in calls)


def as_own_task(run: Run, e: facts.Call, function: Value) -> AbstractContextManager[None] | None:
    """What holds while ``e`` is called: the body of a coroutine that another call starts is followed like that of a
    thread or of a task, so that what it awaits holds up nobody here."""
    role = run.callbacks.coroutines.get(id(e))
    if role is None:
        return None
    inner = function.callee
    is_coroutine = isinstance(inner, FunctionValue) and inner.ir.is_async
    return _apart(run, function, role, run.place(e.span)) if is_coroutine else None


@contextmanager
def _apart(run: Run, function: Value, role: Role, started: Place) -> Iterator[None]:
    kept = run.context
    run.context = callables.describe(run, function, role)
    if role is Role.TASK:
        run.context.node, run.context.registered = kept.node, started
    try:
        yield
    finally:
        run.context = kept
