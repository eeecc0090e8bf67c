"""A thread with a large stack, also from inside such a thread."""

from __future__ import annotations

import threading
import time

import pytest

from archlint.syntax.python import deep_stack
from archlint.syntax.python.deep_stack import STACK_BYTES, call_with_deep_stack


def test_a_call_inside_a_call_leaves_the_size_of_stacks_as_it_was():
    before = threading.stack_size()
    for _ in range(200):
        assert call_with_deep_stack(lambda: call_with_deep_stack(lambda: 7)) == 7
        assert threading.stack_size() == before != STACK_BYTES


def test_a_process_that_is_forked_at_once_finds_the_lock_free(monkeypatch: pytest.MonkeyPatch):
    """The thread that starts another may be slow to let go of it."""
    set_size = threading.stack_size

    def slowly(size: int = 0) -> int:
        if size != deep_stack.STACK_BYTES:
            time.sleep(0.1)
        return set_size(size)

    monkeypatch.setattr(threading, "stack_size", slowly)
    assert deep_stack.call_with_deep_stack(deep_stack._STARTING.locked) is False


def test_calls_at_any_depth_ask_the_system_for_no_memory():
    """Without room for frames there are depths at which each call costs a page, some thousands here."""
    resource = pytest.importorskip("resource")

    def leaf() -> None:
        pass

    def call_at(depth: int) -> None:
        if depth:
            call_at(depth - 1)
        else:
            for _ in range(500):
                leaf()

    def pages() -> int:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
        for depth in range(300):
            call_at(depth)
        return int(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)

    call_with_deep_stack(pages)
    assert call_with_deep_stack(pages) < 300
