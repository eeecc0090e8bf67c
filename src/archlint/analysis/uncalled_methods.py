"""Methods that nothing calls: left over from a tutorial, or waiting for a caller."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_named_by_launch
from archlint.analysis.left_over import idle_callers, idle_methods
from archlint.analysis.source_code import code_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex


def uncalled_method(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """The name of the method that holds a place, where its own file does not name it again, and no other Python file
    has a word for the module and for the method or one that leads to it; None for any other place.  A file that has a
    method of that name itself, and does not import the module or asks ``self`` alone for it, means its own."""
    if workspace is None:
        return None
    function = code_of(workspace).function_at(place)
    if function is None or function.name not in idle_methods(workspace, place.file):
        return None
    leading = sorted(idle_callers(workspace, place.file, function.name))
    is_called = any(is_called_elsewhere(workspace, place.file, name) for name in leading)
    return None if is_called else function.name


def uncalled_main(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """``main`` where a place is in the function of that name of a module which does not call it, no installed program
    starts with and no other file asks for it; None for any other place.  What a module calls that others import, below
    ``if __name__ == '__main__':`` alone, tried it out."""
    file_facts = None if workspace is None else workspace.facts_at(place.file)
    if workspace is None or file_facts is None or place.file in workspace.code.installed_programs:
        return None
    installs = workspace.installs.get(workspace.package_of(place.file) or "")
    if installs is None or installs.open_executables:
        return None
    function = code_of(workspace).function_at(place)
    if function is None or function.name != _MAIN or all(function is not each for each in file_facts.body):
        return None
    stem = posixpath.basename(place.file).removesuffix(".py")
    tried_out = place.file in workspace.code.in_use and not is_named_by_launch(workspace, stem)
    guard = main_guard(file_facts) if tried_out else None
    code = [each for each in file_facts.body if each is not guard]
    named = any(name.id == _MAIN for name in everything_in(code, facts.Name))
    return None if named or is_called_elsewhere(workspace, place.file, _MAIN) else _MAIN


def is_in_trial(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place is in the block below ``if __name__ == '__main__':`` of a module that installed programs import,
    and is none itself: its author tried it out there once."""
    file_facts = None if workspace is None else workspace.facts_at(place.file)
    guard = None if file_facts is None else main_guard(file_facts)
    if workspace is None or guard is None or not guard.span[0] <= place.line <= guard.span[2]:
        return False
    return is_tried_alone(workspace, place.file)


def is_tried_alone(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether installed programs import a file that is none itself: what it does as one is a trial."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or installs.open_executables or file in workspace.code.installed_programs:
        return False
    stem = posixpath.basename(file).removesuffix(".py")
    return file in workspace.code.in_use and not is_named_by_launch(workspace, stem)


_MAIN = "main"


def is_called_elsewhere(workspace: WorkspaceIndex, file: str, method: str) -> bool:
    """Whether another Python file may call a method of one: it has a word for both."""
    module, code = posixpath.basename(file).removesuffix(".py"), workspace.code
    others = (other for other in code.files_that_mention(method) if other != file)
    return any(code.mentions(other, module) and _may_call(workspace, other, file, method) for other in others)


def is_asked_of_others(workspace: WorkspaceIndex, file: str, method: str) -> bool:
    """Whether another Python file asks an object that is not its own for a method of that name (``self.robot.turn()``):
    it need not name the module of a class whose object it is given, or that the package offers by another name."""
    return any(
        part.attr == method and part.dotted != f"self.{method}"
        for other in workspace.code.files_that_mention(method)
        if other != file and (code := workspace.facts_at(other)) is not None
        for part in everything_in(code.body, facts.Attribute)
    )


def _may_call(workspace: WorkspaceIndex, file: str, module: str, method: str) -> bool:
    """Whether a file may call the method of a module.  One that has a method of that name, and asks nothing else than
    ``self`` for it, means its own."""
    file_facts = workspace.facts_at(file)
    if file_facts is None or all(each.name != method for each in everything_in(file_facts.body, facts.Function)):
        return True
    asked = [each for each in everything_in(file_facts.body, facts.Attribute) if each.attr == method]
    of_itself = all(each.dotted == f"self.{method}" for each in asked) and not workspace.code.mentions(file, "getattr")
    return not of_itself and module in workspace.code.reached_from([file])


__all__ = [
    "is_asked_of_others",
    "is_called_elsewhere",
    "is_in_trial",
    "is_tried_alone",
    "uncalled_main",
    "uncalled_method",
]
