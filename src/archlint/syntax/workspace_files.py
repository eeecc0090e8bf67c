"""The files of a workspace, and how to get at what is in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.workspace.importable import Importable
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
    known: Importable | None = None
    """The same files as they can be imported, where an earlier run has sorted them."""

    @cached_property
    def importable(self) -> Importable:
        """The files as they can be imported."""
        return self.known if self.known is not None and self.known.all is self.files else Importable(self.files)


NO_WORKSPACE = WorkspaceFiles()
