"""What is asked of blocks in a row is answered once, and the answer is that of each block by itself."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from syntax.flow import Flow

SIMPLE = st.sampled_from(["a()", "return", "raise ValueError", "sys.exit()"])
IN_A_LOOP = st.sampled_from(["a()", "break", "continue", "return"])
HEADS = ("if t():", "while t():", "for x in y():", "with t():", "while True:")


def indented(lines: list[str]) -> list[str]:
    return [f"    {line}" for line in lines]


def around(inner: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    block = st.tuples(st.sampled_from(HEADS), inner).map(lambda row: [row[0], *indented(row[1])])
    choice = st.tuples(inner, inner).map(lambda rows: ["if t():", *indented(rows[0]), "else:", *indented(rows[1])])
    guarded = st.tuples(inner, inner, st.sampled_from(["except ValueError:", "finally:"])).map(
        lambda rows: ["try:", *indented(rows[0]), rows[2], *indented(rows[1])]
    )
    one = st.one_of(SIMPLE.map(lambda line: [line]), block, choice, guarded)
    return st.lists(one, min_size=1, max_size=4).map(lambda rows: [line for row in rows for line in row])


BODIES = st.recursive(st.lists(SIMPLE, min_size=1, max_size=3), around, max_leaves=8)


@settings(max_examples=150, deadline=None)
@given(BODIES)
def test_it_is_the_answer_for_each_block_by_itself(lines: list[str]) -> None:
    graph = Flow("\n".join(lines)).graph
    for block in graph.blocks:
        assert graph.deciders([block]) == graph._deciders_of([block])
        assert graph.outcomes([block]) == graph._outcomes.at([block])


def test_a_row_of_statements_is_one_question() -> None:
    graph = Flow("if t():\n    return\n" + "a()\n" * 200).graph
    assert {tuple(graph.deciders([block])) for block in graph.blocks[3:]} != {()}
    assert len(graph._answers) < 5
