"""Substitutions in a description of a robot that xacro does not know, ``$(robot)`` for ``$(find robot)``.

Source: ``resolve_args`` of xacro's ``substitution_args.py``, which raises "Unknown substitution command".  What stands
in a macro that nobody calls, a condition that never holds, a property (which is looked at where it is used), a comment
or CDATA may never be looked at.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterator
from typing import NamedTuple

from archlint.records import dataclass
from archlint.syntax.description_files import CONDITIONS, TAG, is_skipped
from archlint.syntax.facts import Span
from archlint.workspace.comments import blank_xml_comments

COMMANDS = ("find", "arg", "env", "optenv", "anon", "dirname", "eval", "cwd")
_PROPERTY = "xacro:property"
_PERHAPS = CONDITIONS | {"xacro:macro", _PROPERTY}
_NAME = re.compile(r"(?<![\w:.-])name\s*=\s*([\"'])(?:xacro:)?([^\"']*)\1")
_CDATA = re.compile(r"<!\[CDATA\[.*?\]\]>", re.DOTALL)
_SUBSTITUTION = re.compile(r"(?<!\$)\$\(\s*([A-Za-z_][\w.-]*)([^()$]*)\)")


@dataclass(frozen=True)
class UnknownCommand:
    """``written`` as a whole, and the ``command`` that it begins with; ``alone`` where no word follows that, and in a
    condition or a macro only ``perhaps`` looked at."""

    written: str
    command: str
    alone: bool
    span: Span
    perhaps: bool


def unknown_commands(text: str, called: Container[str]) -> Iterator[UnknownCommand]:
    """Those that xacro comes to, where the macros are ``called`` that somebody calls.  Never raises."""
    if "$(" not in text:
        return
    text = blank_xml_comments(text)
    text = _CDATA.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    regions = [*_regions(text, called)]
    for match in _SUBSTITUTION.finditer(text):
        around = [region for region in regions if region.start <= match.start() < region.end]
        if match[1] in COMMANDS or any(region.skipped for region in around):
            continue
        line = text.count("\n", 0, match.start()) + 1
        column = match.start() - text.rfind("\n", 0, match.start())
        span = (line, column, line, column + match.end() - match.start())
        yield UnknownCommand(match[0], match[1], not match[2].strip(), span, bool(around))


def macros_called(text: str) -> Iterator[str]:
    """The words that may call a macro, without the name of the file that an include gives them."""
    for match in TAG.finditer(text):
        if match[2].startswith("xacro:"):
            yield match[2].removeprefix("xacro:").rpartition(".")[2]


class _Region(NamedTuple):
    """What is between two tags, where xacro does not always look; or ``skipped``: perhaps never."""

    start: int
    end: int
    skipped: bool


def _regions(text: str, called: Container[str]) -> Iterator[_Region]:
    """Every such region; to the end of the text for what is never closed."""
    inside: list[tuple[int, bool]] = []
    for match in TAG.finditer(text):
        closing, tag, attributes, is_empty = match.groups()
        if tag not in _PERHAPS:
            continue
        if tag not in CONDITIONS and not closing:
            yield _Region(*match.span(), True)  # a default of a macro, or the value of a property
        if closing and inside:
            start, skipped = inside.pop()
            yield _Region(start, match.start(), skipped)
        elif not closing and not is_empty:
            name = _NAME.search(attributes)
            skipped = is_skipped(tag, attributes) if tag in CONDITIONS else name is None or name[2] not in called
            inside.append((match.end(), skipped or tag == _PROPERTY))
    for start, skipped in inside:
        yield _Region(start, len(text), skipped)


__all__ = ["COMMANDS", "UnknownCommand", "macros_called", "unknown_commands"]
