"""Where the files of a package name another one."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.place import Place

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def descriptions_that_find(workspace: WorkspaceIndex, package: str, others: Sequence[str]) -> list[str]:
    """The descriptions of robots in a package that take files of other ones."""
    folder = posixpath.dirname(workspace.packages[package].manifest.relative) or workspace.tree.top
    files = [path for path in workspace.tree.files_below(folder) if path.endswith((".xacro", ".urdf", ".sdf"))]
    finding = rf"(?:\$\(find(?:-pkg-share)? +|package://)(?:{'|'.join(map(re.escape, others))})\b"
    return [path for path in files if workspace.tree.lines_with(path, finding)]


def named_at(workspace: WorkspaceIndex, place: Place, package: str) -> Place:
    """Where a file that uses another package at a place names it, if the place itself does not and one line does."""
    if any(package in line for line in workspace.tree.lines(place.file, place.line, place.end_line)):
        return place
    quoted = re.compile(rf"(['\"]){re.escape(package)}\1")
    lines = workspace.tree.lines_with(place.file, quoted.pattern)
    match = quoted.search(lines[0][1]) if len(lines) == 1 else None
    return Place(place.file, lines[0][0], match.start() + 1, lines[0][0], match.end() + 1) if match else place


__all__ = ["descriptions_that_find", "named_at"]
