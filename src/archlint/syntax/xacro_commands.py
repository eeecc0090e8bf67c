"""What xacro stops at in a description of a robot: ``$(robot)`` for ``$(find robot)``, and ``${`` without its ``}``.

Source: ``resolve_args`` of xacro's ``substitution_args.py``, which raises "Unknown substitution command", and the
``QuickLexer`` of its ``eval_text``, which raises "invalid expression".  What stands
in a macro that nobody calls, a condition that never holds, a property (which is looked at where it is used), a comment
or CDATA may never be looked at.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Sequence
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

_ATTRIBUTE = re.compile(r"""=\s*(?:"([^"]*)"|'([^']*)')""")
_CLOSED = re.compile(r"[^$]|\$\$+[{(]?|\$\{[^}]*\}|\$\([^)]*\)|\$(?![{(])")
"""What the lexer of xacro takes at a time."""


@dataclass(frozen=True)
class UnknownCommand:
    """``written`` as a whole, and the ``command`` that it begins with; ``alone`` where no word follows that, and in a
    condition or a macro only ``perhaps`` looked at."""

    written: str
    command: str
    alone: bool
    span: Span
    perhaps: bool


@dataclass(frozen=True)
class Unclosed:
    """What is ``written`` from an opening bracket to the end of an attribute, without the one that closes it."""

    written: str
    closing: str
    span: Span
    perhaps: bool


def stops_of_xacro(text: str, called: Container[str]) -> Iterator[Unclosed | UnknownCommand]:
    """The ``${`` and ``$(`` in attributes that nothing closes there, and the substitutions that xacro does not know,
    where it comes to them and the macros are ``called`` that somebody calls.  Never raises."""
    if "$" not in text:
        return
    text = _evaluated(text)
    regions = [*_regions(text, called)]
    yield from _unclosed_expressions(text, regions)
    yield from _unknown_commands(text, regions)


def _unknown_commands(text: str, regions: Sequence[_Region]) -> Iterator[UnknownCommand]:
    for match in _SUBSTITUTION.finditer(text):
        around = [region for region in regions if region.start <= match.start() < region.end]
        if match[1] not in COMMANDS and not any(region.skipped for region in around):
            span = _span(text, match.start(), match.end())
            yield UnknownCommand(match[0], match[1], not match[2].strip(), span, bool(around))


def _unclosed_expressions(text: str, regions: Sequence[_Region]) -> Iterator[Unclosed]:
    for tag in TAG.finditer(text):
        for attribute in _ATTRIBUTE.finditer(text, tag.start(3), tag.end(3)):
            start, end = attribute.span(1 if attribute[1] is not None else 2)
            at = _first_unclosed(text, start, end)
            around = [region for region in regions if region.start <= start < region.end]
            if at is not None and not any(region.skipped for region in around):
                written, _, _ = text[at:end].partition("\n")
                closing = "}" if written[1] == "{" else ")"
                yield Unclosed(written, closing, _span(text, at, at + len(written)), bool(around))


def _first_unclosed(text: str, start: int, end: int) -> int | None:
    """Where xacro stops in an attribute."""
    while start < end:
        match = _CLOSED.match(text, start, end)
        if match is None:
            return start
        start = match.end()
    return None


def _evaluated(text: str) -> str:
    """The text without what xacro leaves as it is."""
    return _CDATA.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), blank_xml_comments(text))


def _span(text: str, start: int, end: int) -> Span:
    line = text.count("\n", 0, start) + 1
    column = start - text.rfind("\n", 0, start)
    return (line, column, line, column + end - start)


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


__all__ = ["COMMANDS", "Unclosed", "UnknownCommand", "macros_called", "stops_of_xacro"]
