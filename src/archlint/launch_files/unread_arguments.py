"""Launch arguments that a launch file declares and that nothing it starts reads."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once, once_for_each_file
from archlint.analysis.pinned import may_be_on_focal
from archlint.launch.parameter_sources import ParameterFileUse
from archlint.launch.parameters import from_yaml
from archlint.launch_files.launch_code import may_read_argument
from archlint.launch_files.misread_arguments import misread_arguments
from archlint.launch_files.well_known_includes import named_in_parameters, taken_by
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name
from archlint.systems.overrides import settings_of

if TYPE_CHECKING:
    from archlint.launch.model import DeclaredArgument, Launched
    from archlint.systems.model import System, WorkspaceIndex


def all_readers_are_known(launched: Launched) -> bool:
    """Whether everything is seen that may read a launch argument while a file is launched."""
    includes_others = any(include.reference.source is None for include in launched.included)
    if includes_others or launched.gaps or launched.ros1 or not launched.is_launch_file or launched.reads_any:
        return False
    return not _substitutes_in_parameters(launched)


def _substitutes_in_parameters(launched: Launched) -> bool:
    """Whether parameter files may read any configuration."""
    return any(
        isinstance(parameter, ParameterFileUse) and parameter.substitutions
        for started in launched.started
        for parameter in started.parameters
    )


def _include_readers_are_known(workspace: WorkspaceIndex, launched: Launched) -> bool:
    """The same where well-known files are included that are not here."""
    others = [include for include in launched.included if include.reference.source is None]
    if any(taken_by(include) is None for include in others) or may_be_on_focal(workspace):
        return False
    return not (launched.gaps or launched.ros1 or launched.reads_any or _substitutes_in_parameters(launched))


def unread_arguments(system: System) -> Iterator[DeclaredArgument]:
    """The arguments that the launch file of a system declares, and that neither it nor what it includes reads."""
    launched, workspace = system.launched, system.workspace
    if launched is None or workspace is None:
        return
    if not (all_readers_are_known(launched) or _include_readers_are_known(workspace, launched)):
        return
    elsewhere = {name for include in launched.included for name in taken_by(include) or ()}
    if elsewhere:
        elsewhere |= named_in_parameters(workspace)
    if launched.undeclared or not (launched.started or elsewhere):
        return  # one of these may be the argument, misspelt; or the file declares arguments for those that include it
    others = _read_where_included(workspace).get(launched.file, frozenset())
    misread = {row.declared for row in misread_arguments(workspace, launched.file)}
    for argument in launched.declared:
        if argument.file != launched.file or argument.name in launched.read or argument.name in others:
            continue
        if argument.name in misread or argument.name in elsewhere:
            continue  # LCH003 says by which name it is read, or a file that is not here reads it
        if _is_of_library(launched, argument):
            continue
        if not may_be_read(workspace, launched, argument.name) and not _is_kept_on_purpose(workspace, argument):
            yield argument


def unread_argument_meant(
    workspace: WorkspaceIndex, launched: Launched, name: str, file: str
) -> DeclaredArgument | None:
    """The only argument that a file declares and that nothing reads, of those that a name which it does not declare may
    stand for: a copied line reads ``base_yaml`` where the file has ``arm_yaml``."""
    kind = _last_word(name)
    alike = [
        argument
        for argument in launched.declared
        if argument.file == file and argument.name not in launched.read and _last_word(argument.name) == kind
    ]
    return alike[0] if len(alike) == 1 and not may_be_read(workspace, launched, alike[0].name) else None


def _last_word(name: str) -> str:
    return re.split(r"[_\-.]", name)[-1]


_ON_PURPOSE = re.compile(r"\b(?:compat\w*|deprecated|ignored|no longer used|not used|unused)\b", re.IGNORECASE)
"""Words of a comment that says why nothing reads an argument."""


def _is_kept_on_purpose(workspace: WorkspaceIndex, argument: DeclaredArgument) -> bool:
    """Whether a comment above the declaration of an argument, or above the variable that holds it, says why it is still
    there."""
    kept = kept_for_nothing(workspace, argument)
    lines = (workspace.tree.text(argument.file) or "").splitlines()
    starts = [argument.place.line, *([] if kept is None else [kept[1].line])]
    return any(_ON_PURPOSE.search(comment) for start in starts for comment in _comment_above(lines, start))


def _comment_above(lines: Sequence[str], number: int) -> Iterator[str]:
    """The lines of the comment that ends above a line, which is counted from 1."""
    for line in reversed(lines[: number - 1]):
        if not line.lstrip().startswith(("#", "<!--")):
            return
        yield line


def _is_of_library(launched: Launched, argument: DeclaredArgument) -> bool:
    """Whether a function from outside of the workspace declares an argument: no code of the workspace made it."""
    return argument.file.endswith(".py") and (argument.file, argument.name) not in launched.written


@once
def _read_where_included(workspace: WorkspaceIndex) -> dict[str, frozenset[str]]:
    """The arguments that launches read which include a launch file, by that file: includes are not scoped."""
    read: dict[str, set[str]] = {}
    for launched in (*workspace.launched, *workspace.launched_alone.values()):
        for file in launched.sources[1:]:
            read.setdefault(file, set()).update(launched.read)
    return {file: frozenset(names) for file, names in read.items()}


def may_be_read(workspace: WorkspaceIndex, launched: Launched, name: str) -> bool:
    """Whether any code of a launch may read an argument, be it where the run did not come to, such as a function of a
    module that a launch file imports."""
    imported = workspace.code.reached_from(launched.sources)
    return any(_may_read(workspace, file, name) for file in (*launched.sources, *sorted(imported)))


def _may_read(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether code that the run did not come to may read an argument: the file says its name at other places than where
    it declares it, or keeps a ``LaunchConfiguration`` that it then leaves alone."""
    spare = _without_effect(workspace, file)
    if spare is None:
        return may_read_argument(workspace, file, name) or _stands_in_braces(workspace.tree.text(file) or "", name)
    said = _said(workspace, file) or Counter()
    return said[name] > spare[name]


