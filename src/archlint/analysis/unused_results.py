"""Calls whose result nobody looks at."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import same_expression
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall
    from archlint.place import Place


def stands_alone(code: SourceCode, call: ApiCall) -> bool:
    """Whether a call is a line of its own: ``self.client.call(request)``."""
    return stands_alone_at(code, call.place)


def stands_alone_at(code: SourceCode, place: Place) -> bool:
    """Whether the call at a place is a line of its own."""
    statement = code.statement_at(place)
    return isinstance(statement, facts.Expression) and same_expression(statement.value, code.call_at(place))


def is_needed_to_return(code: SourceCode, call: ApiCall) -> bool:
    """Whether a function that is called for what it returns, by other code or by the server of a goal or a request,
    needs the result of a call for that: what comes later is too late."""
    function = code.function_at(call.place)
    is_asked = call.context.role in (Role.SERVICE, Role.EXECUTE) or bool(call.chain)
    if function is None or function.is_async or not is_asked or is_thrown_away(code, call):
        return False
    return any(end.value is not None for end in everything_in(function.body, facts.Return))


def is_thrown_away(code: SourceCode, call: ApiCall) -> bool:
    """Whether nobody looks at what a call says: it stands alone, or in a variable that nobody reads."""
    statement = code.statement(call)
    if not isinstance(statement, facts.Assign) or not same_expression(statement.value, code.expression(call)):
        return stands_alone(code, call)
    names = [target.variable for target in statement.targets]
    return all(names) and not _reads(code.body(call), names)


def _reads(body: Sequence[facts.Base], names: Sequence[str]) -> bool:
    """Whether code, that of the functions inside it too, reads one of some variables, or passes all of them on."""
    return any(_reads_one(fact, names) for fact in body)


def _reads_one(fact: facts.Base, names: Sequence[str]) -> bool:
    match fact:
        case facts.Name(id=name):
            return name in names or name in ("locals", "vars", "eval")
        case facts.Global(names=shared):
            return not set(names).isdisjoint(shared)
        case facts.Opaque(what=what):
            return what not in ("bytes", "huge integer")
        case facts.Assign(targets=targets, value=value):
            return _reads([value, *(target for target in targets if not target.variable)], names)
    return _reads(fact.children(), names)


__all__ = ["is_thrown_away", "stands_alone", "stands_alone_at"]
