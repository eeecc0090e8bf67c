"""Dependencies of a package.xml that nobody knows and nothing asks for: left over from what the package was copied
from, or of a package that was renamed or taken away."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.pinned import may_be_on_focal
from archlint.packaging.absent_packages import folders_and_manifests, is_wanted_from_elsewhere
from archlint.ros import packages

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_TEXT = frozenset(
    {
        *("", ".cfg", ".gitmodules", ".ini", ".json", ".md", ".repos", ".rosinstall", ".rst", ".toml", ".txt"),
        *(".bash", ".c", ".cc", ".cmake", ".cpp", ".cxx", ".h", ".hpp", ".launch", ".py", ".sh"),
        *(".action", ".msg", ".rviz", ".sdf", ".srv", ".urdf", ".xacro", ".xml", ".yaml", ".yml"),
    }
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
    return not is_wanted_from_elsewhere(workspace, name) and not _is_a_word_of(workspace, name)


_PARTS = ("driver", "interfaces", "msgs", "node", "nodes", "ros", "ros2")
"""What names of packages have at their end that lie in a repository of the shorter name."""


def _is_a_word_of(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a text of a workspace, but for its manifests, or the path of a file has a name, be it with dashes, or one
    of two words as the beginning of a longer name: ``pose_to_tf_node`` for ``pose_to_tf``."""
    longer = {f"{name}_{part}" for part in _PARTS} if "_" in name else set()
    spelt = {name, name.replace("_", "-"), *longer}
    word = re.compile(rf"(?<![\w-])(?:{'|'.join(map(re.escape, sorted(spelt)))})(?![\w-])")

    def has(text: str) -> bool:
        return any(each in text for each in spelt) and word.search(text) is not None

    def is_in_code(path: str) -> bool:
        named = any(workspace.code.mentions(path, each) for each in sorted(spelt))
        return named and bool(workspace.tree.lines_with(path, word.pattern))

    for path in workspace.tree.files_below(workspace.tree.top):
        file, kind = posixpath.basename(path), posixpath.splitext(path)[1]
        is_read = file != _MANIFEST and kind in _TEXT
        if has(posixpath.dirname(path)):
            return True
        if is_read and (is_in_code(path) if kind == ".py" else has(workspace.tree.text(path) or "")):
            return True
    return False


def is_named_by_no_file(workspace: WorkspaceIndex, package: str, name: str) -> bool:
    """Whether no text of a package has the name of another one besides its manifest, nor that of a Python package which
    the other installs."""
    names = {name, *(module.partition(".")[0] for module in workspace.code.modules_of(name))}
    manifest = workspace.packages[package].manifest.relative
    paths = workspace.tree.files_below(posixpath.dirname(manifest) or workspace.tree.top)
    texts = (path for path in paths if path != manifest and posixpath.splitext(path)[1] in _TEXT)
    return not any(workspace.code.mentions(path, each) for path in texts for each in sorted(names))


_OF_A_BUILD = (".action", ".c", ".cc", ".cpp", ".cxx", ".h", ".hpp", ".idl", ".msg", ".srv")


def is_only_asked_for(workspace: WorkspaceIndex, package: str, name: str, file: str) -> bool:
    """Whether a CMake file asks for another package with ``find_package`` and uses nothing of it: no other line there
    has its name, nor has code that is built, and no file of Python imports it."""
    asked = re.compile(rf"\s*find_package\s*\(\s*{re.escape(name)}\b[^()]*\)\s*")
    folder = posixpath.dirname(workspace.packages[package].manifest.relative) or workspace.tree.top
    lines = (line.partition("#")[0] for line in (workspace.tree.text(file) or "").splitlines())
    naming = [line for line in lines if re.search(rf"\b{re.escape(name)}\b", line)]
    if not naming or not all(map(asked.fullmatch, naming)):
        return False
    paths = [path for path in workspace.tree.files_below(folder) if workspace.code.mentions(path, name)]
    imported = rf"^\s*(?:from|import)\s+{re.escape(name)}\b"
    return not any(
        path.endswith(_OF_A_BUILD) or (path.endswith(".py") and workspace.tree.lines_with(path, imported))
        for path in paths
    )


__all__ = ["is_idle", "is_named_by_no_file", "is_only_asked_for"]
