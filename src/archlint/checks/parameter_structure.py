"""PRM009: parameter files that rcl refuses, for their structure, a list of several types or what is no value."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch_files.files_read_in_code import reader_in_code
from archlint.launch_files.refused_parameter_files import (
    ROOT,
    Misplaced,
    MisplacedIn,
    Misplacement,
    MixedList,
    NoValue,
    Refusal,
    SetTwice,
    misplaced_in_files,
    mixed_lists,
    refused_values,
    set_twice,
)
from archlint.launch_files.unloaded_parameter_files import has_no_reader, misplaced_in_unloaded, twice_in_unloaded
from archlint.suggestions import listed

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


@rule("PRM009", scope=Scope.LAUNCH_FILE)
def parameter_file_structure(system: System, options: Options) -> Iterator[Finding]:
    """Keys of parameter files without ``ros__parameters`` above them, or with it in the wrong place."""
    workspace = system.workspace
    told = [*_refused(system), *(_in_unloaded(system, workspace) if workspace is not None else ())]
    for diagnostic in told:
        yield replace(diagnostic, group=(*diagnostic.identity, str(diagnostic.place.line)))


@folds("PRM009", across_systems=True)
def given_by_several_launch_files(several: Sequence[Finding]) -> Finding:
    """One finding for a line of a file, however many launch files give the file to a node."""
    given = dict.fromkeys(row for told in several for row in told.related)
    return replace(several[0], related=tuple(given))


def _in_unloaded(system: System, workspace: WorkspaceIndex) -> Iterator[Finding]:
    """What is wrong with the files that no launch file here gives to a node: asked once, with the open system."""
    if system.launched is None:
        for key in misplaced_in_unloaded(workspace):
            unread = has_no_reader(workspace, key.file) or _is_to_be_filled(key.wrong)
            yield replace(_misplaced(system, key), severity=Severity.INFO if unread else Severity.WARNING)
        for diagnostic in map(_twice, twice_in_unloaded(workspace)):
            unread = has_no_reader(workspace, diagnostic.place.file)
            yield replace(diagnostic, severity=Severity.INFO) if unread else diagnostic


def _is_to_be_filled(wrong: Misplaced) -> bool:
    """Whether a file has a section with nothing in it, and nothing that stands there by mistake in its place."""
    return wrong.kind is Misplacement.NOTHING_BELOW and not wrong.other


def _misplaced(system: System, key: MisplacedIn) -> Finding:
    return finding(
        "PRM009",
        key.place,
        f"{_said(key.wrong)}: {_effect(key)}",
        help=_help(system, key),
        related=_given(key.given),
        identity=(key.file, key.wrong.kind, key.wrong.key),
    )


def _given(place: Place | None) -> tuple[Related, ...]:
    return () if place is None else (Related(place, "this file is given to it here"),)


def _refused(system: System) -> Iterator[Finding]:
    for key in misplaced_in_files(system):
        yield _misplaced(system, key)
    yield from map(_mixed, mixed_lists(system))
    yield from map(_no_value, refused_values(system))
    yield from map(_twice, set_twice(system))


def _twice(row: SetTwice) -> Finding:
    whom = f"'{row.user}'" if row.user else "a node"
    diagnostic = finding(
        "PRM009",
        row.place,
        f"'{row.name}' stands twice in this section: {whom} gets {row.last!r}, and never {row.value!r}{_too(row)}",
        help="remove the line that is not meant",
        related=(
            Related(row.last_place, "this one counts"),
            *_given(row.given),
            *(Related(place, f"'{name}' stands twice with two values, too") for name, place in row.others),
        ),
        identity=(row.file, "twice", row.name),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _too(row: SetTwice) -> str:
    names = listed([f"'{name}'" for name, _ in row.others])
    return f"; so it is with {names}" if row.others else ""


def _no_value(row: NoValue) -> Finding:
    whom = f"'{row.user}'" if row.user else "a node"
    name = row.refused.name
    stops = f"{whom} stops when it reads this file"
    message, help = {
        Refusal.EMPTY: (f"the parameter '{name}' has no value: {stops}", "give it a value, or remove the line"),
        Refusal.ALIAS: (f"'{name}' is an alias, and rcl has none: {stops}", "write the values out"),
        Refusal.NESTED: (f"'{name}' is a list of lists, and rcl has none: {stops}", "write all values in one list"),
        Refusal.MAPS: (
            f"'{name}' is a list of maps, which no parameter of ROS is",
            "give each map a key of its own instead of a dash",
        ),
    }[row.refused.kind]
    return finding(
        "PRM009",
        Place(row.file, *row.refused.span),
        message,
        help=help,
        related=(Related(row.given, "this file is given to it here"),),
        identity=(row.file, row.refused.kind, name),
    )


def _mixed(row: MixedList) -> Finding:
    whom = f"'{row.user}'" if row.user else "a node"
    numbers = set(row.types) == {"integer", "double"}
    return finding(
        "PRM009",
        row.place,
        f"the list '{row.name}' has items of the types {listed(row.types)}: {whom} stops when it reads this file",
        help="write a decimal point in each number of it" if numbers else "give all items of it one type",
        related=(
            Related(row.given, "this file is given to it here"),
            *(Related(place, f"'{name}' has items of several types, too") for name, place in row.others),
        ),
        identity=(row.file, "mixed", row.name),
    )


def _effect(key: MisplacedIn) -> str:
    whom = f"'{key.user}'" if key.user else "a node"
    return f"{whom} stops when it reads this file" if key.wrong.is_refused else f"{whom} never gets them"


def _said(wrong: Misplaced) -> str:
    match wrong.kind:
        case Misplacement.MISSPELT:
            return f"'{wrong.key}' is not '{ROOT}'"
        case Misplacement.NO_NODE:
            return f"there is no node name above '{ROOT}'"
        case Misplacement.NOTHING_BELOW:
            return f"no parameter stands below '{ROOT}'"
        case Misplacement.BESIDE:
            return f"'{wrong.key}' stands beside '{ROOT}', not below it"
        case Misplacement.TWICE:
            return f"there is another '{ROOT}' above this one, so the parameters below it are '{ROOT}.{wrong.other}' …"
        case Misplacement.LIST:
            return "this file is a list, and a parameter file begins with the names of nodes"
    return f"there is no '{ROOT}' above '{wrong.key}'"


def _help(system: System, key: MisplacedIn) -> str:
    wrong = key.wrong
    match wrong.kind:
        case Misplacement.MISSPELT:
            return f"write '{ROOT}', with two underscores"
        case Misplacement.NO_NODE if wrong.other:
            return f"indent '{ROOT}' so that it stands below '{wrong.other}'"
        case Misplacement.NO_NODE:
            return f"write '/**:' above it, or the name of the node, and indent '{ROOT}' and what follows"
        case Misplacement.NOTHING_BELOW if wrong.other:
            return f"indent '{wrong.other}' and what follows so that it stands below '{ROOT}'"
        case Misplacement.NOTHING_BELOW:
            return f"write '{ROOT}: {{}}' for a node without parameters"
        case Misplacement.BESIDE:
            return f"indent '{wrong.key}' so that it stands below '{ROOT}'"
        case Misplacement.LIST:
            return "hand the path over in the parameter by which the program reads it ('config_file' of a bridge)"
        case Misplacement.TWICE:
            return "move this section out, so that the name of its node starts in the first column"
    return _missing(system, key.file, wrong)


def _missing(system: System, file: str, wrong: Misplaced) -> str:
    reader = None if system.workspace is None or wrong.above else reader_in_code(system.workspace, file)
    if reader is not None:
        return f"give the node a file of its own: {posixpath.basename(reader)} reads this one as it is"
    if not wrong.above:
        return f"write '/**:' above the parameters, '{ROOT}:' below that, and indent them below both"
    first = wrong.above[0]
    has_sections = system.workspace is not None and bool(system.workspace.parameters_of(file).sections)
    if has_sections and not _is_node(system, first):
        return f"indent '{first}' so that it stands below the '{ROOT}' of a node"
    return f"write '{ROOT}:' below the name of the node, and indent the parameters below it"


def _is_node(system: System, key: str) -> bool:
    """Whether a key is the name of a node, or the namespace of one, or stands for any."""
    words = {word for node in system.nodes if node.name is not None for word in node.name.split("/")}
    return "*" in key or any(part in words for part in key.split("/") if part)
