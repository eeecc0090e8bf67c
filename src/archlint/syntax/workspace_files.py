"""The files of a workspace, and how to get at what is in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.workspace.tree import NO_FILES, Tree

if TYPE_CHECKING:
    from archlint.syntax.facts import Facts
    from archlint.workspace.model import SourceFile


@dataclass(frozen=True)
class WorkspaceFiles:
    """``facts_of`` gives the facts of a Python file, compiling on demand; ``relevant`` says whether a file can matter,
    as far as its words show; ``tree`` reads any file by its path."""

    files: Sequence[SourceFile] = ()
    facts_of: Callable[[SourceFile], Facts | None] = lambda file: None
    relevant: Callable[[SourceFile], bool] = lambda file: True
    tree: Tree = NO_FILES


NO_WORKSPACE = WorkspaceFiles()
