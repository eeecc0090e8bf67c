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
    for path in sorted(workspace.tree.files_below(workspace.tree.top)):
        text = workspace.tree.text(path) if is_document(path) else None
        for call in _COMMAND.finditer(text or ""):
            line = call.string.count("\n", 0, call.start()) + 1
            rows.setdefault((call[1], call[2]), Place(path, line, 1, line, 1))
    return rows


def is_document(path: str) -> bool:
    """Whether a file is a document or a script, by its name."""
    return _TEXTS.fullmatch(posixpath.basename(path)) is not None


__all__ = ["is_document", "told_to_run"]
