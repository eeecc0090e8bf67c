"""Parameters that one function declares twice on the node that it is given, by a name that it makes of a prefix.

Nobody knows the whole name, and it is the same for both: ``node->declare_parameter(prefix + ".rate", 1.0)``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.given_nodes import given_nodes
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DECLARES = "declare_parameter"
_ASKS = frozenset({"has_parameter", "undeclare_parameter"})


@dataclass(frozen=True)
class DoubledDeclaration:
    """The second declaration of a name in a function, and the first one."""

    place: Place
    first: Place
    name: str
    """As the code has it: ``prefix + '.rate'``."""


def doubled_declarations(workspace: WorkspaceIndex) -> Iterator[list[DoubledDeclaration]]:
    """Those of each function of C++ that always come one after the other."""
    for path in workspace.code.cpp_files_that_mention(_DECLARES):
        code = None if workspace.roles.is_test(path) else workspace.code.cpp_facts_at(path)
        for rows in () if code is None else _doubled_in(code):
            yield [DoubledDeclaration(Place(path, *later), Place(path, *first), name) for later, first, name in rows]


@once_for
def _doubled_in(code: facts.Facts) -> list[list[tuple[facts.Span, facts.Span, str]]]:
    functions = [_of_function(function) for function in everything_in(code.body, facts.Function)]
    return [rows for rows in functions if rows]


def _of_function(function: facts.Function) -> list[tuple[facts.Span, facts.Span, str]]:
    if any(part.attr in _ASKS for part in everything_in(function.body, facts.Attribute)):
        return []
    nodes = given_nodes(function)
    lasting = {param.name for param in function.params} - _changed(function) if nodes else set[str]()
    first: dict[tuple[str, str, str], facts.Span] = {}
    rows: list[tuple[facts.Span, facts.Span, str]] = []
    for statement in function.body:
        if isinstance(statement, facts.Return):
            break
        if not isinstance(statement, facts.Assign | facts.Expression):
            continue
        for call in parts_of(statement, facts.Call):
            match call:
                case facts.Call(
                    func=facts.Attribute(value=facts.Name(id=node), attr="declare_parameter"),
                    args=[
                        facts.Argument(
                            value=facts.Binary(
                                op="+", left=facts.Name(id=prefix), right=facts.Literal(value=str(ending))
                            )
                        ),
                        *_,
                    ],
                ) if node in nodes and {node, prefix} <= lasting:
                    before = first.setdefault((node, prefix, ending), call.span)
                    if before is not call.span:
                        rows.append((call.span, before, f"{prefix} + '{ending}'"))
    return rows


def _changed(function: facts.Function) -> set[str]:
    """The variables that a function assigns, or of which it calls a method that may change a text."""
    assigned = {
        target.id
        for part in everything_in(function.body, facts.Assign)
        for target in part.targets
        if isinstance(target, facts.Name)
    }
    called = {
        part.value.id
        for part in everything_in(function.body, facts.Attribute)
        if isinstance(part.value, facts.Name) and part.attr in _CHANGES
    }
    more = {
        part.target.id for part in everything_in(function.body, facts.Augmented) if isinstance(part.target, facts.Name)
    }
    return assigned | called | more


_CHANGES = frozenset({"append", "assign", "clear", "erase", "insert", "pop_back", "push_back", "replace", "resize"}) | {
    *("reset", "swap"),
}

__all__ = ["DoubledDeclaration", "doubled_declarations"]
