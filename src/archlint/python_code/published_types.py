"""Messages that code makes of one class and publishes with a publisher of another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.source_code import code_of
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in, parts_of

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


def is_published_as_another(workspace: WorkspaceIndex, place: Place, name: str) -> bool:
    """Whether what a class of this name is called for at a place goes to publishers of its function, all of which the
    file makes for other types."""
    around = code_of(workspace).function_at(place)
    types = _types_of_publishers(workspace, place.file) or {}
    body: Sequence[facts.Stmt] = () if around is None else around.body
    sent = [types.get(publisher) for publisher in _publishers_of(body, place)]
    return bool(sent) and all(type_names is not None and name not in type_names for type_names in sent)


def _publishers_of(body: Sequence[facts.Stmt], place: Place) -> Iterator[str]:
    """What publishes the object that is made at a place, at once or from a variable."""
    variables = {
        target.variable
        for statement in parts_of(body, facts.Assign)
        if isinstance(statement.value, facts.Call) and covers(statement.value.func, place.span)
        for target in statement.targets
    }
    for call in parts_of(body, facts.Call):
        match call:
            case facts.Call(func=facts.Attribute(value=publisher, attr="publish"), args=[facts.Argument(value=given)]):
                at_once = isinstance(given, facts.Call) and covers(given.func, place.span)
                if at_once or given.variable in variables - {""}:
                    yield publisher.dotted


@kept_for_each_file
def _types_of_publishers(code: facts.Facts) -> dict[str, set[str]]:
    """The names of the types for which a file makes the publishers of its variables and attributes."""
    types: dict[str, set[str]] = {}
    for statement in everything_in(code.body, facts.Assign):
        match statement.value:
            case facts.Call(func=facts.Attribute(attr="create_publisher"), args=[facts.Argument(value=type_), *_]):
                for target in statement.targets:
                    types.setdefault(target.dotted, set()).add(type_.last_name)
    return types


__all__ = ["is_published_as_another"]
