"""What is written at a position and can perhaps be renamed."""

from __future__ import annotations

from archlint.lookup.answers import Refused, Renamable
from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention
from archlint.lookup.moved import Moves
from archlint.lookup.texts import Texts
from archlint.lookup.words import code

_RENAMED = ("topic", "service", "action", "parameter")


def prepare_rename(index: Index, texts: Texts, file: str, line: int, column: int) -> Renamable | Refused | None:
    """The name at a position that can perhaps be renamed, or why the one that is made there cannot.

    None where no ROS name is: a variable or constant that stands for one is Python's, and the text that it holds can be
    renamed where that is."""
    mention = renamed_at(index, texts, file, line, column)
    if mention is None:
        return None
    place = index.texts.name_at(mention.place, mention.written or "")
    if mention.written is None or place is None:
        return not_written(index.texts, mention)
    now = Moves(index.texts, texts).place_now(place)
    return None if now is None else Renamable(now, mention.written)


def not_written(texts: Texts, mention: Mention) -> Refused | None:
    """Why a name that is computed at a place cannot be renamed; None for a variable."""
    text = texts.at(mention.place)
    if text.replace(".", "").isidentifier():
        return None
    return Refused(f"cannot rename {code(mention.subject.name)}: it is computed here, not written", mention.place)


def renamed_at(index: Index, texts: Texts, file: str, line: int, column: int) -> Mention | None:
    """What can be renamed, first that whose name stands there."""
    mentions = [m for m in index.at(texts, file, line, column) if m.subject.kind in _RENAMED and m.role != "call"]
    return min(mentions, key=lambda mention: mention.written is None, default=None)


__all__ = ["not_written", "prepare_rename", "renamed_at"]
