"""Calls of a constructor that get no object: ``super.__init__('talker')``, ``Talker.__init__('talker')``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import classes_of
from archlint.python_code.offered_names import may_make_names
from archlint.python_code.own_calls import bindings_of
from archlint.python_code.tried_code import tried_for
from archlint.syntax import facts
from archlint.syntax.bare_super import bare_super_calls, calls_without_self
from archlint.syntax.parts import Itself

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def calls_of_bare_super(workspace: WorkspaceIndex) -> Iterator[Place]:
    """Every ``super.__init__(…)`` in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for span in _bare_super_calls(workspace, path) or ():
            yield Place(path, *span)


@kept_for_each_file
def _bare_super_calls(code: facts.Facts) -> list[facts.Span]:
    if "super" in bindings_of(code) or may_make_names(code):
        return []
    forgiven = tried_for(code.body, {"TypeError"})
    calls = (call for cls in classes_of(code) for call in bare_super_calls(cls))
    return [*dict.fromkeys(call.span for call in calls if Itself[facts.Base](call) not in forgiven)]


def constructors_without_self(workspace: WorkspaceIndex) -> Iterator[tuple[str, Place]]:
    """Every ``Talker.__init__('talker')`` in the files that were asked for, with its class."""
    for path in workspace.python_files():
        for name, span in _without_self(workspace, path) or ():
            yield name, Place(path, *span)


@kept_for_each_file
def _without_self(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    forgiven = tried_for(code.body, {"TypeError"})
    calls = (call for cls in classes_of(code) for call in calls_without_self(cls))
    return [(call.func.dotted, call.span) for call in calls if Itself[facts.Base](call) not in forgiven]


__all__ = ["calls_of_bare_super", "constructors_without_self"]
