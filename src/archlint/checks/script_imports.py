"""PKG004: what scripts that CMake installs import from beside them, and do not find there once they are installed."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.packaging.left_out_code import LeftOut
from archlint.packaging.left_out_scripts import modules_beside_scripts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

BESIDE = "beside"
"""The group of all modules that one CMake file leaves out so."""
_SHOWN = 5
"""How many imports are related."""


def imports_of_scripts(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for each module that is not installed beside the scripts that import it."""
    by_file: dict[str, list[LeftOut]] = {}
    for row in modules_beside_scripts(workspace):
        by_file.setdefault(row.file, []).append(row)
    for file, rows in by_file.items():
        yield _left_behind(workspace, file, rows)


def _left_behind(workspace: WorkspaceIndex, file: str, rows: list[LeftOut]) -> Finding:
    [first, *others] = rows
    installs = workspace.installs[first.package]
    name = posixpath.basename(file)
    more = f" and {len(others)} more script{'s' * (len(others) > 1)}" if others else ""
    imports = "import" if others else "imports"
    below = file if installs.folder == "." else file.removeprefix(f"{installs.folder}/")
    return finding(
        "PKG004",
        installs.executables[first.entry].place,
        f"the installed script '{first.entry}'{more} {imports} {name}, which is not installed beside it: a build "
        "without --symlink-install does not have it, and the import fails",
        help=f"add '{below}' to this install(PROGRAMS …)",
        related=[Related(row.needed_at, f"{name} is imported here") for row in rows[:_SHOWN]],
        identity=(first.package, below),
        group=(installs.executables[first.entry].place.file, BESIDE),
    )


__all__ = ["BESIDE", "imports_of_scripts"]
