"""Files that the build of their package neither compiles nor installs, so that nothing ever runs what is in them."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.packaging.uninstalled_files import is_left_out_launch_file
from archlint.workspace.comments import without_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_SOURCES = (".cc", ".cpp", ".cxx")
_HEADERS = (".h", ".hh", ".hpp", ".hxx")
_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
_ABOVE = re.compile(r"^(?:\.{1,2}/)+")
_LAUNCHES = re.compile(r"launch[^/]*\.(?:py|xml|ya?ml)$|\.launch$")
"""What a launch file is called: one that cannot be read says nothing else of itself."""
_LISTS_FOLDERS = frozenset({"GLOB", "GLOB_RECURSE", "aux_source_directory"})
"""Words with which a CMake file builds what lies in a folder."""


def runs_nowhere(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is a C++ source that no CMake file of its package has a word for, a header that nothing includes
    or installs either, or a launch file of a package that installs others or none, and not this one, and that no other
    file names."""
    if file.endswith(_SOURCES):
        return _is_built_by_nothing(workspace, file)
    if file.endswith(_HEADERS):
        return _is_left_header(workspace, file)
    return _LAUNCHES.search(file) is not None and is_left_out_launch_file(workspace, file)


def _is_built_by_nothing(workspace: WorkspaceIndex, file: str) -> bool:
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or not is_unknown_to_cmake(workspace, installs, file):
        return False
    return not _is_included(workspace, installs, posixpath.basename(file))


def is_unknown_to_cmake(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    """Whether no CMake file of a package has a word for a file, by its name without the ending."""
    if not file.startswith(f"{installs.folder}/".removeprefix("./")):
        return False
    texts = _cmake_texts(workspace).get(installs.package, [])
    if not texts or not _LISTS_FOLDERS.isdisjoint(installs.words):
        return False
    name, _ = posixpath.splitext(posixpath.basename(file))
    stem = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return not any(stem.search(text) for text in texts)


def _is_left_header(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether nothing includes a header, no CMake file has a word for it, and its package does not install it."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or installs.open_files or not is_unknown_to_cmake(workspace, installs, file):
        return False
    if any(file.startswith(f"{row.source}/") if row.folder else file == row.source for row in installs.files):
        return False
    parts = file.split("/")
    return not any("/".join(parts[start:]) in _included(workspace) for start in range(len(parts)))


@once
def _included(workspace: WorkspaceIndex) -> frozenset[str]:
    """What the C++ code of the workspace includes, without the folders above that a path begins with."""
    code = [path for path in workspace.tree.files_below(workspace.tree.top) if path.endswith((*_SOURCES, *_HEADERS))]
    paths = (match[1] for path in code for match in _INCLUDE.finditer(workspace.tree.text(path) or ""))
    return frozenset(_ABOVE.sub("", included) for included in paths)


def _is_included(workspace: WorkspaceIndex, installs: Installs, name: str) -> bool:
    """Whether a source of the package includes another one: ``#include "parts.cpp"``."""
    tree = workspace.tree
    code = (path for path in tree.files_below(installs.folder) if path.endswith((*_SOURCES, ".h", ".hpp")))
    return any(name in (tree.text(path) or "") for path in code if posixpath.basename(path) != name)


@once
def _cmake_texts(workspace: WorkspaceIndex) -> dict[str, list[str]]:
    """The CMake files of each package, without their comments."""
    return {
        name: [
            without_comments(workspace.tree.text(path) or "")
            for path in workspace.tree.files_below(installs.folder)
            if posixpath.basename(path) == "CMakeLists.txt" or path.endswith(".cmake")
        ]
        for name, installs in workspace.installs.items()
    }


__all__ = ["is_unknown_to_cmake", "runs_nowhere"]
