"""Grammars as tables of templates: ``«name»`` stands for one of the templates of that name.

A placeholder that stands alone on its line is indented with what it becomes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from benchmarks.fuzz.pick import Pick

_PLACEHOLDER = re.compile(r"^( *)«(\w+)»$|«(\w+)»", re.MULTILINE)
_ENDLESS = 10**6

Templates = Mapping[str, Sequence[str]]
Words = Mapping[str, Callable[[Pick], str]]


class Grammar:
    """``templates`` may lead back to each other; ``words`` are made by functions.

    A text ends: once ``size`` placeholders are filled, or ``depth`` lie in each other, only the templates with the
    shortest way to an end are taken.
    """

    def __init__(self, templates: Templates, words: Words, depth: int = 12, size: int = 400) -> None:
        self._words = words
        self._templates = templates
        self._depth = depth
        self._size = size
        heights = self._heights()
        self._shortest = {
            name: [row for row in rows if self._height(row, heights) == heights[name] - 1]
            for name, rows in templates.items()
        }

    def text(self, pick: Pick, name: str) -> str:
        """A text of the kind ``name``."""
        left = [self._size]
        return self._expanded(pick, name, 0, left)

    def _expanded(self, pick: Pick, name: str, depth: int, left: list[int]) -> str:
        if name in self._words:
            return self._words[name](pick)
        left[0] -= 1
        ends = depth >= self._depth or left[0] < 0
        template = pick.among((self._shortest if ends else self._templates)[name])

        def filled(match: re.Match[str]) -> str:
            indent, alone, within = match.groups()
            text = self._expanded(pick, alone or within, depth + 1, left)
            return text if alone is None else "\n".join(indent + line for line in text.split("\n"))

        return _PLACEHOLDER.sub(filled, template)

    def _heights(self) -> dict[str, int]:
        """How many steps the shortest way from each name to a text has."""
        heights = dict.fromkeys(self._templates, _ENDLESS)
        for _ in self._templates:
            for name, rows in self._templates.items():
                heights[name] = min(1 + self._height(row, heights) for row in rows)
        endless = [name for name, height in heights.items() if height >= _ENDLESS]
        if endless:
            raise ValueError(f"these never end: {endless}")
        return heights

    def _height(self, template: str, heights: Mapping[str, int]) -> int:
        names = [match[2] or match[3] for match in _PLACEHOLDER.finditer(template)]
        return max((heights.get(name, 0) if name not in self._words else 0 for name in names), default=0)
