"""Loops that another callback can stop, by an attribute that says so."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_STOP = re.compile(r"cancel|stop|abort|preempt|halt", re.IGNORECASE)


def can_be_stopped(code: SourceCode, call: ApiCall) -> bool:
    """Whether the loop around a call asks for an attribute with a name such as ``cancel_requested`` which another
    function of the file sets to True."""
    loop, file_facts, function = code.loop(call), code.facts_at(call.file), code.function_at(call.place)
    if loop is None or file_facts is None:
        return False
    tests = [branch.test for branch in statements_of(loop.body, facts.If)]
    tests += [loop.test] if isinstance(loop, facts.While) else []
    asked = {name for test in tests for part in everything_in([test], facts.Attribute) if (name := part.attribute)}
    flags = {name for name in asked if _STOP.search(name)}
    return bool(flags) and any(
        isinstance(assignment.value, facts.Literal)
        and assignment.value.value is True
        and not flags.isdisjoint(target.attribute for target in assignment.targets)
        for other in everything_in(file_facts.body, facts.Function)
        if other is not function
        for assignment in statements_of(other.body, facts.Assign)
    )


__all__ = ["can_be_stopped"]
