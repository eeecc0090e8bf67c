"""Publishers and clients with which nothing is sent: the code never mentions again what it has created."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


def is_idle(system: System, end: Endpoint) -> bool:
    """Whether an end is thrown away, or kept under a name that stands nowhere else; false where that is not known."""
    workspace, place = system.workspace, end.place
    if not end.creation.stored:
        return True
    statement = source_code(system).statement_at(place)
    if workspace is None or not isinstance(statement, facts.Assign) or len(statement.targets) != 1:
        return False
    if Place.of(place.file, getattr(statement.value, "span", (0, 0, 0, 0))) != place:
        return False  # it is in a list or a dict, say
    name = statement.targets[0].last_name
    if not name:
        return False
    files = dict.fromkeys((place.file, *workspace.code.files_that_mention(name)))
    mentions = 0
    for file in files:
        code = workspace.facts_at(file)
        if code is None:
            return False
        mentions += sum(part.last_name == name or _text(part) == name for part in everything_in(code.body))
    return mentions == 1


def _text(part: facts.Base) -> str:
    """A text that may name an attribute: ``getattr(self, "client")``."""
    match part:
        case facts.Literal(value=str(text)):
            return text
    return ""


__all__ = ["is_idle"]
