"""Which names the workspace gives to methods and attributes itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in

if TYPE_CHECKING:
    from archlint.syntax.expressions import Expr
    from archlint.systems.model import System, WorkspaceIndex

BY_NAME = frozenset({"getattr", "vars", "__dict__"})
"""With one of these an attribute may be used that is not written out."""


def is_defined_somewhere(system: System, file: str, name: str) -> bool:
    """Whether any file of the workspace defines a function of a name, assigns an attribute of it or names it in a text
    (``setattr``): an object may have got it from there.  True where a file cannot be read."""
    workspace = system.workspace
    if workspace is None:
        return True
    files = dict.fromkeys((file, *workspace.code.files_that_mention(name)))
    return any((defined := _defined(workspace, path)) is None or name in defined for path in files)


@kept_for_each_file
def _defined(code: facts.Facts) -> frozenset[str]:
    """The functions that a file defines, the attributes that it assigns, and its texts that may name one."""
    names: set[str] = set()
    for part in everything_in(code.body):
        match part:
            case facts.Function(name=name):
                names.add(name)
            case facts.Assign(targets=targets):
                names.update(target.attribute for target in targets if target.attribute)
            case facts.Literal(text=text) if text is not None and text.isidentifier():
                names.add(text)
    return frozenset(names)


def assigned_values(code: facts.Facts, attribute: str) -> list[Expr]:
    """All that a file assigns to an attribute of any object, in the order of the source."""
    return [
        assignment.value
        for assignment in everything_in(code.body, facts.Assign)
        if any(target.attribute == attribute for target in assignment.targets)
    ]


def is_named_only(workspace: WorkspaceIndex, file: str, attribute: str, times: int) -> bool:
    """Whether a file names an attribute so many times, and nothing else of the workspace does, nor can this file by a
    text.  False where the file cannot be read."""
    read = workspace.facts_at(file)
    if read is None:
        return False
    uses = sum(part.attribute == attribute for part in everything_in(read.body, facts.Attribute))
    others = any(other != file for other in workspace.code.files_that_mention(attribute))
    return uses == times and not others and names_in(read.body).isdisjoint(BY_NAME)


__all__ = ["BY_NAME", "assigned_values", "is_defined_somewhere", "is_named_only"]
