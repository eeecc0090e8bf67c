"""What a callback does in one state of its node only: it leaves that state, so it does it once."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, Edge, reach, without_exceptions
from archlint.syntax.flow_facts import outcome
from archlint.syntax.parts import parts_of
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall
    from archlint.syntax.flow_graph import Graph


def leaves_its_state(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback comes to a call only while an attribute of ``self`` says so, and always changes it after::

        if self.state == 'OPENING':
            time.sleep(1.0)
            self.state = 'DONE'

    It may ask and change in different functions on its way; a counter (``self.left -= 1``) is no such state.  A flag
    that it sets before and leaves so, ``if self.sent: return`` and then ``self.sent = True``, is one.
    """
    places = [*(frame.place for frame in call.chain), call.place]
    asked = {name for place in places for name in _asked(code, place)}
    if any(not asked.isdisjoint(_changed_after(code, place)) for place in places):
        return True
    tests = [edge for place in places for edge in _outcomes(code, place) if edge.test is not None]
    return any(
        edge.test is not None and outcome(edge.test, partial(_is_so, name, value)) is (not edge.holds)
        for place in places
        for name, value in _set_before(code, place).items()
        for edge in tests
    )


def _asked(code: SourceCode, place: Place) -> set[str]:
    """The attributes of ``self`` that decide whether a function comes to a place."""
    tests = [edge.test for edge in _outcomes(code, place) if edge.test is not None]
    return {part.dotted for part in parts_of(tests, facts.Attribute) if part.value.variable == "self"}


def _outcomes(code: SourceCode, place: Place) -> list[Edge]:
    """How conditions have come out on every way of a function to a place."""
    graph = graph_of(code.body_at(place))
    return graph.outcomes(graph.evaluating(place.span))


def _changed_after(code: SourceCode, place: Place) -> set[str]:
    """The attributes that a function sets to something fixed after a place, whatever way it takes from there."""
    graph = graph_of(code.body_at(place))
    after = _after(graph, place)
    following = reach(after, without_exceptions)
    return {
        target.dotted
        for assignment in statements_of(code.body_at(place), facts.Assign)
        if isinstance(assignment.value, facts.Literal) or assignment.value.dotted
        if (own := following.intersection(graph.of(assignment)))
        if all(graph.post_dominates(own, block, without_exceptions) for block in after)
        for target in assignment.targets
    }


def _set_before(code: SourceCode, place: Place) -> dict[str, facts.Literal]:
    """What a function has set attributes to once it comes to a place, where it does not set them after."""
    graph = graph_of(code.body_at(place))
    following = reach(_after(graph, place))
    blocks = graph.evaluating(place.span)
    before: dict[str, facts.Literal] = {}
    again: set[str] = set()
    for statement in statements_of(code.body_at(place)):
        own = graph.of(statement)
        if not following.isdisjoint(own):
            again.update(target.dotted for target in statement.assigned)
        match statement:
            case facts.Assign(targets=targets, value=facts.Literal() as value):
                if own and blocks and all(graph.dominates(own, block) for block in blocks):
                    before |= {target.dotted: value for target in targets if target.attribute}
    return {name: value for name, value in before.items() if name not in again}


def _is_so(name: str, value: facts.Literal, part: facts.Expr) -> bool | None:
    """How a part of a condition comes out where an attribute has a value; None where that says nothing of it."""
    match part:
        case facts.Compare(left=left, ops=["==" | "is"], comparators=[facts.Literal(value=other)]):
            return value.value == other if left.dotted == name else None
    return bool(value.value) if part.dotted == name else None


def _after(graph: Graph, place: Place) -> list[Block]:
    """What a function does next where a place raises nothing."""
    return [edge.target for block in graph.evaluating(place.span) for edge in block.edges if without_exceptions(edge)]


__all__ = ["leaves_its_state"]
