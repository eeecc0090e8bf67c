"""PKG004: files that a setup.py installs among the markers of packages."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding
from archlint.packaging.files_in_index import files_in_index
from archlint.suggestions import listed

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def of_files_in_index(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for each package."""
    for row in files_in_index(workspace):
        those = "that for a package, and it is" if len(row.files) == 1 else "these for packages, and they are"
        files = listed([f"'{file}'" for file in row.files])
        yield finding(
            "PKG004",
            row.place,
            f"data_files= puts {files} among the markers of packages: ROS takes {those} not in the share folder",
            help=f"install it to share/{row.package}, and the marker resource/{row.package} alone here",
            identity=(row.package, *row.files),
            group=(row.place.file, "index"),
        )


__all__ = ["of_files_in_index"]
