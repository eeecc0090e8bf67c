"""Waits of a loop over clients."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import targets_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall


def is_for_each_client(code: SourceCode, call: ApiCall) -> bool:
    """Whether a ``for`` loop around the call goes through clients: each round waits for the server of another."""
    expression = code.expression(call)
    method = None if expression is None else expression.func
    if not isinstance(method, facts.Attribute) or not method.value.variable:
        return False
    loops = (loop for loop in code.loops(call) if isinstance(loop, facts.For))
    return any(target.variable == method.value.variable for loop in loops for target in targets_in(loop.target))
