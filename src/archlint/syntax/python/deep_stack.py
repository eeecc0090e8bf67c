"""Room for deeply nested code: a thread with a large stack, and a recursion limit to match."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import copy_context
from typing import TypeVar

Result = TypeVar("Result")

STACK_BYTES = 64 * 1024 * 1024
"""Enough for the deepest code that the gate lets through; libcst overruns a stack without a warning."""

STOCK_LIMIT = 1_000
"""CPython's recursion limit as it comes."""

DEEP_LIMIT = 20_000
"""The recursion limit that fits a stack of :data:`STACK_BYTES`."""

FRAMES = 2**18
"""How many values the frames of the functions that run have room for in one piece: 2 MB."""

_STARTING = threading.Lock()
"""The size of a stack is a setting of the process: a call inside a call must not meet the one outside half done."""


def _with_room(function: Callable[[], Result]) -> Result:
    return function()


# CPython takes memory for frames from the system in pieces of 16 kB, and gives a piece back when the first function in
# it returns.  A function that is called again and again at the end of a piece spends more time on that than on all
# else.  One that says that it needs a large stack of values gets a piece of twice that size, and leaves the rest of it
# to what it calls.
_with_room.__code__ = _with_room.__code__.replace(co_stacksize=FRAMES)


def call_with_deep_stack(function: Callable[[], Result]) -> Result:
    """What ``function`` returns or raises, called in a thread with a stack of :data:`STACK_BYTES`, with the
    recursion limit that fits it and with the context variables of the thread that calls.

    The limit holds for the whole process, so it is sound only because the thread that calls does nothing but wait.
    """
    results: list[Result] = []
    errors: list[BaseException] = []
    context = copy_context()

    def run() -> None:
        with _STARTING:
            pass  # a process that is forked in this thread would find the lock of its starter locked forever
        try:
            results.append(context.run(_with_room, function))
        except BaseException as error:  # raised again in the thread that waits
            errors.append(error)

    thread = threading.Thread(target=run, name="archlint-deep")
    with recursion_limit(DEEP_LIMIT):
        with _STARTING:
            previous = threading.stack_size(STACK_BYTES)
            try:
                thread.start()
            finally:
                threading.stack_size(previous)
        thread.join()
    if errors:
        raise errors[0]
    return results[0]


@contextmanager
def recursion_limit(limit: int) -> Iterator[None]:
    """Another recursion limit for as long as the block runs.  It holds for the whole process."""
    previous = sys.getrecursionlimit()
    sys.setrecursionlimit(limit)
    try:
        yield
    finally:
        sys.setrecursionlimit(previous)
