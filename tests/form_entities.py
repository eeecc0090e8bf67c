"""Reads what the comments in ``fixtures/forms`` say about the entities of each line.

``fixtures/forms/README.md`` describes the comments.  Nothing here depends on archlint.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

KINDS = ("publisher", "subscriber", "service", "client", "action_server", "action_client", "timer")

_COMMENT = re.compile(r"# entity:(?P<entities>.*)$")


@dataclass(frozen=True)
class FormEntity:
    """One entity that a line creates; ``name`` is ``?`` where nothing of it is known.

    A timer has its period in seconds as ``name`` and an empty ``type``.  ``keys`` are the ``key=value``
    words.
    """

    file: str
    line: int
    kind: str
    name: str
    type: str
    conditional: bool = False
    keys: dict[str, str] = field(default_factory=dict, hash=False)

    @property
    def resolution(self) -> str:
        """``exact``, ``parameter``, ``partial`` or ``unknown``."""
        return self.keys.get("resolution", "exact").partition(":")[0]

    @property
    def parameter(self) -> str | None:
        """The parameter that decides the name, if one does."""
        return self.keys.get("resolution", "").partition(":")[2] or self.keys.get("parameter")


def read_forms(folder: Path) -> list[FormEntity]:
    """The entities of all files below ``folder``, by file and line; raises `ValueError` for a bad comment."""
    return [
        entity
        for path in sorted(folder.rglob("*.py"))
        for entity in read_form(path.relative_to(folder).as_posix(), path.read_text(encoding="utf-8"))
    ]


def read_form(file: str, text: str) -> list[FormEntity]:
    """The entities of one file.  Comments on lines of their own belong to the code line above them."""
    entities: list[FormEntity] = []
    code_line = 0
    for number, line in enumerate(text.splitlines(), start=1):
        if line.strip() and not line.lstrip().startswith("#"):
            code_line = number
        if comment := _COMMENT.search(line):
            entities += [_entity(file, code_line, part.split()) for part in comment["entities"].split(";")]
    return entities


def _entity(file: str, line: int, words: list[str]) -> FormEntity:
    keys = dict(word.split("=", 1) for word in words if "=" in word)
    plain = [word for word in words if "=" not in word and word != "conditional"]
    wanted = 2 if plain[:1] == ["timer"] else 3
    if len(plain) != wanted or plain[0] not in KINDS:
        raise ValueError(f"{file}:{line}: not an entity: {' '.join(words)!r}")
    kind, name, type_ = (*plain, "")[:3]
    return FormEntity(file, line, kind, name, type_, "conditional" in words, keys)
