"""Guards on the way to a wait that the code opens which ends the wait: once past them, there is nothing to wait for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.walk import called_name, is_none, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall


def is_behind_its_setter(code: SourceCode, wait: ApiCall, setting: Sequence[ApiCall]) -> bool:
    """Whether a wait for an event is reached only with an attribute that the functions assign that set the event::

        if self.pose is None:
            return
        self.ready.wait()  # on_pose() has set it together with the pose

    An event that is cleared again says nothing of that.
    """
    if _is_cleared(code, wait) or not setting:
        return False
    places = (wait.place, *(frame.place for frame in wait.chain))
    asked = {name for place in places for name in asked_before(code.body_at(place), place)}
    asked -= _assigned_elsewhere(code, wait, setting)
    return all(asked & set(_assigned(statements_of(code.body(call), facts.Assign))) for call in setting)


def _assigned_elsewhere(code: SourceCode, wait: ApiCall, setting: Sequence[ApiCall]) -> set[str]:
    """The attributes that something else in the file assigns, too: they say nothing of the event."""
    file_facts = code.facts_at(wait.file)
    own = {assignment.span for call in setting for assignment in statements_of(code.body(call), facts.Assign)}
    every = everything_in(() if file_facts is None else file_facts.body, facts.Assign)
    return set(_assigned(assignment for assignment in every if assignment.span not in own))


def _is_cleared(code: SourceCode, wait: ApiCall) -> bool:
    expression, file_facts = code.expression(wait), code.facts_at(wait.file)
    if expression is None or file_facts is None:
        return True
    event = _owner(expression)
    calls = everything_in(file_facts.body, facts.Call)
    new = {Itself(call) for call in _while_made(file_facts.body)}  # an event that is new is not set
    again = (call for call in calls if called_name(call) == "clear" and Itself(call) not in new)
    return not event or any(_owner(call) == event for call in again)


def _while_made(body: Sequence[facts.Stmt]) -> Iterator[facts.Call]:
    """The calls of a file that constructors make themselves, before anything can be waited for."""
    for function in everything_in(body, facts.Function):
        if function.name == CONSTRUCTOR:
            yield from parts_of(function.body, facts.Call)


def _owner(call: facts.Call) -> str:
    """``ready`` of ``self.ready.wait()``."""
    return call.func.value.last_name if isinstance(call.func, facts.Attribute) else ""


def _assigned(assigns: Iterable[facts.Assign]) -> Iterator[str]:
    """The attributes that are assigned something other than None."""
    for assignment in assigns:
        if not is_none(assignment.value):
            yield from (
                target.dotted for target in assignment.targets if isinstance(target, facts.Attribute) and target.dotted
            )


def asked_before(body: Sequence[facts.Stmt], place: Place) -> Iterator[str]:
    """The names that must be something, not None, for a function to get to a place."""
    graph = graph_of(body)
    for edge in graph.outcomes(graph.evaluating(place.span)):
        if edge.test is not None:
            yield from _present(edge.test) if edge.holds else _missing(edge.test)


def _missing(test: facts.Expr) -> Iterator[str]:
    """The names that are something where a condition does not hold: ``x`` of ``x is None`` and of ``not x``."""
    match test:
        case facts.Compare(left=left, ops=["is"] | ["=="], comparators=[other]) if is_none(other):
            yield left.dotted
        case facts.Unary(op="not", operand=operand):
            yield operand.dotted
        case facts.Boolean(op="or", values=values):
            for value in values:
                yield from _missing(value)


def _present(test: facts.Expr) -> Iterator[str]:
    """The names that are something where a condition holds."""
    match test:
        case facts.Compare(left=left, ops=["is not"] | ["!="], comparators=[other]) if is_none(other):
            yield left.dotted
        case facts.Compare(left=left, ops=["is"] | ["=="], comparators=[facts.Literal(value=True)]):
            yield left.dotted
        case facts.Boolean(op="and", values=values):
            for value in values:
                yield from _present(value)
        case _:
            yield test.dotted


__all__ = ["asked_before", "is_behind_its_setter"]
