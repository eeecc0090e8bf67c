"""The types that a create call can be given, those that the file imports first, and the import of any other."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.lookup.answers import Completion, Edit
from archlint.lookup.index import Index
from archlint.lookup.texts import Texts
from archlint.lookup.typed_python import imported
from archlint.lookup.wanted import Wanted
from archlint.model import NAMED
from archlint.place import Place
from archlint.ros import standard_interfaces
from archlint.syntax.interfaces import KIND_OF_SUFFIX

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind

_SUFFIX: dict[ConnectionKind, str] = {"topic": "msg", "service": "srv", "action": "action"}
_STARTED_LETTERS = 2
"""So many letters of a type must be typed before those that would have to be imported are offered."""


def types_wanted(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The types of the right kind."""
    if wanted.entity is None:
        return
    suffix, file = _SUFFIX[NAMED[wanted.entity]], wanted.replaces.file
    here = imported("\n".join(texts.lines(file)))
    for bound, name in here.items():
        if name.split("/")[1] == suffix:
            yield Completion(bound, "type", name, wanted.replaces)
    known, used = set(here.values()), {s.name.partition("/")[0] for s in index.subjects() if s.kind == "interface"}
    for name in _all(index, suffix) if len(wanted.typed) >= _STARTED_LETTERS else ():
        package, _, last = name.split("/")
        if name not in known and last.lower().startswith(wanted.typed.lower()) and last not in here:
            edit = _import(texts, file, f"{package}.{suffix}", last)
            rank = 1 if _is_here(index, name) else 2 if package in used else 3
            yield Completion(last, "type", name, wanted.replaces, rank, (edit,))


def types_of_package(index: Index, wanted: Wanted) -> Iterator[Completion]:
    """What can be imported from the module at hand."""
    package, _, suffix = wanted.module.partition("/")
    for name in _all(index, suffix):
        if name.startswith(f"{package}/"):
            yield Completion(name.rpartition("/")[2], "type", name, wanted.replaces)


def _all(index: Index, suffix: str) -> list[str]:
    """The interfaces of the workspace and the standard ones, of one kind; those of the workspace hide others of their
    package."""
    table = index.workspace.interfaces
    own = table.names() if table is not None else []
    packages = {name.partition("/")[0] for name in own}
    kind = KIND_OF_SUFFIX.get(suffix)
    if table is not None and kind is not None:
        own = [name for name in own if not table.is_left_out(name.split("/")[0], kind, name.rpartition("/")[2])]
    standard = (name for name in standard_interfaces.table().interfaces if name.partition("/")[0] not in packages)
    return sorted(name for name in (*own, *standard) if name.split("/")[1] == suffix)


def _is_here(index: Index, name: str) -> bool:
    table = index.workspace.interfaces
    return table is not None and table.file(name) is not None


def _import(texts: Texts, file: str, module: str, name: str) -> Edit:
    """The import of a type: added to the line that imports from its module, or on a line of its own behind the last
    import at the top."""
    last = 0
    for number, row in enumerate(texts.lines(file), start=1):
        if re.match(rf"from {re.escape(module)} import [\w, ]+$", row):
            end = len(row) + 1
            return Edit(Place(file, number, end, number, end), f", {name}")
        if re.match(r"(?:from|import)\s", row) and "(" not in row and not row.endswith("\\"):
            last = number
        elif re.match(r"(?:class|def|@)", row):
            break
    return Edit(Place(file, last + 1, 1, last + 1, 1), f"from {module} import {name}\n")


__all__ = ["types_of_package", "types_wanted"]
