"""Filters of message_filters that no callback and no other filter can ever get anything from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.reach import calls_of, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.unused_results import is_thrown_away
from archlint.libraries.tables.noted import SYNCHRONIZERS
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_BY_NAME = frozenset({"getattr", "vars", "__dict__"})
"""With one of these an attribute may be used that is not written out."""


def idle_filters(system: System) -> list[tuple[Program, ApiCall]]:
    """The calls that make a synchronizer which nothing keeps, or which is kept where nobody asks for it again."""
    code = source_code(system)
    return [
        (program, call)
        for program, call in calls_of(system, SYNCHRONIZERS)
        if is_thrown_away(code, call) or _is_only_kept(system, code, call)
    ]


def _is_only_kept(system: System, code: SourceCode, call: ApiCall) -> bool:
    """Whether an attribute of ``self`` keeps it that no file names again."""
    statement, workspace = code.statement(call), system.workspace
    if workspace is None or workspace.package_of(call.place.file) is None or not isinstance(statement, facts.Assign):
        return False  # of files outside of packages nobody knows which use which
    match statement.targets:
        case [facts.Attribute(value=facts.Name(id="self"), attr=name)]:
            read = workspace.facts_at(call.place.file)
            if read is None or not same_expression(statement.value, code.expression(call)):
                return False
            uses = [part for part in everything_in(read.body, facts.Attribute) if part.attr == name]
            others = [file for file in workspace.code.files_that_mention(name) if file != call.place.file]
            return len(uses) == 1 and not others and names_in(read.body).isdisjoint(_BY_NAME)
    return False


__all__ = ["idle_filters"]
