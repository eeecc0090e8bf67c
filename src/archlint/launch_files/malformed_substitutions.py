"""Texts of XML and YAML launch files that launch refuses, or in which it sees no substitution although one is meant.

Source: ``grammar.lark`` of launch's frontends, and ``parse()`` of each substitution, which counts its words.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.frontends.tables import NESTED, SUBSTITUTIONS
from archlint.launch.frontends.texts import closing, unquoted, words_of
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.suggestions import nearest

if TYPE_CHECKING:
    from archlint.syntax.facts import Span
    from archlint.syntax.launch_elements import Attribute, Element
    from archlint.systems.model import System


class Malformed(StringEnum):
    """What is wrong with a substitution."""

    BRACE = "brace"
    """``${var x}``."""
    NO_DOLLAR = "no dollar"
    """``(find-pkg-share robot)``."""
    NOT_CLOSED = "not closed"
    """``$(var x``."""
    NO_NAME = "no name"
    """``$( var x)``, ``$()``."""
    UNKNOWN = "unknown"
    """``$(find_pkg_share robot)``."""
    WORDS = "words"
    """``$(find-pkg-share)``, ``$(eval 1 + 2)``: too few words, or too many."""


@dataclass(frozen=True)
class MalformedText:
    """One place; ``written`` is how the substitution begins, ``meant`` how it is called or how many words it takes."""

    kind: Malformed
    written: str
    span: Span
    meant: str = ""


def malformed_substitutions(system: System) -> Iterator[tuple[str, MalformedText]]:
    """Every such text in the launch files in XML and YAML of a launched system, with its file."""
    if system.launched is None or system.workspace is None:
        return
    files = system.workspace.launch_files
    for file in filter(files.is_frontend, system.launched.sources):
        read = files.frontend(file)
        if read.root is not None and not read.ros1:
            arguments = frozenset(filter(None, (arg.text("name") for arg in read.root.of("arg"))))
            yield from ((file, malformed) for malformed in _of_element(read.root, arguments))


_NOT_PARSED = frozenset({"description", "doc"})
_FOR_A_SHELL = frozenset({"cmd", "launch-prefix"})
"""Attributes in which ``${x}`` may be meant for a shell."""


def _of_element(element: Element, arguments: frozenset[str]) -> Iterator[MalformedText]:
    for name, attribute in element.attributes.items():
        is_parsed = name not in _NOT_PARSED and (element.tag, name) != ("arg", "name") and element.tag != "choice"
        for text in _texts(attribute) if is_parsed else ():
            known = frozenset() if name in _FOR_A_SHELL else arguments
            yield from _of_text(text, attribute.span, known)
    nested = NESTED.get(element.tag)
    for child in element.children:
        if nested is None or child.tag in nested:  # launch refuses others before it parses their texts
            yield from _of_element(child, arguments)


def _texts(attribute: Attribute) -> list[str]:
    values = attribute.value if isinstance(attribute.value, list) else [attribute.value]
    return [value for value in values if isinstance(value, str)]


_NAME = re.compile(r"[A-Za-z][\w-]*")
_WITH_BRACE = re.compile(
    r"\$\{\s*(var|find-pkg-share|find-pkg-prefix|exec-in-pkg|env|command|eval)\s(?:[^})$]|\$(?!\{))*[})]"
)
_PLAIN_BRACE = re.compile(r"\$\{\s*(\w+)\s*\}")
_WITHOUT_DOLLAR = re.compile(r"(?<!\$)\((find-pkg-share|find-pkg-prefix|exec-in-pkg|var)\s+[\w.-]+[^()]*\)")


def _of_text(text: str, span: Span, arguments: frozenset[str]) -> Iterator[MalformedText]:
    """What is wrong with one text, from left to right; not what is in a quoted word, which is data."""
    at = 0
    while (start := text.find("$(", at)) >= 0:
        yield from _between(text[at:start], span, arguments)
        if start > 0 and text[start - 1] == "\\":
            at = start + 2
            continue
        end = closing(text, start + 2)
        if end < 0:
            if not re.search("[\"']", text[start:]):
                yield MalformedText(Malformed.NOT_CLOSED, text[start:], span)
            return
        yield from _of_substitution(text[start + 2 : end], span)
        at = end + 1
    yield from _between(text[at:], span, arguments)


def _between(text: str, span: Span, arguments: frozenset[str]) -> Iterator[MalformedText]:
    """What is meant as a substitution in a text that launch takes as it stands."""
    for match in _WITH_BRACE.finditer(text):
        yield MalformedText(Malformed.BRACE, match[0], span, f"$({match[0][2:-1].strip()})")
    for match in _PLAIN_BRACE.finditer(text):
        if match[1] in arguments:
            yield MalformedText(Malformed.BRACE, match[0], span, f"$(var {match[1]})")
    for match in _WITHOUT_DOLLAR.finditer(text):
        yield MalformedText(Malformed.NO_DOLLAR, match[0], span, f"${match[0]}")


_OF_ROS1 = {"find": "find-pkg-share", "arg": "var"}
_ALSO_KNOWN = frozenset({"launch_log_dir", "log_dir"})
_WORDS = {
    "var": (1, 2),
    "env": (1, 2),
    "param": (1, 2),
    "eval": (1, 2),
    "command": (1, 2),
    "find-pkg-share": (1, 1),
    "find-pkg-prefix": (1, 1),
    "find-exec": (1, 1),
    "anon": (1, 1),
    "not": (1, 1),
    "exec-in-pkg": (2, 2),
    "and": (2, 2),
    "or": (2, 2),
    "equals": (2, 2),
    "not-equals": (2, 2),
    "dirname": (0, 0),
    "filename": (0, 0),
}
"""How many words each takes at least and at most, in every distribution."""
_ON_ERRORS = frozenset({"fail", "warn", "ignore", "capture"})


def _of_substitution(text: str, span: Span) -> Iterator[MalformedText]:
    name = _NAME.match(text)
    words = list(words_of(text))
    if name is None or not words:
        yield MalformedText(Malformed.NO_NAME, f"$({text})", span)
        return
    known, given = words[0], words[1:]
    if known not in SUBSTITUTIONS and known not in _ALSO_KNOWN:
        meant = _OF_ROS1.get(known) or nearest(known.replace("_", "-").lower(), SUBSTITUTIONS) or _same(known)
        if meant:  # another package may bring substitutions of its own
            yield MalformedText(Malformed.UNKNOWN, f"$({text})", span, meant)
        return
    least, most = _WORDS.get(known, (0, len(given)))
    if not least <= len(given) <= most or (known == "command" and _is_without_quotes(given)):
        yield MalformedText(Malformed.WORDS, f"$({text})", span, _number(known, least, most))
        return
    for word in given:
        if word == unquoted(word):
            yield from _inside(word, span)


def _same(name: str) -> str:
    """The name that is written with ``_`` for ``-``, or with capitals."""
    alike = name.replace("_", "-").lower()
    return alike if alike in SUBSTITUTIONS else ""


def _is_without_quotes(given: list[str]) -> bool:
    """Whether the second word of ``$(command xacro robot.urdf)`` is none that says what to do about errors."""
    return len(given) == len({"command", "on_stderr"}) and "$(" not in given[1] and unquoted(given[1]) not in _ON_ERRORS


def _inside(word: str, span: Span) -> Iterator[MalformedText]:
    """The substitutions in a word of another one."""
    start = word.find("$(")
    while start >= 0:
        end = closing(word, start + 2)
        if end < 0:
            return
        yield from _of_substitution(word[start + 2 : end], span)
        start = word.find("$(", end)


def _number(name: str, least: int, most: int) -> str:
    if name in ("command", "eval"):
        return "put what follows its name in quotes"
    if most == 0:
        return f"write $({name})"
    words = "one word" if most == 1 else "two words" if least == most else "one word, or two"
    return f"$({name} …) takes {words}; what has blanks in it needs quotes"


__all__ = ["Malformed", "MalformedText", "malformed_substitutions"]
