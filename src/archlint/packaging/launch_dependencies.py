"""The packages that launch files need besides those of the nodes that they start: of files that they include, and of
the programs ``xacro`` and ``rviz2``, which a substitution or a process runs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.kinds import FileKind, FileStatus
from archlint.launch_files.launch_code import names_from_launch
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.launch.model import Included
    from archlint.systems.model import WorkspaceIndex

_PROGRAMS = frozenset({"rviz2", "xacro"})
"""The programs that the package of the same name installs into ``bin``, and no other one."""
_RUN_BY = frozenset({"Command", "ExecuteProcess", "FindExecutable"})


def packages_of_includes(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """The packages of the launch files that are included whatever the arguments are, each with its place: that of the
    include, or of the path in another file, which passes it on, or that calls the function which includes."""
    for launched in workspace.launched:
        for include in launched.included:
            reference = include.reference
            known = reference.package is not None and reference.status is not FileStatus.UNKNOWN
            if known and not include.dormant and not reference.conditional and not reference.optional:
                given = reference.given or include.place
                here = _called_at(workspace, include) or include.place
                yield given if given.file != include.place.file else here, reference.package or ""


def _called_at(workspace: WorkspaceIndex, include: Included) -> Place | None:
    """Where a function is called that includes a file of the package that it is given: its own file does not say which
    one."""
    package = include.reference.package or ""
    return None if workspace.code.mentions(include.place.file, package) else include.called_at


def packages_of_files(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """The packages in whose share folders launch files name files whatever the arguments are, each with its place: that
    of the path in the file that passes it as a launch argument, not where another file hands its argument on."""
    for launched in workspace.launched:
        arguments = {
            file.written: file.given or file.place for file in launched.references if file.kind is FileKind.ARGUMENT
        }
        named_by_callers = {row.reference for row in launched.included if _called_at(workspace, row) is not None}
        for file in launched.references:
            if file in named_by_callers:
                continue
            known = file.package is not None and file.status is not FileStatus.UNKNOWN
            if known and file.kind is not FileKind.ARGUMENT and not file.conditional and not file.optional:
                passed = arguments.get(file.written, file.place)
                in_place = file.place if passed.file == file.place.file else passed
                of_parameter = file.kind is FileKind.OTHER and file.name is not None
                yield in_place if of_parameter else file.given or in_place, file.package or ""


def runs_of_programs(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """Where a launch file in Python has a ``Command``, a ``FindExecutable`` or an ``ExecuteProcess`` for such a
    program, each with the package that has it."""
    for file, file_facts in workspace.code.asked_for():
        if file.kind != "launch_python":
            continue
        classes = names_from_launch(file_facts.body)
        for call in everything_in(file_facts.body, facts.Call):
            class_name = classes.get(call.func.last_name, "")
            word = _first_word(_command(class_name, call)) if class_name in _RUN_BY else ""
            if word in _PROGRAMS:
                yield Place(file.relative, *call.span), word


def _command(class_name: str, call: facts.Call) -> facts.Expr | None:
    """What a call is given to run: its ``cmd``, or else its first argument."""
    named = [argument.value for argument in call.args if argument.keyword == "cmd"]
    if class_name == "ExecuteProcess":
        return named[0] if named else None
    return call.args[0].value if call.args else None


def _first_word(value: facts.Expr | None) -> str:
    """The first word of a command as it is written: of a text, or of the first item of a list."""
    match value:
        case facts.Sequence(elements=[first, *_]):
            return _first_word(first)
        case facts.Literal(value=str(text)):
            return (text.split() or [""])[0]
    return ""


__all__ = ["packages_of_includes", "runs_of_programs"]
