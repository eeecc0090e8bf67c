"""The form of a ``condition`` in a package.xml.

Source: ``evaluate_condition`` of catkin_pkg 1.1.1, which takes comparisons of two words, joined by ``and`` and ``or``.
"""

from __future__ import annotations

import re

from archlint.workspace.manifest import MAX_CONDITION

_TOKEN = re.compile(
    r"\s*(?:(?P<joins>(?:and|or)\b)|(?P<compares>[=!<>]=|[<>])|(?P<bracket>[()])"
    r"|(?P<word>\$\w+|[\w-]+|\"[^\"\n]*\"|'[^'\n]*'))",
    re.ASCII,
)
_LETTERS = {"joins": "&", "compares": "=", "word": "w"}
_COMPARISON, _JOINED, _IN_BRACKETS = re.compile("w=w"), re.compile("c&c"), re.compile(r"\(c\)")


def is_condition(text: str) -> bool:
    """Whether catkin_pkg can read a condition; also true of one that is longer than anybody writes."""
    if len(text) > MAX_CONDITION:
        return True
    form, at, end = "", 0, len(text.rstrip())
    while at < end:
        match = _TOKEN.match(text, at)
        if match is None:
            return False
        form += _LETTERS.get(match.lastgroup or "", match[0].strip())
        at = match.end()
    form, before = _COMPARISON.sub("c", form), ""
    while form != before:
        form, before = _IN_BRACKETS.sub("c", _JOINED.sub("c", form)), form
    return form == "c"


__all__ = ["is_condition"]
