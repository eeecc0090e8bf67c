"""Files that a setup.py puts among the markers of packages, where ROS takes each for a package and nobody looks for it.

Source: ``get_packages_with_prefixes()`` of ament_index_python lists what is in that folder, whatever it is called.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.packaging.uninstalled_files import understood
from archlint.place import Place
from archlint.records import dataclass
from archlint.workspace.installed import MARKERS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class FilesInIndex:
    """The files of a package in the folder of markers that are none, by their paths below the folder of the package."""

    package: str
    place: Place
    files: tuple[str, ...]


def files_in_index(workspace: WorkspaceIndex) -> Iterator[FilesInIndex]:
    """Those of each package that are nowhere else, beside its marker: no package has a name with a dot."""
    for installs in understood(workspace).values():
        at = installs.data_files_at
        rows = [row for row in installs.files if posixpath.normpath(row.destination) == MARKERS and not row.folder]
        files = {
            path: row.place or at
            for row in rows
            for path in _matched(workspace, row.source)
            if "." in (row.rename or posixpath.basename(path)).lstrip(".")
            and not any(
                place.startswith("share/") and not place.startswith(MARKERS) for place in installs.places_of(path)
            )
        }
        is_marked = any(posixpath.basename(row.source) in (installs.package, "*") for row in rows)
        if at is not None and is_marked and files:
            place = next(iter(files.values())) or at
            yield FilesInIndex(
                installs.package, place, tuple(posixpath.relpath(file, installs.folder) for file in files)
            )


def _matched(workspace: WorkspaceIndex, source: str) -> list[str]:
    """The files that a row names, by itself or by a pattern for those of one folder."""
    if workspace.tree.is_file(source):
        return [source]
    folder, name = posixpath.split(source)
    if name != "*" or any(sign in folder for sign in "*?["):
        return []
    below = workspace.tree.files_below(folder)
    return sorted(path for path in below if posixpath.dirname(path) == folder and posixpath.basename(path)[0] != ".")


__all__ = ["FilesInIndex", "files_in_index"]
