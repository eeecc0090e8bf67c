"""Commands of launch files that run something else than they should, and descriptions of robots that reach no node.

Source: ``Command`` of launch performs its parts and joins them as they are, then splits that into words (``shlex``), in
all distributions; ``Node`` of launch_ros takes a substitution in ``parameters=`` for the path of a file, and goes on
with a warning if there is none; it flattens a dict in a dict to names with a dot.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.launch_files.launch_code import names_from_launch
from archlint.launch_files.texts_as_yaml import assigned_values, once_assigned, parameters_given, prints_description
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PROGRAM = re.compile(r"(?:.*[\s/])?(xacro|xacro\.py|cat)")
_ARGUMENT = re.compile(r"\w+:=")
_GIVES_A_WORD = frozenset(
    {"FindPackageShare", "LaunchConfiguration", "PathJoinSubstitution", "get_package_share_directory", "join", "str"}
)
"""Calls whose texts neither begin nor end with a blank: paths, and values."""

_DESCRIPTIONS = frozenset({"robot_description", "robot_description_semantic"})


@dataclass(frozen=True)
class MisusedCommand:
    """A command of which the word at the end of a part and the beginning of the next are one, or, with no such
    ``word``, one that is given as a file of parameters."""

    place: Place
    word: str = ""
    is_argument: bool = False
    """Whether that word begins the second part, an argument of xacro, and is not the program."""


def misused_commands(workspace: WorkspaceIndex) -> Iterator[MisusedCommand]:
    """Those of the launch files in Python."""
    for file, code in workspace.code.judged():
        if file.kind != "launch_python" or is_aside(workspace, file.relative):
            continue
        classes = names_from_launch(code.body)
        if "Command" not in classes.values():
            continue
        assigned = assigned_values(code)
        for call in everything_in(code.body, facts.Call):
            if classes.get(called_name(call)) == "Command":
                for span, word, is_argument in _joined(call, classes, assigned):
                    yield MisusedCommand(Place(file.relative, *span), word, is_argument)
        for value in parameters_given(code, assigned):
            is_command = isinstance(value, facts.Call) and classes.get(called_name(value)) == "Command"
            if isinstance(value, facts.Call) and is_command and prints_description(value, classes):
                yield MisusedCommand(Place(file.relative, *value.span))


def descriptions_in_themselves(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """The descriptions of robots in the parameters of a launch file whose value is a dict that has the parameter
    already, each with the name of that: ``robot_description.robot_description`` is what the node gets."""
    for file, code in workspace.code.judged():
        if file.kind != "launch_python" or is_aside(workspace, file.relative):
            continue
        assigned = assigned_values(code)
        for value in parameters_given(code, assigned):
            for key, written in zip(value.keys, value.values, strict=True) if isinstance(value, facts.Mapping) else ():
                name, inner = _text(key), once_assigned(written, assigned)
                keys = inner.keys if isinstance(inner, facts.Mapping) else []
                if isinstance(key, facts.Literal) and name in _DESCRIPTIONS and [*map(_text, keys)] == [name]:
                    yield Place(file.relative, *key.span), name


def _joined(
    command: facts.Call, classes: dict[str, str], assigned: dict[str, list[facts.Expr]]
) -> Iterator[tuple[facts.Span, str, bool]]:
    """Where the program of a command runs into the next part, or an argument into the one before."""
    given = command.args[0].value if command.args else None
    if not isinstance(given, facts.Sequence):
        return
    parts = [once_assigned(part, assigned) for part in given.elements]
    for number, (before, part) in enumerate(itertools.pairwise(parts)):
        program = _program(before, classes) if number == 0 else None
        if program is not None and _begins_with_word(part):
            yield command.span, program, False
        argument = _ARGUMENT.match(part.text or "") if isinstance(part, facts.Literal) else None
        if program is None and isinstance(part, facts.Literal) and argument is not None and _ends_with_word(before):
            yield part.span, argument[0], True


def _program(part: facts.Expr, classes: dict[str, str]) -> str | None:
    """The program that the first part of a command ends with."""
    if isinstance(part, facts.Call) and classes.get(called_name(part)) == "FindExecutable":
        literals = everything_in([part], facts.Literal)
        return next((literal.text for literal in literals if literal.text in ("xacro", "cat")), None)
    match = _PROGRAM.fullmatch(_text(part) or "")
    return match and match[1]


def _begins_with_word(part: facts.Expr) -> bool:
    text = _text(part)
    return _gives_a_word(part) if text is None else bool(text) and not text[0].isspace()


def _ends_with_word(part: facts.Expr) -> bool:
    text = _text(part)
    return _gives_a_word(part) if text is None else bool(text) and not text[-1].isspace()


def _gives_a_word(part: facts.Expr) -> bool:
    return isinstance(part, facts.Call) and called_name(part) in _GIVES_A_WORD


def _text(part: facts.Expr | None) -> str | None:
    return part.text if isinstance(part, facts.Literal) else None


__all__ = ["MisusedCommand", "descriptions_in_themselves", "misused_commands"]
