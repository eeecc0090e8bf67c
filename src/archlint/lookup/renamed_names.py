"""What has to change with the name of a topic, service or action: the texts of all its ends, or none at all.

One text may name several ends: the same class runs in several namespaces, a constant is used twice.  A remapping has to
go along with the name in the code that it replaces.  So a change of one text is followed until nothing more changes.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal

from archlint.lookup.instances import Instance, Written
from archlint.lookup.words import code, where
from archlint.ros import names

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.place import Place

_Part = Literal["literal", "source", "target"]
_Name = tuple["ConnectionKind", str]


class CannotRename(Exception):
    """Why a name cannot be renamed, and the place that stands in the way."""

    def __init__(self, reason: str, place: Place | None = None) -> None:
        super().__init__(reason)
        self.reason, self.place = reason, place


class NameChange:
    """The change of one text and all that follows from it.  ``texts`` are the new texts by their places, ``full_names``
    the new full names by kind and old name.  Raises :class:`CannotRename`."""

    def __init__(self, rows: Iterable[Instance], start: Place, old: str, new: str) -> None:
        self.texts: dict[Place, str] = {}
        self.full_names: dict[_Name, str] = {}
        self.changed: list[Instance] = []
        self._old, self._new = old, new
        self._uses: dict[Place, list[tuple[Instance, _Part]]] = {}
        self._by_name: dict[_Name, list[Instance]] = {}
        for row in rows:
            self._by_name.setdefault((row.kind, row.name), []).append(row)
            for part, written in _parts(row):
                self._uses.setdefault(written.place, []).append((row, part))
        self._to_do: list[Place] = []
        if start not in self._uses:
            raise CannotRename("this text names nothing in what runs, as far as the workspace says", start)
        if all(row.end is None for row, _ in self._uses[start]):
            raise CannotRename("it is a name of a node whose source is not in this workspace", start)
        self._set_text(start, new)
        while self._to_do:
            self._follow(self._to_do.pop(0))

    def _follow(self, place: Place) -> None:
        text = self.texts[place]
        for row, part in self._uses[place]:
            full = row.expand(text)
            if full is None:
                raise CannotRename(f"{code(text)} is no name for what is created at {where(row.place)}", row.place)
            if row not in self.changed:
                self.changed.append(row)
            match part:
                case "literal" if row.is_remapped:
                    self._write(row, row.source, full)
                    self._write_all(row, full)
                case "literal":
                    self._write_all(row, full)
                    self._set_name(row, full)
                case "source":
                    self._write_all(row, full)
                case "target":
                    self._set_name(row, full)

    def _write_all(self, row: Instance, full: str) -> None:
        """All that says the name which the code gives an end."""
        if not row.literals:
            self._refuse_unwritten(row)
        for literal in row.literals:
            self._write(row, literal, full)

    def _write(self, row: Instance, written: Written | None, full: str) -> None:
        if written is None:
            raise CannotRename(f"the remapping of what is created at {where(row.place)} is not a plain text", row.place)
        if row.expand(self.texts.get(written.place, "")) == full:
            return
        text = row.spelled(full, written.text, self._new if written.text == self._old else None)
        if text is None:
            raise CannotRename(f"{code(full)} cannot be written at {where(written.place)}", written.place)
        self._set_text(written.place, text)

    def _refuse_unwritten(self, row: Instance) -> None:
        end = row.end
        if end is None:
            raise CannotRename(f"the node at {where(row.place)} is not in this workspace", row.place)
        at = end.creation.name.origin or end.creation.name_place or row.place
        why = "computed" if end.creation.name.origin_kind == "format" else "not written there as a plain text"
        raise CannotRename(f"the name of the {end.kind.replace('_', ' ')} at {where(row.place)} is {why}", at)

    def _set_text(self, place: Place, text: str) -> None:
        if self.texts.setdefault(place, text) != text:
            raise CannotRename(
                f"the text at {where(place)} names several things, which need different names then", place
            )
        if place not in self._to_do:
            self._to_do.append(place)

    def _set_name(self, row: Instance, full: str) -> None:
        key: _Name = (row.kind, row.name)
        if key in self.full_names:
            if self.full_names[key] != full:
                raise CannotRename(f"{code(row.name)} would get two names at once", row.place)
            return
        self.full_names[key] = full
        for other in self._by_name[key]:
            if other.is_remapped:
                if other.target is None:
                    raise CannotRename(f"what renames the end at {where(other.place)} is not a plain text", other.place)
                self._write(other, other.target, full)
            else:
                self._write_all(other, full)


def _parts(row: Instance) -> list[tuple[_Part, Written]]:
    parts: list[tuple[_Part, Written]] = [("literal", literal) for literal in row.literals]
    if row.source is not None:
        parts.append(("source", row.source))
    if row.target is not None:
        parts.append(("target", row.target))
    return parts


def refuse_wrong_name(new: str) -> None:
    """Raises :class:`CannotRename` where rcl refuses a name."""
    wrong = names.validate_topic_name(new)
    if wrong is not None:
        raise CannotRename(f"{code(new)} is no name: {wrong.message}")


__all__ = ["CannotRename", "NameChange", "refuse_wrong_name"]
