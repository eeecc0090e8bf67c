"""Where the code names its parameters, other than by a call that is followed."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.completeness import enclosing_function
from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node

_BY_NAME_UNSEEN = frozenset({"get_parameters_by_prefix", "get_parameters"})
"""Methods that may read any parameter."""


def names_listed(system: System, call: ApiCall) -> Iterator[tuple[str, Place]]:
    """The texts of the list that a call is given: ``get_parameters(['a', 'b'])``."""
    for given in source_code(system).arguments(call)[:1]:
        for item in given.value.elements if isinstance(given.value, facts.Sequence) else ():
            if isinstance(item, facts.Literal) and item.text is not None:
                yield item.text, Place.of(call.place.file, item.span)


def is_passed_on(system: System, call: ApiCall) -> bool:
    """Whether what a call is given first is a parameter of the function that makes it."""
    function = None if system.workspace is None else enclosing_function(system.workspace, call.place)
    params = set() if function is None else {param.name for param in function.params}
    return any(given.value.variable in params for given in source_code(system).arguments(call)[:1])


def is_named_again(workspace: WorkspaceIndex, declaration: ParameterDeclaration, name: str) -> bool:
    """Whether the name of a parameter stands anywhere else in its file, or the declaration's own result is used."""
    file_facts = workspace.facts_at(declaration.place.file)
    if file_facts is None or any(
        attribute.attr in _BY_NAME_UNSEEN for attribute in everything_in(file_facts.body, facts.Attribute)
    ):
        return True
    lines = (expression.value for expression in everything_in(file_facts.body, facts.Expression))
    spelled = (_plainly_declared(line, declaration, name) for line in lines if isinstance(line, facts.Call))
    written = next((text for text in spelled if text is not None), None)
    texts = (literal.text for literal in everything_in(file_facts.body, facts.Literal))
    return written is None or sum(text in (name, written) for text in texts) != 1


def _plainly_declared(call: facts.Call, declaration: ParameterDeclaration, name: str) -> str | None:
    """The name as a call itself spells it, which no loop does; None where another call declares it, or where its
    default is a value of the running node: such a one is declared for others to see."""
    for at, given in _rows(call):
        here = at[:2] == (declaration.place.line, declaration.place.column)
        text = given[0].text if here and given else None
        spells_it = text and (text == name or name.endswith(f".{text}"))
        if spells_it and not any(_of_the_running_node(value) for value in given[1:2]):
            return text
    return None


def _rows(call: facts.Call) -> Iterator[tuple[facts.Span, list[facts.Expr]]]:
    """What a call declares, each with its place, its name and its default: one parameter, or the entries of its
    list."""
    names_first = sorted(call.args, key=lambda argument: argument.keyword not in (None, "name"))
    yield call.span, [argument.value for argument in names_first]
    for row in (row for argument in call.args for row in argument.value.unpacked):
        if isinstance(row, facts.Sequence) and row.elements and isinstance(row.elements[0], facts.Literal):
            yield row.elements[0].span, row.elements


def _of_the_running_node(value: facts.Expr) -> bool:
    """``count``, ``self.count``"""
    owner, _, name = value.dotted.rpartition(".")
    return name != "" and owner in ("", "self")


def is_named_elsewhere(workspace: WorkspaceIndex, node: Node, declaration: ParameterDeclaration, name: str) -> bool:
    """Whether a file that knows this one, or that this one knows, speaks of the parameter: a subclass or a
    helper may read it."""
    if node.package is None:
        return False
    here, code = declaration.place.file, workspace.code
    return any(
        path != here
        and code.mentions(path, name)
        and (code.mentions(path, _stem(here)) or code.mentions(here, _stem(path)))
        for path in code.files_of(node.package)
    )


def _stem(path: str) -> str:
    return posixpath.splitext(posixpath.basename(path))[0]


__all__ = ["is_named_again", "is_named_elsewhere", "is_passed_on", "names_listed"]
