"""What is noted of code that is run several times: only what each run says of it."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TypeVar

_Key = TypeVar("_Key", bound=Hashable)
_Note = TypeVar("_Note")


def note_if_same(noted: dict[_Key, _Note | None], key: _Key, note: _Note | None) -> bool:
    """Note what a run says: the first note stays as long as all are equal to it, and is None for good once one is not.

    The result is whether what is known under the key has changed: a list made of the notes has to be made again then.
    """
    before = noted.get(key)
    if noted.setdefault(key, note) != note:
        noted[key] = None
    return noted[key] != before


__all__ = ["note_if_same"]
