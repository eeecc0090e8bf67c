"""Where a name stands beside the ends that are known: in files of other kinds, and in code that creates nothing."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from archlint.lookup.index import Index
from archlint.lookup.instances import Instance
from archlint.lookup.renamed_names import CannotRename
from archlint.lookup.words import code, where
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

_CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h", ".hh")
_MODELS = (".urdf", ".xacro", ".sdf", ".world")
_YAML = (".yaml", ".yml", ".rviz")


def refuse_other_texts(index: Index, old: str, rows: Iterable[Instance]) -> None:
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


__all__ = ["other_texts", "refuse_other_texts"]
