"""Which edits of Python files leave the result of a run as it is: those that change nothing of what it depends on.

A result depends on what the code of a file says, on the words that were looked for in its text, and seldom on the text
itself.  A comment more, at the end of a file say, changes none of these.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING

import msgspec

from archlint.records import dataclass
from archlint.workspace.text_questions import is_about_text

if TYPE_CHECKING:
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile
    from archlint.workspace.tree import SourceTree
    from archlint.workspace.words import Words

Answers = list[tuple[str, str, str | None]]
"""What was asked of the disk: question, path and answer."""


@dataclass(frozen=True)
class Alike:
    """What a result depends on beside what the code of the files means.  ``key`` is that of the result."""

    key: str
    digests: dict[str, str]
    """Those of the Python files, by their shown paths."""
    answers: Answers
    screened_out: dict[str, str]
    """What the code of files means that the screen left out and that were read nevertheless."""
    in_one: list[tuple[str, str, bool]]
    """Whether a word occurs in a file."""
    in_all: dict[str, list[str]]
    """The files of the workspace's code that a word occurs in."""

    @classmethod
    def of(cls, key: str, answers: Answers, words: Words, files: Iterable[SourceFile], facts: FactsOfFiles) -> Alike:
        """What was asked in this run, and of which Python files."""
        files = list(files)
        read = [file for file in files if not facts.relevant(file) and facts.was_read(file)]
        screened_out = {file.relative: facts.meaning_of_read(file) or "" for file in read}
        in_one = [(path, word, stands) for (path, word), stands in sorted(words.asked_of_one.items())]
        in_all = {word: sorted(files) for word, files in sorted(words.asked_of_all.items())}
        return cls(key, _digests(files, facts), answers, screened_out, in_one, in_all)

    @classmethod
    def read(cls, record: object) -> Alike:
        """What was written as a record; raises ``ValueError``."""
        return msgspec.convert(record, cls)

    def holds(self, files: Iterable[SourceFile], facts: FactsOfFiles, tree: SourceTree) -> bool:
        """Whether all of it is as it was.  ``files`` are the Python files now, whose outlines are as they were."""
        by_path = {file.relative: file for file in files}
        digests = _digests(by_path.values(), facts)
        edited = {path: by_path[path] for path, digest in digests.items() if self.digests.get(path) != digest}
        unedited = digests.keys() - edited.keys()
        # What was asked of the text of a file that is as it was has the answer that it had.
        open_ = [row for row in self.answers if not is_about_text(row[0]) or row[1] not in unedited]
        if any(tree.answer(question, path) != answer for question, path, answer in open_):
            return False
        read = (file for path, file in edited.items() if path in self.screened_out)
        if any(facts.meaning_of_read(file) != self.screened_out[file.relative] for file in read):
            return False
        return have_same_words(self.in_one, self.in_all, edited, tree.words)


def have_same_words(
    in_one: Iterable[tuple[str, str, bool]],
    in_all: Mapping[str, Collection[str]],
    edited: Mapping[str, SourceFile],
    now: Words,
) -> bool:
    """Whether each word that was asked for, of one file or of all, stands in the edited files where it stood."""
    words = {path: now.of(path) for path in edited}
    if any((word in words[path]) is not stands for path, word, stands in in_one if path in words):
        return False
    code = {path: words[path] for path, file in edited.items() if file.kind == "python" and file.package}
    return all(
        (word in words_now) is (path in before) for word, before in in_all.items() for path, words_now in code.items()
    )


def _digests(files: Iterable[SourceFile], facts: FactsOfFiles) -> dict[str, str]:
    return {file.relative: facts.digest(file) or "" for file in files}


__all__ = ["Alike", "Answers", "have_same_words"]
