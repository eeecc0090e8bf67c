"""Control flow: what may run after what, what always comes before it, and what always after.

Each statement of an example calls something by a short name, and a test speaks of the statement by that name.
"""

from __future__ import annotations

import textwrap
import warnings
from collections.abc import Callable, Iterator

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from archlint.syntax import facts
from archlint.syntax.control_flow import always_raises, graph_of, loop_of, may_run_again
from archlint.syntax.flow_blocks import Block, Edge, Kind, reach
from syntax.flow import Flow, body, names_of, names_of_fact

# ------------------------------------------------------------------------------------------- what runs at all


@pytest.mark.parametrize(
    "source",
    [
        "return\nlater()",
        "raise ValueError\nlater()",
        "import sys\nsys.exit(1)\nlater()",
        "exit()\nlater()",
        "assert False\nlater()",
        "while True:\n    a()\nlater()",
        "while True:\n    a()\nelse:\n    later()",
        "if True:\n    return\nlater()",
        "if 0:\n    later()",
        "for x in y():\n    continue\n    later()",
        "try:\n    return\nfinally:\n    a()\nlater()",
        "try:\n    a()\n    raise ValueError\nexcept:\n    return\nlater()",
        "match a():\n    case _:\n        return\nlater()",
        "match a():\n    case x:\n        return\n    case 1:\n        later()",
        "with a():\n    return\nlater()",
    ],
)
def test_what_never_runs(source: str) -> None:
    assert not Flow(source).runs("later")


@pytest.mark.parametrize(
    "source",
    [
        "if a():\n    return\nlater()",
        "while True:\n    if a():\n        break\nlater()",
        "while a():\n    pass\nelse:\n    later()",
        "try:\n    return a()\nexcept ValueError:\n    later()",
        "try:\n    pass\nexcept ImportError:\n    later()",
        "try:\n    return\nfinally:\n    later()",
        "try:\n    raise ValueError\nexcept:\n    pass\nlater()",
        "while True:\n    try:\n        break\n    finally:\n        later()",
        "match a():\n    case 1:\n        return\nlater()",
        "match a():\n    case x if b():\n        return\nlater()",
        "assert a()\nlater()",
        "other.exit()\nlater()",
    ],
)
def test_what_may_run(source: str) -> None:
    assert Flow(source).runs("later")


def test_a_return_in_finally_swallows_an_exception() -> None:
    flow = Flow("try:\n    a()\nfinally:\n    return")
    assert flow.graph.raised not in reach([flow.graph.entry])
    assert flow.graph.end not in reach([flow.graph.entry])


# ------------------------------------------------------------------------------------------------ dominance


def test_what_stands_before_a_branch_dominates_both_arms_and_what_follows() -> None:
    flow = Flow("""
        a()
        if test():
            b()
        else:
            c()
        d()
    """)
    assert all(flow.dominates("a", name) for name in ("test", "b", "c", "d"))
    assert not flow.dominates("b", "d")
    assert not flow.dominates("d", "a")
    assert flow.dominates("b", "b")


def test_after_an_early_return_the_rest_is_dominated_by_its_test_alone() -> None:
    flow = Flow("""
        if test():
            a()
            return
        b()
    """)
    assert flow.dominates("test", "b")
    assert not flow.dominates("a", "b")


def test_what_may_raise_does_not_dominate_the_handler() -> None:
    flow = Flow("""
        try:
            a()
            b()
        except ValueError:
            c()
        d()
    """)
    assert not flow.dominates("a", "c")  # even entering the try may have raised
    assert not flow.dominates("b", "d")
    assert flow.dominates("a", "b")


# ------------------------------------------------------------------------------------------- always followed


def test_the_end_of_a_function_always_follows_what_does_not_return() -> None:
    flow = Flow("""
        a()
        if test():
            return
        b()
        c()
    """)
    assert flow.always_followed("b", "c")
    assert not flow.always_followed("a", "c")
    assert not flow.always_followed("b", "c", though_it_raises=True)


def test_a_raise_is_a_way_out_even_where_nothing_else_raises() -> None:
    flow = Flow("""
        a()
        if test():
            raise ValueError
        b()
        try:
            c()
        except ValueError:
            raise
        d()
    """)
    assert not flow.always_followed("a", "b")
    assert flow.always_followed("b", "d")


