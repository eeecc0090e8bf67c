"""Dependencies of a package.xml that nobody knows and nothing asks for: left over from what the package was copied
from, or of a package that was renamed or taken away."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.pinned import may_be_on_focal
from archlint.packaging.absent_packages import folders_and_manifests, is_wanted_from_elsewhere
from archlint.ros import packages

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_TEXT = frozenset(
    {".action", ".bash", ".c", ".cc", ".cfg", ".cmake", ".cpp", ".cxx", ".h", ".hpp", ".ini", ".json", ".launch", ".md"}
    | {
        ".msg",
        ".py",
        ".repos",
        ".rosinstall",
        ".rst",
        ".rviz",
        ".sdf",
        ".sh",
        ".srv",
        ".toml",
        ".txt",
        ".urdf",
        ".xacro",
    }
    | {".xml", ".yaml", ".yml", ".gitmodules", ""}
)
"""Endings of files in which a package may be named."""
_MANIFEST = "package.xml"
_WORD = re.compile(r"[\w.+-]+")
_MANY = 3
"""With so many unknown dependencies a package is one that only makes sense among others, which are elsewhere."""


def is_idle(workspace: WorkspaceIndex, package: Package, name: str, known: frozenset[str]) -> bool:
    """Whether nothing in the workspace names a dependency besides manifests, which no distribution ever had."""
    unknown = [d.name for d in package.dependencies if d.name not in known and _WORD.fullmatch(d.name)]
    installs = workspace.installs.get(package.name)
    has_code = workspace.code.files_of(package.name) or (installs is not None and installs.sources)
    if len(unknown) >= _MANY or name in packages.released_names() or not has_code:
        return False
    if name in folders_and_manifests(workspace) or name in packages.table().ended or may_be_on_focal(workspace):
        return False
    return name not in _names_of_the_workspace(workspace) and not is_wanted_from_elsewhere(workspace, name)


@once
def _names_of_the_workspace(workspace: WorkspaceIndex) -> frozenset[str]:
    """All words of the texts of a workspace, but for its manifests, and of the paths of its files."""
    words: set[str] = set()
    for path in workspace.tree.files_below(workspace.tree.top):
        words.update(posixpath.dirname(path).split("/"))
        name = posixpath.basename(path)
        if name != _MANIFEST and posixpath.splitext(name)[1] in _TEXT:
            words.update(_WORD.findall(workspace.tree.text(path) or ""))
    parts = {part for word in words for part in re.split(r"[.+]", word)}
    return frozenset(words | parts | {part.replace("-", "_") for part in parts})


def is_named_by_no_file(workspace: WorkspaceIndex, package: str, name: str) -> bool:
    """Whether no text of a package has a name besides its manifest."""
    word, manifest = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)"), workspace.packages[package].manifest.relative
    paths = workspace.tree.files_below(posixpath.dirname(manifest) or workspace.tree.top)
    texts = (path for path in paths if path != manifest and posixpath.splitext(path)[1] in _TEXT)
    return not any(word.search(workspace.tree.text(path) or "") for path in texts)


__all__ = ["is_idle", "is_named_by_no_file"]
