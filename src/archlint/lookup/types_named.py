"""Where types are mentioned besides create calls: imported, and as those of fields in interface files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.lookup.mentions import Mention, Subject
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.lookup.texts import Texts
    from archlint.systems.model import WorkspaceIndex

_MODULE = re.compile(r"(\w+)\.(msg|srv|action)")
_TYPE = re.compile(r"\s*([A-Za-z][\w/]*)")


def mentions_of_fields(workspace: WorkspaceIndex, texts: Texts) -> Iterator[Mention]:
    """The types of the fields of the workspace's interfaces, those that are interfaces themselves."""
    table = workspace.interfaces
    for name in [] if table is None else table.names():
        source, interface = (None, None) if table is None else (table.file(name), table.get(name))
        if source is None or interface is None:
            continue
        for field in (field for section in interface.sections for field in section.fields):
            written = _TYPE.match(texts.line(source.relative, field.line))
            if written is not None and not field.type.is_primitive:
                place = Place(source.relative, field.line, written.start(1) + 1, field.line, written.end(1) + 1)
                subject = Subject("interface", field.type.qualified(name.partition("/")[0]))
                yield Mention(place, subject, "argument", 0)


def mentions_of_imports(workspace: WorkspaceIndex, texts: Texts) -> Iterator[Mention]:
    """The interfaces that Python files import by their names."""
    for file, read in workspace.code.asked_for():
        for statement in everything_in(read.body, facts.ImportFrom):
            module = _MODULE.fullmatch(statement.module) if statement.level == 0 else None
            for name, _ in statement.names if module is not None else ():
                place = _word(texts, Place.of(file.relative, statement.span), name)
                if module is not None and place is not None:
                    yield Mention(place, Subject("interface", f"{module[1]}/{module[2]}/{name}"), "argument", 0)


def _word(texts: Texts, place: Place, word: str) -> Place | None:
    """Where a word stands first behind ``import``."""
    pattern = re.compile(rf"\b{re.escape(word)}\b")
    for number in range(place.line, place.end_line + 1):
        row = texts.line(place.file, number)
        start = max(row.find(" import "), 0) if number == place.line else 0
        match = pattern.search(row, start)
        if match is not None:
            return Place(place.file, number, match.start() + 1, number, match.end() + 1)
    return None


__all__ = ["mentions_of_fields", "mentions_of_imports"]
