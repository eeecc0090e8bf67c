"""What an edit of a Python file changes: nothing that its code says, only where that is written, or more."""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum
from typing import TYPE_CHECKING

from archlint.engine.alike import have_same_words
from archlint.syntax.facts import Base, decode
from archlint.syntax.files import source_digest

if TYPE_CHECKING:
    from archlint.live.store import LiveStore
    from archlint.live.tree import LiveTree
    from archlint.workspace.model import SourceFile


class Change(IntEnum):
    """How much an edit changes, least first."""

    NOTHING = 0
    """Such as a comment at the end of a line or of the file."""
    PLACES = 1
    """Such as a comment on a line of its own: the code says the same at other places."""
    MORE = 2


def change_of(edited: Iterable[SourceFile], before: LiveTree, now: LiveTree, store: LiveStore) -> Change:
    """What edits of these Python files change for an analysis of the files ``before``.

    It may have looked for words in their texts.
    """
    files = {file.relative: file for file in edited}
    in_one = ((path, word, stands) for (path, word), stands in before.words.asked_of_one.items())
    if not have_same_words(in_one, before.words.asked_of_all, files, now.words):
        return Change.MORE
    changes = (_change_of_text(before.content(path), now.content(path), store) for path in files)
    return max(changes, default=Change.NOTHING)


def _change_of_text(before: bytes | None, now: bytes | None, store: LiveStore) -> Change:
    if before is None or now is None:
        return Change.MORE
    old, new = store.get(source_digest(before)), store.get(source_digest(now))
    if old is None or new is None:
        return Change.MORE
    said, says = decode(old), decode(new)  # None for what the screen left out
    if said is None or says is None:
        return Change.MORE
    if old == new:
        return Change.NOTHING
    if said.suppressions or says.suppressions or said.problems or says.problems:
        return Change.MORE  # they are lines
    return Change.PLACES if _say_the_same(said, says) else Change.MORE


def _say_the_same(fact: Base, other: Base) -> bool:
    """Whether two facts differ in nothing but places and docstrings."""
    pairs: list[tuple[object, object]] = [(fact, other)]
    while pairs:
        left, right = pairs.pop()
        if type(left) is not type(right):
            return False
        if isinstance(left, Base):
            names = (name for name in left.__struct_fields__ if not name.endswith(("span", "docstring")))
            pairs += [(getattr(left, name), getattr(right, name)) for name in names]
        elif isinstance(left, (list, tuple)) and isinstance(right, (list, tuple)):
            if len(left) != len(right):
                return False
            pairs += zip(left, right, strict=True)
        elif left != right:
            return False
    return True


__all__ = ["Change", "change_of"]
