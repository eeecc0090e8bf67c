"""A thread with a large stack, also from inside such a thread."""

from __future__ import annotations

import threading

from archlint.syntax.python.deep_stack import STACK_BYTES, call_with_deep_stack


def test_a_call_inside_a_call_leaves_the_size_of_stacks_as_it_was():
    before = threading.stack_size()
    for _ in range(200):
        assert call_with_deep_stack(lambda: call_with_deep_stack(lambda: 7)) == 7
        assert threading.stack_size() == before != STACK_BYTES
