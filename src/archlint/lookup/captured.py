"""Whether remappings of the nodes at hand get hold of a new name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.lookup.index import Index
from archlint.lookup.instances import Instance
from archlint.lookup.renamed_names import CannotRename, NameChange
from archlint.lookup.texts import Texts
from archlint.lookup.words import where
from archlint.ros import remapping
from archlint.ros.remapping import RemapRule

if TYPE_CHECKING:
    from archlint.model import Text


def refuse_captured(index: Index, rows: Sequence[Instance], change: NameChange) -> None:
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


__all__ = ["refuse_captured"]
