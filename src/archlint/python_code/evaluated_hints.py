"""The annotations of functions in which Python looks names up as it defines the function."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.pinned import ubuntu_releases
from archlint.python_code.signatures import hints_are_postponed
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_BEFORE_PYTHON_3_14 = frozenset({"focal", "jammy", "noble"})
"""The releases of Ubuntu whose Python does not put off what an annotation says."""
_WITH_TYPE_PARAMETERS = r"^\s*(?:(?:async\s+)?def|class)\s+\w+\s*\["
"""``def first[Item](items: list[Item])``: names that the facts of a file do not tell of."""


def evaluates_hints(workspace: WorkspaceIndex, path: str, code: facts.Facts) -> bool:
    """Whether a name in an annotation of a file's functions has to be there when the function is defined."""
    if hints_are_postponed(code) or not ubuntu_releases(workspace) <= _BEFORE_PYTHON_3_14:
        return False
    return not workspace.tree.lines_with(path, _WITH_TYPE_PARAMETERS)


def hints_of(part: facts.Function | facts.Lambda | facts.Class) -> list[facts.Expr]:
    """The annotations of a function, which the code around it evaluates unless that is put off."""
    if not isinstance(part, facts.Function):
        return []
    return [each for each in (*(param.annotation for param in part.params), part.returns) if each is not None]


__all__ = ["evaluates_hints", "hints_of"]
