"""Names that code of the workspace holds to a form, and where a name begins that goes through a helper."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.completeness import enclosing_function
from archlint.analysis.kept import kept, kept_for_each_file
from archlint.analysis.source_code import code_of
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Endpoint


def must_be_absolute(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether a function that the name goes through on its way to the create call raises where it is not absolute."""
    creation = endpoint.creation
    if workspace is None or creation.name.origin is None or creation.name.origin == creation.name_place:
        return False
    made_in = enclosing_function(workspace, endpoint.place)
    bodies: list[tuple[str, Sequence[facts.Stmt]]] = [(endpoint.place.file, [] if made_in is None else made_in.body)]
    bodies += [(frame.place.file, code_of(workspace).body_at(frame.place)) for frame in creation.chain]
    bodies += [(endpoint.place.file, body) for body in _kept_by(workspace, endpoint.place.file, bodies[0][1])]
    return any(_ends_in_demands(workspace, file, body) for file, body in bodies)


def _ends_in_demands(workspace: WorkspaceIndex, file: str, body: Sequence[facts.Stmt]) -> bool:
    """Whether a body, or a function that it gives something to, demands an absolute name."""

    def ask() -> bool:
        return _demands(body) or any(_demands(called_body) for called_body in _called(workspace, file, body))

    # Many names are made in one body, and a body keeps its statements, whose ids are nobody else's for as long.
    return kept(workspace, (_ends_in_demands, file, tuple(map(id, body))), ask)


def passed_from(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> Place | None:
    """The call that gives a helper the beginning of a name, where the helper writes down only how it goes on:
    ``f'{robot}/get_state'``; None where the name begins at the place that it has."""
    origin, chain = endpoint.creation.name.origin, endpoint.creation.chain
    if workspace is None or origin is None or not chain:
        return None
    first = (_variables_in_front(workspace, origin.file) or {}).get(origin.span)
    function = None if first is None else code_of(workspace).function_at(origin)
    given = [] if function is None else [param.name for param in function.params]
    return chain[-1].place if first in given else None


@kept_for_each_file
def _variables_in_front(code: facts.Facts) -> dict[facts.Span, str]:
    """The variables that format strings of a file begin with, by where these stand."""
    return {
        text.span: text.parts[0].value.variable
        for text in everything_in(code.body, facts.FormatString)
        if text.parts and isinstance(text.parts[0], facts.Field) and text.parts[0].value.variable
    }


def _kept_by(workspace: WorkspaceIndex, file: str, body: Sequence[facts.Stmt]) -> Iterator[Sequence[facts.Stmt]]:
    """The statements of a file that set what a body loops over: ``self.topics = checked(topics)`` for
    ``for topic in self.topics``."""
    kept = {loop.iterable.attribute for loop in statements_of(body, facts.For)} - {""}
    file_facts = workspace.facts_at(file)
    for assignment in everything_in([] if file_facts is None or not kept else file_facts.body, facts.Assign):
        if isinstance(assignment.value, facts.Call) and any(target.attribute in kept for target in assignment.targets):
            yield [assignment]


def _demands(body: Sequence[facts.Stmt]) -> bool:
    """Whether a body has ``if not name.startswith('/'): raise …``."""
    return any(
        any(isinstance(inner, facts.Raise) for inner in branch.body)
        and any(_is_relative(part) for part in parts_of(branch.test, facts.Unary))
        for branch in statements_of(body, facts.If)
    )


def _is_relative(test: facts.Unary) -> bool:
    asked = test.operand
    if test.op != "not" or not isinstance(asked, facts.Call):
        return False
    return called_name(asked) == "startswith" and [arg.value.text for arg in asked.args] == ["/"]


def _called(workspace: WorkspaceIndex, file: str, body: Sequence[facts.Stmt]) -> Iterator[Sequence[facts.Stmt]]:
    """The bodies of the functions that a body gives something to, be they of the same file or imported from one of the
    workspace."""
    given = {call.func.variable for call in calls_in(list(body)) if call.args} - {""}
    file_facts = workspace.facts_at(file)
    if file_facts is None:
        return
    sources = [(name, name, file_facts) for name in sorted(given)]
    for statement in (part for part in file_facts.body if isinstance(part, facts.ImportFrom)):
        other = workspace.code.imported(file, statement.module, statement.level)
        if other is not None:
            sources += [(bound, name, other) for name, bound in statement.names if bound in given]
    for _, name, where in sources:
        yield from (
            function.body for function in where.body if isinstance(function, facts.Function) and function.name == name
        )


__all__ = ["must_be_absolute", "passed_from"]
