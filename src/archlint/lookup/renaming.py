"""Renaming topics, services, actions and parameters in Python, launch files and YAML: all of it, or nothing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.lookup.answers import Edit, Refused, Renamable, Renamed
from archlint.lookup.doubts import refuse_doubtful
from archlint.lookup.index import Index
from archlint.lookup.instances import Instance, instances
from archlint.lookup.mentions import Mention
from archlint.lookup.moved import Moves
from archlint.lookup.renamed_names import CannotRename, NameChange, refuse_wrong_name
from archlint.lookup.renamed_parameters import parameter_texts
from archlint.lookup.texts import Texts
from archlint.lookup.words import code, where
from archlint.place import Place
from archlint.ros import remapping
from archlint.ros.remapping import RemapRule

if TYPE_CHECKING:
    from archlint.model import Text

_RENAMED = ("topic", "service", "action", "parameter")
_NOTHING = "no name of ROS is written here"


def prepare_rename(index: Index, texts: Texts, file: str, line: int, column: int) -> Renamable | Refused | None:
    """The name at a position that can perhaps be renamed, or why the one that is made there cannot.

    None where no ROS name is: a variable or constant that stands for one is Python's, and the text that it holds can be
    renamed where that is."""
    mention = _renamed_at(index, texts, file, line, column)
    if mention is None:
        return None
    place = index.texts.name_at(mention.place, mention.written or "")
    if mention.written is None or place is None:
        return _not_written(index.texts, mention)
    now = Moves(index.texts, texts).place_now(place)
    return None if now is None else Renamable(now, mention.written)


def _not_written(texts: Texts, mention: Mention) -> Refused | None:
    """Why a name that is computed at a place cannot be renamed; None for a variable."""
    text = texts.at(mention.place)
    if text.replace(".", "").isidentifier():
        return None
    return Refused(f"cannot rename {code(mention.subject.name)}: it is computed here, not written", mention.place)


def rename(index: Index, texts: Texts, file: str, line: int, column: int, new: str) -> Renamed | Refused:
    """All edits that give another name to what is named at a position.  ``new`` is what shall stand there: other ends
    keep their form, absolute, private or relative.  Refused, with the reason, where any end cannot be changed along or
    is not known."""
    mention = _renamed_at(index, texts, file, line, column)
    if mention is None:
        return Refused(_NOTHING)
    place = index.texts.name_at(mention.place, mention.written or "")
    if mention.written is None or place is None:
        return _not_written(index.texts, mention) or Refused(_NOTHING)
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


def _renamed_at(index: Index, texts: Texts, file: str, line: int, column: int) -> Mention | None:
    """What can be renamed, first that whose name stands there."""
    mentions = [m for m in index.at(texts, file, line, column) if m.subject.kind in _RENAMED and m.role != "call"]
    return min(mentions, key=lambda mention: mention.written is None, default=None)


def _name_texts(index: Index, place: Place, old: str, new: str) -> dict[Place, str]:
    refuse_wrong_name(new)
    rows = instances(index)
    change = NameChange(rows, place, old, new)
    refuse_doubtful(index, rows, change)
    _refuse_captured(index, rows, change)
    return change.texts


def _refuse_captured(index: Index, rows: Sequence[Instance], change: NameChange) -> None:
    """Whether every end of the nodes at hand then has the name that it shall have: no other remapping gets hold of it,
    and none is left without the name that it replaces."""
    nodes = {id(row.end.node) for row in change.changed if row.end is not None}
    for row in rows:
        if row.end is None or row.node is None or id(row.end.node) not in nodes or row.end.written is None:
            continue
        written = next(
            (change.texts[each.place] for each in row.literals if each.place in change.texts), row.end.written
        )
        name = remapping.resolve(written, row.kind, row.node, _rules(row, index.texts, change)).name
        if name != change.full_names.get((row.kind, row.name), row.name):
            raise CannotRename(f"a remapping would change what is created at {where(row.place)}", row.place)


def _rules(row: Instance, texts: Texts, change: NameChange) -> Sequence[RemapRule]:
    """The remap rules of a node with the new texts of its remappings."""
    end = row.end
    if end is None:
        return ()
    new_texts: dict[str, str] = {}
    for remap in end.node.started.remaps if end.node.started is not None else ():
        parts = [_text_after(texts, text, change) for text in (remap.source, remap.target)]
        new_texts[f"{remap.source.text}:={remap.target.text}"] = ":=".join(parts)
    try:
        return [
            replace(RemapRule.parse(new_texts.get(rule.text, rule.text)), kinds=rule.kinds) for rule in end.node.rules
        ]
    except ValueError as error:
        raise CannotRename(str(error), row.place) from None


def _text_after(texts: Texts, text: Text, change: NameChange) -> str:
    """A name of a remapping as it is after the change."""
    written = text.text or ""
    place = None if text.origin is None else texts.name_at(text.origin, written)
    return written if place is None else change.texts.get(place, written)


def _refuse_moved(index: Index, texts: Texts, changed: Iterable[Place]) -> None:
    """Files that have changed since may name it in new places, too."""
    for place in sorted(changed):
        if texts.lines(place.file) != index.texts.lines(place.file):
            raise CannotRename(f"{place.file} has changed since archlint looked at it", place)


__all__ = ["prepare_rename", "rename"]
