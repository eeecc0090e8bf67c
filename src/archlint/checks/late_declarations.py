"""LCH003: launch arguments that are read before the action that declares them has run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.launch_files.launch_code import listed_as

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.mistakes import UndeclaredUse
    from archlint.systems.model import WorkspaceIndex

LATE = "late"
"""What the declarations of a file that come too late have in common: one change of the order mends them all."""


def late_declaration(workspace: WorkspaceIndex | None, use: UndeclaredUse, declared: Place) -> Finding:
    """What to move where.  A declaration may be created early, and yet come late in the ``LaunchDescription``; what
    reads it may be a variable that is given to an action further down."""
    entry, reader = (
        (None, None) if workspace is None else (listed_as(workspace, declared), listed_as(workspace, use.read_at))
    )
    created, read = Related(declared, "it is declared here"), Related(use.place, f"'{use.name}' is read here")
    if entry is not None and reader is not None:
        place, listed = entry[1], reader[1]
        help = f"put '{entry[0]}' before '{reader[0]}' in the LaunchDescription: actions run in that order"
        related = [created, read, Related(listed, f"'{reader[0]}' comes before it")]
    elif declared.span > use.place.span and _holds(use.read_at, use.place):
        place, related = use.place, [created]
        help = "move the declaration before this line: actions run in order"
    else:
        place = declared if entry is None else entry[1]
        related = [created, read, Related(use.read_at, "for this action")]
        help = "put the declaration before what reads it in the LaunchDescription: actions run in that order"
    return finding(
        "LCH003",
        place,
        f"the launch argument '{use.name}' is read before it is declared",
        help=help,
        related=[row for row in dict.fromkeys(related) if row.place != place],
        identity=(use.file, use.name),
        group=(use.file, LATE),
    )


def _holds(outer: Place, inner: Place) -> bool:
    return outer.file == inner.file and outer.span[:2] <= inner.span[:2] and inner.span[2:] <= outer.span[2:]


__all__ = ["LATE", "late_declaration"]
