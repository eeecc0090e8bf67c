"""Programs whose lines in a build file are a comment: somebody has taken them out on purpose, perhaps for a while."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def commented_out_in(workspace: WorkspaceIndex, files: Sequence[str], program: str) -> str | None:
    """The build file in which the ``add_executable()`` of a program, or its entry among the console scripts, is a
    comment."""
    name = re.escape(program)
    line = re.compile(rf"""^[ \t]*#.*(?:\badd_executable[ \t]*\([ \t]*{name}\b|['"]{name}[ \t]*=)""", re.MULTILINE)
    return next((file for file in files if line.search(workspace.tree.text(file) or "")), None)


__all__ = ["commented_out_in"]
