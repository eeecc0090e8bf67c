"""Renaming topics, services, actions and parameters in Python, launch files and YAML: all of it, or nothing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from archlint.lookup.answers import Edit, Refused, Renamed
from archlint.lookup.captured import refuse_captured
from archlint.lookup.doubts import refuse_doubtful
from archlint.lookup.index import Index
from archlint.lookup.instances import instances
from archlint.lookup.mentions import Mention
from archlint.lookup.renamable import not_written, renamed_at
from archlint.lookup.renamed_names import CannotRename, NameChange, refuse_wrong_name
from archlint.lookup.renamed_parameters import parameter_texts
from archlint.lookup.texts import Texts
from archlint.lookup.words import code
from archlint.place import Place

_NOTHING = "no name of ROS is written here"


def rename(index: Index, texts: Texts, file: str, line: int, column: int, new: str) -> Renamed | Refused:
    """All edits that give another name to what is named at a position.  ``new`` is what shall stand there: other ends
    keep their form, absolute, private or relative.  Refused, with the reason, where any end cannot be changed along or
    is not known."""
    mention = renamed_at(index, texts, file, line, column)
    if mention is None:
        return Refused(_NOTHING)
    place = index.texts.name_at(mention.place, mention.written or "")
    if mention.written is None or place is None:
        return not_written(index.texts, mention) or Refused(_NOTHING)
    try:
        if mention.subject.kind == "parameter":
            changed: Mapping[Place, str] = parameter_texts(index, mention, _whole(mention, new))
        else:
            changed = _name_texts(index, place, mention.written, new)
        _refuse_moved(index, texts, changed)
    except CannotRename as error:
        return Refused(f"cannot rename {code(mention.written)}: {error.reason}", error.place)
    return Renamed(tuple(Edit(where_, text) for where_, text in sorted(changed.items()) if texts.at(where_) != text))


def _whole(mention: Mention, new: str) -> str:
    """The whole name of a parameter, of which the last part is written at a place."""
    return mention.subject.name.removesuffix(mention.written or "") + new


def _name_texts(index: Index, place: Place, old: str, new: str) -> dict[Place, str]:
    refuse_wrong_name(new)
    rows = instances(index)
    change = NameChange(rows, place, old, new)
    refuse_doubtful(index, rows, change)
    refuse_captured(index, rows, change)
    return change.texts


def _refuse_moved(index: Index, texts: Texts, changed: Iterable[Place]) -> None:
    """Files that have changed since may name it in new places, too."""
    for place in sorted(changed):
        if texts.lines(place.file) != index.texts.lines(place.file):
            raise CannotRename(f"{place.file} has changed since archlint looked at it", place)


__all__ = ["rename"]
