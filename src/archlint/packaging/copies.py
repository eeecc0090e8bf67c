"""Files that are copied from one package to another."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def are_copies(workspace: WorkspaceIndex, file: str, other: str) -> bool:
    """Whether two files say the same, to the letter, so that one of them is enough."""
    text = workspace.tree.text(file)
    return file != other and text is not None and text == workspace.tree.text(other)


__all__ = ["are_copies"]
