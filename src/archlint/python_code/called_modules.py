"""Modules that are called like the class or function in them: ``from robot import Arm``, ``Arm()``; ``import glob``,
``glob('launch/*')``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.called_values import files_that_run
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
    """A call of a module by the name that a file imports it as, and the file of the module: empty for one of Python's
    own."""

    place: Place
    name: str
    file: str
    has_own: bool
    """Whether the module defines a class or a function of its own name, so that this is what is meant."""
    builds: bool = False
    """Whether the file is a setup.py, so that the build stops."""


def called_modules(workspace: WorkspaceIndex) -> Iterator[CalledModule]:
    """Every such call in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for name, span in _calls(workspace, path) or ():
            file = module_meant_by(workspace, path, name)
            code = None if file is None else workspace.facts_at(file)
            if file is not None and code is not None and "modules" not in code.names:  # it may replace itself
                yield CalledModule(Place(path, *span), name, file, _defines(code, file))
    for path, builds in files_that_run(workspace):
        for name, span in _calls_of_python_s_own(workspace, path) or ():
            yield CalledModule(Place(path, *span), name, "", True, builds)


_LIKE_THEIR_FUNCTION = frozenset({"array", "bisect", "copy", "datetime", "fnmatch", "glob", "pprint", "random", "time"})
"""Python's own modules that have a function or a class of their name."""


@kept_for_each_file
def _calls_of_python_s_own(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    imports = (part for part in code.body if isinstance(part, facts.Import))
    own = {part.module for part in imports if not part.alias and part.module in _LIKE_THEIR_FUNCTION}
    return [row for row in _calls_of_imported(code) if row[0] in own] if own else []


def _defines(code: facts.Facts, file: str) -> bool:
    own = file.rpartition("/")[2].removesuffix(".py")
    return any(isinstance(each, (facts.Class, facts.Function)) and each.name == own for each in code.body)


@kept_for_each_file
def _calls(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    return _calls_of_imported(code)


def _calls_of_imported(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    """The calls of names that an import binds, and nothing else does."""
    names = frozenset[str]() if may_make_names(code) else imported_once(code)
    calls = [call for call in everything_in(code.body, facts.Call) if call.func.variable in names]
    forgiven = tried_for(code.body, {"TypeError", "Exception"}) if calls else set()
    return [(call.func.dotted, call.span) for call in calls if Itself[facts.Base](call) not in forgiven]


__all__ = ["CalledModule", "called_modules"]