def test_finally_follows_whatever_becomes_of_the_rest() -> None:
    graph = graph_of(
        body("""
            try:
                a()
                return b()
            finally:
                c()
        """)
    )
    [first] = [block for block in graph.blocks if "a" in names_of(block)]
    last = [block for block in graph.blocks if "c" in names_of(block)]
    assert len(last) == 2  # one for the return, one for an exception
    assert reach([first], avoiding=last).isdisjoint(graph.exits)


# ---------------------------------------------------------------------------------------------------- loops


@pytest.mark.parametrize(
    ("source", "again"),
    [
        ("while t():\n    x()", True),
        ("while t():\n    x()\n    break", False),
        ("while t():\n    x()\n    return", False),
        ("while t():\n    x()\n    raise ValueError", False),
        ("while t():\n    x()\n    if u():\n        break", True),
        ("while t():\n    if u():\n        x()\n        break", False),
        ("while t():\n    if u():\n        x()\n        continue\n    break", True),
        ("while t():\n    for i in j():\n        x()\n        break", True),
        ("while t():\n    for i in j():\n        x()\n        return", False),
        ("while t():\n    try:\n        x()\n        break\n    except ValueError:\n        y()", True),
        ("while t():\n    try:\n        return x()\n    except ValueError:\n        y()", False),
        ("while t():\n    try:\n        break\n    finally:\n        x()", False),
        ("while t():\n    try:\n        if u():\n            break\n    finally:\n        x()", True),
        ("while t():\n    try:\n        y()\n        x()\n    finally:\n        break", False),
        ("for i in j():\n    x()", True),
        ("for i in j():\n    return x()", False),
        ("for i in j():\n    with y():\n        x()\n        break", False),
        ("for i in j():\n    break\n    x()", False),
    ],
)
def test_whether_a_loop_goes_round_again_after_a_statement(source: str, again: bool) -> None:
    assert Flow(source).repeats_after("x") is again


def test_a_loop_goes_round_after_itself() -> None:
    [loop] = Flow("while t():\n    break").loops()
    assert may_run_again(loop, loop)


def test_a_loop_that_every_way_leaves_never_goes_round() -> None:
    outer, inner = Flow("""
        while test():
            for item in items():
                if a():
                    return
                break
    """).loops()
    assert loop_of(outer).repeats
    assert not loop_of(inner).repeats


def test_the_exits_of_a_loop() -> None:
    [loop] = Flow("""
        while test():
            a()
            if b():
                break
            if c():
                return d()
    """).loops()
    exits = [(names_of(edge.source), edge.holds) for edge in loop_of(loop).exits if edge.kind is not Kind.RAISE]
    assert sorted(exits) == [([], True), (["d"], True), (["test"], False)]


def test_a_finally_that_the_way_out_runs_is_no_part_of_the_loop() -> None:
    flow = Flow("""
        try:
            while test():
                return
        finally:
            a()
    """)
    assert all(not block.loops for block in flow.blocks("a"))


# -------------------------------------------------------------------------------------------- always raises


@pytest.mark.parametrize(
    ("source", "raises"),
    [
        ("raise ValueError", True),
        ("if a():\n    raise ValueError\nelse:\n    sys.exit()", True),
        ("if a():\n    raise ValueError", False),
        ("a()", False),
        ("return", False),
        ("try:\n    raise ValueError\nexcept ValueError:\n    raise", True),
        ("try:\n    raise ValueError\nexcept ValueError:\n    pass", False),
        ("with a():\n    raise ValueError", True),
        ("break", False),
    ],
)
def test_whether_a_block_always_raises(source: str, raises: bool) -> None:
    # `break` is refused outside of a loop: the block is that of a loop.
    [loop] = body("while t():\n" + textwrap.indent(source, "    "))
    assert isinstance(loop, facts.While)
    assert always_raises(loop.body) is raises


# --------------------------------------------------------------------------------------------- what is known


def called(state: frozenset[str], fact: facts.Base) -> frozenset[str]:
    return state | frozenset(names_of_fact(fact))


