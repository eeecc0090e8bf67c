"""Why a renaming would perhaps miss something: ends that are not known, or texts that may mean the same name."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.lookup.index import PROVIDERS, Index
from archlint.lookup.instances import Instance, unknown_ends
from archlint.lookup.renamed_names import CannotRename, NameChange
from archlint.lookup.words import code, where
from archlint.model import NAMED
from archlint.place import Place
from archlint.ros import names, well_known
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind

_CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h", ".hh")
_MODELS = (".urdf", ".xacro", ".sdf", ".world")
_YAML = (".yaml", ".yml", ".rviz")


def refuse_doubtful(index: Index, rows: Sequence[Instance], change: NameChange) -> None:
    """Raises :class:`CannotRename` where it is not certain that a change covers every end."""
    real = {key: [r for r in rows if (r.kind, r.name) == key and r.end is not None] for key in change.full_names}
    for (kind, old), ends in real.items():
        if ends:
            _refuse_known_elsewhere(kind, old)
            _refuse_unknown_ends(index, kind, old, {r.end.type for r in ends if r.end is not None})
            _refuse_open_side(index, old, ends)
            _refuse_overrides(index, old)
            _refuse_other_texts(index, old, rows)
    _refuse_taken(rows, change, [key for key, ends in real.items() if ends])
    _refuse_computed(rows, change)
    _refuse_dormant(index, {written.text for row in change.changed for written in row.literals})


def _refuse_known_elsewhere(kind: ConnectionKind, old: str) -> None:
    if kind == "topic" and any(topic.name == old for topic in well_known.TOPICS):
        raise CannotRename(f"{code(old)} has this name in every ROS 2 system: other tools know it by that")


def _refuse_unknown_ends(index: Index, kind: ConnectionKind, old: str, types: set[str | None]) -> None:
    for end in unknown_ends(index):
        if NAMED[end.kind] != kind or end.node.test or (end.type is not None and types and end.type not in types):
            continue
        if end.name is None or names.pattern_matches(end.name, old):
            words = f"the name of the {end.kind.replace('_', ' ')} at {where(end.place)} is not known"
            raise CannotRename(f"{words}: it may be {code(old)}", end.place)


def _refuse_open_side(index: Index, old: str, ends: Sequence[Instance]) -> None:
    """A node whose source is not here has the name, or one side alone is known and such a node may be the other."""
    for row in ends:
        if row.end is not None and row.end.external:
            words = (
                f"{code(row.end.node.name or 'a node')}, whose source is not in this workspace, calls it {code(old)}"
            )
            raise CannotRename(f"{words}: remap that in the launch file first", row.place)
    if len({row.end.kind in PROVIDERS for row in ends if row.end is not None}) > 1:
        return
    for system, _ in index.systems:
        is_there = any(row.end is not None and row.end.node in system.nodes for row in ends)
        for node in system.nodes if is_there else ():
            if node.is_stranger and node.launch_place is not None:
                name = code(node.name or node.executable or "a node")
                words = (
                    f"only one side of {code(old)} is in this workspace; {name}, whose source is not, may be the other"
                )
                raise CannotRename(words, node.launch_place)


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


def _refuse_other_texts(index: Index, old: str, rows: Iterable[Instance]) -> None:
    """The name in files of other kinds, and in code that does not create anything."""
    known = {(w.place.file, w.place.line) for row in rows for w in (*row.literals, row.source, row.target) if w}
    for place in other_texts(index, old):
        if (place.file, place.line) not in known:
            raise CannotRename(f"{code(old)} stands at {where(place)}, too, and what that means is not known", place)


def other_texts(index: Index, old: str) -> Iterator[Place]:
    """Where a full name stands in C++, in models and in YAML, and in Python as a text of its own."""
    word = re.escape(old.strip("/"))
    patterns = {
        **dict.fromkeys(_CPP, re.compile(rf'"/?{word}"')),
        **dict.fromkeys(_MODELS, re.compile(rf">\s*/?{word}\s*<")),
        **dict.fromkeys(
            _YAML, re.compile(rf"""(?:topic\w*["']?\s*:\s*["']?/?|:\s*["']?/){word}["']?\s*(?:#|$)""", re.I)
        ),
    }
    tree, mentions = index.workspace.tree, index.workspace.code.mentions
    for file in sorted({path for folder in index.workspace.manifests for path in tree.files_below(folder)}):
        pattern = patterns.get(posixpath.splitext(file)[1])
        text = tree.text(file) if pattern is not None and mentions(file, posixpath.basename(old)) else None
        for number, row in enumerate((text or "").split("\n"), start=1):
            match = pattern.search(row) if pattern is not None and row else None
            if match is not None:
                yield Place(file, number, match.start() + 1, number, match.end() + 1)
    for file in index.workspace.code.files_that_mention(posixpath.basename(old)):
        read = index.workspace.facts_at(file)
        for literal in everything_in(read.body if read is not None else [], facts.Literal):
            if literal.text == old:
                yield Place.of(file, literal.span)


__all__ = ["other_texts", "refuse_doubtful"]
