"""Control flow: what decides whether a call is reached, how conditions have come out, what lies between calls.

Each statement of an example calls something by a short name, and a test speaks of the statement by that name.
"""

from __future__ import annotations

import pytest

from archlint.syntax.control_flow import loop_of
from archlint.syntax.flow_blocks import Block
from syntax.flow import Flow, names_of


def deciders_of(source: str, name: str = "x") -> set[str]:
    """What the blocks call that decide whether something is called; ``for`` and ``match`` by their words."""
    flow = Flow(source)
    return {word_of(block) for block in flow.graph.deciders(flow.blocks(name))}


def word_of(block: Block) -> str:
    return " ".join(names_of(block)) or type(block.statement).__name__.lower()


def outcomes_at(source: str, name: str = "x") -> dict[str, bool]:
    """How the conditions have come out, by what they call, wherever something is called."""
    flow = Flow(source)
    edges = flow.graph.outcomes(flow.blocks(name))
    return {" ".join(names_of(edge.source)): edge.holds for edge in edges}


@pytest.mark.parametrize(
    ("source", "deciders"),
    [
        ("x()", set()),
        ("a()\nx()\nb()", set()),
        ("if t():\n    x()", {"t"}),
        ("if t():\n    x()\nelse:\n    a()", {"t"}),
        ("if t():\n    a()\nx()", set()),
        ("if t():\n    return\nx()", {"t"}),
        ("if t():\n    raise ValueError\nx()", {"t"}),
        ("if t():\n    sys.exit()\nx()", {"t"}),
        ("x()\nif t():\n    return", set()),
        ("if t():\n    if u():\n        return\nx()", {"t", "u"}),
        ("if t():\n    if u():\n        a()\nx()", set()),
        ("if t():\n    return\nelse:\n    return\nx()", set()),
        ("if t():\n    try:\n        return\n    finally:\n        a()\nx()", {"t"}),
        ("with a():\n    if t():\n        return\nx()", {"t"}),
        ("try:\n    if t():\n        raise ValueError\nexcept ValueError:\n    a()\nx()", set()),
        ("try:\n    if t():\n        raise ValueError\nexcept ValueError:\n    return\nx()", {"t"}),
        ("match t():\n    case 1:\n        x()", {"t"}),
        # What may raise decides nothing, unless it is `raise` itself.
        ("try:\n    a()\nexcept ValueError:\n    return\nx()", set()),
        # Whichever way a `finally` is come to, it runs.
        ("try:\n    if t():\n        return\n    a()\nfinally:\n    x()", set()),
    ],
)
def test_what_decides_whether_a_call_is_reached(source: str, deciders: set[str]) -> None:
    assert deciders_of(source) == deciders


@pytest.mark.parametrize(
    ("source", "deciders"),
    [
        ("while t():\n    x()", {"t"}),
        ("while True:\n    x()", set()),
        ("for i in j():\n    x()", {"for"}),
        ("while t():\n    a()\nx()", set()),  # that it ends is taken for granted
        ("while t():\n    if u():\n        return\nx()", {"t", "u"}),
        ("while t():\n    if u():\n        break\nx()", set()),
        ("while True:\n    if t():\n        continue\n    x()", {"t"}),  # not in this round
        ("while True:\n    if t():\n        break\n    x()", {"t"}),
        ("while True:\n    x()\n    if t():\n        break", set()),
        ("while True:\n    for i in j():\n        if t():\n            break\n    x()", set()),
        ("while True:\n    for i in j():\n        if t():\n            return\n    x()", {"for", "t"}),
        ("while t():\n    x()\n    break", {"t"}),  # first of all, and nothing leads back
        ("while True:\n    if t():\n        x()\n    break", {"t"}),
    ],
)
def test_what_decides_about_a_call_in_and_after_loops(source: str, deciders: set[str]) -> None:
    assert deciders_of(source) == deciders


@pytest.mark.parametrize(
    ("source", "outcomes"),
    [
        ("if t():\n    x()", {"t": True}),
        ("if t():\n    a()\nelse:\n    x()", {"t": False}),
        ("if t():\n    return\nx()", {"t": False}),
        ("if t():\n    if u():\n        return\nx()", {}),
        ("if t():\n    if u():\n        x()", {"t": True, "u": True}),
        ("if t():\n    a()\n    return\nelif u():\n    return\nx()", {"t": False, "u": False}),
        ("while t():\n    a()\nx()", {"t": False}),
        ("while t():\n    if u():\n        break\nx()", {}),
        ("while True:\n    if t():\n        break\nx()", {"t": True}),
        ("if t():\n    return\ntry:\n    a()\nexcept ValueError:\n    x()", {"t": False}),
        ("try:\n    if t():\n        return\n    a()\nfinally:\n    x()", {}),
        ("return\nif t():\n    x()", {}),  # never reached: nothing is known
    ],
)
def test_how_conditions_have_come_out_where_a_call_is_reached(source: str, outcomes: dict[str, bool]) -> None:
    assert outcomes_at(source) == outcomes


def test_what_lies_between_two_calls() -> None:
    flow = Flow("""
        before()
        first()
        if t():
            a()
            return
        while u():
            b()
        last()
        after()
    """)
    between = flow.graph.between(flow.blocks("first"), flow.blocks("last"))
    assert {name for block in between for name in names_of(block)} == {"t", "u", "b"}


def test_what_comes_round_between_two_calls_of_a_loop() -> None:
    flow = Flow("""
        while t():
            last()
            a()
            first()
            b()
    """)
    between = flow.graph.between(flow.blocks("first"), flow.blocks("last"))
    assert {name for block in between for name in names_of(block)} == {"t", "b"}


def test_the_blocks_of_a_statement_without_what_is_inside_it() -> None:
    flow = Flow("""
        if t():
            a()
    """)
    [statement] = flow.body
    assert [names_of(block) for block in flow.graph.of(statement)] == [["t"]]
    assert [names_of(block) for block in flow.graph.at(statement)] == [["t"], ["a"]]


@pytest.mark.parametrize(
    ("source", "left"),
    [
        ("while t():\n    x()", False),
        ("while t():\n    if u():\n        break", True),
        ("while t():\n    if u():\n        return", True),
        ("while t():\n    for i in j():\n        break", False),
        ("while t():\n    if u():\n        raise ValueError", False),
        ("while t():\n    try:\n        x()\n    except ValueError:\n        break", True),
    ],
)
def test_whether_break_or_return_may_end_a_loop(source: str, left: bool) -> None:
    [loop, *_] = Flow(source).loops()
    assert loop_of(loop).is_left_by_jump is left
