"""What decides and how conditions come out, in made-up programs: held against taking a look at all ways each time."""

from __future__ import annotations

import gc
import time

from hypothesis import given, settings
from hypothesis import strategies as st

from archlint.syntax import flow_deciders, flow_outcomes
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, reach
from archlint.syntax.flow_facts import ends_of
from archlint.syntax.flow_graph import Graph
from syntax.flow import body

JUMPS = st.sampled_from(["return", "raise ValueError"])
JUMPS_IN_LOOPS = st.sampled_from(["return", "raise ValueError", "break", "continue"])


def blocks_of(depth: int, in_loop: bool) -> st.SearchStrategy[list[str]]:
    """Some lines: calls, jumps, and compound statements as deep as that."""
    plain = st.just(["a()"]) | (JUMPS_IN_LOOPS if in_loop else JUMPS).map(lambda word: [word])
    if not depth:
        return st.lists(plain, min_size=1, max_size=2).map(flat)
    inner, looped = blocks_of(depth - 1, in_loop), blocks_of(depth - 1, True)
    compound = st.one_of(
        st.tuples(st.just("if t():"), inner).map(headed),
        st.tuples(st.just("if t():"), inner, st.just("else:"), inner).map(headed),
        st.tuples(st.just("while t():"), looped).map(headed),
        st.tuples(st.just("for i in t():"), looped, st.just("else:"), inner).map(headed),
    )
    return st.lists(plain | compound, min_size=1, max_size=3).map(flat)


def flat(groups: list[list[str]]) -> list[str]:
    return [line for group in groups for line in group]


def headed(parts: tuple[str | list[str], ...]) -> list[str]:
    return flat([[part] if isinstance(part, str) else [f"    {line}" for line in part] for part in parts])


def graph(source: str) -> Graph:
    return graph_of(body(source))


@settings(max_examples=300, deadline=None)
@given(blocks_of(3, in_loop=False).map("\n".join))
def test_deciders_are_those_of_a_look_at_all_ways(source: str) -> None:
    flow = graph(source)
    for block in flow.blocks:
        if block.statement is not None:
            told = set(flow.deciders([block]))
            assert told == flow._deciders_with_copies([block]), (source, block.statement)


@settings(max_examples=300, deadline=None)
@given(blocks_of(3, in_loop=False).map("\n".join))
def test_outcomes_are_the_edges_that_no_way_goes_without(source: str) -> None:
    flow = graph(source)
    edges = [edge for block in flow.blocks for edge in block.edges if edge.test is not None]
    for block in flow.blocks:
        certain = [
            edge for edge in edges if block not in reach([flow.entry], lambda other, left=edge: other is not left)
        ]
        assert flow.outcomes([block]) == certain


def on_line(flow: Graph, line: int) -> list[Block]:
    return [block for block in flow.blocks if block.statement is not None and ends_of(block.statement)[0][0] == line]


def test_an_endless_loop_decides_about_what_comes_behind_it() -> None:
    flow = graph("if t():\n    while True:\n        a()\nx()")
    assert flow.deciders(on_line(flow, 4)) == on_line(flow, 1)


def test_a_thousand_early_returns_are_no_square() -> None:
    def seconds(many: int) -> float:
        flow = graph("if t(): return\nx()\n" * many)
        gc.disable()  # it goes through all that the other tests have left, too
        try:
            started = time.process_time()
            for block in flow.blocks:
                assert len(flow.deciders([block])) <= flow_deciders.MOST
                assert len(flow.outcomes([block])) <= flow_outcomes.MOST
            return time.process_time() - started
        finally:
            gc.enable()

    assert min(seconds(1600) for _ in range(2)) < 8 * min(seconds(400) for _ in range(3))


def test_the_nearest_conditions_are_told() -> None:
    flow = graph("if t(): return\n" * 300 + "x()")
    nearest = range(301 - flow_outcomes.MOST, 301)
    assert [edge.source for edge in flow.outcomes(on_line(flow, 301))] == [
        block for line in nearest for block in on_line(flow, line)[:1]
    ]
    assert flow.deciders(on_line(flow, 301)) == [on_line(flow, line)[0] for line in nearest]
