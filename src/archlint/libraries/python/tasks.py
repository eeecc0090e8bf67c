"""Coroutines that a call passes to an event loop: ``asyncio.create_task(self.go())`` waits for nothing."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, FunctionValue, Unknown, Value
from archlint.libraries.rclpy import callables
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.libraries.run import Run

STARTERS = frozenset({"create_task", "ensure_future", "run_coroutine_threadsafe"})
"""Calls of asyncio, its loops and task groups that start a coroutine and return at once.  ``create_task`` of an
executor of rclpy is none of them: its task runs in the executor's thread."""


def note_started(run: Run, e: facts.Call, starter: Value) -> None:
    """Remember the calls among the arguments of ``e`` whose coroutines it starts."""
    if isinstance(starter, (External, Unknown)) and called_name(e) in STARTERS:
        run.callbacks.coroutines.update(
            id(argument.value) for argument in e.args if isinstance(argument.value, facts.Call)
        )


def as_own_task(run: Run, e: facts.Call, function: Value) -> AbstractContextManager[None] | None:
    """What holds while ``e`` is called: the body of a coroutine that another call starts is followed like that of a
    thread, so that what it waits for holds up nobody here."""
    if id(e) not in run.callbacks.coroutines:
        return None
    inner = function.callee
    is_coroutine = isinstance(inner, FunctionValue) and inner.ir.is_async
    return _in_thread(run, function) if is_coroutine else None


@contextmanager
def _in_thread(run: Run, function: Value) -> Iterator[None]:
    kept = run.context
    run.context = callables.describe(run, function, Role.THREAD)
    try:
        yield
    finally:
        run.context = kept
