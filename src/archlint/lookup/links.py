"""The places of a file that lead to other files: includes, parameter files, executables, types."""

from __future__ import annotations

from archlint.lookup.answers import Link
from archlint.lookup.index import Index
from archlint.lookup.moved import Moves
from archlint.lookup.targets import places_meant
from archlint.lookup.texts import Texts
from archlint.place import Place

_LINKED = ("file", "executable", "interface")


def links(index: Index, texts: Texts, file: str) -> list[Link]:
    """The links of a file, in the order of its lines; one for each place, where all that it may mean is one file."""
    targets: dict[Place, set[Place]] = {}
    moves = Moves(index.texts, texts)
    for mention in index.in_file(file):
        kind, place = mention.subject.kind, moves.place_now(mention.place)
        if kind not in _LINKED or mention.role == "call" or place is None:
            continue
        shown = place if kind == "interface" else texts.inside(place)
        if shown is not None:
            targets.setdefault(shown, set()).update(places_meant(index, mention))
    return [Link(place, *meant) for place, meant in sorted(targets.items()) if len(meant) == 1]


__all__ = ["links"]
