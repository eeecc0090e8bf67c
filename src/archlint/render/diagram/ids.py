"""Ids for what is drawn: of the names, so that an edit elsewhere changes none of them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from archlint.render.diagram.model import Key

_LONGEST = 60


def ids_of(keys: Iterable[Key]) -> Mapping[Key, str]:
    """An id for each: letters, digits and underscores, and no word that means something in any format."""
    ids: dict[Key, str] = {}
    taken: set[str] = set()
    for key in sorted(keys):
        words = re.sub(r"[^A-Za-z0-9]+", "_", key[1]).strip("_")[:_LONGEST]
        base = f"{key[0]}_{words}"
        id, number = base, 2
        while id.lower() in taken:
            id, number = f"{base}_{number}", number + 1
        taken.add(id.lower())
        ids[key] = id
    return ids


__all__ = ["ids_of"]
