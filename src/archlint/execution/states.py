"""What a callback does in one state of its node only: it leaves that state, so it does it once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import reach, without_exceptions
from archlint.syntax.parts import parts_of
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall


def leaves_its_state(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback comes to a call only while an attribute of ``self`` says so, and always changes it after::

        if self.state == 'OPENING':
            time.sleep(1.0)
            self.state = 'DONE'

    It may ask and change in different functions on its way; a counter (``self.left -= 1``) is no such state.
    """
    places = [*(frame.place for frame in call.chain), call.place]
    asked = {name for place in places for name in _asked(code, place)}
    return any(not asked.isdisjoint(_changed_after(code, place)) for place in places)


def _asked(code: SourceCode, place: Place) -> set[str]:
    """The attributes of ``self`` that decide whether a function comes to a place."""
    graph = graph_of(code.body_at(place))
    tests = [edge.test for edge in graph.outcomes(graph.evaluating(place.span)) if edge.test is not None]
    return {part.dotted for part in parts_of(tests, facts.Attribute) if part.value.variable == "self"}


def _changed_after(code: SourceCode, place: Place) -> set[str]:
    """The attributes that a function sets to something fixed after a place, whatever way it takes from there."""
    graph = graph_of(code.body_at(place))
    blocks = graph.evaluating(place.span)
    after = [edge.target for block in blocks for edge in block.edges if without_exceptions(edge)]
    following = reach(after, without_exceptions)
    return {
        target.dotted
        for assignment in statements_of(code.body_at(place), facts.Assign)
        if isinstance(assignment.value, facts.Literal) or assignment.value.dotted
        if (own := following.intersection(graph.of(assignment)))
        if all(graph.post_dominates(own, block, without_exceptions) for block in after)
        for target in assignment.targets
    }


__all__ = ["leaves_its_state"]
