"""Parameter files that a command in a text gives to a program: ``ros2 run … --params-file config.yaml`` in a script, or
in a launch file that types it into a terminal (``tmux send-keys``)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_ENDS = (".py", ".sh", ".bash", ".zsh", ".service")
_OPTION = "--params-file"
_COMMAND = re.compile(rf"\bros2\s+run\s.*?{_OPTION}[ =]+(\S*)")
_UNKNOWN = re.compile(r"[{$]|^[\"']?$")
"""Where a variable stands for the file, or the text ends and something is added to it."""


def may_be_given_by_command(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether such a command names a parameter file, or leaves it to a variable which file that is."""
    name = posixpath.basename(file)
    return any(
        _UNKNOWN.search(given) or posixpath.basename(given.strip("\"',;")) == name for given in _given(workspace)
    )


@once
def _given(workspace: WorkspaceIndex) -> frozenset[str]:
    """What stands behind the option in each such command."""
    return frozenset(match[1] for text in _texts(workspace) for match in _COMMAND.finditer(text))


def _texts(workspace: WorkspaceIndex) -> Iterator[str]:
    """The files with the option, with lines that a backslash continues as one."""
    tree = workspace.tree
    for path in sorted(tree.files_below(tree.top)):
        if path.endswith(_ENDS) and workspace.code.mentions(path, _OPTION):
            yield (tree.text(path) or "").replace("\\\n", " ")


__all__ = ["may_be_given_by_command"]
