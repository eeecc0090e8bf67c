"""The calls, lists and dicts that are open where somebody types, in Python that need not be complete.

A text in the middle of a change is no Python that a parser takes, and what was known of the file knows no such call: so
the brackets and strings in front of the position are counted.
"""

from __future__ import annotations

import re
from dataclasses import field

from archlint.records import dataclass

_TOKEN = re.compile(
    r"""
    (?P<long>[a-zA-Z]{0,2}(?:\"{3}(?:\\.|[^\\])*?(?:\"{3}|\Z)|'{3}(?:\\.|[^\\])*?(?:'{3}|\Z)))
    |(?P<text>[a-zA-Z]{0,2}(?:"(?:\\.|[^"\\\n])*"?|'(?:\\.|[^'\\\n])*'?))
    |(?P<comment>\#[^\n]*)
    |(?P<keyword>\b\w+)\s*=(?!=)
    |(?P<open>[(\[{])
    |(?P<close>[)\]}])
    |(?P<comma>,)
    |(?P<colon>:)
    |(?P<definition>^[ \t]*(?:async[ ]+def|def|class|import|from)\b)
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
_START = re.compile(r"""([a-zA-Z]{0,2})(["'])(.*)\Z""", re.DOTALL)


@dataclass
class Open:
    """An open bracket: ``callee`` is what it calls (empty for none), ``start`` the offset of what follows it."""

    bracket: str
    callee: str
    start: int
    number: int = 0
    """How many commas there are in it so far."""
    keyword: str = ""
    """The keyword of the argument that is typed."""
    behind_colon: bool = False
    """Whether that is the value of a dict's key."""
    starts: list[tuple[str, int, int]] = field(default_factory=list)
    """The keyword, start and end of each argument before it."""
    argument_start: int = 0

    @property
    def name(self) -> str:
        """The last part of what is called."""
        return self.callee.rpartition(".")[2]


@dataclass(frozen=True)
class Typing:
    """What is open at a position, outermost first, and what is typed there: in a text, or a word."""

    opened: tuple[Open, ...]
    typed: str
    in_text: bool
    is_plain: bool = True
    """Whether a text is one without holes."""


def typing_at(before: str) -> Typing | None:
    """What is open at the end of a text; None in a comment or a text of several lines."""
    stack: list[Open] = []
    for token in _TOKEN.finditer(before):
        kind, at_end = token.lastgroup, token.end() == len(before)
        if kind == "comment" and at_end:
            return None
        if kind == "long" and at_end and not _is_closed(token[0]):
            return None
        if kind == "text" and at_end and not _is_closed(token[0]):
            start = _START.match(token[0])
            if start is None:
                return None
            return Typing(tuple(stack), start[3], True, "f" not in start[1].lower())
        _follow(stack, token, before)
    word = re.search(r"\w*\Z", before)
    return Typing(tuple(stack), word[0] if word is not None else "", False)


def _is_closed(text: str) -> bool:
    body = text.lstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")
    quote = body[:3] if body[:3] in ('"""', "'''") else body[:1]
    return len(body) >= 2 * len(quote) and body.endswith(quote) and not re.search(r"(?<!\\)(?:\\\\)*\\\Z", body[:-1])


def _follow(stack: list[Open], token: re.Match[str], text: str) -> None:
    match token.lastgroup:
        case "open":
            name = _callee_before(text, token.start()) if token[0] == "(" else ""
            stack.append(Open(token[0], name, token.end(), argument_start=token.end()))
        case "close" if stack:
            stack.pop()
        case "comma" if stack:
            top = stack[-1]
            top.starts.append((top.keyword, top.argument_start, token.start()))
            top.number, top.keyword, top.behind_colon, top.argument_start = top.number + 1, "", False, token.end()
        case "colon" if stack and stack[-1].bracket == "{":
            stack[-1].behind_colon = True
        case "keyword" if stack and stack[-1].bracket == "(":
            stack[-1].keyword, stack[-1].argument_start = token["keyword"], token.end()
        case "definition":
            stack.clear()  # whatever was left open before does not reach as far


def _callee_before(text: str, end: int) -> str:
    start = end
    while start > 0 and (text[start - 1].isalnum() or text[start - 1] in "_."):
        start -= 1
    return text[start:end]


__all__ = ["Open", "Typing", "typing_at"]
