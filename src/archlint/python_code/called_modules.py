"""Modules of the workspace that are called like the class or function in them: ``from robot import Arm``, ``Arm()``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.imported_modules import imported_once, module_meant_by
from archlint.python_code.offered_names import may_make_names
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class CalledModule:
    """A call of a module by the name that a file imports it as, and the file of the module."""

    place: Place
    name: str
    file: str
    has_own: bool
    """Whether the module defines a class or a function of its own name, so that this is what is meant."""


def called_modules(workspace: WorkspaceIndex) -> Iterator[CalledModule]:
    """Every such call in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for name, span in _calls(workspace, path) or ():
            file = module_meant_by(workspace, path, name)
            code = None if file is None else workspace.facts_at(file)
            if file is not None and code is not None and "modules" not in code.names:  # it may replace itself
                yield CalledModule(Place(path, *span), name, file, _defines(code, file))


def _defines(code: facts.Facts, file: str) -> bool:
    own = file.rpartition("/")[2].removesuffix(".py")
    return any(isinstance(each, (facts.Class, facts.Function)) and each.name == own for each in code.body)


@kept_for_each_file
def _calls(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    """The calls of names that an import binds, and nothing else does."""
    names = frozenset[str]() if may_make_names(code) else imported_once(code)
    calls = [call for call in everything_in(code.body, facts.Call) if call.func.variable in names]
    forgiven = tried_for(code.body, {"TypeError", "Exception"}) if calls else set()
    return [(call.func.dotted, call.span) for call in calls if Itself[facts.Base](call) not in forgiven]


__all__ = ["CalledModule", "called_modules"]
