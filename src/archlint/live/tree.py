"""The files of a workspace as an editor has them: those that it holds, and the disk for all others."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import field
from pathlib import Path
from typing import TypeVar

from archlint.records import dataclass
from archlint.workspace.tree import SourceTree
from archlint.workspace.words import WORD

Answer = TypeVar("Answer")


@dataclass
class DiskMemory:
    """What the disk has answered, for as long as nothing on it changes: analyses ask the same again and again."""

    real: dict[str, Path | None] = field(default_factory=dict)
    kinds: dict[str, str | None] = field(default_factory=dict)
    listings: dict[str, list[str]] = field(default_factory=dict)
    contents: dict[str, bytes | OSError | None] = field(default_factory=dict)
    words: dict[str, tuple[str, frozenset[str]]] = field(default_factory=dict)
    """The words of files, each with the text that has them."""


class LiveTree(SourceTree):
    """A tree in which some files, by absolute path, have other bytes than on the disk."""

    def __init__(self, base: Path, within: Path, held: Mapping[str, bytes], memory: DiskMemory | None = None) -> None:
        super().__init__(base, within)
        self.held = held
        """Those bytes."""
        self._memory = memory or DiskMemory()
        self._real_held = {os.path.realpath(path): data for path, data in held.items()}
        self.words.split = self._words

    def given(self, path: str) -> bytes | None:
        return self.held.get(os.path.normpath(os.path.join(self.base, path)))

    def content(self, path: str) -> bytes | None:
        """The bytes of a file; None where it cannot be read."""
        try:
            return self._content_now(path)
        except OSError:
            return None

    def answer(self, question: str, path: str) -> str | None:
        return LiveTree(self.base, Path(self._within), self.held).ask((question, path))

    def _content_now(self, path: str) -> bytes | None:
        real = self._real(path)
        held = None if real is None else self._real_held.get(str(real))
        if held is not None:
            return held
        known = _remembered(self._memory.contents, path, self._content_or_error)
        if isinstance(known, OSError):
            raise known
        return known

    def _content_or_error(self, path: str) -> bytes | OSError | None:
        try:
            return super()._content_now(path)
        except OSError as error:
            return error

    def _real(self, path: str) -> Path | None:
        return _remembered(self._memory.real, path, super()._real)

    def _kind_now(self, path: str) -> str | None:
        return _remembered(self._memory.kinds, path, super()._kind_now)

    def _list(self, folder: str) -> list[str]:
        return _remembered(self._memory.listings, folder, super()._list)

    def _words(self, path: str, text: str) -> frozenset[str]:
        known = self._memory.words.get(path)
        if known is None or known[0] != text:
            known = self._memory.words[path] = text, frozenset(WORD.findall(text))
        return known[1]


def _remembered(memory: dict[str, Answer], path: str, ask: Callable[[str], Answer]) -> Answer:
    if path not in memory:
        memory[path] = ask(path)
    return memory[path]


__all__ = ["DiskMemory", "LiveTree"]
