"""Targets that commands of a CMakeLists.txt name, and that no source is left to build of."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.suggestions import nearest

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_MAIN = r"^\s*(?:int|auto)\s+main\s*\("
_SOURCES = (".c", ".cc", ".cpp", ".cu", ".cxx")
_NOT_A_TARGET = "project"


def left_over_targets(workspace: WorkspaceIndex, installs: Installs) -> frozenset[str]:
    """The targets that are not there, that no other one is almost called like, and that no source is left for: their
    commands came with a file that was copied, or outlived what they were for."""
    absent = {
        named.name
        for named in installs.names_of_nothing
        if not named.package and named.command != _NOT_A_TARGET and nearest(named.name, installs.targets) is None
    }
    if not absent:
        return frozenset()
    used = installs.sources.union(*(target.sources for target in installs.built))
    sources = (file for file in workspace.tree.files_below(installs.folder) if file.endswith(_SOURCES))
    left = [file for file in sources if file not in used]
    if any(not workspace.roles.is_test(file) and workspace.tree.lines_with(file, _MAIN) for file in left):
        return frozenset()
    stems = {_plain(posixpath.splitext(posixpath.basename(file))[0]) for file in left}
    return frozenset(name for name in absent if not any(_are_alike(stem, _plain(name)) for stem in stems))


def _are_alike(first: str, second: str) -> bool:
    return first in second or second in first


def _plain(name: str) -> str:
    """The letters and digits of the name of a target or of a file, without what all nodes have in theirs."""
    plain = re.sub(r"[\W_]", "", name.lower())
    return plain.removesuffix("node") or plain


__all__ = ["left_over_targets"]
