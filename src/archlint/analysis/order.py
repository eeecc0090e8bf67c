"""What comes before a call on every way to it, in the function around it or in those that lead there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import without_exceptions

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall

_Path = tuple["Place", ...]
"""The calls that lead from the body of a callback to a call, that one last."""


def paths_to(call: ApiCall) -> Iterator[_Path]:
    """Each way from what runs to a call."""
    for chain in (call.chain, *(other for other, _, _ in call.call_chains)):
        yield (*(frame.place for frame in chain), call.place)


def always_comes_before(code: SourceCode, first: ApiCall, later: ApiCall) -> bool:
    """Whether a callback cannot get to a call without another one, be that in a function which it calls on its way."""
    return all(any(path_comes_before(code, path, other) for path in paths_to(first)) for other in paths_to(later))


def always_comes_after(code: SourceCode, last: ApiCall, earlier: ApiCall) -> bool:
    """Whether a callback that has come to a call goes on to another one, be that in a function which it then calls,
    unless something raises."""
    return all(any(_comes_after(code, path, other) for path in paths_to(last)) for other in paths_to(earlier))


def _comes_after(code: SourceCode, last: _Path, earlier: _Path) -> bool:
    shared = _shared(last, earlier)
    if shared is None:
        return False
    here, *inside = last[shared:]
    if here.file != earlier[shared].file:
        return False
    graph = graph_of(code.body_at(here))
    before, after = graph.evaluating(earlier[shared].span), graph.evaluating(here.span)
    follows = all(block not in after and graph.post_dominates(after, block, without_exceptions) for block in before)
    return bool(before and after) and follows and all(_always_runs(code, place) for place in inside)


def is_called_in_branches(code: SourceCode, call: ApiCall) -> bool:
    """Whether the helper that holds a call is reached only where an ``if`` comes out in one way, whoever calls it."""
    return all(any(is_in_branch(code, place) for place in path[:-1]) for path in paths_to(call))


def is_in_branch(code: SourceCode, place: Place) -> bool:
    """Whether a function comes to a place only where an ``if`` comes out in one way."""
    graph = graph_of(code.body_at(place))
    return any(isinstance(edge.source.statement, facts.If) for edge in graph.outcomes(graph.evaluating(place.span)))


def path_comes_before(code: SourceCode, first: _Path, later: _Path) -> bool:
    """Whether what runs cannot go one way to its end without having gone another one."""
    shared = _shared(first, later)
    if shared is None:
        return False
    here, *inside = first[shared:]
    return dominates(code, here, later[shared]) and all(_always_runs(code, place) for place in inside)


def _shared(path: _Path, other: _Path) -> int | None:
    """How many steps two ways have in common before they part; None where one of them goes on from the other."""
    steps = enumerate(zip(path, other, strict=False))
    return next((number for number, (here, there) in steps if here != there), None)


def dominates(code: SourceCode, first: Place, later: Place) -> bool:
    """Whether a function cannot get to a place without another one before."""
    if first.file != later.file:
        return False
    graph = graph_of(code.body_at(later))
    before, after = graph.evaluating(first.span), graph.evaluating(later.span)
    return bool(before and after) and all(block not in before and graph.dominates(before, block) for block in after)


def _always_runs(code: SourceCode, place: Place) -> bool:
    """Whether a function that does not raise always comes to a place."""
    graph = graph_of(code.body_at(place))
    blocks = graph.evaluating(place.span)
    return bool(blocks) and graph.post_dominates(blocks, graph.entry, without_exceptions)


def certainly_true(code: SourceCode, path: Sequence[Place]) -> Iterator[tuple[str, facts.Call]]:
    """The calls, each with its file, that have returned something true by the time a path is gone: ``if not
    client.wait_for_service(1.0): return`` precedes it."""
    for place in path:
        graph = graph_of(code.body_at(place))
        for edge in graph.outcomes(graph.evaluating(place.span)):
            if edge.test is not None:
                yield from ((place.file, call) for call in _true_calls(edge.test, edge.holds))


def _true_calls(test: facts.Expr, holds: bool) -> Iterator[facts.Call]:
    """The calls that are true where a condition comes out so."""
    match test:
        case facts.Unary(op="not"):
            yield from _true_calls(test.operand, not holds)
        case facts.Boolean() if (test.op == "and") is holds:
            for value in test.values:
                yield from _true_calls(value, holds)
        case facts.Compare(ops=["==" | "is"], comparators=[facts.Literal(value=bool(wanted))]):
            yield from _true_calls(test.left, wanted is holds)
        case facts.Assigned():
            yield from _true_calls(test.value, holds)
        case facts.Call() if holds:
            yield test


__all__ = [
    "always_comes_after",
    "always_comes_before",
    "certainly_true",
    "dominates",
    "is_called_in_branches",
    "is_in_branch",
    "path_comes_before",
    "paths_to",
]
