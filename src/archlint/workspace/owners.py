"""Which package a file belongs to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import SourceFile


class FileOwners:
    """The packages of files: of those that were found it is known, of others the folder says it."""

    def __init__(self, files: Sequence[SourceFile] = (), installs: Mapping[str, Installs] | None = None) -> None:
        self._packages = {file.relative: file.package for file in files}
        self._installs = installs or {}

    def package_of(self, path: str) -> str | None:
        if path in self._packages:
            return self._packages[path]
        inside = [i for i in self._installs.values() if path.startswith(i.folder + "/") or i.folder == "."]
        return max(inside, key=lambda i: len(i.folder)).package if inside else None
