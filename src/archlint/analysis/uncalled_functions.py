"""Functions at the top of files that no code calls: left over, or their only call stands in a comment."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, kept_for_each_file
from archlint.analysis.uncalled_methods import is_tried_alone
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex

_HOPS = 3
"""Through how many functions that call each other it is looked for one that something calls."""
_PATH = re.compile(r"[\w.:]+")
"""What may name a function in a text: ``car.drive:main``."""
_AS_PROGRAM = "__main__"
_BY_OTHERS = frozenset({"main", "generate_launch_description"})
"""Functions that others call by their names."""


def uncalled_function(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """The name of the function at the top of a file that holds a place, where no code of Python here has a word for it
    but what stands in itself and in other such functions; None for any other place.  Who imports it and does not name
    it again does not call it."""
    code = None if workspace is None else workspace.facts_at(place.file)
    if workspace is None or code is None:
        return None
    functions = [part for part in code.body if isinstance(part, facts.Function)]
    around = [part for part in functions if part.span[0] <= place.line <= part.span[2]]
    if len(around) != 1 or around[0].decorators or around[0].name in _BY_OTHERS:
        return None
    name = around[0].name
    return name if _is_idle(workspace, place.file, name) else None


def _is_idle(workspace: WorkspaceIndex, file: str, name: str, depth: int = _HOPS) -> bool:
    return kept(workspace, (_is_idle, file, name, depth), lambda: all(_are_idle(workspace, file, name, depth)))


def _are_idle(workspace: WorkspaceIndex, file: str, name: str, depth: int) -> Iterator[bool]:
    """For all that may name the function of a file, whether nothing calls that."""
    yield name not in _started(workspace)
    for other in _may_call(workspace, file, name):
        by_text = workspace.code.kind_of(other) == "python"  # in a launch file it is that of an executable
        for owner, names, texts in _uses(workspace, other) or ():
            if (name in names or (by_text and name in texts)) and owner != name:
                if owner == _AS_PROGRAM:
                    yield is_tried_alone(workspace, other)
                else:
                    yield owner not in ("", *_BY_OTHERS) and depth > 0 and _is_idle(workspace, other, owner, depth - 1)


def _may_call(workspace: WorkspaceIndex, file: str, name: str) -> list[str]:
    """The files that have a word for a function and for its module, that one among them; all that have one for the
    function, where any imports it: another may have it from there."""
    module = posixpath.basename(file).removesuffix(".py")
    launch_files = (each for each in workspace.launch_files.all() if each.endswith(".py"))
    files = [*workspace.code.files_that_mention(name), *launch_files]
    naming = [each for each in files if workspace.code.mentions(each, name)]
    if any(name in (_imported(workspace, each) or ()) for each in naming if each != file):
        return naming
    return [each for each in naming if each == file or workspace.code.mentions(each, module)]


@kept_for_each_file
def _imported(code: facts.Facts) -> list[str]:
    """What a file imports from others, as it is called there; a star may be anything."""
    return [name for part in everything_in(code.body, facts.ImportFrom) for name, _ in part.names]


def _started(workspace: WorkspaceIndex) -> frozenset[str]:
    """The functions that installed programs start with."""
    every = (each for installs in workspace.installs.values() for each in installs.executables.values())
    return kept(workspace, _started, lambda: frozenset(each.function or "" for each in every))


@kept_for_each_file
def _uses(code: facts.Facts) -> list[tuple[str, list[str], list[str]]]:
    """What the functions at the top of a file name, in code and in texts, what it does as a program, and what
    all of its rest (``""``); imports under the same name call nothing."""
    rows: list[tuple[str, list[str], list[str]]] = []
    guard = main_guard(code)
    for statement in code.body:
        owner = statement.name if isinstance(statement, facts.Function) and not statement.decorators else ""
        owner = _AS_PROGRAM if statement is guard else owner
        every = [*everything_in([statement])]
        texts = (part.value for part in every if isinstance(part, facts.Literal) and isinstance(part.value, str))
        words = {word for text in texts if _PATH.fullmatch(text) for word in re.split(r"\W+", text)}
        froms = (part for part in every if isinstance(part, facts.ImportFrom))
        renamed = {name for part in froms for name, bound in part.names if name != bound}
        rows.append((owner, sorted(names_in([statement]) | renamed), sorted(words)))
    return rows


__all__ = ["uncalled_function"]
