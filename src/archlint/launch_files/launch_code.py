"""What the code of launch files says beside what a run with their defaults shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once, once_for_each_file
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_WRITERS = frozenset({"write_text", "write_bytes", "copy", "copy2", "copyfile"})


def writes_files(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a launch file may make the files that it names: it opens one to write, or copies one."""
    return workspace is not None and bool(_writes(workspace, file))


def names_from_launch(body: Sequence[facts.Stmt]) -> dict[str, str]:
    """What a file calls the classes that it imports from launch and launch_ros, with their own names."""
    imports = (i for i in everything_in(body, facts.ImportFrom) if i.module.split(".")[0] in ("launch", "launch_ros"))
    return {bound: name for i in imports for name, bound in i.names}


@once_for_each_file
def _writes(file_facts: facts.Facts) -> bool:
    for call in everything_in(file_facts.body, facts.Call):
        name = called_name(call)
        modes = (arg.value for arg in call.args[1:])
        texts = (str(mode.value) for mode in modes if isinstance(mode, facts.Literal))
        if name in _WRITERS or (name == "open" and any(text[:1] in ("w", "a", "x") for text in texts)):
            return True
    return False


def is_for_several_distros(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a launch file asks for the distribution: what one refuses, another wants."""
    return workspace is not None and workspace.code.mentions(file, "ROS_DISTRO")


@once
def words_of_launch_code(workspace: WorkspaceIndex) -> list[frozenset[str]]:
    """The texts in each launch file in Python: other arguments, or an event, may start what its defaults do not."""
    return [
        frozenset(str(literal.value) for literal in everything_in(file_facts.body, facts.Literal))
        for file, file_facts in workspace.code.asked_for()
        if file.kind == "launch_python"
    ]


@once
def started_programs(workspace: WorkspaceIndex) -> frozenset[tuple[str | None, str | None]]:
    """What launch files start, by package and executable; None for one that is not known."""
    return frozenset((s.package.text, s.executable.text) for launched in workspace.launched for s in launched.started)


def has_action_for(workspace: WorkspaceIndex, package: str | None, executable: str) -> bool:
    """Whether a module of a package has an action for an executable that launch files can use."""
    return any(
        workspace.code.mentions(path, executable) and workspace.code.mentions(path, "launch_ros")
        for path in workspace.code.files_of(package or "")
    )


_ADDING = frozenset({"LaunchDescription", "add_action", "add_entity"})


def listed_as(workspace: WorkspaceIndex, at: Place) -> tuple[str, Place] | None:
    """The variable that the action made at a place is kept in, and where ``LaunchDescription([…])`` lists it, or
    ``add_action()`` adds it; None where either is not written so."""
    file_facts = workspace.facts_at(at.file)
    body = [] if file_facts is None else file_facts.body
    names = [
        assign.targets[0].variable
        for assign in everything_in(body, facts.Assign)
        if len(assign.targets) == 1 and assign.span[:2] <= at.span[:2] and at.span[2:] <= assign.span[2:]
    ]
    for call in everything_in(body, facts.Call):
        if called_name(call) in _ADDING and len(names) == 1 and names[0]:
            listed = (part for argument in call.args for part in everything_in([argument.value], facts.Name))
            entry = next((part for part in listed if part.id == names[0]), None)
            if entry is not None:
                return entry.id, Place.of(at.file, entry.span)
    return None


def may_read_argument(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether code that the defaults pass by may read a launch argument: something in the file says its name that is
    no key of a dict, no name of a package, executable or node, and no text that a node, process or include is given."""
    texts = _texts(workspace, file)
    if texts is None:
        text = workspace.tree.text(file)
        return text is None or any(_stands_behind("$(", line, name) for line in text.split("\n"))
    return any(_says(text, name) for text in texts)


def _says(text: str, name: str) -> bool:
    return text == name or any(_stands_behind("$(", line, name) for line in text.split("\n"))


def _stands_behind(mark: str, line: str, name: str) -> bool:
    at = line.find(mark)
    return at >= 0 and name in line and re.compile(rf"(?<!\w){re.escape(name)}(?!\w)").search(line, at) is not None


_NAMES_OF_NODES = frozenset({"package", "executable", "name", "namespace", "plugin", "exec_name"})
_STARTS = frozenset(
    {"Node", "LifecycleNode", "ComposableNode", "ComposableLifecycleNode", "ComposableNodeContainer", "ExecuteProcess"}
)
_GIVEN = frozenset({"parameters", "arguments", "ros_arguments", "remappings", "cmd", "launch_arguments"})
"""Keywords for what actions pass on: a text there is a value."""


@once_for_each_file
def _texts(file_facts: facts.Facts) -> list[str]:
    names = {id(name) for name in _names(file_facts)}
    literals = (literal for literal in everything_in(file_facts.body, facts.Literal) if id(literal) not in names)
    return [literal.value for literal in literals if isinstance(literal.value, str)]


def _names(file_facts: facts.Facts) -> Iterator[facts.Expr | None]:
    """What names something else than a launch argument, or is passed on as it stands."""
    for mapping in everything_in(file_facts.body, facts.Mapping):
        yield from mapping.keys
    for call in everything_in(file_facts.body, facts.Call):
        if called_name(call) in _STARTS:
            yield from (arg.value for arg in call.args if arg.keyword in _NAMES_OF_NODES)
        for argument in call.args:
            if argument.keyword in _GIVEN:
                yield from _displayed(argument.value)


def _displayed(value: facts.Expr) -> Iterator[facts.Expr]:
    """A value, or what is in a display of lists, tuples and dicts, but not what a call in it is given."""
    match value:
        case facts.Sequence(elements=inner) | facts.Mapping(values=inner):
            for element in inner:
                yield from _displayed(element)
        case facts.Call(func=facts.Attribute(value=facts.Mapping() as mapping, attr="items")):
            yield from _displayed(mapping)
        case _:
            yield value


def listed_in(value: facts.Expr) -> set[str]:
    """The variables that are elements of a list anywhere in a value."""
    lists = everything_in([value], facts.Sequence)
    return {element.variable for each in lists for element in each.elements if element.variable}


__all__ = [
    "has_action_for",
    "is_for_several_distros",
    "listed_as",
    "listed_in",
    "may_read_argument",
    "names_from_launch",
    "started_programs",
    "words_of_launch_code",
    "writes_files",
]
