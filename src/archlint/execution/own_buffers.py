"""Transforms that nobody misses while a callback waits: it alone looks into the buffer, and has done so by then."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.order import always_comes_before
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall, Creation, Program

_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_LISTENERS = frozenset({"TransformListener", "StaticTransformListener"})


def is_of_listener(code: SourceCode, creation: Creation) -> bool:
    """Whether a subscription is that of a transform listener."""
    listener = code.call_at(creation.place)
    return listener is not None and called_name(listener) in _LISTENERS


def fills_what_is_read_before(code: SourceCode, creation: Creation, call: ApiCall, program: Program) -> bool:
    """Whether a subscription is that of a transform listener whose buffer, an attribute of the node, serves nothing
    but lookups which the callback of a wait does before it waits."""
    listener = code.call_at(creation.place)
    file_facts = code.facts_at(creation.place.file)
    if listener is None or file_facts is None or called_name(listener) not in _LISTENERS or call.looped:
        return False
    buffer = next((given.value for given in listener.args if given.keyword in (None, "buffer")), None)
    if not isinstance(buffer, facts.Attribute) or buffer.value.variable != "self":
        return False
    name = buffer.attr
    uses = sum(attribute.attr == name for attribute in everything_in(file_facts.body, facts.Attribute))
    assignments = sum(
        any(target.attribute == name for target in assignment.targets)
        for assignment in everything_in(file_facts.body, facts.Assign)
    )
    lookups = {
        Place.of(creation.place.file, asked.span)
        for asked in everything_in(file_facts.body, facts.Call)
        if isinstance(asked.func, facts.Attribute) and asked.func.value.attribute == name
    }
    if not lookups or uses != assignments + 1 + len(lookups):
        return False  # it is used for something else, or by somebody else
    asked_in = [other for other in program.calls if other.api in _LOOKUPS and other.place in lookups]
    return lookups == {other.place for other in asked_in} and all(
        other.context.place == call.context.place and always_comes_before(code, other, call) for other in asked_in
    )


__all__ = ["fills_what_is_read_before", "is_of_listener"]
