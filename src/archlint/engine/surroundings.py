"""What belongs to a workspace and to no revision of its repository."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.engine.git import Repository
from archlint.engine.inputs import find_files
from archlint.engine.request import NothingToDo, Request
from archlint.workspace.around import is_below

if TYPE_CHECKING:
    from archlint.engine.old_tree import OldTree
    from archlint.workspace.model import SourceFile


def folder_of(path: str) -> str:
    """The folder that a path is, or lies in."""
    absolute = os.path.abspath(path)
    return absolute if os.path.isdir(absolute) else os.path.dirname(absolute)


def _files_now(request: Request) -> Sequence[SourceFile]:
    """Those of the working tree, which has none where nothing is checked out, or where all was removed."""
    try:
        return find_files(request).files
    except NothingToDo:
        return ()


class Surroundings:
    """What belongs to a workspace and to no revision of its repository: files outside of it, those of repositories in
    it, and the configuration, which is that of the working tree."""

    def __init__(self, request: Request, repository: Repository) -> None:
        self._root = repository.root
        self._folders = [os.getcwd(), *map(folder_of, request.paths)]
        self._configuration = request.settings.read
        self._masters: dict[str, bool] = {}
        self._files = [file for file in _files_now(request) if self._is_foreign(file.path)]

    def add_to(self, tree: OldTree) -> None:
        written = {folder for folder in tree.written if folder != self._root}
        files = [file for file in self._files if not any(is_below(file.path, folder) for folder in written)]
        tree.surround(files, self._folders, self._root)
        for file in self._configuration:
            tree.copy(file)
        for folder in self._folders:
            if os.path.isdir(folder) and not is_below(folder, self._root):
                os.makedirs(tree.place(folder), exist_ok=True)

    def rows(self) -> list[object]:
        """What changes with them."""
        return [(file.relative, *file.stamp) for file in self._files]

    def _is_foreign(self, path: str) -> bool:
        if not is_below(path, self._root):
            return True
        return self._has_other_master(os.path.dirname(path))

    def _has_other_master(self, folder: str) -> bool:
        """Whether a folder below the root is reached through a link, or lies in another repository."""
        if folder == self._root or folder == os.path.dirname(folder):
            return False
        if folder not in self._masters:
            is_other = os.path.islink(folder) or os.path.lexists(os.path.join(folder, ".git"))
            self._masters[folder] = is_other or self._has_other_master(os.path.dirname(folder))
        return self._masters[folder]


__all__ = ["Surroundings", "folder_of"]
