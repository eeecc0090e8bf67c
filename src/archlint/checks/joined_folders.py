"""LCH004: folders that are joined without what belongs between them, a slash or, in a search path, a colon."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding
from archlint.launch.kinds import FileKind
from archlint.packaging.absent_packages import is_nowhere

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.mistakes import JoinedFolder
    from archlint.launch.named_files import FileReference
    from archlint.systems.model import System

WHAT = {
    FileKind.LAUNCH: "launch file",
    FileKind.PARAMETERS: "parameter file",
    FileKind.RVIZ: "RViz configuration",
    FileKind.READ: "file",
    FileKind.OTHER: "file",
    FileKind.ARGUMENT: "file",
}
_JOINED = re.compile(
    r"\$\(find-pkg-(?P<folder>share|prefix) (?P<package>[\w.-]+)\)(?P<rest>(?P<word>[A-Za-z][\w-]*).*)", re.DOTALL
)
"""A path right behind the folder of a package.  One that begins with ``_description`` may lead to another package."""


def joined_folders(system: System) -> Iterator[Finding]:
    """Files and search paths of which a launch file joins the parts like that."""
    launched = system.launched
    if launched is None:
        return
    for reference in launched.references:
        joined = _JOINED.fullmatch(reference.written or "")
        if joined is None or not is_joined_wrongly(system, reference):
            continue
        rest, package, place = joined["rest"], joined["package"], decided_at(reference)
        yield finding(
            "LCH004",
            place,
            f"the {WHAT[reference.kind]} '{rest}' stands right behind the {joined['folder']} folder of '{package}', so "
            f"that this looks for '…/{package}{rest}'",
            help=f"write '/{rest}', or join the two with os.path.join()"
            if place.file.endswith(".py")
            else f"write '/{rest}'",
            identity=(package, rest),
            group=("joined", package, rest),
        )
    yield from (_in_search_path(row) for row in launched.joined_folders if _is_wrong(system, row))


def is_joined_wrongly(system: System, reference: FileReference) -> bool:
    """Whether a slash is missing in the path of a file: no package could have the name that comes of it."""
    joined = _JOINED.fullmatch(reference.written or "")
    return joined is not None and _is_no_package(system, f"{joined['package']}{joined['word']}")


def decided_at(reference: FileReference) -> Place:
    """Where the name of a file is written, an argument's default say, unless that is inside of what uses it."""
    use, given = reference.place, reference.given
    if given is None or given.file != use.file:
        return given or use
    starts = (use.line, use.column) <= (given.line, given.column)
    ends = (given.end_line, given.end_column) <= (use.end_line, use.end_column)
    return use if starts and ends else given


def _is_no_package(system: System, name: str) -> bool:
    return system.workspace is not None and is_nowhere(system.workspace, name)


def _is_wrong(system: System, row: JoinedFolder) -> bool:
    if row.separator == ":" or row.after.startswith("…"):
        return True
    return _is_no_package(system, f"{row.before}{row.after}".rpartition("/")[2])


def _in_search_path(row: JoinedFolder) -> Finding:
    parts = ["what it was before" if part == row.variable else f"'{part}'" for part in (row.before, row.after)]
    if row.separator == ":":
        message = (
            f"{row.variable} gets {parts[0]} and {parts[1]} without a colon between them: where it was set, the two "
        )
        message, help = f"{message}become one folder that is not there", "write ':' between them"
    elif row.after.startswith("…"):
        message = f"{row.variable} gets {parts[0]} in front of the folder {parts[1]}: there is no such folder"
        help = f"write '/{row.before}' behind the folder"
    else:
        message = f"{row.variable} gets {parts[1]} right behind the folder {parts[0]}: there is no such folder"
        help = f"write '/{row.after}'"
    return finding(
        "LCH004",
        row.place,
        message,
        help=help,
        identity=(row.variable, f"{row.before} {row.after}"),
        group=("joined", row.variable, f"{row.before} {row.after}"),
    )


__all__ = ["WHAT", "decided_at", "is_joined_wrongly", "joined_folders"]
