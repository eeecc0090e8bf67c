"""What code reads of objects of the workspace's classes, as far as a run has followed them, and no class gives them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.reach import judged_notes
from archlint.place import Place
from archlint.python_code.absent_members import AbsentMember, absent_of
from archlint.python_code.class_chains import ClassInFile, classes_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


def absent_of_objects(system: System) -> Iterator[AbsentMember]:
    """Every such read of a Python file that was asked for, outside of test code."""
    workspace = system.workspace
    if workspace is None:
        return
    asked_for = {*workspace.python_files()}
    reads = {(read.place, read.name): read for read in judged_notes(system, lambda program: program.absent_reads)}
    for place, name in sorted(reads):
        cls = _class_at(workspace, reads[place, name].cls) if place.file in asked_for else None
        called = place.span in (_called(workspace, place.file) or ())
        absent = None if cls is None else absent_of(workspace, cls, name, place, called)
        is_helper = place.file in workspace.code.helpers  # what is passed to one may be of several classes
        if absent is not None and (absent.near or not is_helper):
            yield absent


@kept_for_each_file
def _called(code: facts.Facts) -> list[facts.Span]:
    """Where the attributes stand that a file calls."""
    return [call.func.span for call in everything_in(code.body, facts.Call) if isinstance(call.func, facts.Attribute)]


def _class_at(workspace: WorkspaceIndex, place: Place) -> ClassInFile | None:
    file_facts = workspace.facts_at(place.file)
    for code in classes_of(file_facts) if file_facts is not None else ():
        if Place(place.file, *code.name_span) == place:
            return ClassInFile(place.file, code)
    return None


__all__ = ["absent_of_objects"]
