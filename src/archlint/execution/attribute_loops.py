"""Loops that go on until an attribute of a node changes, which only callbacks change that cannot run meanwhile."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.execution.attribute_changes import changing_callbacks
from archlint.execution.busy_flags import waits_for_busy_flag
from archlint.execution.loop_tests import awaited_attributes
from archlint.execution.waiting_functions import EndlessWait, Waiting, classes_of, waiting_functions, why_kept_out
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System


@dataclass(frozen=True, kw_only=True)
class AttributeLoop(EndlessWait):
    """A loop that nothing ends once it is entered; its place is that of its test."""

    loop: Place
    others: int
    """How many other callbacks change the attribute; none of them can run meanwhile, either."""


@once
def attribute_loops(system: System) -> list[AttributeLoop]:
    """The loops that wait for attributes of a node, and that nothing ends."""
    rows = [loop for program, waiting in waiting_functions(system) for loop in _loops_of(system, program, waiting)]
    first = {loop.place: loop for loop in sorted(rows, key=_by_place, reverse=True)}
    return [first[place] for place in sorted(first)]


def _by_place(loop: AttributeLoop) -> tuple[Place, bool, Place]:
    return loop.place, loop.waiting is None, loop.setter.place if loop.waiting is None else loop.waiting.place


def _loops_of(system: System, program: Program, waiting: Waiting) -> Iterator[AttributeLoop]:
    code = source_code(system).facts_at(waiting.file)
    if code is None:
        return
    for loop in statements_of(waiting.function.body, facts.While):
        awaited = awaited_attributes(loop, waiting.variable, code)
        attributes = [each for each in awaited if not waits_for_busy_flag(loop, each, code)]
        setters = _setters(system, program, waiting, attributes)
        reasons = [why_kept_out(system, waiting, setter, program) for _, setter in setters]
        if reasons and all(reasons):
            attribute, setter = setters[0]
            yield AttributeLoop(
                place=Place.of(waiting.file, _span_of(loop)),
                loop=Place.of(waiting.file, loop.span),
                waiting=waiting.callback,
                node=waiting.node,
                attribute=f"{waiting.variable}.{attribute}",
                setter=setter,
                others=len({callback.place for _, callback in setters}) - 1,
                why=reasons[0] or "",
            )


def _setters(
    system: System, program: Program, waiting: Waiting, attributes: Sequence[str]
) -> list[tuple[str, Callback]]:
    """What changes the attributes, each with one of them; none where something else may do so."""
    own = Place.of(waiting.file, waiting.function.name_span)
    classes = classes_of(system, waiting) if attributes else set()
    setters: list[tuple[str, Callback]] = []
    for attribute in attributes:
        callbacks = changing_callbacks(system, program, waiting.node, waiting.file, attribute, classes)
        if callbacks is None:
            return []
        setters += [(attribute, callback) for callback in callbacks if callback.place != own]
    return setters


def _span_of(loop: facts.While) -> facts.Span:
    """The test of a loop; all of it where the test has no place of its own."""
    return getattr(loop.test, "span", loop.span)


__all__ = ["AttributeLoop", "attribute_loops"]
