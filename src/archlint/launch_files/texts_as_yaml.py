"""Descriptions of robots that a launch file gives to a node as a bare ``Command([…])``.

Source: ``evaluate_parameter_dict`` of launch_ros, in all distributions, reads the text of a substitution as YAML, and
stops where it is none; a ``ParameterValue`` with ``value_type=str`` takes it as it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.launch_files.launch_code import names_from_launch
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.kept_comments import comment_that_is_no_yaml
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_HANDS_ON = ("xacro", "cat")
"""The programs that print a description with its comments."""


@dataclass(frozen=True)
class TextAsYaml:
    """A parameter whose text is no YAML, as the ``mark`` in a comment of the description shows."""

    parameter: str
    place: Place
    comment: Place
    mark: str


def texts_as_yaml(workspace: WorkspaceIndex) -> Iterator[TextAsYaml]:
    """Each such parameter, with the first comment of the description that is no YAML."""
    described = {
        reference.place: reference.source
        for launched in workspace.launched
        for reference in launched.references
        if reference.source is not None and not reference.conditional and not reference.optional
    }
    for file, code in workspace.code.judged():
        if file.kind != "launch_python" or is_aside(workspace, file.relative):
            continue
        for parameter, command in _commands(code):
            source = described.get(Place(file.relative, *command.span))
            comment = None if source is None else comment_that_is_no_yaml(workspace.tree.text(source) or "")
            if source is not None and comment is not None:
                line, mark = comment
                place = Place(file.relative, *command.span)
                yield TextAsYaml(parameter, place, Place(source, line, 1, line, 1), mark)


def _commands(code: facts.Facts) -> Iterator[tuple[str, facts.Call]]:
    """The commands whose text is the value of a parameter of a node, each with its name."""
    classes = names_from_launch(code.body)
    assigned = assigned_values(code)
    for value in parameters_given(code, assigned):
        for mapping in everything_in([value], facts.Mapping):
            for key, given in zip(mapping.keys, mapping.values, strict=True):
                command = once_assigned(given, assigned)
                if not isinstance(key, facts.Literal) or key.text is None or not isinstance(command, facts.Call):
                    continue
                if classes.get(called_name(command)) == "Command" and prints_description(command, classes):
                    yield key.text, command


def assigned_values(code: facts.Facts) -> dict[str, list[facts.Expr]]:
    """What a file assigns to each variable."""
    assigned: dict[str, list[facts.Expr]] = {}
    for assign in everything_in(code.body, facts.Assign):
        for target in assign.targets:
            assigned.setdefault(target.variable, []).append(assign.value)
    return assigned


def parameters_given(code: facts.Facts, assigned: dict[str, list[facts.Expr]]) -> Iterator[facts.Expr]:
    """What stands in the lists of ``parameters=``, with the values of variables that are assigned once."""
    for call in everything_in(code.body, facts.Call):
        for argument in call.args:
            if argument.keyword == "parameters" and isinstance(argument.value, facts.Sequence):
                yield from (once_assigned(element, assigned) for element in argument.value.elements)


def once_assigned(value: facts.Expr, assigned: dict[str, list[facts.Expr]]) -> facts.Expr:
    """The value of a variable that is assigned once, or what stands there itself."""
    values = assigned.get(value.id, []) if isinstance(value, facts.Name) else []
    return values[0] if len(values) == 1 else value


def prints_description(command: facts.Call, classes: dict[str, str]) -> bool:
    """Whether a command prints a description as it is, or as xacro makes it."""
    first = command.args[0].value if command.args else None
    while isinstance(first, facts.Sequence) and first.elements:
        first = first.elements[0]
    if isinstance(first, facts.Call):
        named = everything_in([first], facts.Call)
        return any(classes.get(called_name(call)) == "FindExecutable" and _says_xacro(call) for call in named)
    return isinstance(first, facts.Literal) and (first.text or "").partition(" ")[0] in _HANDS_ON


def _says_xacro(call: facts.Call) -> bool:
    return any(literal.text == "xacro" for literal in everything_in([call], facts.Literal))


__all__ = ["TextAsYaml", "assigned_values", "once_assigned", "parameters_given", "prints_description", "texts_as_yaml"]
