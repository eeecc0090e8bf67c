"""Launch files that are parts of others, for the time being left out there: their include is commented out."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.workspace.comments import without_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_WORD = re.compile(r"[\w-]+")


def is_left_out_fragment(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether other launch files have a word for one in comments alone, and one of them, or what includes it, declares
    an argument of a ``name``: the file gets it from there once it is included again."""
    stem = posixpath.basename(file).partition(".")[0]
    if any(stem in code for other, (code, _) in _words(workspace).items() if other != file):
        return False
    parents = {other for other, (_, said) in _words(workspace).items() if other != file and stem in said}
    return any(
        argument.name == name
        for launched in workspace.launched
        if not parents.isdisjoint(launched.sources)
        for argument in launched.declared
    )


@once
def _words(workspace: WorkspaceIndex) -> Mapping[str, tuple[frozenset[str], frozenset[str]]]:
    """The words of each launch file: those of its code, and those that stand in its comments alone."""
    words = {}
    for path in workspace.launch_files.all():
        text = workspace.tree.text(path) or ""
        code = frozenset(_WORD.findall(without_comments(text)))
        words[path] = code, frozenset(_WORD.findall(text)) - code
    return words


__all__ = ["is_left_out_fragment"]
