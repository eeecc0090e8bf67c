"""The scripts that documents and scripts of a workspace give to Python: `python3 tools/calibrate.py`."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import once

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_TEXTS = re.compile(r"(?:.*\.(?:md|rst|txt|sh|bash|zsh|ps1|bat|cmd|desktop|ya?ml|service)|(?:Docker|Make)file[\w.-]*)")
_PROGRAM = re.compile(
    r"""(?:\bpython[\d.]*(?:\.exe)?[ \t]+(?:-m[ \t]+|-\w+[ \t]+)*["']?|(?<![\w./~])\./)([\w./~${}:\\-]+)"""
)


def tells_commands(path: str) -> bool:
    """Whether a file is a document or a script that says by its name that it may have commands in it."""
    return _TEXTS.fullmatch(posixpath.basename(path)) is not None


def is_told_to_run(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a document or a script of the workspace says to run a file of Python, by its path or as a module."""
    return posixpath.basename(file).removesuffix(".py") in _programs(workspace)


@once
def _programs(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names of the scripts and modules that are given to Python."""
    names: set[str] = set()
    for path in workspace.tree.files_below(workspace.tree.top):
        text = workspace.tree.text(path) if tells_commands(path) else None
        for call in _PROGRAM.finditer(text or ""):
            stem = posixpath.basename(call[1].replace("\\", "/")).removesuffix(".py")
            names |= {stem, stem.rpartition(".")[2]}
    return frozenset(names)


__all__ = ["is_told_to_run", "tells_commands"]
