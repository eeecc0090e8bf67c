"""Why a renaming would perhaps miss something, or give two connections one name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.lookup.index import Index
from archlint.lookup.instances import Instance
from archlint.lookup.open_ends import refuse_known_elsewhere, refuse_open_side, refuse_unknown_ends
from archlint.lookup.other_texts import refuse_other_texts
from archlint.lookup.renamed_names import CannotRename, NameChange
from archlint.lookup.words import code, where
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind


def refuse_doubtful(index: Index, rows: Sequence[Instance], change: NameChange) -> None:
    """Raises :class:`CannotRename` where it is not certain that a change covers every end."""
    real = {key: [r for r in rows if (r.kind, r.name) == key and r.end is not None] for key in change.full_names}
    for (kind, old), ends in real.items():
        if ends:
            refuse_known_elsewhere(kind, old)
            refuse_unknown_ends(index, kind, old, {r.end.type for r in ends if r.end is not None})
            refuse_open_side(index, old, ends)
            _refuse_overrides(index, old)
            refuse_other_texts(index, old, rows)
    _refuse_taken(rows, change, [key for key, ends in real.items() if ends])
    _refuse_computed(rows, change)
    _refuse_dormant(index, {written.text for row in change.changed for written in row.literals})


def _refuse_overrides(index: Index, old: str) -> None:
    for system, _ in index.systems:
        for node in system.nodes:
            if any(key.startswith(f"qos_overrides.{old}.") for key in node.overrides):
                raise CannotRename(
                    f"parameters of {code(node.name or 'a node')} set the quality of service of {code(old)}"
                )


def _refuse_taken(rows: Sequence[Instance], change: NameChange, renamed: Sequence[tuple[ConnectionKind, str]]) -> None:
    olds: dict[tuple[ConnectionKind, str], str] = {}
    for key in renamed:
        new = (key[0], change.full_names[key])
        other = olds.setdefault(new, key[1])
        if other != key[1]:
            raise CannotRename(f"{code(other)} and {code(key[1])} would become one {key[0]}, {code(new[1])}")
        taken = next((row for row in rows if (row.kind, row.name) == new and row.end is not None), None)
        if taken is not None and new not in change.full_names:
            raise CannotRename(f"there is a {new[0]} {code(new[1])} already, at {where(taken.place)}", taken.place)


def _refuse_computed(rows: Iterable[Instance], change: NameChange) -> None:
    """A text that stands for itself may be a part of other names, too."""
    elsewhere = {w.text.strip("/~") for row in change.changed for w in row.literals if not _is_argument(row, w.place)}
    for row in rows:
        name = None if row.end is None else row.end.creation.name
        if name is None or name.text is None or row.literals or name.origin_kind == "literal":
            continue
        part = next((text for text in sorted(elsewhere) if text and f"/{text}/" in f"/{name.text.strip('/~')}/"), None)
        if part is not None:
            raise CannotRename(f"the name at {where(row.place)} is computed, perhaps from {code(part)}", row.place)


def _is_argument(row: Instance, place: Place) -> bool:
    given = None if row.end is None else row.end.creation.name_place
    return given is not None and given.file == place.file and given.span[:2] <= place.span[:2] <= given.span[2:]


def _refuse_dormant(index: Index, olds: set[str]) -> None:
    """What is started under other arguments only, and renames the same."""
    ends = {posixpath.basename(old) for old in olds}
    for launched in index.workspace.launched:
        for started in launched.started:
            for remap in started.remaps if started.dormant else ():
                texts = (remap.source.text or "", remap.target.text or "")
                if any(posixpath.basename(text) in ends for text in texts):
                    words = (
                        f"the remapping at {where(remap.place)} is for other launch arguments, and not followed here"
                    )
                    raise CannotRename(words, remap.place)


__all__ = ["refuse_doubtful"]
