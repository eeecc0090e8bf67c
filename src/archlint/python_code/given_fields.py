"""Messages inside messages that are given to functions of the workspace which take numbers apart:
``to_euler(msg.pose.orientation)`` and ``x, y, z, w = q``.

Source: as for :mod:`~archlint.python_code.message_operations`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.field_operations import Deed, FieldOperation, deeds_in, fields_read, goes_wrong, held_in
from archlint.python_code.own_calls import FunctionInFile, function_meant, own_calls_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex

_TAKES_APART = frozenset({"unpacks", "takes out of", "goes through"})
_MAY_BE_LEFT_OUT = (facts.If, facts.While, facts.Try, facts.Match)


@dataclass(frozen=True)
class GivenField:
    """Such an argument of a call of ``name``: what is done there at a place with the ``parameter`` that gets it."""

    operation: FieldOperation
    name: str
    parameter: str
    done: Place


def given_fields(system: System) -> Iterator[GivenField]:
    """Each such argument, where only such messages come to it and the function surely takes them apart."""
    workspace, uses = system.workspace, fields_read(system)
    if workspace is None:
        return
    for file in sorted({file for file, *_ in uses}):
        for name, meant, value, parameter in _arguments(workspace, file):
            use, kind = uses.get((file, *value.span), (None, None))
            deed = _deed_to(meant.code, parameter)
            if use is not None and kind is not None and deed is not None and held_in(kind) == "message":
                what, by, span = deed
                operation = FieldOperation(Place(file, *value.span), use, "message", kind.name, what, "", by)
                yield GivenField(operation, name, parameter, Place(meant.file, *span))


def _arguments(workspace: WorkspaceIndex, file: str) -> Iterator[tuple[str, FunctionInFile, facts.Attribute, str]]:
    """The fields that calls in a file give to functions of the workspace, and the parameters that get them."""
    code = workspace.facts_at(file)
    calls = {} if code is None else {call.span: call for call in everything_in(code.body, facts.Call)}
    for own in (own_calls_of(workspace, file) or ()) if calls else ():
        call = calls.get(own.span)
        given = () if call is None else [each for each in call.args if isinstance(each.value, facts.Attribute)]
        meant = function_meant(workspace, file, own) if given else None
        if call is None or meant is None or meant.code.is_async or meant.code.is_generator:
            continue
        own_params = [each.name for each in meant.code.params[meant.bound :] if each.kind in _BY_POSITION]
        for at, argument in enumerate(call.args):
            parameter = argument.keyword or (own_params[at] if at < len(own_params) else "")
            if isinstance(argument.value, facts.Attribute) and parameter:
                yield own.name, meant, argument.value, parameter


_BY_POSITION = frozenset({"positional_only", "normal"})


def _deed_to(code: facts.Function, parameter: str) -> tuple[Deed, str, facts.Span] | None:
    """How a function surely takes a parameter apart that it binds to nothing else."""
    return _deeds(code).get(parameter)


@once_for
def _deeds(code: facts.Function) -> dict[str, tuple[Deed, str, facts.Span]]:
    params = {param.name for param in code.params}.difference(names_bound(code.body))
    sure = [*_sure(code.body)] if params else []
    rows: dict[str, tuple[Deed, str, facts.Span]] = {}
    for deed, other, by, value, span in deeds_in(code) if sure else ():
        wrong = value.variable in params and deed in _TAKES_APART and goes_wrong("message", deed, other, by)
        if wrong and any(covers(statement, span) for statement in sure):
            rows.setdefault(value.variable, (deed, by, span))
    return rows


def _sure(body: Sequence[facts.Stmt]) -> Iterator[facts.Assign | facts.Expression | facts.For | facts.Return]:
    """The statements that a function begins with, up to the first that asks for something."""
    for statement in body:
        if isinstance(statement, _MAY_BE_LEFT_OUT) or any(map(_chooses, everything_in([statement]))):
            return
        if isinstance(statement, (facts.Assign, facts.Expression, facts.For, facts.Return)):
            yield statement


def _chooses(part: facts.Base) -> bool:
    return isinstance(part, (facts.Conditional, facts.Boolean, *_MAY_BE_LEFT_OUT))


__all__ = ["GivenField", "given_fields"]
