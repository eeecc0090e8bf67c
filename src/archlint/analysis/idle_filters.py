"""Filters of message_filters that no callback and no other filter can ever get anything from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.own_names import is_named_only
from archlint.analysis.reach import calls_of, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.unused_results import is_thrown_away
from archlint.libraries.tables.noted import SYNCHRONIZERS
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System


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
            made_here = same_expression(statement.value, code.expression(call))
            return made_here and is_named_only(workspace, call.place.file, name, times=1)
    return False


__all__ = ["idle_filters"]