def ways_to_the_end(source: str) -> set[str]:
    """What has been called by the end, for each way that leads there."""
    ends = graph_of(body(source)).ends(frozenset(), called)
    return {
        " ".join(sorted(state)) for states in (ends.falls, *(given for _, given in ends.returns)) for state in states
    }


def test_what_each_way_to_the_end_has_called() -> None:
    assert ways_to_the_end("if t():\n    a()\nelse:\n    b()") == {"a t", "b t"}
    assert ways_to_the_end("for i in j():\n    a()") == {"j", "a j"}
    assert ways_to_the_end("if t():\n    return a()\nb()") == {"a t", "b t"}
    assert ways_to_the_end("try:\n    a()\nexcept ValueError:\n    b()") == {"a", "b", "a b"}
    assert ways_to_the_end("try:\n    return a()\nfinally:\n    b()") == {"a b"}
    assert ways_to_the_end("try:\n    return a()\nexcept ValueError:\n    b()") == {"a", "b"}


def test_a_condition_keeps_states_out_of_an_arm() -> None:
    def branch(state: bool, test: facts.Expr, holds: bool) -> bool | None:
        return state if test.dotted != "ready" or state is holds else None

    def step(state: bool, fact: facts.Base) -> bool:
        return state or names_of_fact(fact) == ["prepare"]

    graph = graph_of(body("prepare()\nif ready:\n    return 1\nreturn 2"))
    ends = graph.ends(False, step, branch)
    assert [(end.value.number, states) for end, states in ends.returns if end.value] == [(1.0, frozenset({True}))]


# ------------------------------------------------------------------------- held against Python, and against paths


class Failure(Exception):
    """What a statement of a generated program may raise."""


_NAMES = [f"s{number}" for number in range(40)]


def _blocks(depth: int, in_loop: bool) -> st.SearchStrategy[list[object]]:
    simple: list[st.SearchStrategy[object]] = [st.just("call"), st.just("call"), st.just("return"), st.just("raise")]
    if in_loop:
        simple += [st.just("break"), st.just("continue")]
    if depth == 0:
        return st.lists(st.one_of(simple), min_size=1, max_size=2)
    inner = _blocks(depth - 1, in_loop)
    looped = _blocks(depth - 1, True)
    maybe = st.one_of(st.just([]), inner)
    return st.lists(
        st.one_of(
            *simple,
            st.tuples(st.just("if"), inner, maybe),
            st.tuples(st.sampled_from(["while", "for"]), looped, maybe),
            st.tuples(st.just("with"), inner),
            st.tuples(st.sampled_from(["except Failure", "except"]), inner, inner, maybe),
            st.tuples(st.just("finally"), inner, inner),
        ),
        min_size=1,
        max_size=3,
    )


def source_of(block: list[object], names: Iterator[str]) -> list[str]:
    """The lines of a program; every statement and condition has a name of its own."""
    lines: list[str] = []
    for one in block:
        match one:
            case "call":
                lines.append(f"{next(names)}()")
            case "return":
                lines.append(f"return {next(names)}()")
            case "raise":
                lines.append(f"raise {next(names)}()")
            case str():
                lines.append(one)
            case ("if" | "while" | "for" as word, list(first), list(second)):
                head = f"for _ in {next(names)}():" if word == "for" else f"{word} {next(names)}():"
                lines += [head, *_indented(first, names)]
                lines += ["else:", *_indented(second, names)] if second else []
            case ("with", list(first)):
                lines += [f"with {next(names)}():", *_indented(first, names)]
            case ("finally", list(first), list(second)):
                lines += ["try:", *_indented(first, names), "finally:", *_indented(second, names)]
            case (str(word), list(first), list(second), list(third)):
                lines += ["try:", *_indented(first, names), f"{word}:", *_indented(second, names)]
                lines += ["else:", *_indented(third, names)] if third else []
    return lines


def _indented(block: list[object], names: Iterator[str]) -> list[str]:
    return ["    " + line for line in source_of(block, names)]


class Entered:
    def __enter__(self) -> None: ...

    def __exit__(self, *given: object) -> None: ...


