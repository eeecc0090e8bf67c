"""Dependencies that a comment of a package.xml says to be left out since they would close a circle."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.workspace.comments import xml_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_CIRCLE = re.compile(r"\b(?:circles?|circular(?:ity)?|cycl(?:e|es|ic))\b", re.IGNORECASE)


def is_left_out_for_a_circle(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether a comment of a manifest speaks of a dependency and of a circle: who wrote it knows, and has decided."""
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    comments = xml_comments(workspace.tree.text(package.manifest.relative) or "")
    return any(_CIRCLE.search(comment) and word.search(comment) for comment in comments)


__all__ = ["is_left_out_for_a_circle"]
