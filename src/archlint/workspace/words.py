"""The words that occur in the texts of files, and what was asked of them.

Most edits of a file change nothing of that: so the questions are noted with their answers, and not that the text was
read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Sequence

WORD = re.compile(r"\w+")


class Words:
    """The words of files by their shown paths; each file is read once."""

    def __init__(self, text_of: Callable[[str], str | None]) -> None:
        self._text_of = text_of
        self._words: dict[str, frozenset[str]] = {}
        self.asked_of_one: dict[tuple[str, str], bool] = {}
        """Whether a word occurs in a file, by path and word, for all that were asked for."""
        self.asked_of_all: dict[str, set[str]] = {}
        """The files of the workspace's code that a word occurs in, for all words that were asked for."""

        self.split: Callable[[str, str], frozenset[str]] = _split
        """Gives the words of a file, by its path and its text."""

        self.known: Callable[[str], Iterable[str] | None] = _unknown
        """Gives the words of a file that need not be read for them; None for any other."""

    @property
    def read(self) -> Collection[str]:
        """The files whose words anybody has asked for."""
        return self._words.keys()

    def of(self, path: str) -> frozenset[str]:
        """The words of a file; none where it cannot be read."""
        words = self._words.get(path)
        if words is None:
            known = self.known(path)
            words = self.split(path, self._text_of(path) or "") if known is None else frozenset(known)
            self._words[path] = words
        return words

    def stand_in(self, path: str, word: str) -> bool:
        """Whether a word occurs in a file."""
        answer = self.asked_of_one[path, word] = word in self.of(path)
        return answer

    def note(self, word: str, files: Sequence[str]) -> Sequence[str]:
        """These are the files of a workspace that a word occurs in; several may stand side by side."""
        self.asked_of_all.setdefault(word, set()).update(files)
        return files


def _unknown(path: str) -> None:
    return None


def _split(path: str, text: str) -> frozenset[str]:
    return frozenset(WORD.findall(text))


__all__ = ["WORD", "Words"]