def executed(lines: list[str], decisions: list[int]) -> tuple[list[str], str]:
    """The statements that Python runs, and how the function ends; each name decides by the next number what it does."""
    trace: list[str] = []
    left = list(decisions)

    def named(name: str, line: str) -> Callable[[], object]:
        def run() -> object:
            trace.append(name)
            decision = left.pop(0) if left else 0
            if decision == 3:
                raise Failure
            if line.startswith("for"):
                return range(decision)
            if line.startswith("with"):
                return Entered()
            return Failure() if line.startswith("raise") else decision > 0

        return run

    program = "def program():\n" + textwrap.indent("\n".join(lines), "    ") + "\n    s_end()\n"
    names = {word: named(word, line.strip()) for line in lines for word in _words(line)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SyntaxWarning)
        scope: dict[str, object] = {"Failure": Failure, "s_end": lambda: trace.append("s_end"), **names}
        exec(compile(program, "program", "exec"), scope)
    try:
        scope["program"]()  # type: ignore[operator]
    except Failure:
        return trace, "raised"
    if trace[-1:] == ["s_end"]:
        return trace[:-1], "end"
    return trace, "return"


def _words(line: str) -> list[str]:
    return [word for word in line.replace("(", " ").split() if word in _NAMES]


def quiet_ways(starts: list[Block]) -> set[Block]:
    """The blocks that come next, through such as have no name."""
    found = set(starts)
    waiting = [block for block in starts if not names_of(block)]
    while waiting:
        for edge in waiting.pop().edges:
            if edge.target not in found:
                found.add(edge.target)
                if not names_of(edge.target):
                    waiting.append(edge.target)
    return found


@settings(max_examples=300, deadline=None)
@given(_blocks(3, False), st.lists(st.integers(0, 3), max_size=30))
def test_whatever_python_does_is_a_way_through_the_graph(block: list[object], decisions: list[int]) -> None:
    lines = source_of(block, iter(_NAMES * 20))
    if len({word for line in lines for word in _words(line)}) < sum(len(_words(line)) for line in lines):
        return  # more statements than names
    trace, how = executed(lines, decisions)
    flow = Flow("\n".join(lines))
    here = [flow.graph.entry]
    for name in trace:
        here = [one for one in quiet_ways(here) if name in names_of(one)]
        assert here, (lines, trace, name)
        here = [edge.target for one in here for edge in one.edges]
    ends = {
        "raised": [flow.graph.raised],
        "end": [flow.graph.end],
        "return": [exit_ for _, exit_ in flow.graph.returns],
    }
    assert not quiet_ways(here).isdisjoint(ends[how]), (lines, trace, how)


def every_way(start: Block, ends: list[Block]) -> Iterator[list[Block]]:
    """Every way from a block to an end that comes to no block twice."""

    def on(way: list[Block]) -> Iterator[list[Block]]:
        if way[-1] in ends:
            yield way
        for edge in way[-1].edges:
            if edge.target not in way:
                yield from on([*way, edge.target])

    return on([start])


@settings(max_examples=60, deadline=None)
@given(_blocks(2, False))
def test_dominance_is_what_all_ways_have_in_common(block: list[object]) -> None:
    graph = Flow("\n".join(source_of(block, iter(_NAMES * 20)))).graph
    if len(graph.blocks) > 14:
        return  # too many ways to write them all down
    for second in graph.blocks:
        ways = list(every_way(graph.entry, [second]))
        ends = list(every_way(second, graph.exits))
        for first in graph.blocks:
            assert graph.dominates([first], second) is all(first in way for way in ways)
            assert graph.post_dominates([first], second) is all(first in way for way in ends)


@settings(max_examples=100, deadline=None)
@given(_blocks(2, False))
def test_blocks_stand_in_an_order_in_which_only_loops_lead_back(block: list[object]) -> None:
    graph = Flow("\n".join(source_of(block, iter(_NAMES * 20)))).graph
    number = {one: at for at, one in enumerate(graph.blocks)}

    def leads_back(edge: Edge) -> bool:
        return number[edge.target] <= number[edge.source]

    back = [edge for one in graph.blocks for edge in one.edges if leads_back(edge)]
    assert all(edge.kind is Kind.BACK for edge in back)
    assert all(graph.dominates([edge.target], edge.source) for edge in back)
