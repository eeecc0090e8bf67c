"""Plain values that functions of the workspace return, and code takes for objects: ``self.pose().x`` of a tuple."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.misused_kinds import ASKS, HAVE
from archlint.python_code.own_calls import function_meant, own_calls_of
from archlint.python_code.plain_kinds import Kind, kind_of, values_in
from archlint.python_code.tried_code import OF_A_WRONG_KIND, tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class LookedIntoResult:
    """``self.pose().x``, where ``pose()`` always returns a value of some ``kind``, ``returned`` at one place."""

    place: Place
    name: str
    kind: Kind
    attribute: str
    returned: Place


@dataclass(frozen=True)
class _Asked:
    """The attribute that is asked of the result of a call."""

    called: facts.Span
    attribute: str
    span: facts.Span


def looked_into_results(workspace: WorkspaceIndex) -> Iterator[LookedIntoResult]:
    """The first such line of each call in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        asked: dict[facts.Span, list[_Asked]] = {}
        for row in _asked(workspace, path) or ():
            asked.setdefault(row.called, []).append(row)
        for call in (own_calls_of(workspace, path) or ()) if asked else ():
            meant = function_meant(workspace, path, call) if call.span in asked else None
            returned = None if meant is None else _returned(meant.code)
            if meant is None or returned is None:
                continue
            kind, span = returned
            first = next((row for row in asked[call.span] if row.attribute not in HAVE[kind] | HAVE[Kind.NONE]), None)
            if first is not None:
                place, there = Place(path, *first.span), Place(meant.file, *span)
                yield LookedIntoResult(place, call.name, kind, first.attribute, there)


@once_for
def _returned(code: facts.Function) -> tuple[Kind, facts.Span] | None:
    """What a function returns wherever it returns something, and where it first does so."""
    if code.is_async or code.is_generator or code.decorators:
        return None
    values = values_in(code)
    rows = [
        (None if each.value is None else kind_of(each.value, values), each.span)
        for each in parts_of(code.body, facts.Return)
        if not (each.value is None or is_none(each.value))
    ]
    kinds = {kind for kind, _ in rows}
    kind = kinds.pop() if len(kinds) == 1 else None
    return (kind, rows[0][1]) if kind is not None and kind in HAVE else None


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _asked(code: facts.Facts) -> list[_Asked]:
    """What is asked of the results of calls, or of the one variable that gets them."""
    expecting = tried_for(code.body, OF_A_WRONG_KIND)
    rows: list[_Asked] = []
    bodies = [code.body, *(function.body for function in everything_in(code.body, facts.Function))]
    for body in bodies:
        kept = _kept_in(body)
        for part in parts_of(body, facts.Attribute):
            if Itself[facts.Base](part) in expecting or part.attr.startswith("__"):
                continue
            match part.value:
                case facts.Call(span=called):
                    rows.append(_Asked(called, part.attr, part.span))
                case facts.Name(id=name) if name in kept:
                    rows.append(_Asked(kept[name].span, part.attr, part.span))
    return rows


def _kept_in(body: Sequence[facts.Stmt]) -> dict[str, facts.Call]:
    """The variables of a body that get the result of one call and nothing else, and whose class nobody asks for."""
    calls = [call for call in everything_in(body, facts.Call) if call.func.last_name in ASKS]
    asked = {name.id for call in calls for name in everything_in([call], facts.Name)}
    asked |= {name for statement in everything_in(body, facts.Global) for name in statement.names}
    bound = list(names_bound(body))
    kept: dict[str, facts.Call] = {}
    for statement in parts_of(body, facts.Assign):
        match statement:
            case facts.Assign(targets=[facts.Name(id=name)], value=facts.Call() as call):
                if bound.count(name) == 1 and name not in asked:
                    kept[name] = call
    return kept


__all__ = ["LookedIntoResult", "looked_into_results"]
