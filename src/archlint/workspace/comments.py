"""The text of a file without its comments, for who only asks which words stand in it."""

from __future__ import annotations

import re
from collections.abc import Callable

_OF_XML = re.compile(r"<!--.*?-->", re.DOTALL)
_IN_A_LINE = re.compile(r"[^\n]")
_OF_LINES = re.compile(r"(?:^|(?<=\s))#[^\n]*", re.MULTILINE)


def without_comments(text: str) -> str:
    """A text of Python, TOML, INI, YAML or XML without its comments.  A ``#`` starts one at the start of a line or
    after a space, so that a colour (``'#fff'``) is none."""
    return _OF_LINES.sub("", replace_xml_comments(text, lambda comment: ""))


def replace_xml_comments(text: str, put: Callable[[str], str]) -> str:
    """A text in which ``put`` says what stands in the place of each comment of XML."""
    end = _end_of_last(text)
    return _OF_XML.sub(lambda match: put(match[0]), text[:end]) + text[end:]


def blank(text: str) -> str:
    """Blanks for a text, on as many lines: what stands behind it stays where it is."""
    return _IN_A_LINE.sub(" ", text)


def blank_xml_comments(text: str) -> str:
    """A text of XML with blanks for its comments."""
    return replace_xml_comments(text, blank)


def xml_comments(text: str) -> list[str]:
    """What stands in the comments of a text of XML, without the marks around each."""
    return [comment[len("<!--") : -len("-->")] for comment in _OF_XML.findall(text[: _end_of_last(text)])]


def _end_of_last(text: str) -> int:
    """Behind the last end there is no comment, and each start there would be held against all that follows."""
    last = text.rfind("-->")
    return 0 if last < 0 else last + len("-->")


__all__ = ["blank", "blank_xml_comments", "replace_xml_comments", "without_comments", "xml_comments"]
