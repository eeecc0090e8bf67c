"""What the documents and scripts of a workspace say to start by ``ros2 run`` and ``ros2 launch``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_TEXTS = re.compile(r"(?:.*\.(?:md|rst|txt|sh|bash|zsh|ya?ml|service)|(?:Docker|Make)file[\w.-]*)")
_COMMAND = re.compile(r"\bros2[ \t]+run[ \t]+([\w-]+)[ \t]+([\w.-]+)")


@once
def told_to_run(workspace: WorkspaceIndex) -> Mapping[tuple[str, str], Place]:
    """Package and executable after each ``ros2 run``, with the first place of it."""
    rows: dict[tuple[str, str], Place] = {}
    for path, text in documents(workspace).items():
        for call in _COMMAND.finditer(text):
            line = text.count("\n", 0, call.start()) + 1
            rows.setdefault((call[1], call[2]), Place(path, line, 1, line, 1))
    return rows


@once
def _told_arguments(workspace: WorkspaceIndex) -> Mapping[str, frozenset[str]]:
    """The launch arguments that each ``ros2 launch`` sets, by the last part of the file's name."""
    rows: dict[str, frozenset[str]] = {}
    for text in documents(workspace).values():
        for call in _LAUNCH.finditer(text.replace("\\\n", " ")):
            name = posixpath.basename(call[1])
            rows[name] = rows.get(name, frozenset()) | frozenset(_ARGUMENT.findall(call[2]))
    return rows


_LAUNCH = re.compile(r"\bros2[ \t]+launch[ \t]+(?:[\w-]+[ \t]+)?([\w./~-]+)([^\n]*)")
_ARGUMENT = re.compile(r"(?<=\s)([\w-]+):=")


def is_told_to_set(workspace: WorkspaceIndex, file: str, argument: str) -> bool:
    """Whether a document or script sets an argument on the command line of a launch file."""
    return argument in _told_arguments(workspace).get(posixpath.basename(file), ())


@once
def documents(workspace: WorkspaceIndex) -> Mapping[str, str]:
    """The texts of the documents and scripts of a workspace, by their paths, in the order of these."""
    paths = sorted(workspace.tree.files_below(workspace.tree.top))
    texts = ((path, workspace.tree.text(path)) for path in paths if _TEXTS.fullmatch(posixpath.basename(path)))
    return {path: text for path, text in texts if text is not None}


__all__ = ["documents", "is_told_to_set", "told_to_run"]
