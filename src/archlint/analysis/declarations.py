"""Declarations of parameters: which of them surely run, and whether their types hold."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.completeness import enclosing_function
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from collections.abc import Iterable

    from archlint.model import ParameterDeclaration
    from archlint.systems.model import WorkspaceIndex


def surely_run_both(workspace: WorkspaceIndex, declaration: ParameterDeclaration, other: ParameterDeclaration) -> bool:
    """Whether the constructor of a node surely comes to both declarations."""
    return all(not is_guarded(workspace, each) and _is_of_constructor(workspace, each) for each in (declaration, other))


def _is_of_constructor(workspace: WorkspaceIndex, declaration: ParameterDeclaration) -> bool:
    if any(frame.caller.rpartition(".")[2] == "__init__" for frame in declaration.chain):
        return True
    function = enclosing_function(workspace, declaration.place)
    return function is not None and function.name == "__init__"


def is_guarded(workspace: WorkspaceIndex | None, declaration: ParameterDeclaration) -> bool:
    """Whether the function asks ``has_parameter``, or catches what a second declaration raises."""
    function = None if workspace is None else enclosing_function(workspace, declaration.place)
    if function is None:
        return False
    asked = (attribute.attr for attribute in everything_in(function.body, facts.Attribute))
    if any(name in ("has_parameter", "undeclare_parameter") for name in asked):
        return True
    tried = (statement.span for statement in everything_in(function.body, facts.Try))
    return any(span[0] <= declaration.place.line <= span[2] for span in tried)


def may_be_dynamic(workspace: WorkspaceIndex | None, declarations: Iterable[ParameterDeclaration]) -> bool:
    """Whether a file of the declarations speaks of dynamic typing: then no type is certain."""
    files = {declaration.place.file for declaration in declarations}
    return workspace is None or any(workspace.code.mentions(file, "dynamic_typing") for file in files)


def is_of_variable(workspace: WorkspaceIndex | None, declared: ParameterDeclaration) -> bool:
    """Whether C++ takes the type from a variable, which may be a ``double`` that was given a whole number."""
    place = declared.place
    if workspace is None or place.file.endswith((".py", ".yaml", ".yml")):
        return False
    lines = (workspace.tree.text(place.file) or "").splitlines()[place.line - 1 : place.end_line]
    return not any(re.search(rf"(?<![\w.]){declared.default}(?![\w.])|<\s*(?:\w+::)*u?int", line) for line in lines)


__all__ = ["is_guarded", "is_of_variable", "may_be_dynamic", "surely_run_both"]
