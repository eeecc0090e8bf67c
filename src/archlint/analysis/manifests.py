"""The package.xml files of a workspace: which one is around a file, and where a line goes into one."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.finding import Place

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_LEVELS = 60
"""How many folders upwards a package.xml is looked for; the tree answers for nothing above the workspace."""


def package_around(workspace: WorkspaceIndex, folder: str) -> Package | None:
    """The package whose package.xml is the nearest one upwards from a folder; None where that one makes no package."""
    for _ in range(_LEVELS):
        if workspace.tree.is_file(posixpath.normpath(posixpath.join(folder, "package.xml"))):
            return workspace.manifests.get(folder)
        folder = posixpath.normpath(posixpath.join(folder, ".."))
    return None


def place_of_a_dependency(workspace: WorkspaceIndex, package: Package) -> tuple[Place, str] | None:
    """Where the next dependency for run time goes, and what the lines there are indented with: after the last of their
    kind, or where the first would stand."""
    lines = (workspace.tree.text(package.manifest.relative) or "").splitlines()
    in_force = _COMMENT.sub(lambda found: "\n" * found[0].count("\n"), "\n".join(lines)).split("\n")
    after = [number for number, line in enumerate(in_force, start=1) if _DEPEND.match(line)]
    after = after or [number for number, line in enumerate(in_force, start=1) if _ABOUT.match(line)]
    if not after:
        return None
    line = lines[after[-1] - 1]
    return Place(package.manifest.relative, after[-1] + 1, 1, after[-1] + 1, 1), line[: -len(line.lstrip())]


_DEPEND = re.compile(r"\s*<(?:exec_|run_|build_export_|buildtool_|build_|)depend\b.*</\w*depend>\s*$")
_ABOUT = re.compile(r"\s*<(?:maintainer|license|url|author)\b.*</(?:maintainer|license|url|author)>\s*$")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)

__all__ = ["package_around", "place_of_a_dependency"]
