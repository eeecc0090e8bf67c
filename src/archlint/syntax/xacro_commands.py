"""Substitutions in a description of a robot that xacro does not know, ``$(robot)`` for ``$(find robot)``.

Source: ``resolve_args`` of xacro's ``substitution_args.py``, which raises "Unknown substitution command".  What stands
in a macro, a condition, a property (which is looked at where it is used), a comment or CDATA may never be looked at.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.records import dataclass
from archlint.syntax.description_files import TAG
from archlint.syntax.facts import Span
from archlint.workspace.comments import blank_xml_comments

COMMANDS = ("find", "arg", "env", "optenv", "anon", "dirname", "eval", "cwd")
_PERHAPS = frozenset({"xacro:if", "xacro:unless", "xacro:macro", "xacro:property"})
_CDATA = re.compile(r"<!\[CDATA\[.*?\]\]>", re.DOTALL)
_SUBSTITUTION = re.compile(r"(?<!\$)\$\(\s*([A-Za-z_][\w.-]*)([^()$]*)\)")


@dataclass(frozen=True)
class UnknownCommand:
    """``written`` as a whole, and the ``command`` that it begins with; ``alone`` where no word follows that."""

    written: str
    command: str
    alone: bool
    span: Span


def unknown_commands(text: str) -> Iterator[UnknownCommand]:
    """Those that xacro certainly comes to.  Never raises."""
    if "$(" not in text:
        return
    text = blank_xml_comments(text)
    text = _CDATA.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    perhaps = [*_perhaps(text)]
    for match in _SUBSTITUTION.finditer(text):
        if match[1] in COMMANDS or any(start <= match.start() < end for start, end in perhaps):
            continue
        line = text.count("\n", 0, match.start()) + 1
        column = match.start() - text.rfind("\n", 0, match.start())
        span = (line, column, line, column + match.end() - match.start())
        yield UnknownCommand(match[0], match[1], not match[2].strip(), span)


def _perhaps(text: str) -> Iterator[tuple[int, int]]:
    """From where to where xacro may not look; to the end for what is never closed."""
    depth = start = 0
    for match in TAG.finditer(text):
        closing, tag, _, is_empty = match.groups()
        if tag not in _PERHAPS:
            continue
        if is_empty:
            yield match.span()
            continue
        if not closing and not depth:
            start = match.start()
        depth += -1 if closing else 1
        if not depth:
            yield start, match.end()
    if depth:
        yield start, len(text)


__all__ = ["COMMANDS", "UnknownCommand", "unknown_commands"]