def _stands_in_braces(text: str, name: str) -> bool:
    """``${name}``, which is meant to read it."""
    return re.search(rf"\$\{{[^}}\n]*\b{re.escape(name)}\b", text) is not None


@once_for_each_file
def _said(file_facts: facts.Facts) -> Counter[str]:
    """How often each text stands in a file, but for keys of dicts."""
    keys = {id(key) for mapping in everything_in(file_facts.body, facts.Mapping) for key in mapping.keys}
    literals = (literal for literal in everything_in(file_facts.body, facts.Literal) if id(literal) not in keys)
    return Counter(literal.value for literal in literals if isinstance(literal.value, str))


@once_for_each_file
def _without_effect(file_facts: facts.Facts) -> Counter[str]:
    """How often each text names an argument where it is declared, or in a configuration that nothing uses."""
    spare: Counter[str] = Counter()
    for call in everything_in(file_facts.body, facts.Call):
        if called_name(call) == "DeclareLaunchArgument":
            spare.update(first_text(call))
    for _, call in _kept_for_nothing(file_facts):
        spare.update(first_text(call))
    return spare


def _kept_for_nothing(file_facts: facts.Facts) -> Iterator[tuple[facts.Name, facts.Call]]:
    """The variables that hold a configuration and that nothing uses."""
    names = Counter(part.id for part in everything_in(file_facts.body, facts.Name))
    for assign in everything_in(file_facts.body, facts.Assign):
        match assign:
            case facts.Assign(targets=[facts.Name(id=name) as variable], value=facts.Call() as call):
                if called_name(call) == "LaunchConfiguration" and names[name] == 1:
                    yield variable, call


def kept_for_nothing(workspace: WorkspaceIndex, argument: DeclaredArgument) -> tuple[str, Place] | None:
    """The variable of a launch file that holds an argument and that nothing uses, and where it is."""
    file_facts = workspace.facts_at(argument.file) if argument.file.endswith(".py") else None
    for variable, call in () if file_facts is None else _kept_for_nothing(file_facts):
        if argument.name in first_text(call):
            return variable.id, Place(argument.file, *variable.span)
    return None


def first_text(call: facts.Call) -> list[str]:
    """The name that a call is given first, or by name."""
    values = [argument.value for argument in call.args if argument.keyword in ("name", "variable_name")]
    values = values or [argument.value for argument in call.args[:1] if argument.keyword is None]
    return [value.text for value in values if value.text is not None]


def is_text_that_yaml_reads(system: System, argument: DeclaredArgument) -> bool:
    """Whether the launch file writes the default of an argument as a text into a parameter of its name, and launch
    would make something else of it where the argument is read there: ``'0001'`` becomes a number."""
    launched, workspace = system.launched, system.workspace
    default = None if argument.default is None else argument.default.text
    if launched is None or workspace is None or default is None or isinstance(from_yaml(default), str):
        return False
    return any(
        setting.written is None and (setting.name, setting.value) == (argument.name, default)
        for started in launched.started
        for setting in settings_of(started, workspace.parameters_of)
    )


__all__ = [
    "all_readers_are_known",
    "first_text",
    "is_text_that_yaml_reads",
    "kept_for_nothing",
    "may_be_read",
    "unread_argument_meant",
    "unread_arguments",
]
