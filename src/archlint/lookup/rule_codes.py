"""The rule whose code stands in a suppression comment."""

from __future__ import annotations

import re

from archlint.lookup.answers import Hover
from archlint.lookup.texts import Texts
from archlint.place import Place
from archlint.rulebook import find_rule
from archlint.syntax.comment_words import CODES, SUPPRESSION

_COMMENT = re.compile(SUPPRESSION)


def rule_at(texts: Texts, file: str, line: int, column: int) -> Hover | None:
    """The summary of the rule whose code or name is at a position of a suppression."""
    text = texts.line(file, line)
    for comment in _COMMENT.finditer(text) if "archlint:" in text else ():
        listed = comment[CODES] or ""
        for word in re.finditer(r"[\w-]+", listed):
            start = comment.start(CODES) + word.start() + 1
            if start <= column <= start + len(word[0]):
                rule = find_rule(word[0])
                if rule is None:
                    return None
                place = Place(file, line, start, line, start + len(word[0]))
                title = f"{rule.title} ({rule.severity.label})"
                return Hover(f"{title}\n\n{rule.summary}\n\n`archlint explain {rule.code}` says more.", place)
    return None


__all__ = ["rule_at"]
