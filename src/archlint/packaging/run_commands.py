"""What the documents and scripts of a workspace say to start by ``ros2 run``."""

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
def documents(workspace: WorkspaceIndex) -> Mapping[str, str]:
    """The texts of the documents and scripts of a workspace, by their paths, in the order of these."""
    paths = sorted(workspace.tree.files_below(workspace.tree.top))
    texts = ((path, workspace.tree.text(path)) for path in paths if _TEXTS.fullmatch(posixpath.basename(path)))
    return {path: text for path, text in texts if text is not None}


__all__ = ["documents", "told_to_run"]
