"""The files of a workspace as an editor has them: those that it holds, and the disk for all others."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from archlint.workspace.tree import SourceTree


class LiveTree(SourceTree):
    """A tree in which some files, by absolute path, have other bytes than on the disk."""

    def __init__(self, base: Path, within: Path, held: Mapping[str, bytes]) -> None:
        super().__init__(base, within)
        self._held = held
        self._real_held = {os.path.realpath(path): data for path, data in held.items()}

    def given(self, path: str) -> bytes | None:
        return self._held.get(os.path.normpath(os.path.join(self.base, path)))

    def content(self, path: str) -> bytes | None:
        """The bytes of a file; None where it cannot be read."""
        try:
            return self._content_now(path)
        except OSError:
            return None

    def answer(self, question: str, path: str) -> str | None:
        return LiveTree(self.base, Path(self._within), self._held).ask((question, path))

    def _content_now(self, path: str) -> bytes | None:
        real = self._real(path)
        held = None if real is None else self._real_held.get(str(real))
        return super()._content_now(path) if held is None else held


__all__ = ["LiveTree"]
